//! The log map by propagation.

use std::sync::Arc;

use glam::{DVec2, DVec3};
use heatwalk_base::sort;
use heatwalk_sparse::{Progress, Stage, c64, report};
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element, ToPoint, VertexData, VertexId};

use super::log_map::{LogMap, departures};
use super::plane::Plane;
use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, WORK_BETWEEN_CALLS};
use crate::extremum::larger;
use crate::propagation::{Propagation, PropagationOptions, Windows};

/// The log map from a point of the surface, as [`log_map`](super::log_map()), by propagated distances with so many windows of each half-edge.
///
/// Within the exact search that goes first, directions are those of exact paths. Beyond, from near to far, a vertex takes that of the place
/// where a straight line from the source crosses the opposite edge of a triangle, as the distances of the edge's ends tell it. Nothing is
/// carried across bridges.
///
/// # Errors
/// Those of [`log_map`](super::log_map()).
pub fn propagated_log_map(
    geometry: &Arc<ExactGeometry>,
    source: impl ToPoint,
    direction: Option<DVec3>,
    windows: Windows,
    progress: Progress<'_>,
) -> Result<LogMap> {
    if geometry.costs().is_some() {
        return Err(Error::NotExact);
    }
    let surface = geometry.surface();
    let place = source.to_point(surface)?;
    let plane = Plane::at(geometry, place.place())?;
    let u = plane.first_axis(direction)?;
    let options = PropagationOptions { windows, ..PropagationOptions::default() };
    let mut propagation = Propagation::new(Arc::clone(geometry), &[place], options)?;
    while !propagation.advance(f64::INFINITY, WORK_BETWEEN_CALLS)? {
        report(progress, Stage::Searching { radius: propagation.radius() }, 0.0)?;
    }
    let mut directions = departures(propagation.exact(), &plane, u, propagation.exact_below())?;
    let distances = propagation.values();
    let is_open = |vertex: &VertexId| directions[vertex.index()].re.is_nan() && distances[*vertex].is_finite();
    let mut open: Vec<VertexId> = surface.vertices().filter(is_open).collect();
    sort::sort_by(&mut open, |&a, &b| distances[a].total_cmp(&distances[b]));
    for vertex in open {
        directions[vertex.index()] = onward(surface, vertex, distances, &directions);
    }
    let coordinates = directions
        .iter()
        .zip(distances)
        .map(|(direction, &distance)| distance * DVec2::new(direction.re, direction.im));
    Ok(LogMap { coordinates: coordinates.collect(), distances: distances.clone(), axes: plane.axes(u) })
}

/// The direction of a vertex, from those of nearer ones beside it; not a number where none has one.
fn onward(surface: &Surface, vertex: VertexId, distances: &VertexData<f64>, directions: &[c64]) -> c64 {
    let mut best = (f64::INFINITY, c64::new(f64::NAN, f64::NAN));
    let at = surface.position(vertex);
    for (face, k) in surface.corners_of_vertex(vertex) {
        let corners = surface.faces()[face];
        let ends = [1, 2].map(|next| corners[(k + next) % 3]);
        let known = ends.map(|end| distances[end] < distances[vertex] && !directions[end.index()].re.is_nan());
        let lengths = ends.map(|end| surface.position(end).distance(at));
        let places = ends.map(|end| distances[end] * directions[end.index()]);
        let mut offer = |length: f64, place: c64| {
            if length < best.0 {
                best = (length, place / place.norm());
            }
        };
        for end in (0..2).filter(|&end| known[end]) {
            offer(distances[ends[end]] + lengths[end], places[end]);
        }
        if known == [true; 2] {
            // The edge along x, the vertex above it, what the source unfolds to below.
            let edge = surface.position(ends[0]).distance(surface.position(ends[1]));
            let over = |[first, second]: [f64; 2]| {
                let x = (first * first - second * second + edge * edge) / (2.0 * edge);
                [x, larger(first * first - x * x, 0.0).sqrt()]
            };
            let ([x, y], [source_x, depth]) = (over(lengths), over(ends.map(|end| distances[end])));
            let share = (source_x + (x - source_x) * depth / (depth + y)) / edge;
            if (0.0..=1.0).contains(&share) {
                offer((x - source_x).hypot(y + depth), (1.0 - share) * places[0] + share * places[1]);
            }
        }
    }
    best.1
}
