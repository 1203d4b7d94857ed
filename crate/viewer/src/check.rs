//! Checks of what the page hands over. They are called from many places, and each copy would be downloaded.

use glam::Vec3;

use crate::error::Error;

/// Largest coordinate that is drawn, either way: fourth powers of lengths, as in squared areas, stay far from the largest
/// single-precision number.
const LARGEST_COORDINATE: f32 = 1e8;

/// Every place must be a finite one that single precision can calculate with.
#[inline(never)]
pub(crate) fn places(what: &'static str, places: &[Vec3]) -> Result<(), Error> {
    match places.iter().position(|place| !(place.abs().max_element() <= LARGEST_COORDINATE && place.is_finite())) {
        None => Ok(()),
        Some(index) if places[index].is_finite() => Err(Error::OutOfRange { what, index }),
        Some(index) => Err(Error::NotFinite { what, index }),
    }
}

/// Every vector must be finite.
#[inline(never)]
pub(crate) fn vectors(what: &'static str, vectors: &[Vec3]) -> Result<(), Error> {
    match vectors.iter().position(|vector| !vector.is_finite()) {
        None => Ok(()),
        Some(index) => Err(Error::NotFinite { what, index }),
    }
}

/// One vector a place.
#[inline(never)]
pub(crate) fn same_length(what: &'static str, places: &[Vec3], vectors: &[Vec3]) -> Result<(), Error> {
    if places.len() == vectors.len() {
        return Ok(());
    }
    Err(Error::WrongLength { what, expected: 3 * places.len(), found: 3 * vectors.len() })
}

/// Every corner of a triangle must be a vertex.
#[inline(never)]
pub(crate) fn corners(triangles: &[[u32; 3]], vertex_count: usize) -> Result<(), Error> {
    let corners = triangles.as_flattened();
    match corners.iter().position(|&vertex| vertex as usize >= vertex_count) {
        None => Ok(()),
        Some(at) => Err(Error::VertexOutOfRange { triangle: at / 3, vertex: corners[at], vertex_count }),
    }
}

/// Triangles with a normal at each vertex.
#[inline(never)]
pub(crate) fn mesh(positions: &[Vec3], normals: &[Vec3], triangles: &[[u32; 3]]) -> Result<(), Error> {
    same_length("normals", positions, normals)?;
    places("positions", positions)?;
    vectors("normals", normals)?;
    corners(triangles, positions.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_finite_and_of_moderate_size() {
        assert!(places("places", &[Vec3::splat(-LARGEST_COORDINATE), Vec3::ZERO]).is_ok());
        let refused = |place| places("places", &[Vec3::ONE, place]).expect_err("a place that cannot be drawn");
        assert!(matches!(refused(Vec3::new(0.0, 1e25, 0.0)), Error::OutOfRange { index: 1, .. }));
        for spoil in [f32::NAN, f32::NEG_INFINITY] {
            assert!(matches!(refused(Vec3::new(spoil, 0.0, 1e25)), Error::NotFinite { index: 1, .. }));
        }
        assert!(vectors("normals", &[Vec3::splat(1e25)]).is_ok());
        assert!(vectors("normals", &[Vec3::ZERO, Vec3::NAN]).is_err());
        assert!(same_length("normals", &[Vec3::ZERO; 2], &[Vec3::ZERO]).is_err());
        let refused = corners(&[[0, 1, 2], [2, 3, 1]], 3).expect_err("a vertex that is not there");
        assert!(matches!(refused, Error::VertexOutOfRange { triangle: 1, vertex: 3, vertex_count: 3 }));
    }
}
