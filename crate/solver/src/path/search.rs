//! Exact shortest paths, searched step by step.

use std::sync::Arc;

use heatwalk_surface::{Path, Source, SurfacePoint, ToPoint, ToSource};

use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, Wavefront};
use crate::refinement;

/// The search for a shortest path, as [`exact::shortest_path`](crate::exact::shortest_path), which can be interrupted.
#[derive(Debug)]
pub struct PathSearch {
    from: SurfacePoint,
    front: Wavefront,
}

impl PathSearch {
    /// Begins at the sources.
    ///
    /// # Errors
    /// [`Error::NoSource`]; [`Error::OutOfMemory`]; those of [`ToSource::to_source`] and [`ToPoint::to_point`].
    pub fn new<S: ToSource>(geometry: &Arc<ExactGeometry>, from: impl ToPoint, sources: &[S]) -> Result<Self> {
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        refinement::require_room(geometry)?;
        let from = from.to_point(geometry.surface())?;
        Ok(Self { from, front: Wavefront::with_targets(Arc::clone(geometry), sources, &[from])? })
    }

    /// Whether it is the search from this place to these sources on this geometry.
    pub(crate) fn is_of(&self, geometry: &Arc<ExactGeometry>, from: SurfacePoint, sources: &[Source]) -> bool {
        Arc::ptr_eq(self.front.geometry(), geometry) && self.from == from && self.front.sources() == sources
    }

    /// Propagates about `work` windows further. Gives the path once no other can be shorter.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`]; [`Error::Unreachable`].
    pub fn step(&mut self, work: usize) -> Result<Option<Path>> {
        refinement::advance(&mut self.front, work)?;
        let is_found = self.front.is_done() || self.front.radius() > self.front.target_values()[0];
        is_found.then(|| self.front.path_from_target(0)).transpose()
    }
}
