//! Random windows for tests.

use super::window::Beam;

/// Numbers from 0 to 1 that repeat late.
pub struct Numbers(pub u64);

impl Numbers {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A window of a half-edge of length 1 that sees its source at up to 1.5 from the half-edge.
    pub fn window(&mut self, offset: f64) -> Beam {
        let [begin, end] = [0.5 * self.next(), 0.5 + 0.5 * self.next()];
        Beam { begin, end, x: 2.0 * self.next() - 0.5, depth: 0.02 + 1.5 * self.next(), offset, root: 0 }
    }
}
