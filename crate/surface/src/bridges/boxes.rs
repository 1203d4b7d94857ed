//! A few boxes that are compared with another one at once.

use super::bounds::Bounds;

/// How many.
pub const WIDTH: usize = 4;

/// So many boxes, coordinate by coordinate. Where there are fewer, the others hold nothing, and are infinitely far away.
#[derive(Clone)]
#[repr(align(32))]
pub struct Boxes {
    low: [[f64; WIDTH]; 3],
    high: [[f64; WIDTH]; 3],
}

impl Boxes {
    /// Of at most [`WIDTH`] boxes.
    #[inline]
    pub fn new(bounds: impl IntoIterator<Item = Bounds>) -> Self {
        let mut boxes = Self { low: [[f64::INFINITY; WIDTH]; 3], high: [[f64::NEG_INFINITY; WIDTH]; 3] };
        for (number, Bounds { low, high }) in bounds.into_iter().enumerate() {
            for axis in 0..3 {
                boxes.low[axis][number] = low[axis];
                boxes.high[axis][number] = high[axis];
            }
        }
        boxes
    }

    /// Squares of the distances to a box.
    #[inline]
    pub fn squared_distances(&self, other: Bounds) -> [f64; WIDTH] {
        let (low, high) = (other.low.to_array(), other.high.to_array());
        let mut squared = [0.0; WIDTH];
        for axis in 0..3 {
            for number in 0..WIDTH {
                let (below, above) = (low[axis] - self.high[axis][number], self.low[axis][number] - high[axis]);
                let apart = if above > below { above } else { below };
                let apart = if apart > 0.0 { apart } else { 0.0 };
                squared[number] += apart * apart;
            }
        }
        squared
    }
}
