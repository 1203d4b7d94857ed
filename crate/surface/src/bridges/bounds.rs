//! Axis-aligned boxes.

use glam::DVec3;

/// The smaller of two numbers each. As in C: one instruction, where [`f64::min`] takes three to see to what is no number.
#[inline]
fn smaller(a: DVec3, b: DVec3) -> DVec3 {
    let least = |a: f64, b: f64| if b < a { b } else { a };
    DVec3::new(least(a.x, b.x), least(a.y, b.y), least(a.z, b.z))
}

/// The larger of two numbers each, likewise.
#[inline]
fn larger(a: DVec3, b: DVec3) -> DVec3 {
    let most = |a: f64, b: f64| if b > a { b } else { a };
    DVec3::new(most(a.x, b.x), most(a.y, b.y), most(a.z, b.z))
}

/// Least and greatest corner of an axis-aligned box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    pub low: DVec3,
    pub high: DVec3,
}

impl Bounds {
    /// The box of nothing.
    pub const EMPTY: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// The least box that holds these points.
    #[inline]
    pub fn of_points(points: impl IntoIterator<Item = DVec3>) -> Self {
        let mut points = points.into_iter();
        let Some(first) = points.next() else { return Self::EMPTY };
        let with = |bounds: Self, point| Self { low: smaller(bounds.low, point), high: larger(bounds.high, point) };
        points.fold(Self { low: first, high: first }, with)
    }

    /// The least box that holds both.
    #[must_use]
    #[inline]
    pub fn around(self, other: Self) -> Self {
        Self { low: smaller(self.low, other.low), high: larger(self.high, other.high) }
    }

    /// The box that reaches farther by this much to every side.
    #[must_use]
    #[inline]
    pub fn grown(self, margin: f64) -> Self {
        Self { low: self.low - margin, high: self.high + margin }
    }

    /// Length of its diagonal.
    #[inline]
    pub fn diagonal(self) -> f64 {
        (self.high - self.low).length()
    }

    /// Whether a point is in it.
    #[inline]
    pub fn holds(self, point: DVec3) -> bool {
        point.cmpge(self.low).all() && point.cmple(self.high).all()
    }

    /// Square of the least distance between points of both.
    #[inline]
    pub fn squared_distance(self, other: Self) -> f64 {
        larger(larger(other.low - self.high, self.low - other.high), DVec3::ZERO).length_squared()
    }

    /// Square of the distance of the middles of both, four times.
    #[inline]
    pub fn squared_offset(self, other: Self) -> f64 {
        (self.low + self.high).distance_squared(other.low + other.high)
    }

    /// The shares of the way from `start` to `end` between which the segment is in it.
    pub fn clip(self, [start, end]: [DVec3; 2]) -> Option<[f64; 2]> {
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for axis in 0..3 {
            let along = end[axis] - start[axis];
            let [low, high] = [self.low[axis] - start[axis], self.high[axis] - start[axis]];
            if along == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return None;
                }
            } else {
                enters = enters.max((low / along).min(high / along));
                leaves = leaves.min((low / along).max(high / along));
            }
        }
        (enters <= leaves).then_some([enters, leaves])
    }
}
