//! Memory that a mesh takes, told before any of it is taken.

use crate::error::{Error, Result};
use crate::options::DEFAULT_WINDOWS;

/// Bytes that a surface keeps of each vertex of the input, each welded vertex and each triangle.
const SURFACE: Bytes = Bytes { input: 8, vertex: 45, triangle: 60 };
/// What windows need of the surface: triangles in the plane, and how paths bend at vertices.
const GEOMETRY: Bytes = Bytes { input: 0, vertex: 1, triangle: 96 };
/// The exact search around the sources, the front beyond it, and the field with its directions.
const SEARCH: Bytes = Bytes { input: 0, vertex: 105, triangle: 42 };
/// What propagation knows of each stretch of a half-edge. The windows that wait are few beside.
const WINDOW: Bytes = Bytes { input: 0, vertex: 0, triangle: 24 };

#[derive(Clone, Copy)]
struct Bytes {
    input: u64,
    vertex: u64,
    triangle: u64,
}

/// Most bytes in use at once from the vertices and triangles of a file to the first distance by so many windows of each
/// half-edge; by none, those of a surface that is only factored, without its factors. The surface is taken to be closed, or
/// nearly: one in loose triangles has up to six times as many vertices.
pub fn footprint(vertices: usize, triangles: usize, windows: u16) -> u64 {
    let (input, triangles) = (vertices as u64, triangles as u64);
    let welded = input.min(triangles / 2 + 2);
    let bytes = |of: Bytes| of.input * input + of.vertex * welded + of.triangle * triangles;
    bytes(SURFACE) + bytes(GEOMETRY) + bytes(SEARCH) + u64::from(windows) * bytes(WINDOW)
}

/// Refuses a mesh whose [`footprint`] is larger than the memory there is.
///
/// # Errors
/// [`Error::MeshTooLarge`] where not even one window of each half-edge would fit; [`Error::TooManyWindows`].
pub fn require_room(vertices: usize, triangles: usize, windows: u16, available_bytes: u64) -> Result<()> {
    let needed_bytes = footprint(vertices, triangles, windows);
    let least_bytes = footprint(vertices, triangles, windows.min(DEFAULT_WINDOWS));
    if least_bytes > available_bytes {
        Err(Error::MeshTooLarge { triangles, needed_bytes: least_bytes, available_bytes })
    } else if needed_bytes > available_bytes {
        Err(Error::TooManyWindows { triangles, windows, needed_bytes, available_bytes })
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::TRIANGLE_BYTES;

    #[test]
    fn a_triangle_takes_what_the_page_reckons_with() {
        let triangles = 2_000_000;
        let reckoned = u64::from(TRIANGLE_BYTES) * triangles as u64;
        let taken = footprint(triangles / 2 + 2, triangles, DEFAULT_WINDOWS);
        assert!(taken <= reckoned && 10 * taken > 9 * reckoned, "{taken} bytes, {reckoned} reckoned");
    }

    #[test]
    fn what_does_not_fit_is_refused_and_fewer_windows_are_offered_where_they_do() {
        let (vertices, triangles) = (1_000_002, 2_000_000);
        let [one, eight] = [1, 8].map(|windows| footprint(vertices, triangles, windows));
        assert!(require_room(vertices, triangles, 8, eight).is_ok());
        let refused = require_room(vertices, triangles, 8, eight - 1).expect_err("one byte less");
        assert_eq!(refused.code(), "too-many-windows");
        assert!(
            refused.to_string().starts_with("8 windows of each half-edge of 2000000 triangles take 895"),
            "{refused}"
        );
        assert!(require_room(vertices, triangles, 1, one).is_ok());
        for windows in [0, 1, 8] {
            let available = footprint(vertices, triangles, windows.min(1)) - 1;
            let refused = require_room(vertices, triangles, windows, available).expect_err("one byte less");
            assert_eq!(refused.code(), "mesh-too-large");
        }
    }
}
