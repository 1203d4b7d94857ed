//! The exact region of a surface. Where faces have different costs, it has the distances of refracted windows.

use std::borrow::Cow;

use heatwalk_surface::{VertexData, VertexId};

use crate::error::Result;
use crate::exact::Wavefront;
use crate::heat::point_source::PointSource;
use crate::heat::region::{ExactRegion, grow};
use crate::options::ExactRadius;
use crate::propagation::Propagation;

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
pub(in crate::heat) trait Outward {
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

/// What a search knows for certain: all where it is done, else what is below a radius.
pub(in crate::heat) fn region_of(front: &impl Outward, radius: f64) -> ExactRegion<'_> {
    let is_done = front.radius() == f64::INFINITY;
    let radius = if is_done { f64::INFINITY } else { radius.min(front.radius()) };
    ExactRegion::new(front.values().as_slice(), front.reached(), radius)
}

/// The region of this radius around the sources that a search starts from.
///
/// # Errors
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
pub(in crate::heat) fn region_within<'a>(
    radius: ExactRadius,
    front: &'a mut impl Outward,
    sources: &[PointSource],
    mean_edge: f64,
) -> Result<ExactRegion<'a>> {
    let work = windows(front.values().len());
    let radius = grow(radius, sources, mean_edge, work, |radius, work| {
        front.advance(radius, work)?;
        Ok(front.radius())
    })?;
    Ok(ExactRegion::new(front.values().as_slice(), front.reached(), radius))
}
