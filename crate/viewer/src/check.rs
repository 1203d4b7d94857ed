//! Checks of what the page hands over.

use glam::Vec3;

use crate::error::Error;

/// Largest coordinate that is drawn, either way: fourth powers of lengths, as in squared areas, stay far from the largest
/// single-precision number.
const LARGEST_COORDINATE: f32 = 1e8;

/// Every place must be a finite one that single precision can calculate with.
pub(crate) fn places(what: &'static str, places: &[Vec3]) -> Result<(), Error> {
    match places.iter().position(|place| !(place.abs().max_element() <= LARGEST_COORDINATE && place.is_finite())) {
        None => Ok(()),
        Some(index) if places[index].is_finite() => Err(Error::OutOfRange { what, index }),
        Some(index) => Err(Error::NotFinite { what, index }),
    }
}

/// Every vector must be finite.
pub(crate) fn vectors(what: &'static str, vectors: &[Vec3]) -> Result<(), Error> {
    match vectors.iter().position(|vector| !vector.is_finite()) {
        None => Ok(()),
        Some(index) => Err(Error::NotFinite { what, index }),
    }
}

/// One vector a place.
pub(crate) fn same_length(what: &'static str, places: &[Vec3], vectors: &[Vec3]) -> Result<(), Error> {
    if places.len() == vectors.len() {
        return Ok(());
    }
    Err(Error::WrongLength { what, expected: 3 * places.len(), found: 3 * vectors.len() })
}
