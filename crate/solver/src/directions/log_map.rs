//! The log map.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use heatwalk_sparse::{Progress, c64};
use heatwalk_surface::{ToPoint, VertexData};

use super::plane::Plane;
use super::searched;
use crate::error::Result;
use crate::exact::ExactGeometry;

/// Where the normal is nearer to the x axis than 45°, directions are measured from the y axis unless another direction is given.
const STEEP: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Where shortest paths from a source lead to: their lengths, in the directions in which they leave it.
#[derive(Debug, Clone, PartialEq)]
pub struct LogMap {
    /// `#V`, in the file's unit: as long as the distance, u along the direction that was asked for, v to its left as seen from outside. Not
    /// numbers where the source does not reach.
    pub coordinates: VertexData<DVec2>,
    /// `#V`, the exact distance, in the file's unit; infinite where the source does not reach.
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
    let surface = geometry.surface();
    let place = source.to_point(surface)?;
    let plane = Plane::at(geometry, place.place())?;
    let direction = direction.unwrap_or(if plane.normal().x.abs() > STEEP { DVec3::Y } else { DVec3::X });
    let u = plane.number("the direction", direction)?;
    let u = u / u.norm();
    let front = searched(geometry, &[place], progress)?;
    let mut directions = vec![c64::new(f64::NAN, f64::NAN); surface.vertex_count() + front.end_values().len()];
    front.for_each_leg(|stop, leg| {
        directions[stop] = match front.start_of_leg(leg) {
            None => c64::cis(plane.angle(&leg.departure)) * u.conj(),
            Some(start) => directions[start],
        };
    })?;
    let distances = front.into_values();
    let coordinates = directions
        .iter()
        .zip(&distances)
        .map(|(direction, &distance)| distance * DVec2::new(direction.re, direction.im));
    let coordinates = coordinates.collect();
    Ok(LogMap { coordinates, distances, axes: [plane.vector(u), plane.vector(u * c64::new(0.0, 1.0))] })
}
