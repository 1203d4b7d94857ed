//! Sets that grow together (Tarjan 1975), on any number of threads (Anderson & Woll 1991: a root gets a parent by a single
//! compare-and-swap, and shortening a path only moves a parent up).

use crate::parallel::Numbers;

/// Numbers `0..n`, each in a set of its own until sets are joined.
pub struct UnionFind {
    parent: Numbers,
}

impl UnionFind {
    /// Each of so many numbers alone.
    pub fn new(count: usize) -> Self {
        Self { parent: Numbers::identity(count) }
    }

    /// The least number of the set that this one is in.
    pub fn least(&self, mut number: u32) -> u32 {
        loop {
            let parent = self.parent.get(number);
            if parent == number {
                return number;
            }
            let above = self.parent.get(parent);
            if above == parent {
                return parent;
            }
            self.parent.set(number, above);
            number = above;
        }
    }

    /// Of each number its set, and how many sets there are; they are counted in the order of their least numbers.
    pub fn sets(&self) -> (Vec<u32>, u32) {
        let mut sets: Vec<u32> = Vec::with_capacity(self.parent.count());
        let mut count = 0;
        for number in 0..self.parent.count() as u32 {
            let least = self.least(number);
            sets.push(if least == number { count } else { sets[least as usize] });
            count += u32::from(least == number);
        }
        (sets, count)
    }

    /// Makes one set of two.
    pub fn join(&self, a: u32, b: u32) {
        loop {
            let (a, b) = (self.least(a), self.least(b));
            // Another thread may just have joined the greater one to a third.
            if a == b || self.parent.replace(a.max(b), a.max(b), a.min(b)) {
                return;
            }
        }
    }
}
