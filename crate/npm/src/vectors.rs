//! Lists of numbers, and vectors in them.

use glam::DVec3;
use heatwalk_bindings::{Failure, Result};

/// Points of space, in one list.
pub fn coordinates(points: impl IntoIterator<Item = DVec3>) -> Vec<f64> {
    points.into_iter().flat_map(|point| point.to_array()).collect()
}

/// Points of space of their coordinates, three each.
pub fn points(coordinates: &[f64]) -> impl Iterator<Item = DVec3> {
    coordinates.as_chunks().0.iter().map(|&point| DVec3::from_array(point))
}

/// A vector of three numbers.
pub fn vector(numbers: &[f64]) -> Result<DVec3> {
    let vector = numbers.try_into().map(DVec3::from_array);
    vector.map_err(|_| Failure::of("bad-shape", "a vector is three numbers"))
}

/// Refuses anything but one `what` for each source.
pub fn require_one_each(sources: usize, given: usize, what: &str) -> Result<()> {
    if sources == given {
        return Ok(());
    }
    Err(Failure::of("bad-shape", &format!("there are {sources} sources and {given} {what}")))
}
