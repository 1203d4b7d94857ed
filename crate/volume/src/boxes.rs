//! Boxes by their numbers, and which of them a place is in.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk::surface::index::{Bounds, Tree, along_curve};

/// Boxes of a leaf, but for the last one.
const LEAF: usize = 8;

/// Boxes by their numbers.
#[derive(Debug)]
pub(crate) struct Boxes {
    tree: Tree<2, LEAF>,
    /// Their numbers along the curve, leaf after leaf.
    order: Vec<u32>,
    /// `#nodes`, around the boxes below.
    around: Vec<Bounds>,
}

impl Boxes {
    /// Of so many.
    pub(crate) fn new(count: usize, bounds: impl Fn(usize) -> Bounds + Sync) -> Self {
        let order = along_curve(count, |number| bounds(number).middle(), NonZeroUsize::MIN);
        let tree = Tree::new(count);
        let of_leaf =
            |leaf: &[u32]| leaf.iter().map(|&number| bounds(number as usize)).fold(Bounds::EMPTY, Bounds::around);
        let around = tree.values(|leaf| of_leaf(&order[leaf]), Bounds::around);
        Self { tree, order, around }
    }

    /// Tells the numbers of all boxes of leaves that a place is in, in no order: those that have the place, and some near it.
    pub(crate) fn near(&self, place: DVec3, mut visit: impl FnMut(u32)) {
        let leaves = self.tree.leaves(|node| self.around[node].holds(place));
        leaves.flat_map(|leaf| &self.order[leaf]).for_each(|&number| visit(number));
    }
}
