//! How far apart components may be.

use std::collections::HashMap;

/// Which components may be joined. Lengths in units of the scene.
pub struct Tolerance {
    /// `#components`, the set of each: components of one set are not joined.
    pub set: Vec<u32>,
    /// `#sets`, how far apart each may be from any other.
    pub reach: Vec<f64>,
    /// The same of pairs of sets, the lower number first, where only these are joined; empty where all are.
    pub pairs: HashMap<[u32; 2], f64>,
}

impl Tolerance {
    /// How far apart a component may be from any other.
    pub fn of(&self, component: u32) -> f64 {
        self.reach[self.set[component as usize] as usize]
    }

    /// How far apart places of two components may be; `None` where these are not joined however near they are.
    #[inline]
    pub fn between(&self, a: u32, b: u32) -> Option<f64> {
        let [a, b] = [a, b].map(|component| self.set[component as usize]);
        if a == b {
            return None;
        }
        let tolerance = self.reach[a as usize].min(self.reach[b as usize]);
        if self.pairs.is_empty() {
            return Some(tolerance);
        }
        self.pairs.get(&[a.min(b), a.max(b)]).map(|most| tolerance.min(*most))
    }
}
