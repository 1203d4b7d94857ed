//! Sets that grow together (Tarjan 1975).

/// Numbers `0..n`, each in a set of its own until sets are joined.
pub struct UnionFind {
    parent: Vec<u32>,
}

impl UnionFind {
    /// Each of so many numbers alone.
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect() }
    }

    /// The least number of the set that this one is in.
    pub fn least(&mut self, mut number: u32) -> u32 {
        while self.parent[number as usize] != number {
            let above = self.parent[self.parent[number as usize] as usize];
            self.parent[number as usize] = above;
            number = above;
        }
        number
    }

    /// Makes one set of two.
    pub fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.least(a), self.least(b));
        self.parent[a.max(b) as usize] = a.min(b);
    }
}
