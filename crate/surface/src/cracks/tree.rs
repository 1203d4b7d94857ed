//! Nearest points by a balanced k-d tree (Bentley, "Multidimensional binary search trees used for associative searching", 1975).

use std::ops::Range;

use glam::DVec3;

/// Points of a leaf at most.
const LEAF: usize = 8;

/// Some of a list of points.
pub struct Tree<'a> {
    points: &'a [DVec3],
    /// Numbers of points: those of the lower half, by the axis of the level, the middle one, those of the upper half.
    order: Vec<u32>,
}

/// The best point so far.
#[derive(Clone, Copy)]
struct Nearest {
    squared: f64,
    point: Option<u32>,
}

impl<'a> Tree<'a> {
    /// Of the points with these numbers.
    pub fn new(points: &'a [DVec3], mut order: Vec<u32>) -> Self {
        arrange(points, &mut order, 0);
        Self { points, order }
    }

    /// The nearest point that is accepted, no farther away than this, with its distance; of several the first in number.
    /// `accepts` is told a point and its distance.
    pub fn nearest(&self, from: DVec3, within: f64, accepts: impl Fn(u32, f64) -> bool) -> Option<(u32, f64)> {
        let mut nearest = Nearest { squared: within * within, point: None };
        self.visit(0..self.order.len(), 0, from, &mut nearest, &accepts);
        nearest.point.map(|point| (point, nearest.squared.sqrt()))
    }

    fn visit(
        &self,
        range: Range<usize>,
        axis: usize,
        from: DVec3,
        nearest: &mut Nearest,
        accepts: &impl Fn(u32, f64) -> bool,
    ) {
        let look = |point: u32, nearest: &mut Nearest| {
            let squared = from.distance_squared(self.points[point as usize]);
            let is_nearer = squared < nearest.squared
                || squared == nearest.squared && nearest.point.is_none_or(|best| point < best);
            if is_nearer && accepts(point, squared.sqrt()) {
                *nearest = Nearest { squared, point: Some(point) };
            }
        };
        if range.len() <= LEAF {
            for &point in &self.order[range] {
                look(point, nearest);
            }
            return;
        }
        let middle = range.start + range.len() / 2;
        let point = self.order[middle];
        look(point, nearest);
        let beyond = from[axis] - self.points[point as usize][axis];
        let (lower, upper) = (range.start..middle, middle + 1..range.end);
        let [near, far] = if beyond < 0.0 { [lower, upper] } else { [upper, lower] };
        self.visit(near, (axis + 1) % 3, from, nearest, accepts);
        if beyond * beyond <= nearest.squared {
            self.visit(far, (axis + 1) % 3, from, nearest, accepts);
        }
    }
}

fn arrange(points: &[DVec3], order: &mut [u32], axis: usize) {
    if order.len() <= LEAF {
        return;
    }
    let middle = order.len() / 2;
    let along = |point: u32| points[point as usize][axis];
    order.select_nth_unstable_by(middle, |&a, &b| along(a).total_cmp(&along(b)).then(a.cmp(&b)));
    let (lower, upper) = order.split_at_mut(middle);
    arrange(points, lower, (axis + 1) % 3);
    arrange(points, &mut upper[1..], (axis + 1) % 3);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn the_nearest_point_is_that_of_all() {
        let mut state = 5_u64;
        // Few values, so that many points are equally far away.
        let mut coordinate = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((state >> 33) % 12) as f64
        };
        let points: Vec<DVec3> = (0..500).map(|_| DVec3::new(coordinate(), coordinate(), coordinate())).collect();
        let some: Vec<u32> = (0..points.len() as u32).filter(|point| point % 3 > 0).collect();
        let tree = Tree::new(&points, some.clone());
        for (number, &from) in (0..).zip(&points) {
            let accepts = |point: u32, distance: f64| point != number && distance <= f64::from(point % 5);
            let distance = |point: u32| from.distance(points[point as usize]);
            let accepted = some.iter().map(|&point| (point, distance(point)));
            let accepted = accepted.filter(|&(point, distance)| distance <= 3.0 && accepts(point, distance));
            let expected = accepted.min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
            assert_eq!(tree.nearest(from, 3.0, accepts), expected, "{number}");
        }
    }
}
