//! Samples, cells and means.

use heatwalk::exact::exact_distance;
use heatwalk::{Place, SampleCount, SurfacePoint, cells, farthest_samples, mean, relaxed};
use heatwalk_bindings::{Failure, Message, Result, reporter};
use js_sys::{Function, Object};
use wasm_bindgen::prelude::*;

use crate::given::{count, property};
use crate::mesh::Mesh;
use crate::places::Places;
use crate::vectors::require_one_each;

/// What is nearest to each of several sources.
#[derive(Message)]
pub struct Cells {
    /// Of each vertex the number of its nearest source; -1 where none is reached.
    pub nearest: Vec<i32>,
    /// How far that is; Infinity where none is reached.
    pub distances: Vec<f64>,
}

/// Places spread over the surface.
#[derive(Message)]
pub struct Samples {
    /// Of each its face.
    pub faces: Vec<u32>,
    /// Three of each: of the corners of its face, of sum 1.
    pub weights: Vec<f64>,
    /// Three coordinates of each.
    pub points: Vec<f64>,
    /// Their vertices; undefined where they were relaxed.
    pub vertices: Option<Vec<u32>>,
    /// How far the farthest vertex is from one.
    pub radius: f64,
}

/// Where squared distances from weighted places sum to least.
#[derive(Message)]
pub struct Mean {
    /// Of the place its face.
    pub face: u32,
    /// Three: of the corners of its face, of sum 1.
    pub weights: Vec<f64>,
    /// Where that is.
    pub point: Vec<f64>,
    /// The mean squared distance there.
    pub variance: f64,
}

#[wasm_bindgen]
impl Mesh {
    /// The nearest source of each vertex, by exact distance.
    pub fn cells(&self, sources: &[f64], options: &Object, progress: &Function) -> Result<Cells> {
        let found = cells(&self.geometry(), &self.sources(sources, options)?, &mut reporter(progress))?;
        let nearest = self.to_inputs(&found.nearest, None);
        Ok(Cells {
            nearest: nearest.into_iter().map(|source| source.map_or(-1, |source| source as i32)).collect(),
            distances: self.to_inputs(&found.distances, f64::INFINITY),
        })
    }

    /// Farthest samples: `count` or within `radius`, from `start` on, moved `relax` times to the middles of their cells.
    pub fn sample(&self, start: Option<u32>, options: &Object, progress: &Function) -> Result<Samples> {
        let wanted = match [property(options, "count"), property(options, "radius")] {
            [Some(wanted), None] => SampleCount::Exactly(count("count", &wanted)?),
            [None, Some(radius)] => SampleCount::Within(radius.as_f64().unwrap_or(f64::NAN)),
            _ => return Err(Failure::of("bad-parameter", "give one of count and radius")),
        };
        let rounds = property(options, "relax").map_or(Ok(0), |rounds| count("relax", &rounds))?;
        let (surface, geometry, progress) = (self.surface(), self.geometry(), &mut reporter(progress));
        let first = match start {
            None => surface.first_vertex(),
            Some(start) => {
                let point = self.point(&[0.0, f64::from(start), 0.0, 0.0, 0.0])?;
                point.place().vertex(surface).ok_or_else(|| Failure::of("bad-place", "the start is no vertex"))?
            }
        };
        let samples = farthest_samples(&geometry, first, wanted, progress)?;
        if rounds == 0 {
            let Places { faces, weights, points } =
                self.told_places(samples.vertices.iter().map(|&vertex| Place::Vertex(vertex)));
            let inputs = samples.vertices.iter().map(|&vertex| surface.inputs_of_vertex(vertex)[0].0);
            let (vertices, radius) = (Some(inputs.collect()), samples.covering_radius());
            return Ok(Samples { faces, weights, points, vertices, radius });
        }
        let moved = relaxed(&geometry, &samples.vertices, rounds, progress)?;
        let distances = exact_distance(surface, &moved, progress)?;
        let Places { faces, weights, points } = self.told_places(moved.iter().map(SurfacePoint::place));
        let radius = distances.iter().copied().fold(0.0, f64::max);
        Ok(Samples { faces, weights, points, vertices: None, radius })
    }

    /// The mean of places with weights.
    pub fn mean(&self, sources: &[f64], weights: &[f64], progress: &Function) -> Result<Mean> {
        let sources = self.points(sources)?;
        require_one_each(sources.len(), weights.len(), "weights")?;
        let weighted: Vec<(SurfacePoint, f64)> = sources.into_iter().zip(weights.iter().copied()).collect();
        let heatwalk::Mean { place, variance } = mean(&self.geometry(), &weighted, &mut reporter(progress))?;
        let Places { faces, weights, points: point } = self.told_places([place].into_iter());
        Ok(Mean { face: faces[0], weights, point, variance })
    }
}
