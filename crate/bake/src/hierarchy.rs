//! A bounding volume hierarchy that is quickly made and handed over as two flat arrays: triangles along a Morton curve, in
//! leaves of a few, under a complete binary tree (Lauterbach and others, "Fast BVH construction on GPUs", 2009).

use glam::Vec3;
use heatwalk_surface::{along_curve, parallel};

use crate::ray::{Hit, Ray, entry};

/// Triangles of a leaf, but for the last one.
const LEAF: usize = 8;
/// Boxes reach beyond their triangles by this share of their coordinates: a ray along a side would miss its box, since
/// depths along a ray are rounded.
const MARGIN: f32 = 64.0 * f32::EPSILON;
/// The box of nothing.
const EMPTY: Corners = [Vec3::INFINITY, Vec3::NEG_INFINITY];

/// Least and greatest corner of an axis-aligned box.
pub type Corners = [Vec3; 2];

/// A bounding volume hierarchy over numbered triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hierarchy {
    /// `#F`, leaf after leaf.
    order: Vec<u32>,
    /// Of the root, then of the children of box `i` at `2 i + 1` and `2 i + 2`; those of the leaves come last.
    boxes: Vec<Corners>,
}

impl Hierarchy {
    /// Of `#V × 3` finite positions and `#F × 3` indices in range.
    #[must_use]
    pub fn new(positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let corners = |triangle: u32| triangles[triangle as usize].map(|vertex| positions[vertex as usize]);
        let middle = |triangle: usize| corners(triangle as u32).iter().sum::<Vec3>().as_dvec3();
        let order = along_curve(triangles.len(), middle, parallel::ONE);
        let boxes = vec![EMPTY; box_count(order.len())];
        let mut hierarchy = Self { order, boxes };
        hierarchy.fit(positions, triangles);
        hierarchy
    }

    /// Fits the boxes to its triangles in other positions. The less these are neighbours there that were before, the longer
    /// questions take.
    pub(crate) fn fit(&mut self, positions: &[Vec3], triangles: &[[u32; 3]]) {
        let inner = self.boxes.len() / 2;
        for (leaf, numbers) in self.boxes[inner..].iter_mut().zip(self.order.chunks(LEAF)) {
            *leaf = EMPTY;
            for &number in numbers {
                let [a, b, c] = triangles[number as usize].map(|vertex| positions[vertex as usize]);
                let (low, high) = (a.min(b).min(c), a.max(b).max(c));
                let margin = MARGIN * low.abs().max(high.abs()).max_element();
                *leaf = around(*leaf, [low - margin, high + margin]);
            }
        }
        for node in (0..inner).rev() {
            self.boxes[node] = around(self.boxes[2 * node + 1], self.boxes[2 * node + 2]);
        }
    }

    /// Of the arrays of another one, where they are those of so many triangles.
    #[must_use]
    pub fn from_arrays(order: Vec<u32>, boxes: Vec<Corners>, triangles: usize) -> Option<Self> {
        let fits = order.len() == triangles && boxes.len() == box_count(triangles);
        let is_in_range = |&number: &u32| (number as usize) < triangles;
        (fits && order.iter().all(is_in_range)).then_some(Self { order, boxes })
    }

    /// `#F`, the triangles leaf after leaf: neighbours in it are neighbours in space.
    #[must_use]
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// The boxes, from the root to the leaves.
    #[must_use]
    pub fn boxes(&self) -> &[Corners] {
        &self.boxes
    }

    /// The nearest hit along a ray; `meet` tells that of a triangle.
    pub(crate) fn nearest(&self, ray: Ray, meet: impl Fn(u32) -> Option<Hit>) -> Option<Hit> {
        let inner = self.boxes.len() / 2;
        let inverse = ray.direction.recip();
        let mut nearest: Option<Hit> = None;
        let mut waiting = vec![(0, self.entry(0, ray.origin, inverse))];
        while let Some((node, entry)) = waiting.pop() {
            if entry.is_infinite() || nearest.is_some_and(|hit| hit.depth <= entry) {
                continue;
            }
            if node >= inner {
                let first = LEAF * (node - inner);
                let leaf = &self.order[first..self.order.len().min(first + LEAF)];
                for hit in leaf.iter().filter_map(|&triangle| meet(triangle)) {
                    if nearest.is_none_or(|before| hit.depth < before.depth) {
                        nearest = Some(hit);
                    }
                }
            } else {
                let mut children =
                    [2 * node + 1, 2 * node + 2].map(|node| (node, self.entry(node, ray.origin, inverse)));
                // What is entered first is looked at first, so last in.
                children.sort_unstable_by(|a, b| b.1.total_cmp(&a.1));
                waiting.extend(children);
            }
        }
        nearest
    }

    /// How far along a ray its box begins; 0 from inside, infinite where the ray misses it. `inverse`: of its direction.
    fn entry(&self, node: usize, origin: Vec3, inverse: Vec3) -> f32 {
        self.boxes.get(node).map_or(f32::INFINITY, |&corners| entry(corners, origin, inverse))
    }
}

/// A complete binary tree over so many triangles.
fn box_count(triangles: usize) -> usize {
    (2 * triangles.div_ceil(LEAF)).saturating_sub(1)
}

fn around([low, high]: Corners, [other_low, other_high]: Corners) -> Corners {
    [low.min(other_low), high.max(other_high)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_box_holds_what_is_below_it() {
        for count in [1, 7, 8, 9, 100, 1000] {
            let place = |i: u32| Vec3::new((0.7 * i as f32).sin(), (1.3 * i as f32).cos(), 0.001 * i as f32);
            let positions: Vec<Vec3> = (0..count + 2).map(place).collect();
            let triangles: Vec<[u32; 3]> = (0..count).map(|i| [i, i + 1, i + 2]).collect();
            let hierarchy = Hierarchy::new(&positions, &triangles);
            let mut sorted = hierarchy.order().to_vec();
            sorted.sort_unstable();
            assert!(sorted.into_iter().eq(0..count));
            let holds = |[low, high]: Corners, point: Vec3| low.cmple(point).all() && high.cmpge(point).all();
            let boxes = hierarchy.boxes();
            let inner = boxes.len() / 2;
            assert_eq!(boxes.len() - inner, (count as usize).div_ceil(LEAF));
            for (leaf, numbers) in hierarchy.order().chunks(LEAF).enumerate() {
                for vertex in numbers.iter().flat_map(|&number| triangles[number as usize]) {
                    assert!(holds(boxes[inner + leaf], positions[vertex as usize]));
                }
            }
            for node in 1..boxes.len() {
                let above = boxes[(node - 1) / 2];
                assert!(boxes[node].into_iter().all(|corner| holds(above, corner)));
            }
        }
    }

    #[test]
    fn arrays_of_other_triangles_are_refused() {
        let hierarchy = Hierarchy::new(&[Vec3::ZERO, Vec3::X, Vec3::Y], &[[0, 1, 2]; 9]);
        let (order, boxes) = (hierarchy.order().to_vec(), hierarchy.boxes().to_vec());
        assert_eq!(Hierarchy::from_arrays(order.clone(), boxes.clone(), 9), Some(hierarchy));
        assert_eq!(Hierarchy::from_arrays(order.clone(), boxes.clone(), 10), None);
        assert_eq!(Hierarchy::from_arrays(order, boxes[1..].to_vec(), 9), None);
        assert_eq!(Hierarchy::from_arrays(vec![9; 9], boxes, 9), None);
    }
}
