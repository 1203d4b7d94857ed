//! Random numbers, the same on every machine.

use glam::{DQuat, DVec3};
use rand::{Rng, RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

pub struct Random(SplitMix64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(SplitMix64::seed_from_u64(seed))
    }

    /// From 0 to below 1.
    pub fn share(&mut self) -> f64 {
        self.0.random()
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// Each power of ten is as likely.
    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// From 0 to below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.0.next_u64() % count as u64) as usize
    }

    /// One of a range, its end included.
    pub fn count(&mut self, low: usize, high: usize) -> usize {
        low + self.below(high - low + 1)
    }

    pub fn chance(&mut self, share: f64) -> bool {
        self.share() < share
    }

    pub fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }

    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }

    /// Coordinates from −1 to 1.
    pub fn point(&mut self) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| self.between(-1.0, 1.0)))
    }

    pub fn turn(&mut self) -> DQuat {
        let axis = self.point().try_normalize().unwrap_or(DVec3::X);
        DQuat::from_axis_angle(axis, self.between(0.0, std::f64::consts::TAU))
    }

    /// So many numbers from 0 to 1, ascending, with both ends, and none twice.
    pub fn cuts(&mut self, inner: usize) -> Vec<f64> {
        let mut cuts: Vec<f64> = (0..inner).map(|_| self.between(1e-3, 1.0 - 1e-3)).chain([0.0, 1.0]).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        cuts
    }
}
