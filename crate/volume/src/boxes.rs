//! A hierarchy of boxes, which finds those that a place is in.
//!
//! They lie along a Morton curve in leaves of a few, under a complete binary tree.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk::surface::along_curve;

/// Boxes of a leaf, but for the last one.
const LEAF: usize = 8;

/// Nodes that can wait: a complete tree has fewer than 32 levels, and each puts one aside.
const STACK: usize = 32;

/// Low and high corner of a box.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds([DVec3; 2]);

impl Bounds {
    const EMPTY: Self = Self([DVec3::INFINITY, DVec3::NEG_INFINITY]);

    /// Of places, and beyond them by a share of its size.
    pub(crate) fn of(places: &[DVec3], margin: f64) -> Self {
        let Self([low, high]) = places.iter().fold(Self::EMPTY, |own, &place| own.around(Self([place; 2])));
        let margin = (high - low) * margin;
        Self([low - margin, high + margin])
    }

    fn around(self, Self([low, high]): Self) -> Self {
        Self([self.0[0].min(low), self.0[1].max(high)])
    }

    #[inline]
    pub(crate) fn contains(&self, place: DVec3) -> bool {
        self.0[0].cmple(place).all() && self.0[1].cmpge(place).all()
    }

    fn middle(&self) -> DVec3 {
        self.0[0].midpoint(self.0[1])
    }
}

/// Boxes by their numbers.
#[derive(Debug)]
pub(crate) struct Boxes {
    /// Their numbers along the curve, leaf after leaf.
    order: Vec<u32>,
    /// The root, then the children of node `i` at `2 i + 1` and `2 i + 2`; the leaves come last.
    nodes: Vec<Bounds>,
}

impl Boxes {
    /// Of so many, one at least.
    pub(crate) fn new(count: usize, bounds: impl Fn(usize) -> Bounds + Sync) -> Self {
        let order = along_curve(count, |number| bounds(number).middle(), NonZeroUsize::MIN);
        let inner = count.div_ceil(LEAF) - 1;
        let mut nodes = vec![Bounds::EMPTY; inner];
        let around = |all: Bounds, &number: &u32| all.around(bounds(number as usize));
        nodes.extend(order.chunks(LEAF).map(|leaf| leaf.iter().fold(Bounds::EMPTY, around)));
        for node in (0..inner).rev() {
            nodes[node] = nodes[2 * node + 1].around(nodes[2 * node + 2]);
        }
        Self { order, nodes }
    }

    /// Tells the numbers of all boxes of leaves that a place is in, in no order: those that have the place, and some near it.
    pub(crate) fn near(&self, place: DVec3, mut visit: impl FnMut(u32)) {
        let first_leaf = self.nodes.len() / 2;
        let mut stack = [0; STACK];
        let mut waiting = 1;
        while waiting > 0 {
            waiting -= 1;
            let node = stack[waiting];
            if !self.nodes[node].contains(place) {
                continue;
            }
            if node >= first_leaf {
                let start = LEAF * (node - first_leaf);
                let leaf = start..(start + LEAF).min(self.order.len());
                self.order[leaf].iter().for_each(|&number| visit(number));
            } else {
                stack[waiting] = 2 * node + 1;
                stack[waiting + 1] = 2 * node + 2;
                waiting += 2;
            }
        }
    }
}
