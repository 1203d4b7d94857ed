//! Log maps, transport and what is diffused.

use glam::DVec3;
use heatwalk::{Method, Windows, log_map, propagated_log_map, transport};
use heatwalk_bindings::{Message, Result, reporter};
use js_sys::Function;
use wasm_bindgen::prelude::*;

use crate::mesh::Mesh;
use crate::options::method_of;
use crate::vectors::{coordinates, points, require_one_each, vector};

/// In which direction shortest paths leave a source, and how long they are.
#[derive(Message)]
pub struct LogMap {
    /// Two a vertex, as long as the distance; NaN where nothing is reached.
    pub coordinates: Vec<f64>,
    /// One a vertex; Infinity where nothing is reached.
    pub distances: Vec<f64>,
    /// Two unit vectors in space, along u and v.
    pub axes: Vec<f64>,
}

#[wasm_bindgen]
impl Mesh {
    /// The log map of a source; u is along the direction where one is given.
    pub fn log_map(
        &self,
        source: &[f64],
        direction: Option<Vec<f64>>,
        method: &str,
        progress: &Function,
    ) -> Result<LogMap> {
        let (source, progress) = (self.point(source)?, &mut reporter(progress));
        let direction = direction.map(|direction| vector(&direction)).transpose()?;
        let methods = [Method::Exact, Method::Propagation, Method::Heat];
        let map = match method_of(method, &methods, "log maps are not made")? {
            Method::Heat => self.diffusion(progress)?.log_map(source, direction, progress)?,
            Method::Propagation => {
                propagated_log_map(&self.geometry(), source, direction, Windows::default(), progress)?
            }
            Method::Exact | Method::Auto => log_map(&self.geometry(), source, direction, progress)?,
        };
        let of_vertices = self.to_inputs(&map.coordinates, glam::DVec2::NAN);
        Ok(LogMap {
            coordinates: of_vertices.into_iter().flat_map(|place| place.to_array()).collect(),
            distances: self.to_inputs(&map.distances, f64::INFINITY),
            axes: coordinates(map.axes),
        })
    }

    /// Three coordinates a vertex of tangent vectors that are carried from sources, three coordinates each.
    pub fn transport(&self, sources: &[f64], vectors: &[f64], method: &str, progress: &Function) -> Result<Vec<f64>> {
        let (sources, progress) = (self.points(sources)?, &mut reporter(progress));
        require_one_each(sources.len(), vectors.len() / 3, "vectors")?;
        let placed: Vec<_> = sources.into_iter().zip(points(vectors)).collect();
        let carried = match method_of(method, &[Method::Exact, Method::Heat], "vectors are not carried")? {
            Method::Heat => self.diffusion(progress)?.transport(&placed, progress)?,
            _ => transport(&self.geometry(), &placed, progress)?,
        };
        Ok(coordinates(self.to_inputs(&carried, DVec3::NAN)))
    }

    /// One a vertex of numbers that are carried from sources by heat.
    pub fn extend(&self, sources: &[f64], values: &[f64], progress: &Function) -> Result<Vec<f64>> {
        let (sources, progress) = (self.points(sources)?, &mut reporter(progress));
        require_one_each(sources.len(), values.len(), "values")?;
        let placed: Vec<_> = sources.into_iter().zip(values.iter().copied()).collect();
        let extended = self.diffusion(progress)?.extend(&placed, progress)?;
        Ok(self.to_inputs(&extended, f64::NAN))
    }
}
