//! Damaged copies of files.

use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

const DAMAGED_COPIES: usize = 3000;

/// Copies with one to three random bytes replaced, the same at every run.
pub fn damaged_copies(bytes: &[u8]) -> impl Iterator<Item = Vec<u8>> {
    let mut random = SplitMix64::seed_from_u64(1);
    (0..DAMAGED_COPIES).map(move |_| {
        let mut damaged = bytes.to_vec();
        for _ in 0..random.random_range(1..=3) {
            damaged[random.random_range(0..bytes.len())] = random.random();
        }
        damaged
    })
}
