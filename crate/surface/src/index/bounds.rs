//! Axis-aligned boxes.

use glam::DVec3;

/// Least and greatest corner of an axis-aligned box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Least coordinates.
    pub low: DVec3,
    /// Greatest coordinates.
    pub high: DVec3,
}

impl Bounds {
    /// The box of nothing.
    pub const EMPTY: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    /// A point.
    #[must_use]
    #[inline]
    pub fn at(point: DVec3) -> Self {
        Self { low: point, high: point }
    }

    /// The least box that holds these points.
    #[must_use]
    #[inline]
    pub fn of_points(points: impl IntoIterator<Item = DVec3>) -> Self {
        points.into_iter().map(Self::at).reduce(Self::around).unwrap_or(Self::EMPTY)
    }

    /// The least box that holds both.
    #[must_use]
    #[inline]
    pub fn around(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The box that reaches farther by this much to both sides along each axis.
    #[must_use]
    #[inline]
    pub fn grown(self, margin: DVec3) -> Self {
        Self { low: self.low - margin, high: self.high + margin }
    }

    /// Lengths of its sides.
    #[must_use]
    #[inline]
    pub fn size(self) -> DVec3 {
        self.high - self.low
    }

    /// Its middle.
    #[must_use]
    #[inline]
    pub fn middle(self) -> DVec3 {
        self.low.midpoint(self.high)
    }

    /// Whether it has a point in common with another one.
    #[must_use]
    #[inline]
    pub fn meets(self, other: Self) -> bool {
        self.low.cmple(other.high).all() && self.high.cmpge(other.low).all()
    }

    /// Whether a point is in it.
    #[must_use]
    #[inline]
    pub fn holds(self, point: DVec3) -> bool {
        point.cmpge(self.low).all() && point.cmple(self.high).all()
    }

    /// Square of the least distance between points of both.
    #[must_use]
    #[inline]
    pub fn squared_distance(self, other: Self) -> f64 {
        (other.low - self.high).max(self.low - other.high).max(DVec3::ZERO).length_squared()
    }

    /// Square of the distance of the middles of both, four times.
    #[must_use]
    #[inline]
    pub fn squared_offset(self, other: Self) -> f64 {
        (self.low + self.high).distance_squared(other.low + other.high)
    }

    /// The shares of the way from `start` to `end` between which the segment is in it.
    #[must_use]
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
