//! Pairs of triangles of different components that may be near enough to each other, each pair once: the smaller one meets the
//! larger one.
//!
//! Blocks of neighbours go down the hierarchy together as far as its boxes hold as many triangles as they; from there on, groups
//! of a few go on alone, to the boxes with the nearest middles first: where parts overlap, most boxes do.

use std::ops::Range;

use super::boxes::{Boxes, WIDTH};
use super::budget::Budget;
use super::hierarchy::{Hierarchy, Item, LEAF, Node};
use super::tolerance::Tolerance;
use crate::index::{Below, Bounds};

/// Triangles of a part of a block, for which boxes are put in order.
const PART: usize = LEAF * WIDTH;

/// A node that is near what is looked for.
struct Near {
    node: usize,
    /// Square of the distance of the boxes.
    squared: f64,
    /// The same of the middles of the boxes.
    apart: f64,
}

/// What is done with pairs of triangles.
pub trait Visitor {
    /// How near a place of a component must be to be of use to any of a group of triangles with sides of this length at most;
    /// `None` where none is.
    fn bound(&self, group: &[Item], component: u32, longest: f64) -> Option<f64>;

    /// Looks at a triangle of a group and a larger one. `squared`: square of the distance of their boxes.
    fn meet(&mut self, group: &[Item], own: usize, other: &Item, squared: f64);

    /// All triangles near this group were met, or as many as it may meet.
    fn leave(&mut self) {}

    /// What was looked at and kept so far, in steps of a budget.
    fn steps(&self) -> usize;
}

/// Shows the triangles of each of the blocks those larger ones of other components that may be near enough. `sets`: the set of all
/// components below each node, if it is one. Returns whether the budget was enough to show all.
pub fn visit<'a>(
    hierarchy: &Hierarchy,
    sets: &[Option<u32>],
    blocks: impl Iterator<Item = &'a [Item]>,
    tolerance: &Tolerance,
    budget: &Budget,
    visitor: &mut impl Visitor,
) -> bool {
    let mut are_all = true;
    let (mut waiting, mut near, mut near_part) = (Vec::new(), Vec::new(), Vec::new());
    for block in blocks {
        let mut query = Query::new(hierarchy, sets, block, tolerance);
        let most = budget.of_group();
        let mut steps = 0;
        waiting.push(Near { node: 0, squared: 0.0, apart: 0.0 });
        while let Some(Near { node, .. }) = waiting.pop() {
            match hierarchy.below(node) {
                Below::Nodes(children) if !hierarchy.is_block(node) => {
                    query.near(node, children, query.most, &mut waiting);
                }
                _ => near.push(node),
            }
            steps += 1;
            if steps > most {
                // Each group goes all the way alone, to what is nearest to it.
                waiting.clear();
                near.clear();
                near.push(0);
            }
        }
        are_all &= budget.take(steps);
        for part in block.chunks(PART) {
            query.narrow(part);
            near_part.extend(near.iter().filter_map(|&node| query.may_hold(node)));
            // What is nearest is looked at first, so last in.
            near_part.sort_unstable_by(|a, b| b.apart.total_cmp(&a.apart));
            // Those that are passed over take their time, too.
            are_all &= budget.take(near.len());
            for group in part.chunks(LEAF) {
                query.narrow(group);
                query.boxes = Boxes::new(group.iter().map(|item| item.bounds));
                let (most, before) = (budget.of_group(), visitor.steps());
                let mut steps = 0;
                waiting.extend(near_part.iter().filter_map(|near| query.may_hold(near.node)));
                are_all &= budget.take(near_part.len());
                while let Some(Near { node, squared, .. }) = waiting.pop() {
                    steps += 1;
                    if steps + visitor.steps() - before > most {
                        waiting.clear();
                        continue;
                    }
                    let Node { component, longest, .. } = *hierarchy.node(node);
                    let bound = match component {
                        Some(component) => visitor.bound(group, component, longest),
                        None => Some(query.most),
                    };
                    let Some(bound) = bound.filter(|bound| squared <= bound * bound) else { continue };
                    match hierarchy.below(node) {
                        Below::Nodes(children) => query.near(node, children, bound, &mut waiting),
                        Below::Items(leaf) => meet(group, &query, node, hierarchy.items(leaf), bound, visitor),
                    }
                }
                are_all &= budget.take(steps + visitor.steps() - before);
                visitor.leave();
            }
            near_part.clear();
        }
        near.clear();
    }
    are_all
}

/// Shows the triangles of a group those larger ones of a leaf that may be near enough, and no farther away than `within`.
#[inline]
fn meet(group: &[Item], query: &Query, leaf: usize, others: &[Item], within: f64, visitor: &mut impl Visitor) {
    let apart = query.hierarchy.boxes(leaf).squared_distances(query.around);
    for (other, apart) in others.iter().zip(apart) {
        if apart > within * within || other.longest < query.shortest {
            continue;
        }
        let Some(bound) = visitor.bound(group, other.component, other.longest) else { continue };
        if apart > bound * bound {
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
        let (around, boxes) = (Bounds::EMPTY, Boxes::new([]));
        let mut query = Self { hierarchy, sets, own, most, around, shortest: 0.0, boxes };
        query.narrow(items);
        query
    }

    /// The same for these triangles alone.
    fn narrow(&mut self, items: &[Item]) {
        self.around = items.iter().map(|item| item.bounds).fold(Bounds::EMPTY, Bounds::around);
        self.shortest = items.iter().map(|item| item.longest).fold(f64::INFINITY, f64::min);
    }

    /// A node, if there may be something near enough below it.
    #[inline]
    fn may_hold(&self, node: usize) -> Option<Near> {
        let Node { bounds, longest, .. } = self.hierarchy.node(node);
        let squared = bounds.squared_distance(self.around);
        let is_near = squared <= self.most * self.most;
        (is_near && *longest >= self.shortest && self.sets[node] != Some(self.own)).then(|| Near {
            node,
            squared,
            apart: bounds.squared_offset(self.around),
        })
    }

    /// The same of the children of a node that are no farther away than `within`, the one whose middle is nearest last.
    #[inline]
    fn near(&self, node: usize, children: Range<usize>, within: f64, waiting: &mut Vec<Near>) {
        let first = waiting.len();
        for (child, squared) in children.zip(self.hierarchy.boxes(node).squared_distances(self.around)) {
            let Node { bounds, longest, .. } = self.hierarchy.node(child);
            if squared > within * within || *longest < self.shortest || self.sets[child] == Some(self.own) {
                continue;
            }
            let apart = bounds.squared_offset(self.around);
            let mut place = waiting.len();
            waiting.push(Near { node: child, squared, apart });
            while place > first && waiting[place - 1].apart < apart {
                waiting.swap(place - 1, place);
                place -= 1;
            }
        }
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
    use heatwalk_base::parallel;

    /// Pairs of faces that met, the smaller one first.
    struct Met<'a> {
        tolerance: &'a Tolerance,
        pairs: HashSet<[u32; 2]>,
    }

    impl Visitor for Met<'_> {
        fn bound(&self, group: &[Item], component: u32, _: f64) -> Option<f64> {
            self.tolerance.between(group[0].component, component)
        }

        fn meet(&mut self, group: &[Item], own: usize, other: &Item, squared: f64) {
            assert_eq!(squared, group[own].bounds.squared_distance(other.bounds));
            assert!(self.pairs.insert([group[own].face, other.face]));
        }

        fn steps(&self) -> usize {
            self.pairs.len()
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
            let budget = Budget::new(items.len());
            assert!(visit(&hierarchy, &sets, hierarchy.blocks(), &tolerance, &budget, &mut met));
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
