//! Distances of vertices.

use std::num::NonZeroUsize;

use heatwalk::{InputPlace, SurfacePoint, VertexId, row_source, surface};
use heatwalk_bindings::{Message, Result, reporter};
use js_sys::{Float64Array, Function, Object, Reflect};
use wasm_bindgen::prelude::*;

use crate::mesh::Mesh;
use crate::options::distance_options;

/// A distance, and how it was found.
#[derive(Message)]
pub struct Answer {
    /// One a vertex; Infinity where nothing is reached.
    pub distances: Vec<f64>,
    /// What found them.
    pub method: String,
    /// Distances below this are exact.
    pub exact_below: f64,
    /// How many windows crossed a face.
    pub windows: usize,
}

#[wasm_bindgen]
impl Mesh {
    /// The distance of each vertex from the nearest source.
    pub fn solve(&self, sources: &[f64], options: &Object, progress: &Function) -> Result<Answer> {
        let (sources, options) = (self.sources(sources, options)?, distance_options(&without(options, "initial"))?);
        self.with_solver(|solver| {
            let answer = solver.distance(&sources, &options, &mut reporter(progress))?;
            Ok(Answer {
                distances: solver.of_inputs(&answer),
                method: answer.method.to_string(),
                exact_below: answer.distance.exact_below,
                windows: answer.windows,
            })
        })
    }

    /// Distances from each source by itself to some vertices, a row a source; `row` is given the number of each and its numbers.
    pub fn rows(
        &self,
        sources: &[f64],
        targets: &[u32],
        options: &Object,
        row: &Function,
        progress: &Function,
    ) -> Result<()> {
        let options = distance_options(options)?;
        let targets = targets.iter().map(|&target| self.column(target)).collect::<Result<Vec<_>>>()?;
        let places = sources.as_chunks::<5>().0;
        self.with_solver(|solver| {
            let mut report = reporter(progress);
            for (number, place) in places.iter().enumerate() {
                let point = self.reachable(place)?;
                let tell = |_: usize, values: &[f64]| values.to_vec();
                let found =
                    solver.map_rows(&[point], &targets, (&options, NonZeroUsize::MIN), tell, &mut heatwalk::go_on)?;
                let values = Float64Array::from(found.concat().as_slice());
                // What is done with a row is no reason to stop.
                let _ = row.call2(&JsValue::NULL, &number.into(), &values);
                let share = (number + 1) as f64 / places.len() as f64;
                let _ = report(heatwalk::Stage::Searching { radius: 0.0 }, share);
            }
            Ok(())
        })
    }
}

impl Mesh {
    /// The surface's vertex of one of the caller's; none for a vertex that no face uses.
    fn column(&self, target: u32) -> Result<Option<VertexId>> {
        let vertices = self.surface().vertices_of_inputs();
        let vertex = target as usize;
        let missing = surface::Error::NoSuchVertex { vertex, vertices: vertices.len() };
        Ok(*vertices.as_slice().get(vertex).ok_or(missing)?)
    }

    /// The place on the surface; none for a vertex that no face uses.
    fn reachable(&self, place: &[f64; 5]) -> Result<Option<SurfacePoint>> {
        match *place {
            [0.0, vertex, ..] => Ok(row_source(InputPlace::Vertex(vertex as usize), self.soup(), self.surface())?),
            _ => self.point(place).map(Some),
        }
    }
}

/// The same options but for one.
pub fn without(options: &Object, name: &str) -> Object {
    let rest = Object::assign(&Object::new(), options);
    // A property of a plain object can be taken away.
    let _ = Reflect::delete_property(&rest, &name.into());
    rest
}
