//! What is near to a point, among many that move.

use glam::{DVec3, IVec3};

/// What lies at a point of space.
pub(super) trait Lies {
    fn position(&self) -> DVec3;
}

/// Things by cubes of space, in a hashed table of lists that lie one after another.
#[derive(Debug, Clone)]
pub(super) struct Grid<T> {
    /// Side of a cube.
    side: f64,
    /// Per entry of the table where its list begins, and one more.
    starts: Vec<u32>,
    /// By entry.
    things: Vec<T>,
}

impl<T: Lies + Copy> Grid<T> {
    /// Without anything.
    pub const fn new() -> Self {
        Self { side: 1.0, starts: Vec::new(), things: Vec::new() }
    }

    /// Sorts things into cubes, for questions up to `reach` away.
    pub fn sort(&mut self, things: &[T], reach: f64) {
        self.side = 2.0 * reach;
        let count = (2 * things.len()).next_power_of_two();
        self.starts.clear();
        self.starts.resize(count + 1, 0);
        let entries: Vec<usize> = things.iter().map(|thing| self.entry(self.cube(thing.position()))).collect();
        // Where each list ends, until its things are in.
        for &entry in &entries {
            self.starts[entry] += 1;
        }
        let mut sum = 0;
        for end in &mut self.starts {
            sum += *end;
            *end = sum;
        }
        self.things.clear();
        self.things.extend_from_slice(things);
        for (&thing, &entry) in things.iter().zip(&entries).rev() {
            self.starts[entry] -= 1;
            self.things[self.starts[entry] as usize] = thing;
        }
    }

    /// All of them, those of a cube together.
    pub fn things(&self) -> &[T] {
        &self.things
    }

    /// Visits all things within reach of a position, once each.
    pub fn for_each_near(&self, position: DVec3, mut visit: impl FnMut(&T)) {
        if self.things.is_empty() {
            return;
        }
        let reach_squared = 0.25 * self.side * self.side;
        // Of the cubes around, those on the side of its own cube that it is on: all others are farther away.
        let low = (position / self.side - 0.5).floor().as_ivec3();
        let mut seen = [usize::MAX; 8];
        for k in 0..8 {
            let entry = self.entry(low + IVec3::new(k & 1, (k >> 1) & 1, k >> 2));
            // Two cubes may share an entry.
            if seen[..k as usize].contains(&entry) {
                continue;
            }
            seen[k as usize] = entry;
            for thing in &self.things[self.starts[entry] as usize..self.starts[entry + 1] as usize] {
                if thing.position().distance_squared(position) <= reach_squared {
                    visit(thing);
                }
            }
        }
    }

    fn cube(&self, position: DVec3) -> IVec3 {
        (position / self.side).floor().as_ivec3()
    }

    fn entry(&self, cube: IVec3) -> usize {
        let mixed =
            (cube.x.wrapping_mul(73_856_093)) ^ (cube.y.wrapping_mul(19_349_663)) ^ (cube.z.wrapping_mul(83_492_791));
        (mixed ^ (mixed >> 15)) as u32 as usize & (self.starts.len() - 2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    impl Lies for (usize, DVec3) {
        fn position(&self) -> DVec3 {
            self.1
        }
    }

    #[test]
    fn all_points_within_reach_are_visited_once() {
        // A spiral through several cubes, on both sides of the origin.
        let at = |k: usize| {
            let angle = k as f64 * 0.37;
            (k, DVec3::new(angle.cos() * 3.0, angle.sin() * 2.0, k as f64 * 0.02 - 2.0))
        };
        let points: Vec<(usize, DVec3)> = (0..200).map(at).collect();
        let mut grid = Grid::new();
        grid.sort(&points, 0.8);
        for &(_, from) in &points {
            let mut visits = vec![0; points.len()];
            grid.for_each_near(from, |&(number, _)| visits[number] += 1);
            for &(number, position) in &points {
                assert_eq!(visits[number], usize::from(position.distance(from) <= 0.8), "{from} {position}");
            }
        }
    }
}
