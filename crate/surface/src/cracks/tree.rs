//! Nearest points by a balanced k-d tree (Bentley, "Multidimensional binary search trees used for associative searching", 1975).

use std::ops::Range;

use glam::DVec3;

use crate::csr::NONE;

/// Points of a leaf at most.
const LEAF: usize = 8;

/// Of what was removed.
const REMOVED: f64 = f64::NEG_INFINITY;

/// Points, each with how far others may be from it; they are removed one by one.
pub struct Tree<'a> {
    points: &'a [DVec3],
    /// Numbers of points: those of the lower half, along the axis in which they lie farthest apart, the middle one, those of the
    /// upper half.
    order: Vec<u32>,
    /// By the place of the middle one: that axis.
    axis: Vec<u8>,
    /// `#points`, the place of each in `order`.
    place: Vec<u32>,
    /// `#points`
    reach: Vec<f64>,
    /// By the place of the middle one: the greatest reach of a half.
    most: Vec<f64>,
}

/// The best point so far.
#[derive(Clone, Copy)]
struct Nearest {
    squared: f64,
    point: Option<u32>,
}

impl<'a> Tree<'a> {
    /// Of the points that reach anywhere. `reach`: `#points`.
    pub fn new(points: &'a [DVec3], reach: &[f64]) -> Self {
        let mut order: Vec<u32> = (0..points.len() as u32).filter(|&point| reach[point as usize] > 0.0).collect();
        let mut axis = vec![0; order.len()];
        arrange(points, &mut order, &mut axis);
        let (mut place, most) = (vec![NONE; points.len()], vec![REMOVED; order.len()]);
        for (&point, index) in order.iter().zip(0..) {
            place[point as usize] = index;
        }
        let mut tree = Self { points, order, axis, place, reach: reach.to_vec(), most };
        tree.measure(0..tree.order.len());
        tree
    }

    /// All points, some of which may have been removed.
    pub fn points(&self) -> &[u32] {
        &self.order
    }

    /// How far others may be from a point.
    pub fn reach(&self, point: u32) -> f64 {
        self.reach[point as usize]
    }

    /// Shortens the reach of a point.
    pub fn shorten(&mut self, point: u32, reach: f64) {
        self.reach[point as usize] = reach;
        self.update(0..self.order.len(), self.place[point as usize] as usize);
    }

    /// Removes a point.
    pub fn remove(&mut self, point: u32) {
        self.shorten(point, REMOVED);
    }

    /// The nearest other point, with its distance, of those that are within the reach of this one and have it in theirs; of
    /// several the first in number.
    pub fn nearest(&self, to: u32) -> Option<(u32, f64)> {
        let within = Some(self.reach(to)).filter(|&within| within >= 0.0)?;
        let mut nearest = Nearest { squared: within * within, point: None };
        self.visit(0..self.order.len(), to, DVec3::ZERO, &mut nearest);
        nearest.point.map(|point| (point, nearest.squared.sqrt()))
    }

    /// `apart`: how far the cell of the range is from the point, along each axis.
    fn visit(&self, range: Range<usize>, to: u32, apart: DVec3, nearest: &mut Nearest) {
        if range.is_empty() {
            return;
        }
        let middle = middle(&range);
        let (squared, most) = (apart.length_squared(), self.most[middle]);
        if squared > nearest.squared || most < 0.0 || squared > most * most {
            return;
        }
        let from = self.points[to as usize];
        let look = |point: u32, nearest: &mut Nearest| {
            let squared = from.distance_squared(self.points[point as usize]);
            let is_nearer = squared < nearest.squared
                || squared == nearest.squared && nearest.point.is_none_or(|best| point < best);
            if is_nearer && point != to && squared.sqrt() <= self.reach(point) {
                *nearest = Nearest { squared, point: Some(point) };
            }
        };
        if range.len() <= LEAF {
            for &point in &self.order[range] {
                look(point, nearest);
            }
            return;
        }
        let point = self.order[middle];
        look(point, nearest);
        let axis = usize::from(self.axis[middle]);
        let beyond = from[axis] - self.points[point as usize][axis];
        let [lower, upper] = halves(range);
        let [near, far] = if beyond < 0.0 { [lower, upper] } else { [upper, lower] };
        self.visit(near, to, apart, nearest);
        let mut apart = apart;
        apart[axis] = beyond.abs();
        self.visit(far, to, apart, nearest);
    }

    /// Finds the greatest reach of a range and of all its halves.
    fn measure(&mut self, range: Range<usize>) {
        if range.len() > LEAF {
            for half in halves(range.clone()) {
                self.measure(half);
            }
        }
        self.sum_up(range);
    }

    /// The same where only the reach of the point at a place has changed.
    fn update(&mut self, range: Range<usize>, place: usize) {
        if range.len() > LEAF
            && let Some(half) = halves(range.clone()).into_iter().find(|half| half.contains(&place))
        {
            self.update(half, place);
        }
        self.sum_up(range);
    }

    /// The greatest reach of a range whose halves have theirs.
    fn sum_up(&mut self, range: Range<usize>) {
        if range.is_empty() {
            return;
        }
        let middle = middle(&range);
        let of = |place: usize| self.reach(self.order[place]);
        self.most[middle] = if range.len() <= LEAF {
            range.map(of).fold(REMOVED, f64::max)
        } else {
            let below =
                halves(range).into_iter().filter(|half| !half.is_empty()).map(|half| self.most[self::middle(&half)]);
            below.fold(of(middle), f64::max)
        };
    }
}

/// The place of the middle one.
fn middle(range: &Range<usize>) -> usize {
    range.start + range.len() / 2
}

/// What is on both sides of the middle one.
fn halves(range: Range<usize>) -> [Range<usize>; 2] {
    let middle = middle(&range);
    [range.start..middle, middle + 1..range.end]
}

/// Puts points in the order of a [`Tree`], and tells the axes.
fn arrange(points: &[DVec3], order: &mut [u32], axes: &mut [u8]) {
    if order.len() <= LEAF {
        return;
    }
    let all = || order.iter().map(|&point| points[point as usize]);
    let (low, high) = (all().fold(DVec3::INFINITY, DVec3::min), all().fold(DVec3::NEG_INFINITY, DVec3::max));
    let axis = (high - low).max_position();
    let middle = order.len() / 2;
    let along = |point: u32| points[point as usize][axis];
    order.select_nth_unstable_by(middle, |&a, &b| along(a).total_cmp(&along(b)).then(a.cmp(&b)));
    axes[middle] = axis as u8;
    let ((lower, upper), (lower_axes, upper_axes)) = (order.split_at_mut(middle), axes.split_at_mut(middle));
    arrange(points, lower, lower_axes);
    arrange(points, &mut upper[1..], &mut upper_axes[1..]);
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_xoshiro::SplitMix64;

    use super::*;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    #[test]
    fn the_nearest_point_is_that_of_all_that_are_left() {
        let mut random = SplitMix64::seed_from_u64(5);
        // Few values, so that many points are equally far away.
        let mut coordinate = || f64::from(random.random_range(0..12));
        let points: Vec<DVec3> = (0..500).map(|_| DVec3::new(coordinate(), coordinate(), coordinate())).collect();
        let mut reach: Vec<f64> = (0..500).map(|point| f64::from(point % 5)).collect();
        let mut tree = Tree::new(&points, &reach);
        for changed in 0..500 {
            let reaches = |point: &u32| reach[*point as usize] > 0.0;
            for from in (changed..500).step_by(7).filter(reaches) {
                let distance = |point: u32| points[from as usize].distance(points[point as usize]);
                let others = (0..500).filter(reaches).filter(|&point| point != from);
                let within = |&(point, distance): &(u32, f64)| {
                    distance <= reach[from as usize] && distance <= reach[point as usize]
                };
                let near = others.map(|point| (point, distance(point))).filter(within);
                let expected = near.min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
                assert_eq!(tree.nearest(from), expected, "{from} after {changed}");
            }
            if reach[changed as usize] > 0.0 {
                let shorter = if changed % 2 == 0 { REMOVED } else { 0.5 * reach[changed as usize] };
                reach[changed as usize] = shorter;
                tree.shorten(changed, shorter);
            }
        }
    }
}
