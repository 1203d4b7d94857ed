//! Places and paths in the words of the caller.

use heatwalk::surface::PathPoint;
use heatwalk::{FaceId, InputPlace, Path, Place};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;

use crate::arrays::{rows, vectors};
use crate::mesh::Mesh;
use crate::named::named;

/// What places are told by: `n` faces of the caller, and `n × 3` weights of their corners.
pub type Places<'py> = (Bound<'py, PyArray1<i64>>, Bound<'py, PyArray2<f64>>);

impl Mesh {
    /// Places on faces, in the words of the caller.
    pub fn told<'py>(&self, py: Python<'py>, places: impl ExactSizeIterator<Item = (Place, FaceId)>) -> Places<'py> {
        let within = |(place, face)| InputPlace::within(place, face, self.soup(), self.surface());
        let within: Vec<(usize, [f64; 3])> = places.map(within).collect();
        let faces = PyArray1::from_iter(py, within.iter().map(|&(triangle, _)| triangle as i64));
        (faces, vectors(py, within.into_iter().map(|(_, weights)| weights)))
    }

    /// `n × 3` points of a path, their faces and weights.
    pub fn told_path<'py>(&self, py: Python<'py>, path: &Path) -> (Bound<'py, PyArray2<f64>>, Places<'py>) {
        let points = rows(py, path.points.iter().map(|point| point.position.to_array()));
        let place = |point: &PathPoint| (point.location, point.face);
        (points, self.told(py, path.points.iter().map(place)))
    }

    /// A `Place`.
    pub fn told_place<'py>(&self, py: Python<'py>, place: Place) -> PyResult<Bound<'py, PyAny>> {
        let (face, weights) = InputPlace::within(place, place.faces(self.surface())[0], self.soup(), self.surface());
        named(py, "Place", (face, <(f64, f64, f64)>::from(weights)))
    }
}
