//! A bounding volume hierarchy that is quickly made and handed over as two flat arrays.

use glam::Vec3;
use heatwalk_base::parallel;
use heatwalk_surface::index::{Tree, along_curve};

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
    /// Of the nodes of the [tree](Tree) over it.
    boxes: Vec<Corners>,
}

impl Hierarchy {
    /// Of `#V × 3` finite positions and `#F × 3` indices in range.
    #[must_use]
    pub fn new(positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let corners = |triangle: u32| triangles[triangle as usize].map(|vertex| positions[vertex as usize]);
        let middle = |triangle: usize| corners(triangle as u32).iter().sum::<Vec3>().as_dvec3();
        let order = along_curve(triangles.len(), middle, parallel::ONE);
        let mut hierarchy = Self { order, boxes: Vec::new() };
        hierarchy.fit(positions, triangles);
        hierarchy
    }

    /// Fits the boxes to its triangles in other positions. The less these are neighbours there that were before, the longer
    /// questions take.
    pub(crate) fn fit(&mut self, positions: &[Vec3], triangles: &[[u32; 3]]) {
        let of_triangle = |&number: &u32| {
            let [a, b, c] = triangles[number as usize].map(|vertex| positions[vertex as usize]);
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            let margin = MARGIN * low.abs().max(high.abs()).max_element();
            [low - margin, high + margin]
        };
        let of_leaf = |leaf: &[u32]| leaf.iter().map(of_triangle).fold(EMPTY, around);
        self.boxes = tree(self.order.len()).values(|leaf| of_leaf(&self.order[leaf]), around);
    }

    /// Of the arrays of another one, where they are those of so many triangles.
    #[must_use]
    pub fn from_arrays(order: Vec<u32>, boxes: Vec<Corners>, triangles: usize) -> Option<Self> {
        let fits = order.len() == triangles && boxes.len() == tree(triangles).len();
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
        let inverse = ray.direction.recip();
        let enters = |node: usize| entry(self.boxes[node], ray.origin, inverse);
        let mut nearest: Option<Hit> = None;
        tree(self.order.len()).nearest(f32::INFINITY, enters, |leaf, mut depth| {
            for hit in self.order[leaf].iter().filter_map(|&triangle| meet(triangle)) {
                if hit.depth < depth {
                    (nearest, depth) = (Some(hit), hit.depth);
                }
            }
            depth
        });
        nearest
    }
}

/// Of so many triangles.
fn tree(triangles: usize) -> Tree<2, LEAF> {
    Tree::new(triangles)
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
