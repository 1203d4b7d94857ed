//! The near field: exact distances around the sources, where the heat method is off by 15 to 20 % on any mesh.

use std::sync::Arc;

use crate::exact::Wavefront;
use crate::heat::{HeatSolver, NearField};
use crate::sources::Source;

/// A radius that work has cut short is rounded down to a power of this in mean edges, so that moving or adding a
/// source mostly leaves it, and with it the responses kept from before.
const RADIUS_STEP: f64 = 1.189_207_115_002_721; // the fourth root of 2

/// Windows that the near field may propagate, per point and doubling of the points: a solve passes twice over some six
/// entries of the factors for each, and a window costs as much as sixty of them. Counted so, and not by the entries
/// there are, because these change with the numbering of the points.
const WINDOWS: f64 = 0.1;

/// Exact distances around the sources.
pub(super) struct Near {
    /// `#P`; infinite outside.
    pub(super) values: Vec<f64>,
    /// Every distance below it is in `values`; infinite when all are.
    pub(super) radius: f64,
}

impl Near {
    /// What a wavefront knows for certain: all where it is done, else what is below a radius.
    pub(super) fn of(front: &Wavefront, radius: f64) -> Self {
        let radius = if front.is_done() { f64::INFINITY } else { radius.min(front.radius()) };
        let is_final = |&value: &f64| if value < radius { value } else { f64::INFINITY };
        Self { values: front.values().iter().map(is_final).collect(), radius }
    }
}

impl HeatSolver {
    /// The wavefront of exact distances from some sources.
    pub(super) fn wavefront(&self, sources: &[Source]) -> Wavefront {
        Wavefront::new(Arc::clone(&self.surface), Arc::clone(&self.exact), sources, &[])
    }

    /// The near field that the parameters ask for.
    pub(super) fn near_field(&self, sources: &[Source]) -> Near {
        let least = sources.iter().map(|source| source.offset).fold(f64::INFINITY, f64::min);
        match self.parameters.near_field {
            NearField::Edges(0.0) => Near { values: vec![f64::INFINITY; self.surface.point_count()], radius: least },
            NearField::Edges(edges) => {
                let mut front = self.wavefront(sources);
                let radius = least + edges * self.mean_edge;
                front.advance(radius, usize::MAX);
                Near::of(&front, radius)
            }
            NearField::Automatic => {
                let mut front = self.wavefront(sources);
                let points = self.surface.point_count() as f64;
                let windows = (WINDOWS * points * points.log2()) as usize;
                front.advance(f64::INFINITY, windows);
                let steps = ((front.radius() - least) / self.mean_edge).log(RADIUS_STEP).floor();
                Near::of(&front, least + self.mean_edge * RADIUS_STEP.powf(steps))
            }
        }
    }
}
