//! A distance field as the page gets it, and what is known of how exact it is.

use heatwalk::{Distance, Solution};
use heatwalk_bindings::{Field, FieldError};

use crate::drawn::Drawn;

/// How a field was found before any of it was refined.
#[derive(Clone, Copy)]
pub enum Origin {
    /// By heat that has flowed for t = m h², with this m.
    Heat { time_factor: f64 },
    /// By so many windows of each half-edge; 0: carried by vertices alone.
    Windows(u16),
}

/// The field solved last.
pub struct Solved {
    pub solution: Solution,
    pub origin: Origin,
}

impl Solved {
    pub fn distance(&self) -> &Distance {
        &self.solution.answer().distance
    }
}

/// `in_walls`: how many vertices cannot be reached by anything.
pub(crate) fn field(drawn: &Drawn, solved: &Solved, in_walls: usize) -> Field {
    let distance = solved.distance();
    let (mut max_distance, mut reachable, mut exact) = (0.0_f64, 0, 0);
    for &value in &distance.values {
        if value.is_finite() {
            max_distance = max_distance.max(value);
            reachable += 1;
            exact += usize::from(value < distance.exact_below);
        }
    }
    let (time_factor, windows) = match solved.origin {
        Origin::Heat { time_factor } => (Some(time_factor), None),
        Origin::Windows(count) => (None, Some(count)),
    };
    Field {
        distance: drawn.spread(&distance.values),
        inner: None,
        by_corner: drawn.is_by_corner,
        max_distance,
        unreachable_vertices: (distance.values.len() - reachable).saturating_sub(in_walls),
        exact_below: distance.exact_below,
        exact_share: exact as f64 / reachable.max(1) as f64,
        time_factor,
        windows,
        error: solved.solution.error().map(|error| FieldError { mean: error.mean, max: error.max }),
    }
}
