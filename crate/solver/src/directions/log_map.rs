//! The log map.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use heatwalk_sparse::{Progress, c64};
use heatwalk_surface::{ToPoint, VertexData};

use super::plane::Plane;
use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};

/// Where shortest paths from a source lead to: their lengths, in the directions in which they leave it.
#[derive(Debug, Clone, PartialEq)]
pub struct LogMap {
    /// `#V`, in the file's unit: as long as the distance, u along the direction that was asked for, v to its left as seen from outside. Not
    /// numbers where the source does not reach.
    pub coordinates: VertexData<DVec2>,
    /// `#V`, the lengths of the coordinates, along exact paths the exact distance; infinite where the source does not reach.
    pub distances: VertexData<f64>,
    /// Unit vectors in space along u and v, at the source.
    pub axes: [DVec3; 2],
}

/// The log map from a point of the surface: for each vertex, the direction in which an exact shortest path leaves the source, and its
/// length.
///
/// `direction` is a vector in space, of any length, whose part along the surface is u; without it, u is along the x axis, or the y axis where the normal
/// at the source is nearer than 45° to the x axis. Angles at a vertex are scaled to sum to 2π, but not at a boundary. Where a path bends, at vertices
/// with more than a full angle and at boundaries, it keeps the direction in which it left the source; so it does across bridges.
///
/// # Errors
/// [`Error::BadParameter`](crate::Error::BadParameter) for a direction that is zero, not finite or square to the surface, and for a source where the surface has no tangent
/// plane, as on edges of three faces; [`Error::NotExact`](crate::Error::NotExact) where faces have different costs; those of [`ToPoint::to_point`];
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory); [`Error::Cancelled`](crate::Error::Cancelled).
pub fn log_map(
    geometry: &Arc<ExactGeometry>,
    source: impl ToPoint,
    direction: Option<DVec3>,
    progress: Progress<'_>,
) -> Result<LogMap> {
    let mut search = LogMapSearch::new(geometry, source)?;
    // A direction that there is not is told before anything is searched.
    let u = search.plane.first_axis(direction)?;
    search.front.grow(f64::INFINITY, progress)?;
    search.map_along(u)
}

/// The log map from a point of the surface, found as far as it is asked for: the search goes on from where it was.
#[derive(Debug)]
pub struct LogMapSearch {
    front: Wavefront,
    plane: Plane,
}

impl LogMapSearch {
    /// Starts at a point of the surface.
    ///
    /// # Errors
    /// As [`log_map`].
    pub fn new(geometry: &Arc<ExactGeometry>, source: impl ToPoint) -> Result<Self> {
        let place = source.to_point(geometry.surface())?;
        let plane = Plane::at(geometry, place.place())?;
        Ok(Self { front: Wavefront::new(Arc::clone(geometry), &[place])?, plane })
    }

    /// Goes on to a distance, or until about `work` more windows have crossed a face. Whether it has come as far.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn advance(&mut self, radius: f64, work: usize) -> Result<bool> {
        self.front.advance(radius, work)
    }

    /// `#V`, distances, which are final where they are below the distance that it has come to.
    pub fn distances(&self) -> &VertexData<f64> {
        self.front.values()
    }

    /// The log map of what it has come to; beyond that coordinates are not numbers and distances infinite.
    ///
    /// # Errors
    /// As [`log_map`].
    pub fn map(&self, direction: Option<DVec3>) -> Result<LogMap> {
        self.map_along(self.plane.first_axis(direction)?)
    }

    fn map_along(&self, u: c64) -> Result<LogMap> {
        let radius = self.front.radius();
        let directions = departures(&self.front, &self.plane, u, radius)?;
        let known = |&distance: &f64| if distance < radius { distance } else { f64::INFINITY };
        let distances: VertexData<f64> = self.front.values().iter().map(known).collect();
        let at = |(direction, &distance): (&c64, &f64)| match distance.is_finite() {
            true => distance * DVec2::new(direction.re, direction.im),
            false => DVec2::NAN,
        };
        let coordinates = directions.iter().zip(&distances).map(at).collect();
        Ok(LogMap { coordinates, distances, axes: self.plane.axes(u) })
    }
}

/// The directions in which exact paths shorter than `below` leave their source, whose plane this is, relative to u: of vertices, then of the
/// ends of portals; not numbers elsewhere.
pub(super) fn departures(front: &Wavefront, plane: &Plane, u: c64, below: f64) -> Result<Vec<c64>> {
    let mut directions = vec![c64::new(f64::NAN, f64::NAN); front.values().len() + front.end_values().len()];
    front.for_each_leg(below, |stop, leg| {
        directions[stop] = match front.start_of_leg(leg) {
            None => c64::cis(plane.angle(&leg.departure)) * u.conj(),
            Some(start) => directions[start],
        };
    })?;
    Ok(directions)
}
