//! Paths of answers, and between two places.

use std::sync::Arc;

use glam::DVec3;
use heatwalk_sparse::Progress;
use heatwalk_surface::{Path, Source, SurfacePoint, ToPoint};

use super::{Answer, DistanceOptions, DistanceSolver};
use crate::error::{Error, Result};
use crate::exact::{self, PlaceDistances};
use crate::options::{Method, PathKind};
use crate::path::{PathSearch, descend, descend_corners, refract, shortest, straighten};
use crate::propagation::{REFRACTED, Windows};

impl DistanceSolver {
    /// The path from a place to its nearest source of an answer. Where all its distances are exact, a straightened path is the shortest one.
    /// Where faces have different costs, no path is known to be exact: all but the descent are refracted there, and where the distance
    /// tells of a cheaper path, so is the way from corner to corner by which the distance is least.
    ///
    /// # Errors
    /// As [`descend`]; for [`PathKind::Exact`] as [`exact::shortest_path`].
    pub fn path(&mut self, answer: &Answer, from: impl ToPoint, kind: PathKind) -> Result<Path> {
        let surface = &*self.surface;
        let descent = || descend(surface, &answer.distance, from);
        match (kind, self.several_costs()) {
            (PathKind::Descent, _) => descent(),
            (PathKind::Straightened | PathKind::Exact, Some(costs)) => {
                let path = refract(surface, costs, &descent()?)?;
                let distance = self.along(answer, &path);
                if distance <= answer.distance.at(surface, from)? {
                    return Ok(path);
                }
                // Paths of locally least cost differ by the sides on which they go around what is dear.
                let by_corners = match descend_corners(surface, &answer.distance, from) {
                    Err(Error::Unreachable) => return Ok(path),
                    found => found?,
                };
                let other = refract(surface, costs, &by_corners)?;
                Ok(if self.along(answer, &other) < distance { other } else { path })
            }
            (PathKind::Straightened | PathKind::Exact, None) if answer.is_exact() => {
                let distances = self.place_distances(answer)?.expect("all distances are exact");
                shortest(&distances, from)
            }
            (PathKind::Straightened, None) => straighten(surface, &descent()?),
            (PathKind::Exact, None) => exact::shortest_path(self.exact_geometry(), from, &answer.sources),
        }
    }

    /// The distance at a place: exact where all those of the answer are. Where costs differ it is that along the
    /// [path](Self::path) from there, unless it is by heat; else it is interpolated in the face. Infinite where no source reaches.
    ///
    /// # Errors
    /// As [`Distance::at`](crate::Distance::at) and [`Self::path`].
    pub fn at(&mut self, answer: &Answer, place: impl ToPoint) -> Result<f64> {
        if let Some(distances) = self.place_distances(answer)? {
            return distances.at(place);
        }
        let interpolated = answer.distance.at(&self.surface, place)?;
        if self.several_costs().is_none() || answer.method == Method::Heat || interpolated.is_infinite() {
            return Ok(interpolated);
        }
        let path = self.path(answer, place, PathKind::Straightened)?;
        Ok(self.along(answer, &path))
    }

    /// The distance where a path to a source of an answer begins: what it costs, and the initial distance where it ends.
    fn along(&self, answer: &Answer, path: &Path) -> f64 {
        let end = path.points.last().map_or(DVec3::ZERO, |point| point.position);
        let nearest = answer.sources.iter().min_by(|one, other| {
            let away = |source: &Source| source.place().position(&self.surface).distance_squared(end);
            away(one).total_cmp(&away(other)).then(one.initial_distance().total_cmp(&other.initial_distance()))
        });
        self.cost_of(path) + nearest.map_or(0.0, Source::initial_distance)
    }

    /// What a path on the surface costs: its length where all costs are 1.
    pub fn cost_of(&self, path: &Path) -> f64 {
        self.costs().map_or_else(|| path.length(), |costs| costs.of_path(&self.surface, path))
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
