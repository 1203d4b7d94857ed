//! A few boxes that are compared with another one at once.

use heatwalk_base::lanes::Lanes;

use crate::index::Bounds;

/// How many.
pub const WIDTH: usize = 4;

const PAIRS: usize = WIDTH / 2;

/// So many boxes, coordinate by coordinate. Where there are fewer, the others hold nothing, and are infinitely far away.
#[derive(Clone)]
#[repr(align(32))]
pub struct Boxes {
    low: [[Lanes; PAIRS]; 3],
    high: [[Lanes; PAIRS]; 3],
}

impl Boxes {
    /// Of at most [`WIDTH`] boxes.
    #[inline]
    pub fn new(bounds: impl IntoIterator<Item = Bounds>) -> Self {
        let (mut low, mut high) = ([[f64::INFINITY; WIDTH]; 3], [[f64::NEG_INFINITY; WIDTH]; 3]);
        for (number, bounds) in bounds.into_iter().enumerate() {
            for axis in 0..3 {
                (low[axis][number], high[axis][number]) = (bounds.low[axis], bounds.high[axis]);
            }
        }
        let in_pairs = |[a, b, c, d]: [f64; WIDTH]| [[a, b], [c, d]].map(Lanes::new);
        Self { low: low.map(in_pairs), high: high.map(in_pairs) }
    }

    /// Squares of the distances to a box.
    #[inline]
    pub fn squared_distances(&self, other: Bounds) -> [f64; WIDTH] {
        let (low, high) = (other.low.to_array().map(Lanes::both), other.high.to_array().map(Lanes::both));
        let of_pair = |pair: usize| {
            let along = |axis: usize| {
                let (below, above) = (low[axis] - self.high[axis][pair], self.low[axis][pair] - high[axis]);
                let apart = below.larger(above).larger(Lanes::both(0.0));
                apart * apart
            };
            (along(0) + along(1) + along(2)).to_array()
        };
        let [[a, b], [c, d]] = [of_pair(0), of_pair(1)];
        [a, b, c, d]
    }
}
