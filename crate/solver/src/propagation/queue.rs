//! What waits, by distance: in buckets, or in exact order where buckets would not do.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::exact::{ExactGeometry, Ring};

/// Buckets are as wide as edges, and what waits in one is taken in any order: what is near may come after what it makes shorter, which is
/// then taken again. Beyond so many times for each item that there is, edges are far shorter than buckets are wide, as on slivers, and
/// work might grow with the square of their number.
const TIMES: usize = 16;

/// Items that wait, each as often as it was pushed.
#[derive(Debug)]
pub(super) struct Queue {
    ring: Ring,
    /// Items by the bits of their distances, which order as the distances do.
    sorted: BinaryHeap<Reverse<(u64, u32)>>,
    is_sorted: bool,
    is_refused: bool,
    /// Buckets take so many times as many items as there are.
    times: usize,
    /// Items that may still be taken out of buckets.
    left: usize,
}

impl Queue {
    /// Of half-edges or vertices, with buckets so wide in mean edges. On slivers it is in exact order from the start.
    pub fn new(geometry: &ExactGeometry, width: f64) -> Self {
        Self {
            ring: Ring::new(0.0, width * geometry.mean_edge()),
            sorted: BinaryHeap::new(),
            is_sorted: false,
            is_refused: false,
            times: if geometry.is_of_slivers() { 0 } else { TIMES },
            left: 0,
        }
    }

    /// Takes all out, to begin again at `base`, with so many items that may come.
    pub fn clear(&mut self, base: f64, items: usize) {
        self.ring.clear(base, |_| ());
        self.sorted.clear();
        (self.is_sorted, self.is_refused, self.left) = (false, false, self.times * items);
    }

    /// Goes on in exact order.
    #[cold]
    fn sort(&mut self) {
        let mut items = Vec::new();
        self.is_sorted = true;
        loop {
            let distance = self.ring.floor();
            self.ring.pop_some(f64::INFINITY, usize::MAX, &mut items);
            if items.is_empty() {
                return;
            }
            items.iter().for_each(|&item| self.push(item, distance));
        }
    }

    /// Whether there was no memory for an item, which is lost.
    pub fn is_refused(&self) -> bool {
        self.is_refused | self.ring.is_refused()
    }

    /// Every waiting item is at least this far; infinity where none waits.
    pub fn floor(&self) -> f64 {
        if self.is_sorted { self.first().unwrap_or(f64::INFINITY) } else { self.ring.floor() }
    }

    /// What waits nearer than this comes next; infinity where none waits.
    pub fn ceiling(&self) -> f64 {
        if self.is_sorted { self.floor().next_up() } else { self.ring.ceiling() }
    }

    fn first(&self) -> Option<f64> {
        self.sorted.peek().map(|&Reverse((bits, _))| f64::from_bits(bits))
    }

    /// Lets an item wait at `distance`.
    #[inline(always)]
    pub fn push(&mut self, item: u32, distance: f64) {
        if self.is_sorted {
            self.insert(item, distance);
        } else {
            self.ring.push(item, distance);
        }
    }

    #[cold]
    fn insert(&mut self, item: u32, distance: f64) {
        if self.sorted.try_reserve(1).is_ok() {
            self.sorted.push(Reverse((distance.to_bits(), item)));
        } else {
            self.is_refused = true;
        }
    }

    /// Takes some of the nearest items out, unless they are at `limit` or beyond: `most` at most.
    pub fn pop_some(&mut self, limit: f64, most: usize, items: &mut Vec<u32>) {
        if !self.is_sorted {
            self.ring.pop_some(limit, most, items);
            self.left = self.left.saturating_sub(items.len());
            return;
        }
        items.clear();
        if self.first().is_some_and(|first| first < limit) {
            items.extend(self.sorted.pop().map(|Reverse((_, item))| item));
        }
    }
}

/// Lets queues go on in exact order once buckets do not do for one of them. Returns whether they begin to.
#[inline(always)]
pub(super) fn sort_spent<const N: usize>(mut queues: [&mut Queue; N]) -> bool {
    let is_spent = queues.iter().any(|queue| queue.left == 0) && queues.iter().any(|queue| !queue.is_sorted);
    if is_spent {
        queues.iter_mut().filter(|queue| !queue.is_sorted).for_each(|queue| queue.sort());
    }
    is_spent
}
