//! What goes on from an exact search.

use std::fmt;

use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};
use crate::extremum::smaller;
use heatwalk_surface::{FaceId, Source, Surface, VertexData, VertexId};

/// Number of the source of a vertex that has not been reached.
pub(super) const NOWHERE: u32 = u32::MAX;

/// Items of a queue that are processed together.
pub(super) const BATCH: usize = 32;

/// What grows outward, however that is carried.
pub(super) trait Grow: Send + Sync {
    /// Goes on, alone, from where an exact search has come to.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    fn start(&mut self, exact: &Wavefront) -> Result<()>;

    /// Goes on, alone, from sources.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    fn start_at(&mut self, sources: &[Source]) -> Result<()>;

    /// Grows until every value below `radius` is final (by vertices alone, or seldom falls), or faces were crossed about `work` times.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory); then it does not grow until it starts anew.
    fn advance(&mut self, radius: f64, work: usize) -> Result<()>;

    /// Every value below this is final, as in [`advance`](Self::advance); infinity when all is done.
    fn radius(&self) -> f64;

    /// `#V`, distances from the sources.
    fn values(&self) -> &VertexData<f64>;

    /// Number of the source that a vertex's value comes from, [`NOWHERE`] where it has not been reached.
    fn nearest(&self, vertex: VertexId) -> u32;

    /// The distance at an end of a portal that paths reach through it.
    fn entered(&self, end: u32) -> Option<f64>;

    /// How often faces were crossed.
    fn crossed(&self) -> usize;
}

/// Not its windows, which are millions, and whose formatting would be part of every program that links a front.
impl fmt::Debug for dyn Grow {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let mut front = formatter.debug_struct("Front");
        front.field("radius", &self.radius()).field("crossed", &self.crossed()).finish_non_exhaustive()
    }
}

/// The least initial distance.
pub(super) fn nearest_start(sources: &[Source]) -> f64 {
    sources.iter().map(|source| source.initial_distance()).fold(f64::INFINITY, smaller)
}

/// The places in faces that sources light, by barycentric weights, each with its initial distance and the number of its source.
pub(super) fn lights(
    geometry: &ExactGeometry,
    surface: &Surface,
    sources: &[Source],
) -> impl Iterator<Item = ((u32, [f64; 3]), f64, u32)> {
    (0..).zip(sources).flat_map(|(number, source)| {
        let places = geometry.faces_at(surface, source.place());
        places.into_iter().map(move |at| (at, source.initial_distance(), number))
    })
}

/// Reads what the faces around some vertices have, so that the processor waits for all of it at once instead of for one
/// after another.
pub(super) fn fetch_around(geometry: &ExactGeometry, surface: &Surface, vertices: impl Iterator<Item = u32> + Clone) {
    let first_faces = vertices.clone().filter_map(|vertex| surface.corners_of_vertex(VertexId(vertex)).next());
    std::hint::black_box(first_faces.fold(0, |sum, (face, _)| sum ^ face.0));
    let faces = vertices.flat_map(|vertex| surface.corners_of_vertex(VertexId(vertex)));
    let lengths = |face: FaceId| [0, 2].map(|k| geometry.frame(face.0)[k].length).iter().sum::<f64>();
    std::hint::black_box(faces.map(|(face, _)| lengths(face)).sum::<f64>());
}
