//! The exact region: exact distances around the sources, where the heat method is off by 15 to 20 % on any mesh.

use std::borrow::Cow;

use glam::DVec3;
use heatwalk_surface::VertexId;

use crate::error::Result;
use crate::heat::constraint::Constraint;
use crate::heat::point_source::PointSource;
use crate::options::ExactRadius;

/// With several sources, a radius that work has cut short is rounded down to a power of this in mean edges, so that
/// moving or adding a source mostly leaves it, and with it the Schur columns kept from before. One needs none.
const RADIUS_STEP: f64 = 1.189_207_115_002_721; // the fourth root of 2

/// Goes as far out from the sources as the options say, and returns the radius of the region.
///
/// `advance` goes on until every distance below a radius is final, or so much work is done, and returns the radius below which all are:
/// infinity where nothing is left to do. `work` is that for a radius that is chosen.
///
/// # Errors
/// As `advance`.
pub fn grow(
    radius: ExactRadius,
    sources: &[PointSource],
    mean_edge: f64,
    work: usize,
    mut advance: impl FnMut(f64, usize) -> Result<f64>,
) -> Result<f64> {
    let least = sources.iter().map(PointSource::initial_distance).fold(f64::INFINITY, f64::min);
    let within =
        |final_below: f64, radius: f64| if final_below.is_finite() { radius.min(final_below) } else { final_below };
    Ok(match radius {
        ExactRadius::Edges(0.0) => least,
        ExactRadius::Edges(edges) => {
            let radius = least + edges * mean_edge;
            within(advance(radius, usize::MAX)?, radius)
        }
        ExactRadius::Automatic => {
            let final_below = advance(f64::INFINITY, work)?;
            if sources.len() == 1 {
                return Ok(final_below);
            }
            let steps = ((final_below - least) / mean_edge).log(RADIUS_STEP).floor();
            within(final_below, least + mean_edge * RADIUS_STEP.powf(steps))
        }
    })
}

/// Exact distances around the sources: those below a radius.
#[derive(Debug)]
pub struct ExactRegion<'a> {
    distances: &'a [f64],
    reached: Cow<'a, [VertexId]>,
    radius: f64,
}

impl<'a> ExactRegion<'a> {
    /// Of `distances` (`#V`) those below `radius`; infinite when all are exact. `reached` are all vertices that have one, in any order.
    pub fn new(distances: &'a [f64], reached: impl Into<Cow<'a, [VertexId]>>, radius: f64) -> Self {
        Self { distances, reached: reached.into(), radius }
    }

    /// A region without vertices; `distances` (`#V`) are not looked at.
    pub(super) fn none(distances: &'a [f64]) -> Self {
        Self::new(distances, &[][..], f64::NEG_INFINITY)
    }

    /// Every distance below it is in the region; infinite when all are.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The distance of a vertex, if it is in the region.
    #[inline]
    pub fn value(&self, vertex: u32) -> Option<f64> {
        Some(self.distances[vertex as usize]).filter(|&distance| distance < self.radius)
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
    pub(super) fn known<'b>(&self, positions: &[DVec3], sources: impl Iterator<Item = &'b PointSource>) -> Vec<f64> {
        let mut known = vec![f64::INFINITY; positions.len()];
        self.write(&mut known);
        sources.for_each(|source| source.lower(positions, &mut known));
        known
    }

    /// What distance beyond the region has to meet: on the rim of each patch of the region the mean of the exact distances. `touched` are
    /// the elements with corners in the region, each with whether all of them are.
    pub fn rims<const N: usize>(&self, touched: impl IntoIterator<Item = ([u32; N], bool)>) -> Vec<Constraint> {
        Constraint::of_rims(self.distances.len(), touched, |vertex| self.value(vertex))
    }

    /// Whether a source is not all in the region.
    pub(super) fn lacks(&self, source: &PointSource) -> bool {
        source.vertices().any(|vertex| self.value(vertex).is_none())
    }
}
