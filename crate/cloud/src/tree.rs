//! What is nearest to a point among others: a tree that halves them along the longest side of their box (Friedman, Bentley, Finkel, "An
//! algorithm for finding best matches in logarithmic expected time", 1977).

use glam::DVec3;

/// Points that are compared one by one.
const LEAF: usize = 8;

/// Points in an order in which each half, quarter and so on is a box.
pub struct Tree {
    /// Positions in that order, and which point each is.
    points: Vec<(DVec3, u32)>,
    /// Of each inner node, in the order of a heap: the axis that it is parted along and where.
    parts: Vec<(usize, f64)>,
}

/// A point and its squared distance.
pub type Near = (f64, u32);

impl Tree {
    pub fn new(points: impl Iterator<Item = (DVec3, u32)>) -> Self {
        let mut points: Vec<(DVec3, u32)> = points.collect();
        let mut inner = 0;
        while points.len() >> inner > LEAF {
            inner += 1;
        }
        let mut tree = Self { parts: vec![(0, 0.0); (1 << inner) - 1], points: Vec::new() };
        part(&mut points, 0, &mut tree.parts);
        tree.points = points;
        tree
    }

    /// The `count` points that are nearest to a place, the nearest first; of equal distances the lower number.
    pub fn nearest(&self, place: DVec3, count: usize, found: &mut Vec<Near>) {
        found.clear();
        self.visit(place, count, 0, &self.points, found);
    }

    fn visit(&self, place: DVec3, count: usize, node: usize, points: &[(DVec3, u32)], found: &mut Vec<Near>) {
        let Some(&(axis, at)) = self.parts.get(node) else {
            for &(position, point) in points {
                let near = (position.distance_squared(place), point);
                if found.len() == count && found.last().is_some_and(|last| near >= *last) {
                    continue;
                }
                found.truncate(count - 1);
                found.insert(found.partition_point(|other| *other < near), near);
            }
            return;
        };
        let (low, high) = points.split_at(points.len() / 2);
        let beyond = place[axis] - at;
        let halves = [(2 * node + 1, low), (2 * node + 2, high)];
        let near = usize::from(beyond > 0.0);
        let (child, points) = halves[near];
        self.visit(place, count, child, points, found);
        if found.len() < count || found.last().is_some_and(|last| beyond * beyond <= last.0) {
            let (child, points) = halves[1 - near];
            self.visit(place, count, child, points, found);
        }
    }
}

fn part(points: &mut [(DVec3, u32)], node: usize, parts: &mut [(usize, f64)]) {
    let Some(own) = parts.get_mut(node) else { return };
    let (low, high) =
        points.iter().fold((DVec3::MAX, DVec3::MIN), |(low, high), (at, _)| (low.min(*at), high.max(*at)));
    let size = high - low;
    let axis = (0..3).fold(0, |longest, axis| if size[axis] > size[longest] { axis } else { longest });
    let middle = points.len() / 2;
    points.select_nth_unstable_by(middle, |(a, i), (b, j)| a[axis].total_cmp(&b[axis]).then(i.cmp(j)));
    *own = (axis, points[middle].0[axis]);
    let (low, high) = points.split_at_mut(middle);
    part(low, 2 * node + 1, parts);
    part(high, 2 * node + 2, parts);
}
