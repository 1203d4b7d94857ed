//! The exact region: exact distances around the sources, where the heat method is off by 15 to 20 % on any mesh. Where faces
//! have different costs, it has those of refracted windows.

use std::borrow::Cow;

use crate::cost::Costs;
use crate::error::Result;
use crate::exact::Wavefront;
use crate::heat::constraint::Constraint;
use crate::options::ExactRadius;
use crate::propagation::Propagation;
use heatwalk_surface::{Source, Surface, VertexData, VertexId};

/// With several sources, a radius that work has cut short is rounded down to a power of this in mean edges, so that
/// moving or adding a source mostly leaves it, and with it the Schur columns kept from before. One needs none.
const RADIUS_STEP: f64 = 1.189_207_115_002_721; // the fourth root of 2

/// Windows that the exact region may propagate, times the fourth root of the number of vertices: beyond some rings it
/// gains little, and the finer the mesh, the less it may take of a solve.
const WINDOWS: f64 = 540.0;

/// Vertices below which that falls with their number, so that on small meshes, too, it takes at most about twice the time
/// of the rest of a solve.
const FEW_VERTICES: f64 = 5000.0;

/// Windows that it may propagate on any mesh: some dozen faces around a source, without which the first rings are worthless.
const LEAST_WINDOWS: f64 = 300.0;

/// Windows that the exact region may propagate where its radius is chosen.
fn windows(vertices: usize) -> usize {
    let vertices = vertices as f64;
    (WINDOWS * vertices.powf(0.25) * (vertices / FEW_VERTICES).min(1.0)).max(LEAST_WINDOWS) as usize
}

/// What grows outward from the sources.
pub(super) trait Outward {
    /// Grows until every value below `radius` is final, or about `work` windows have crossed a face.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    fn advance(&mut self, radius: f64, work: usize) -> Result<()>;

    /// Every value below this is final; infinity when all is done.
    fn radius(&self) -> f64;

    /// `#V`.
    fn values(&self) -> &VertexData<f64>;

    /// All vertices with a value, in any order.
    fn reached(&self) -> Cow<'_, [VertexId]>;
}

impl Outward for Wavefront {
    fn advance(&mut self, radius: f64, work: usize) -> Result<()> {
        self.advance(radius, work)?;
        Ok(())
    }

    fn radius(&self) -> f64 {
        if self.is_done() { f64::INFINITY } else { self.radius() }
    }

    fn values(&self) -> &VertexData<f64> {
        self.values()
    }

    fn reached(&self) -> Cow<'_, [VertexId]> {
        self.reached().into()
    }
}

impl Outward for Propagation {
    fn advance(&mut self, radius: f64, work: usize) -> Result<()> {
        self.advance(radius, work)?;
        Ok(())
    }

    fn radius(&self) -> f64 {
        self.radius()
    }

    fn values(&self) -> &VertexData<f64> {
        self.values()
    }

    fn reached(&self) -> Cow<'_, [VertexId]> {
        self.surface().vertices().filter(|&vertex| self.values()[vertex] < f64::INFINITY).collect()
    }
}

/// Exact distances around the sources: those of a wavefront that are below a radius.
pub(super) struct ExactRegion<'a> {
    distances: &'a VertexData<f64>,
    reached: Cow<'a, [VertexId]>,
    /// Every distance below it is in the region; infinite when all are.
    pub(super) radius: f64,
}

/// A triangle of which some corners are in the exact region.
pub(super) struct Touched {
    pub(super) corners: [u32; 3],
    /// Whether all are.
    pub(super) is_inside: bool,
}

impl<'a> ExactRegion<'a> {
    /// What a wavefront knows for certain: all where it is done, else what is below a radius.
    pub(super) fn of(front: &'a impl Outward, radius: f64) -> Self {
        let is_done = front.radius() == f64::INFINITY;
        let radius = if is_done { f64::INFINITY } else { radius.min(front.radius()) };
        Self { distances: front.values(), reached: front.reached(), radius }
    }

    /// A region without vertices; `distances` (`#V`) are not looked at.
    pub(super) fn none(distances: &'a VertexData<f64>) -> Self {
        Self { distances, reached: Cow::Borrowed(&[]), radius: f64::NEG_INFINITY }
    }

    /// The region of this radius around the sources that a wavefront starts from.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub(super) fn within(
        radius: ExactRadius,
        front: &'a mut impl Outward,
        sources: &[Source],
        mean_edge: f64,
    ) -> Result<Self> {
        let least = sources.iter().map(|source| source.initial_distance()).fold(f64::INFINITY, f64::min);
        Ok(match radius {
            ExactRadius::Edges(0.0) => Self { distances: front.values(), reached: front.reached(), radius: least },
            ExactRadius::Edges(edges) => {
                let radius = least + edges * mean_edge;
                front.advance(radius, usize::MAX)?;
                Self::of(front, radius)
            }
            ExactRadius::Automatic => {
                front.advance(f64::INFINITY, windows(front.values().len()))?;
                if sources.len() == 1 {
                    return Ok(Self::of(front, f64::INFINITY));
                }
                let steps = ((front.radius() - least) / mean_edge).log(RADIUS_STEP).floor();
                Self::of(front, least + mean_edge * RADIUS_STEP.powf(steps))
            }
        })
    }

    /// The distance of a vertex, if it is in the region.
    pub(super) fn value(&self, vertex: u32) -> Option<f64> {
        Some(self.distances[VertexId(vertex)]).filter(|&distance| distance < self.radius)
    }

    /// The vertices of the region with their distances.
    pub(super) fn values(&self) -> impl Iterator<Item = (u32, f64)> + '_ {
        self.reached.iter().filter_map(|&vertex| Some((vertex.0, self.value(vertex.0)?)))
    }

    /// Sets the region's distances among those of all vertices (`#V`).
    pub(super) fn write(&self, distances: &mut [f64]) {
        for (vertex, distance) in self.values() {
            distances[vertex as usize] = distance;
        }
    }

    /// Distances (`#V`) in the region and at sources that it does not contain, infinite elsewhere.
    pub(super) fn known(&self, surface: &Surface, costs: Option<&Costs>, sources: &[Source]) -> Vec<f64> {
        let mut known = vec![f64::INFINITY; surface.vertex_count()];
        self.write(&mut known);
        for source in sources {
            let place = source.place();
            let position = place.position(surface);
            let least = |costs: &Costs| {
                place.faces(surface).into_iter().map(|face| costs.of(face)).fold(f64::INFINITY, f64::min)
            };
            let cost = costs.map_or(1.0, least);
            for (vertex, _) in place.support(surface) {
                let distance = source.initial_distance() + cost * position.distance(surface.position(vertex));
                let known = &mut known[vertex.0 as usize];
                *known = known.min(distance);
            }
        }
        known
    }

    /// What distance beyond the region has to meet: on the rim of each patch of the region the mean of the exact
    /// distances, and the initial distances of sources that no patch contains.
    pub(super) fn constraints(&self, surface: &Surface, touched: &[Touched], sources: &[Source]) -> Vec<Constraint> {
        let touched = touched.iter().map(|triangle| (triangle.corners, triangle.is_inside));
        let mut constraints = Constraint::of_rims(surface.vertex_count(), touched, |vertex| self.value(vertex));
        let is_beyond =
            |source: &&Source| source.place().support(surface).any(|(vertex, _)| self.value(vertex.0).is_none());
        let at_source = |source: &Source| Constraint::new(source.place().support(surface), source.initial_distance());
        constraints.extend(sources.iter().filter(is_beyond).map(at_source));
        constraints
    }
}
