//! The last field as it was found, for files: in double precision, over welded vertices.

use std::sync::Arc;

use heatwalk::{FaceId, InputVertex, Place};
use heatwalk_bindings::Result;
use js_sys::{Float64Array, Uint32Array};
use wasm_bindgen::prelude::*;

use super::Solver;

#[wasm_bindgen]
impl Solver {
    /// `#V × 3`, vertices of the surface as it is shown, in the file's unit.
    pub fn positions(&self) -> Float64Array {
        let numbers: Vec<f64> = self.shown.positions().iter().flat_map(|position| position.to_array()).collect();
        numbers.as_slice().into()
    }

    /// `#F × 3`, triangles of the surface in the order in which they are drawn.
    pub fn faces(&self) -> Uint32Array {
        let faces = self.drawn.faces().iter().map(|&face| self.shown.faces()[face]);
        let corners: Vec<u32> = faces.flat_map(|face| face.map(|vertex| vertex.0)).collect();
        corners.as_slice().into()
    }

    /// `#V`, the last field.
    pub fn distances(&self) -> Result<Float64Array> {
        let values: Vec<f64> = self.solved()?.distance().values.iter().copied().collect();
        Ok(values.as_slice().into())
    }

    /// The last field at places of the surface, in the file's unit: `#P` drawn triangles, and `#P × 3` weights of their corners; none
    /// where not all of it is exact, where costs differ, and while the surface is shown in another pose than it was measured in.
    ///
    /// # Errors
    /// For a triangle that is not there, or weights out of range.
    pub fn exact_distances_in(&mut self, triangles: &[u32], weights: &[f64]) -> Result<Option<Vec<f64>>> {
        let solved = self.solved.as_ref().ok_or(heatwalk::Error::NoSource)?;
        if !Arc::ptr_eq(self.solver.surface(), &self.shown) {
            return Ok(None);
        }
        let distances = match self.solver.place_distances(solved.solution.answer()) {
            Err(heatwalk::Error::NotExact) => None,
            distances => distances?,
        };
        let Some(distances) = distances else { return Ok(None) };
        let place = |(&triangle, &weights): (&u32, &[f64; 3])| {
            // One that there is none of is for the surface to name.
            let face = self.drawn.face(triangle).unwrap_or(FaceId(triangle));
            Place::Face { face, weights }
        };
        let places: Vec<Place> = triangles.iter().zip(weights.as_chunks().0).map(place).collect();
        Ok(Some(distances.at_all(&places)?))
    }

    /// `#P × 2`, points of the path that was traced last: the length up to each, and the last field there, both in the file's
    /// unit; none without a path.
    pub fn path_profile(&self) -> Result<Option<Float64Array>> {
        let Some(path) = &self.path else { return Ok(None) };
        let (surface, distance) = (self.solver.surface(), self.solved()?.distance());
        let mut length = 0.0;
        let mut numbers = Vec::with_capacity(2 * path.points.len());
        let mut before = None;
        for point in &path.points {
            length += before.map_or(0.0, |before| point.position.distance(before));
            before = Some(point.position);
            numbers.extend([length, distance.at(surface, point.location)?]);
        }
        Ok(Some(numbers.as_slice().into()))
    }

    /// Of each vertex of the input the vertex that it became; 2³² − 1 where no triangle uses it.
    pub fn vertices_of_inputs(&self) -> Uint32Array {
        let inputs = (0..self.shown.report().input_vertices as u32).map(InputVertex);
        let vertices: Vec<u32> =
            inputs.map(|input| self.shown.vertex_of_input(input).map_or(u32::MAX, |vertex| vertex.0)).collect();
        vertices.as_slice().into()
    }
}
