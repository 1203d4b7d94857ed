//! What a wavefront of type `F` has where it starts from lines, beside sources. The page's module is small without this as long as nobody
//! asks for it.

use super::geometry::{ExactGeometry, Frame};

/// Lines, and what they have sent.
pub(super) trait Lines<F>: std::fmt::Debug + Send + Sync {
    /// Lets what waits at a half-edge enter its face.
    fn cross(&mut self, front: &mut F, geometry: &ExactGeometry, halfedge: u32);

    /// The face of a side's line.
    fn face(&self, side: u32) -> u32;

    /// The weights of the place of a side's line that is nearest to one of its face, which is laid out by its half-edge `k`.
    fn foot(&self, frame: &Frame, k: usize, side: u32, place: [f64; 2]) -> [f64; 3];
}
