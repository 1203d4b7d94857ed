//! The points that are nearest to a place.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk_surface::index::{Bounds, Tree};

const LEAF: usize = 8;

/// Points in an order for the index.
pub struct Neighbours {
    tree: Tree<2, LEAF>,
    bounds: Vec<Bounds>,
    /// Positions, and which points these are.
    points: Vec<(DVec3, u32)>,
}

/// A point and its squared distance.
pub type Near = (f64, u32);

impl Neighbours {
    pub fn new(positions: &[DVec3]) -> Self {
        let tree = Tree::new(positions.len());
        let order = tree.arranged(positions, (0..positions.len() as u32).collect());
        let points: Vec<(DVec3, u32)> = order.into_iter().map(|point| (positions[point as usize], point)).collect();
        let bounds = tree.values(|leaf| Bounds::of_points(points[leaf].iter().map(|point| point.0)), Bounds::around);
        Self { tree, bounds, points }
    }

    /// The `count` points nearest to a place, the nearest first.
    pub fn nearest(&self, place: DVec3, count: NonZeroUsize, found: &mut Vec<Near>) {
        found.clear();
        let at = Bounds::at(place);
        let distance = |node: usize| self.bounds[node].squared_distance(at);
        self.tree.nearest(f64::INFINITY, distance, |leaf, _| {
            for &(position, point) in &self.points[leaf] {
                let near = (position.distance_squared(place), point);
                let place = found.partition_point(|other| *other < near);
                if place < count.get() {
                    found.truncate(count.get() - 1);
                    found.insert(place, near);
                }
            }
            if found.len() < count.get() { f64::INFINITY } else { found[count.get() - 1].0 }
        });
    }
}
