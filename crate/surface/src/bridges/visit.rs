//! Pairs of triangles of different components that may be near enough to each other, each pair once: the smaller one meets the
//! larger one.
//!
//! Blocks of neighbours go down the hierarchy together as far as its boxes hold as many triangles as they; from there on, groups
//! of a few go on alone, to the nearest boxes first.

use super::bounds::Bounds;
use super::hierarchy::{Below, Hierarchy, Item, LEAF, Node};
use super::tolerance::Tolerance;

/// What is done with pairs of triangles.
pub trait Visitor {
    /// How near a place of a component must be to be of use to any of a group of triangles; `None` where none is.
    fn bound(&self, group: &[Item], component: u32) -> Option<f64>;

    /// Looks at a triangle of a group and a larger one. `squared`: square of the distance of their boxes.
    fn meet(&mut self, group: &[Item], own: usize, other: &Item, squared: f64);

    /// All triangles near this group were met.
    fn leave(&mut self) {}
}

/// Shows the triangles of each of the blocks those larger ones of other components that may be near enough. `sets`: the set of all
/// components below each node, if it is one.
pub fn visit<'a>(
    hierarchy: &Hierarchy,
    sets: &[Option<u32>],
    blocks: impl Iterator<Item = &'a [Item]>,
    tolerance: &Tolerance,
    visitor: &mut impl Visitor,
) {
    let (mut waiting, mut near) = (Vec::new(), Vec::new());
    for block in blocks {
        let mut query = Query::new(hierarchy, sets, block, tolerance);
        waiting.push((0, 0.0));
        while let Some((node, _)) = waiting.pop() {
            match hierarchy.below(node) {
                Below::Nodes(children) if !hierarchy.is_block(node) => {
                    waiting.extend(query.near(children).into_iter().flatten());
                }
                _ => near.push(node),
            }
        }
        for group in block.chunks(LEAF) {
            query.narrow(group);
            query.boxes = Boxes::new(group);
            waiting.extend(near.iter().filter_map(|&node| query.may_hold(node)));
            // What is nearest is looked at first, so last in.
            waiting.sort_unstable_by(|a, b| b.1.total_cmp(&a.1));
            while let Some((node, squared)) = waiting.pop() {
                let bound = match hierarchy.node(node).component {
                    Some(component) => visitor.bound(group, component),
                    None => Some(query.most),
                };
                if bound.is_none_or(|bound| squared > bound * bound) {
                    continue;
                }
                match hierarchy.below(node) {
                    Below::Nodes(children) => waiting.extend(query.near(children).into_iter().flatten()),
                    Below::Items(others) => meet(group, &query, others, visitor),
                }
            }
            visitor.leave();
        }
        near.clear();
    }
}

/// Shows the triangles of a group those larger ones of a leaf that may be near enough.
#[inline]
fn meet(group: &[Item], query: &Query, others: &[Item], visitor: &mut impl Visitor) {
    for other in others.iter().filter(|other| other.longest >= query.shortest) {
        let Some(bound) = visitor.bound(group, other.component) else { continue };
        if other.bounds.squared_distance(query.around) > bound * bound {
            continue;
        }
        let squared = query.boxes.squared_distances(other.bounds);
        for (own, item) in group.iter().enumerate() {
            let is_larger = other.longest > item.longest || (other.longest == item.longest && other.face > item.face);
            if is_larger && squared[own] <= bound * bound {
                visitor.meet(group, own, other, squared[own]);
            }
        }
    }
}

/// What triangles of one component look for.
struct Query<'a> {
    hierarchy: &'a Hierarchy,
    sets: &'a [Option<u32>],
    /// The set of the component.
    own: u32,
    /// How far apart they may be from any other component.
    most: f64,
    /// The box around all of them.
    around: Bounds,
    /// The least length of a longest side.
    shortest: f64,
    /// The boxes of those of a group.
    boxes: Boxes,
}

impl<'a> Query<'a> {
    fn new(hierarchy: &'a Hierarchy, sets: &'a [Option<u32>], items: &[Item], tolerance: &Tolerance) -> Self {
        let component = items[0].component;
        let most = tolerance.of(component);
        let own = tolerance.set[component as usize];
        let (around, boxes) = (Bounds::EMPTY, Boxes::new(&[]));
        let mut query = Self { hierarchy, sets, own, most, around, shortest: 0.0, boxes };
        query.narrow(items);
        query
    }

    /// The same for these triangles alone.
    fn narrow(&mut self, items: &[Item]) {
        self.around = items.iter().map(|item| item.bounds).fold(Bounds::EMPTY, Bounds::around);
        self.shortest = items.iter().map(|item| item.longest).fold(f64::INFINITY, f64::min);
    }

    /// A node and the square of its distance, if there may be something near enough below it.
    #[inline]
    fn may_hold(&self, node: usize) -> Option<(usize, f64)> {
        let Node { bounds, longest, .. } = self.hierarchy.node(node);
        let squared = bounds.squared_distance(self.around);
        let is_near = squared <= self.most * self.most;
        (is_near && *longest >= self.shortest && self.sets[node] != Some(self.own)).then_some((node, squared))
    }

    /// The same of the children of a node, the nearer one last.
    #[inline]
    fn near(&self, children: [usize; 2]) -> [Option<(usize, f64)>; 2] {
        let [first, second] = children.map(|child| self.may_hold(child));
        match (first, second) {
            (Some(a), Some(b)) if a.1 < b.1 => [second, first],
            _ => [first, second],
        }
    }
}

/// The boxes of a group, coordinate by coordinate, so that all are compared at once. Where there is no triangle, the box is that
/// of nothing.
struct Boxes {
    low: [[f64; LEAF]; 3],
    high: [[f64; LEAF]; 3],
}

impl Boxes {
    #[inline]
    fn new(group: &[Item]) -> Self {
        let mut boxes = Self { low: [[f64::INFINITY; LEAF]; 3], high: [[f64::NEG_INFINITY; LEAF]; 3] };
        for (own, item) in group.iter().enumerate() {
            let (low, high) = (item.bounds.low.to_array(), item.bounds.high.to_array());
            for axis in 0..3 {
                boxes.low[axis][own] = low[axis];
                boxes.high[axis][own] = high[axis];
            }
        }
        boxes
    }

    /// Squares of the distances to a box.
    #[inline]
    fn squared_distances(&self, other: Bounds) -> [f64; LEAF] {
        let (low, high) = (other.low.to_array(), other.high.to_array());
        let mut squared = [0.0; LEAF];
        for axis in 0..3 {
            for own in 0..LEAF {
                let (below, above) = (low[axis] - self.high[axis][own], self.low[axis][own] - high[axis]);
                let apart = if above > below { above } else { below };
                let apart = if apart > 0.0 { apart } else { 0.0 };
                squared[own] += apart * apart;
            }
        }
        squared
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use std::collections::{HashMap, HashSet};

    use super::super::scene::Scene;
    use super::super::tests::{assembled, cuboid, sphere};
    use super::*;
    use crate::parallel;

    /// Pairs of faces that met, the smaller one first.
    struct Met<'a> {
        tolerance: &'a Tolerance,
        pairs: HashSet<[u32; 2]>,
    }

    impl Visitor for Met<'_> {
        fn bound(&self, group: &[Item], component: u32) -> Option<f64> {
            self.tolerance.between(group[0].component, component)
        }

        fn meet(&mut self, group: &[Item], own: usize, other: &Item, squared: f64) {
            assert_eq!(squared, group[own].bounds.squared_distance(other.bounds));
            assert!(self.pairs.insert([group[own].face, other.face]));
        }
    }

    #[test]
    fn all_pairs_that_are_near_meet_once() {
        let balls = (0..5).map(|number| sphere([1.9 * f64::from(number), 0.0, 0.0], 1.0));
        let shapes: Vec<_> = balls.chain([cuboid([-1.0, -1.0, -2.0], [8.0, 1.0, -0.98])]).collect();
        let surface = assembled(&shapes);
        let scene = Scene::new(&surface, parallel::ONE);
        let hierarchy = Hierarchy::new(&scene);
        let items: Vec<Item> = hierarchy.groups().flatten().copied().collect();
        for set in [vec![0, 1, 2, 3, 4, 5], vec![0, 0, 2, 3, 3, 5]] {
            let tolerance = Tolerance { set, reach: vec![0.004; 6], pairs: HashMap::new() };
            let sets = hierarchy.common(|component| tolerance.set[component as usize]);
            let mut met = Met { tolerance: &tolerance, pairs: HashSet::new() };
            visit(&hierarchy, &sets, hierarchy.blocks(), &tolerance, &mut met);
            let pairs = items.iter().flat_map(|item| items.iter().map(move |other| [item, other]));
            let near = pairs.filter(|[item, other]| {
                let bound = tolerance.between(item.component, other.component);
                let squared = item.bounds.squared_distance(other.bounds);
                (item.longest, item.face) < (other.longest, other.face)
                    && bound.is_some_and(|bound| squared <= bound * bound)
            });
            let near: HashSet<[u32; 2]> = near.map(|pair| pair.map(|item| item.face)).collect();
            assert!(near.len() > 100, "{}", near.len());
            assert_eq!(met.pairs, near);
        }
    }
}
