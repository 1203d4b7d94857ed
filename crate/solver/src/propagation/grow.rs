//! What goes on from an exact search.

use std::collections::HashMap;
use std::fmt;

use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};
use crate::extremum::smaller;
use heatwalk_surface::{Element, FaceId, Place, Source, Surface, VertexData, VertexId};

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
/// Of sources at one place that is in many faces, the first that starts nearest lights these alone.
pub(super) fn lights(
    geometry: &ExactGeometry,
    surface: &Surface,
    sources: &[Source],
) -> impl Iterator<Item = ((u32, [f64; 3]), f64, u32)> {
    let mut first_at: HashMap<Spot, usize> = HashMap::new();
    for (number, source) in sources.iter().enumerate() {
        let Some(spot) = spot(surface, source.place()) else { continue };
        let first = first_at.entry(spot).or_insert(number);
        if source.initial_distance() < sources[*first].initial_distance() {
            *first = number;
        }
    }
    let is_first = move |number: usize, place: Place| spot(surface, place).is_none_or(|spot| first_at[&spot] == number);
    let lighting = sources.iter().enumerate().filter(move |&(number, source)| is_first(number, source.place()));
    lighting.flat_map(|(number, source)| {
        let places = geometry.faces_at(surface, source.place());
        places.into_iter().map(move |at| (at, source.initial_distance(), number as u32))
    })
}

/// Two vertices, the lower number first, and the bits of the share of the way between them.
type Spot = ([VertexId; 2], u64);

/// What tells a place in many faces from others: at a vertex, or on an edge of three faces or more.
fn spot(surface: &Surface, place: Place) -> Option<Spot> {
    match place.reduced(surface) {
        Place::Vertex(vertex) => Some(([vertex; 2], 0)),
        Place::Edge { halfedge, fraction } if halfedge.index() < 3 * surface.face_count() => {
            let [a, b] = surface.ends(halfedge);
            let spot = if a < b { ([a, b], fraction.to_bits()) } else { ([b, a], (1.0 - fraction).to_bits()) };
            surface.edges().is_branching(halfedge).then_some(spot)
        }
        _ => None,
    }
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
