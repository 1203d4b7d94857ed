//! Exact shortest paths, searched step by step.

use std::sync::Arc;

use heatwalk_surface::{Path, Source, SurfacePoint, ToPoint, ToSource};

use super::straighten::straighten;
use crate::error::{Error, Result};
use crate::exact::{self, ExactGeometry, PlaceDistances, Wavefront};
use crate::refinement;

/// A shortest path from a place to the source for which initial distance plus length is least, found by way of the exact distances of
/// vertices around it: as [`exact::shortest_path`], without a search from the sources.
///
/// # Errors
/// As [`exact::shortest_path`].
pub fn shortest(distances: &PlaceDistances<'_>, from: impl ToPoint) -> Result<Path> {
    let (geometry, sources) = distances.asked();
    let surface = geometry.surface();
    let from = from.to_point(surface)?;
    if let Some((points, length)) = distances.crossed(from.place()) {
        let path = straighten(surface, &Path::new(surface, points))?;
        if path.length() <= length {
            return Ok(path);
        }
    }
    exact::shortest_path(geometry, from, sources)
}

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
