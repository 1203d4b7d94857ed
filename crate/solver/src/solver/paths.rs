//! Paths of answers, and between two places.

use std::sync::Arc;

use heatwalk_sparse::Progress;
use heatwalk_surface::{Path, Source, SurfacePoint, ToPoint};

use super::{Answer, DistanceOptions, DistanceSolver};
use crate::error::Result;
use crate::exact::{self, PlaceDistances};
use crate::options::{Method, PathKind};
use crate::path::{PathSearch, descend, descend_corners, refract, shortest, straighten};
use crate::propagation::{REFRACTED, Windows};

impl DistanceSolver {
    /// The path from a place to its nearest source of an answer. Where all its distances are exact, a straightened path is the shortest one.
    /// Where faces have different costs, no path is known to be exact: all but the descent are refracted there.
    ///
    /// # Errors
    /// As [`descend`]; for [`PathKind::Exact`] as [`exact::shortest_path`].
    pub fn path(&mut self, answer: &Answer, from: impl ToPoint, kind: PathKind) -> Result<Path> {
        let surface = &*self.surface;
        let descent = || descend(surface, &answer.distance, from);
        match (kind, self.several_costs()) {
            (PathKind::Descent, _) => descent(),
            (PathKind::Straightened | PathKind::Exact, Some(costs)) => {
                // Paths of locally least cost differ by the sides on which they go around what is dear. Where the distance tells
                // of a cheaper one, another is tried.
                let path = refract(surface, costs, &descent()?)?;
                let cost = costs.of_path(surface, &path);
                let distance = surface.point(from)?.place().interpolate(surface, &answer.distance.values);
                if cost <= distance {
                    return Ok(path);
                }
                let other = refract(surface, costs, &descend_corners(surface, &answer.distance, from)?)?;
                Ok(if costs.of_path(surface, &other) < cost { other } else { path })
            }
            (PathKind::Straightened | PathKind::Exact, None) if answer.is_exact() => {
                let distances = self.place_distances(answer)?.expect("all distances are exact");
                shortest(&distances, from)
            }
            (PathKind::Straightened, None) => straighten(surface, &descent()?),
            (PathKind::Exact, None) => exact::shortest_path(self.exact_geometry(), from, &answer.sources),
        }
    }

    /// A path between two places that is locally shortest, or of locally least cost where costs differ, by few windows.
    ///
    /// # Errors
    /// As [`Self::distance`] and [`descend`].
    pub fn path_between(&mut self, from: SurfacePoint, to: SurfacePoint, progress: Progress<'_>) -> Result<Path> {
        let windows = if self.several_costs().is_some() { REFRACTED } else { Windows::default() };
        let options = DistanceOptions { windows, ..DistanceOptions::by(Method::Propagation) };
        let answer = self.distance(&[Source::from(to)], &options, progress)?;
        self.path(&answer, from, PathKind::Straightened)
    }

    /// Searches the exact path from a place to the nearest of some sources by about `work` windows further; `None` until it is found. The
    /// search is kept in `begun`, and begins anew where that is another one or the ground has changed.
    ///
    /// # Errors
    /// As [`PathSearch::new`] and [`PathSearch::step`].
    pub fn search_path(
        &mut self,
        begun: &mut Option<PathSearch>,
        from: SurfacePoint,
        sources: &[Source],
        work: usize,
    ) -> Result<Option<Path>> {
        let geometry = self.exact_geometry();
        let mut search = match begun.take().filter(|search| search.is_of(geometry, from, sources)) {
            Some(search) => search,
            None => PathSearch::new(geometry, from, sources)?,
        };
        let path = search.step(work)?;
        *begun = Some(search).filter(|_| path.is_none());
        Ok(path)
    }

    /// The exact distances of an answer at any place; `None` where not all distances of vertices are exact.
    ///
    /// # Errors
    /// As [`PlaceDistances::new`].
    pub fn place_distances<'a>(&'a mut self, answer: &'a Answer) -> Result<Option<PlaceDistances<'a>>> {
        if !answer.is_exact() {
            return Ok(None);
        }
        let geometry: &'a Arc<_> = self.exact_geometry();
        PlaceDistances::new(geometry, &answer.distance.values, &answer.sources).map(Some)
    }
}
