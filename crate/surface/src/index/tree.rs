//! Which nodes and things are below a node of a complete tree, and the way through it.

use std::ops::Range;

use glam::DVec3;

use super::bounds::Bounds;

/// Levels of a tree of two children a node at most: items are numbered in 32 bits. One node waits on each.
const LEVELS: usize = 33;

/// A complete tree of nodes with `WIDTH` children each over `items`, `LEAF` of them a leaf, but for the last node and the last leaf:
/// the root is 0, the children of node `i` are from `WIDTH i + 1` to `WIDTH i + WIDTH`, the leaves come last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tree<const WIDTH: usize, const LEAF: usize> {
    items: usize,
    /// How many nodes are no leaves.
    inner: usize,
    nodes: usize,
}

/// What is below a node.
#[derive(Debug, Clone, PartialEq)]
pub enum Below {
    /// Other nodes.
    Nodes(Range<usize>),
    /// Items, by their places in order.
    Items(Range<usize>),
}

impl<const WIDTH: usize, const LEAF: usize> Tree<WIDTH, LEAF> {
    /// A tree over so many items, which has no node where there are none.
    #[must_use]
    pub const fn new(items: usize) -> Self {
        let leaves = items.div_ceil(LEAF);
        let inner = leaves.saturating_sub(1).div_ceil(WIDTH - 1);
        Self { items, inner, nodes: inner + leaves }
    }

    /// How many nodes there are.
    #[must_use]
    pub const fn len(self) -> usize {
        self.nodes
    }

    /// Whether there are no nodes.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.nodes == 0
    }

    /// What is below a node.
    #[inline]
    #[must_use]
    pub fn below(self, node: usize) -> Below {
        if node < self.inner { Below::Nodes(self.children(node)) } else { Below::Items(self.leaf(node)) }
    }

    #[inline]
    fn children(self, node: usize) -> Range<usize> {
        let first = WIDTH * node + 1;
        first..self.nodes.min(first + WIDTH)
    }

    #[inline]
    fn leaf(self, node: usize) -> Range<usize> {
        let first = LEAF * (node - self.inner);
        first..self.items.min(first + LEAF)
    }

    /// A value a node: those of leaves are made of their items, those of others by joining the values of their children.
    pub fn values<T: Clone>(self, leaf: impl Fn(Range<usize>) -> T, join: impl Fn(T, T) -> T) -> Vec<T> {
        if self.is_empty() {
            return Vec::new();
        }
        // Any value does for the nodes that have none yet.
        let mut values = vec![leaf(self.leaf(self.inner)); self.nodes];
        for node in self.inner + 1..self.nodes {
            values[node] = leaf(self.leaf(node));
        }
        for node in (0..self.inner).rev() {
            values[node] = self.joined(&values, node, &join);
        }
        values
    }

    fn joined<T: Clone>(self, values: &[T], node: usize, join: impl Fn(T, T) -> T) -> T {
        self.children(node).map(|child| values[child].clone()).reduce(join).expect("each node has a child")
    }

    /// The same where an item has changed since.
    pub fn update<T: Clone>(
        self,
        values: &mut [T],
        item: usize,
        leaf: impl FnOnce(Range<usize>) -> T,
        join: impl Fn(T, T) -> T,
    ) {
        let mut node = self.inner + item / LEAF;
        values[node] = leaf(self.leaf(node));
        while node > 0 {
            node = (node - 1) / WIDTH;
            values[node] = self.joined(values, node, &join);
        }
    }
}

impl<const LEAF: usize> Tree<2, LEAF> {
    /// Puts numbers of points in an order for the tree in which, whatever the distances between them, the points below a node are
    /// near each other: those below its first child are lower than those below its second along the axis in which they lie farthest
    /// apart (Bentley, "Multidimensional binary search trees used for associative searching", 1975).
    #[must_use]
    pub fn arranged(self, points: &[DVec3], mut numbers: Vec<u32>) -> Vec<u32> {
        let counts = self.values(|leaf| leaf.len(), |one, other| one + other);
        let mut order = vec![0; numbers.len()];
        if !self.is_empty() {
            self.arrange(0, &counts, points, &mut numbers, &mut order);
        }
        order
    }

    fn arrange(self, node: usize, counts: &[usize], points: &[DVec3], numbers: &mut [u32], order: &mut [u32]) {
        let children = match self.below(node) {
            Below::Items(items) => return order[items].copy_from_slice(numbers),
            Below::Nodes(children) => children,
        };
        let axis = Bounds::of_points(numbers.iter().map(|&number| points[number as usize])).size().max_position();
        let along = |number: u32| points[number as usize][axis];
        let place = counts[children.start];
        numbers.select_nth_unstable_by(place, |&a, &b| along(a).total_cmp(&along(b)).then(a.cmp(&b)));
        let (first, second) = numbers.split_at_mut(place);
        self.arrange(children.start, counts, points, first, order);
        self.arrange(children.start + 1, counts, points, second, order);
    }

    /// The items of the leaves that are entered, as all nodes above them are, from the first to the last. `enter` is told a node and
    /// answers whether to go on there.
    #[inline]
    pub fn leaves(self, mut enter: impl FnMut(usize) -> bool) -> impl Iterator<Item = Range<usize>> {
        // Counted from 1, a node has its children at twice its number. 0: at the end.
        let mut number = usize::from(!self.is_empty());
        std::iter::from_fn(move || {
            while number > 0 {
                let node = number - 1;
                let is_entered = enter(node);
                if is_entered && node < self.inner {
                    number *= 2;
                    continue;
                }
                // The next child of the nearest node above that has one: up from each second child.
                number += 1;
                number >>= number.trailing_zeros();
                if number == 1 {
                    number = 0;
                }
                if is_entered {
                    return Some(self.leaf(node));
                }
            }
            None
        })
    }

    /// Looks at leaves, those of the nearest nodes first, as long as they are nearer than a bound. `distance`: the least that a node's
    /// items may have. `look` is told items and the bound, and answers the bound from there on.
    #[inline]
    pub fn nearest<D: Copy + PartialOrd>(
        self,
        mut bound: D,
        distance: impl Fn(usize) -> D,
        mut look: impl FnMut(Range<usize>, D) -> D,
    ) {
        if self.is_empty() {
            return;
        }
        let mut waiting = [(0, bound); LEVELS];
        waiting[0] = (0, distance(0));
        let mut count = 1;
        while count > 0 {
            count -= 1;
            let mut nearest = waiting[count];
            while nearest.1 < bound {
                let (node, _) = nearest;
                if node >= self.inner {
                    bound = look(self.leaf(node), bound);
                    break;
                }
                let [mut near, mut far] = [2 * node + 1, 2 * node + 2].map(|child| (child, distance(child)));
                if far.1 < near.1 {
                    (near, far) = (far, near);
                }
                if far.1 < bound {
                    waiting[count] = far;
                    count += 1;
                }
                nearest = near;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use rand::{RngExt, SeedableRng};
    use rand_xoshiro::SplitMix64;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    const COUNTS: [usize; 8] = [0, 1, 3, 4, 5, 9, 100, 1000];

    /// Points in an order for the tree.
    fn points(count: usize) -> Vec<DVec3> {
        let mut random = SplitMix64::seed_from_u64(3);
        let points: Vec<DVec3> = (0..count).map(|_| DVec3::from_array(random.random())).collect();
        let order = Tree::<2, 4>::new(count).arranged(&points, (0..count as u32).collect());
        order.into_iter().map(|number| points[number as usize]).collect()
    }

    fn boxes(tree: Tree<2, 4>, points: &[DVec3]) -> Vec<Bounds> {
        tree.values(|leaf| Bounds::of_points(points[leaf].iter().copied()), Bounds::around)
    }

    fn each_item_is_below_every_node_above_it<const WIDTH: usize, const LEAF: usize>() {
        for count in COUNTS {
            let tree = Tree::<WIDTH, LEAF>::new(count);
            let join = |one: Vec<usize>, other: Vec<usize>| [one, other].concat();
            let below = tree.values(|leaf| leaf.collect(), join);
            assert_eq!(below.len(), tree.len());
            assert_eq!(tree.is_empty(), count == 0);
            let mut root = below.first().cloned().unwrap_or_default();
            root.sort_unstable();
            assert!(root.into_iter().eq(0..count), "each of {count} items once");
            for (node, own) in below.iter().enumerate() {
                match tree.below(node) {
                    Below::Items(items) => assert!(items.len() <= LEAF && own.iter().copied().eq(items)),
                    Below::Nodes(children) => {
                        assert!(children.start > node && children.len() <= WIDTH);
                        assert_eq!(*own, below[children].concat());
                    }
                }
            }
        }
    }

    #[test]
    fn each_item_is_below_one_leaf() {
        each_item_is_below_every_node_above_it::<2, 4>();
        each_item_is_below_every_node_above_it::<4, 4>();
    }

    #[test]
    fn a_changed_item_changes_the_values_above_it() {
        let mut items: Vec<u32> = (0..100).collect();
        let tree = Tree::<4, 4>::new(items.len());
        let of = |items: &[u32]| items.iter().copied().max().expect("no leaf is empty");
        let mut values = tree.values(|leaf| of(&items[leaf]), u32::max);
        for item in [99, 0, 50, 98] {
            items[item] /= 2;
            tree.update(&mut values, item, |leaf| of(&items[leaf]), u32::max);
            assert_eq!(values, tree.values(|leaf| of(&items[leaf]), u32::max));
        }
    }

    #[test]
    fn the_boxes_that_a_place_is_in_and_the_pairs_within_a_distance_are_those_of_all() {
        for count in COUNTS {
            let (points, tree) = (points(count), Tree::new(count));
            let boxes = boxes(tree, &points);
            for (number, &point) in points.iter().enumerate().step_by(7) {
                let is_near = |&other: &usize| points[other].distance_squared(point) <= 0.04;
                let mut near = Vec::new();
                for leaf in tree.leaves(|node| boxes[node].squared_distance(Bounds::at(point)) <= 0.04) {
                    near.extend(leaf.filter(is_near));
                }
                near.sort_unstable();
                assert!(near.contains(&number) && near.into_iter().eq((0..count).filter(is_near)));
                let mut holds = Vec::new();
                let leaves = tree.leaves(|node| {
                    let is_in = boxes[node].holds(point);
                    holds.extend(is_in.then_some(node));
                    is_in
                });
                leaves.for_each(drop);
                holds.sort_unstable();
                assert!(holds.into_iter().eq((0..tree.len()).filter(|&node| boxes[node].holds(point))));
            }
        }
    }

    #[test]
    fn the_nearest_is_found_in_few_looks_at_any_scale() {
        let mut random = SplitMix64::seed_from_u64(8);
        // Each cluster is a billionth of the one around it.
        let mut cluster = |size: f64| (0..1000).map(|_| size * DVec3::from_array(random.random())).collect::<Vec<_>>();
        let points = [1.0, 1e-9, 1e-18].map(&mut cluster).concat();
        let tree = Tree::<2, 4>::new(points.len());
        let order = tree.arranged(&points, (0..points.len() as u32).collect());
        let boxes =
            tree.values(|leaf| Bounds::of_points(order[leaf].iter().map(|&n| points[n as usize])), Bounds::around);
        let mut looked = 0;
        for point in &points {
            let distance = |node: usize| boxes[node].squared_distance(Bounds::at(*point));
            tree.nearest(f64::INFINITY, distance, |leaf, bound| {
                looked += leaf.len();
                order[leaf].iter().map(|&n| points[n as usize].distance_squared(*point)).fold(bound, f64::min)
            });
        }
        assert!(looked < 12 * points.len(), "{looked}");
    }

    #[test]
    fn the_nearest_and_the_five_nearest_are_those_of_all() {
        for count in COUNTS {
            let (points, tree) = (points(count), Tree::new(count));
            let boxes = boxes(tree, &points);
            for place in self::points(50) {
                let place = 1.2 * place - 0.1;
                for most in [1, 5] {
                    let mut nearest: Vec<f64> = Vec::new();
                    let mut looked = 0;
                    let distance = |node: usize| boxes[node].squared_distance(Bounds::at(place));
                    tree.nearest(f64::INFINITY, distance, |leaf, _| {
                        looked += leaf.len();
                        nearest.extend(points[leaf].iter().map(|point| point.distance_squared(place)));
                        nearest.sort_unstable_by(f64::total_cmp);
                        nearest.truncate(most);
                        nearest.get(most - 1).copied().unwrap_or(f64::INFINITY)
                    });
                    let mut all: Vec<f64> = points.iter().map(|point| point.distance_squared(place)).collect();
                    all.sort_unstable_by(f64::total_cmp);
                    all.truncate(most);
                    assert_eq!(nearest, all);
                    assert!(count < 1000 || looked < count / 4, "looked at {looked} of {count}");
                }
            }
        }
    }
}
