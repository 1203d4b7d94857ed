//! Nearest points that reach each other.

use glam::DVec3;
use heatwalk_base::csr::NONE;

use crate::index::{Bounds, Tree};

/// Points of a leaf, but for the last one.
const LEAF: usize = 8;

/// Of what was removed.
const REMOVED: f64 = f64::NEG_INFINITY;

/// Points, each with how far others may be from it; they are removed one by one.
pub struct Reaching<'a> {
    points: &'a [DVec3],
    tree: Tree<2, LEAF>,
    /// Numbers of points, [arranged](Tree::arranged).
    order: Vec<u32>,
    /// `#points`, the place of each in `order`.
    place: Vec<u32>,
    /// `#nodes`
    boxes: Vec<Bounds>,
    /// `#points`
    reach: Vec<f64>,
    /// `#nodes`, the greatest reach of a point below.
    most: Vec<f64>,
}

impl<'a> Reaching<'a> {
    /// Of the points that reach anywhere. `reach`: `#points`.
    pub fn new(points: &'a [DVec3], reach: &[f64]) -> Self {
        let own: Vec<u32> = (0..points.len() as u32).filter(|&point| reach[point as usize] > 0.0).collect();
        let tree = Tree::new(own.len());
        let order = tree.arranged(points, own);
        let mut place = vec![NONE; points.len()];
        for (&point, index) in order.iter().zip(0..) {
            place[point as usize] = index;
        }
        let of_leaf = |leaf: &[u32]| Bounds::of_points(leaf.iter().map(|&point| points[point as usize]));
        let boxes = tree.values(|leaf| of_leaf(&order[leaf]), Bounds::around);
        let reach = reach.to_vec();
        let most = tree.values(|leaf| greatest(&order[leaf], &reach), f64::max);
        Self { points, tree, order, place, boxes, reach, most }
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
        let place = self.place[point as usize] as usize;
        self.tree.update(&mut self.most, place, |leaf| greatest(&self.order[leaf], &self.reach), f64::max);
    }

    /// Removes a point.
    pub fn remove(&mut self, point: u32) {
        self.shorten(point, REMOVED);
    }

    /// The nearest other point, with its distance, of those that are within the reach of this one and have it in theirs; of
    /// several the first in number.
    pub fn nearest(&self, to: u32) -> Option<(u32, f64)> {
        let within = Some(self.reach(to)).filter(|&within| within >= 0.0)?;
        let from = self.points[to as usize];
        let distance = |node: usize| {
            let squared = self.boxes[node].squared_distance(Bounds::at(from));
            if squared.sqrt() <= self.most[node] { squared } else { f64::INFINITY }
        };
        let mut nearest = (within * within, NONE);
        // What is as near may be the first in number.
        self.tree.nearest(nearest.0.next_up(), distance, |leaf, _| {
            for &point in &self.order[leaf] {
                let squared = from.distance_squared(self.points[point as usize]);
                if (squared, point) < nearest && point != to && squared.sqrt() <= self.reach(point) {
                    nearest = (squared, point);
                }
            }
            nearest.0.next_up()
        });
        (nearest.1 != NONE).then(|| (nearest.1, nearest.0.sqrt()))
    }
}

/// The greatest reach of some points.
fn greatest(points: &[u32], reach: &[f64]) -> f64 {
    points.iter().map(|&point| reach[point as usize]).fold(REMOVED, f64::max)
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
        let mut left = Reaching::new(&points, &reach);
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
                assert_eq!(left.nearest(from), expected, "{from} after {changed}");
            }
            if reach[changed as usize] > 0.0 {
                let shorter = if changed % 2 == 0 { REMOVED } else { 0.5 * reach[changed as usize] };
                reach[changed as usize] = shorter;
                left.shorten(changed, shorter);
            }
        }
    }
}
