//! Exact polyhedral distances, and how far others are from them.

use std::sync::Arc;
use std::time::Instant;

use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{Source, Surface};

use crate::report::milliseconds;

/// What exact distances need of a surface, and the milliseconds that it took.
pub fn geometry(surface: &Arc<Surface>) -> (Arc<ExactGeometry>, f64) {
    let start = Instant::now();
    let geometry = Arc::new(ExactGeometry::new(surface));
    (geometry, milliseconds(start))
}

/// `#P`, infinite where no source can be reached.
pub fn distances(surface: &Arc<Surface>, geometry: &Arc<ExactGeometry>, sources: &[Source]) -> Vec<f64> {
    let mut front = Wavefront::new(Arc::clone(surface), Arc::clone(geometry), sources, &[]);
    front.advance(f64::INFINITY, usize::MAX);
    front.into_values()
}

/// Error relative to the exact distance, in percent, over the points where that is positive and finite.
#[derive(Debug, Clone, Copy)]
pub struct RelativeError {
    pub mean_percent: f64,
    pub max_percent: f64,
}

impl RelativeError {
    /// Both `#P`.
    pub fn of(values: &[f64], exact: &[f64]) -> Self {
        let measured = values.iter().zip(exact).filter(|&(_, &exact)| exact > 0.0 && exact.is_finite());
        let (mut sum, mut max, mut count) = (0.0, 0.0_f64, 0);
        for (value, exact) in measured {
            let error = 100.0 * (value - exact).abs() / exact;
            sum += error;
            max = max.max(error);
            count += 1;
        }
        Self { mean_percent: sum / f64::from(count.max(1)), max_percent: max }
    }
}
