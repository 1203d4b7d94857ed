//! Distances that become exact step by step, from the sources outward.

use std::sync::Arc;

use heatwalk_surface::{ToSource, VertexId, memory};

use crate::distance::Distance;
use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};
use crate::extremum::smaller;

/// What is being done where memory does not suffice.
const STAGE: &str = "refining to exact distances";

/// Bytes that a wavefront takes before it has any windows, a face.
const BYTES_PER_FACE: u64 = 96;

/// Refuses exact distances where there is no room to start them.
///
/// # Errors
/// [`OutOfMemory`](crate::Error::OutOfMemory).
pub(crate) fn require_room(geometry: &ExactGeometry) -> Result<()> {
    Ok(memory::require(BYTES_PER_FACE * geometry.surface().face_count() as u64, STAGE)?)
}

/// Starts exact distances, where there is room for them.
///
/// # Errors
/// [`OutOfMemory`](crate::Error::OutOfMemory); those of [`ToSource::to_source`].
pub(crate) fn start<S: ToSource>(geometry: &Arc<ExactGeometry>, sources: &[S]) -> Result<Wavefront> {
    require_room(geometry)?;
    Wavefront::new(Arc::clone(geometry), sources)
}

/// Propagates about `work` windows further, where there is room for as much again as is held: memory that is refused while
/// windows are propagated ends the search.
///
/// # Errors
/// [`OutOfMemory`](crate::Error::OutOfMemory).
pub(crate) fn advance(front: &mut Wavefront, work: usize) -> Result<()> {
    memory::require(front.pending_bytes() as u64, STAGE)?;
    front.advance(f64::INFINITY, work)?;
    Ok(())
}

/// Lengths of paths, as [propagation](crate::propagation) gives them, that become exact step by step.
#[derive(Debug)]
pub struct PropagationRefinement {
    front: Wavefront,
    /// Beyond the exact ones.
    lengths: Distance,
}

impl PropagationRefinement {
    /// Begins to make a distance from these sources exact.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory); those of [`ToSource::to_source`].
    pub fn new<S: ToSource>(geometry: &Arc<ExactGeometry>, sources: &[S], lengths: Distance) -> Result<Self> {
        Ok(Self { front: start(geometry, sources)?, lengths })
    }

    /// Propagates about `work` windows further and gives the distance that is known then: exact within the radius that
    /// they have reached, beyond it the shorter of two paths.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn step(&mut self, work: usize) -> Result<Distance> {
        advance(&mut self.front, work)?;
        let (radius, found) = (self.front.radius(), self.front.values());
        let shorter = |vertex: VertexId| {
            let value = found[vertex];
            if value < radius { value } else { smaller(value, self.lengths.values[vertex]) }
        };
        let values = self.front.surface().vertices().map(shorter).collect();
        let mut crossings = self.front.geometry().portals().crossings(|end| self.front.entered(end));
        crossings.retain(|crossing| crossing.distance < radius);
        crossings.extend(self.lengths.crossings.iter().filter(|crossing| crossing.distance >= radius));
        let distance = Distance::of_paths(self.front.surface(), values, self.front.sources(), radius);
        Ok(Distance { heat: self.lengths.heat.clone(), ..distance.crossing(crossings) })
    }

    /// Whether every distance is exact.
    pub fn is_done(&self) -> bool {
        self.front.is_done()
    }
}
