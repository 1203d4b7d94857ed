//! What is near to a point, among many that move.

use glam::{DVec3, IVec3};

/// Points by cubes of space, in a hashed table of lists.
#[derive(Debug, Clone, Default)]
pub(super) struct Grid {
    /// Side of a cube.
    side: f64,
    /// Per entry of the table where its list begins, and one more.
    starts: Vec<u32>,
    /// The points, by entry.
    points: Vec<u32>,
}

impl Grid {
    /// Sorts points into cubes, for questions up to `reach` away.
    pub fn sort(&mut self, positions: &[DVec3], reach: f64) {
        self.side = 2.0 * reach;
        let count = (2 * positions.len()).next_power_of_two();
        self.starts.clear();
        self.starts.resize(count + 1, 0);
        let entries: Vec<usize> = positions.iter().map(|&position| self.entry(self.cube(position))).collect();
        // Where each list ends, until its points are in.
        for &entry in &entries {
            self.starts[entry] += 1;
        }
        let mut sum = 0;
        for end in &mut self.starts {
            sum += *end;
            *end = sum;
        }
        self.points.clear();
        self.points.resize(positions.len(), 0);
        for (point, &entry) in entries.iter().enumerate().rev() {
            self.starts[entry] -= 1;
            self.points[self.starts[entry] as usize] = point as u32;
        }
    }

    /// Visits all points within reach of a position, once each, and some farther away.
    pub fn for_each_near(&self, position: DVec3, mut visit: impl FnMut(usize)) {
        if self.points.is_empty() {
            return;
        }
        // Of the cubes around, those on the side of its own cube that it is on: all others are farther away.
        let low = (position / self.side - 0.5).floor().as_ivec3();
        let mut seen = [usize::MAX; 8];
        for k in 0..8 {
            let cube = low + IVec3::new(k & 1, (k >> 1) & 1, k >> 2);
            let entry = self.entry(cube);
            // Two cubes may share an entry.
            if seen[..k as usize].contains(&entry) {
                continue;
            }
            seen[k as usize] = entry;
            for &point in &self.points[self.starts[entry] as usize..self.starts[entry + 1] as usize] {
                visit(point as usize);
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

    #[test]
    fn all_points_within_reach_are_visited_once() {
        // A spiral through several cubes, on both sides of the origin.
        let at = |k: usize| {
            let angle = k as f64 * 0.37;
            DVec3::new(angle.cos() * 3.0, angle.sin() * 2.0, k as f64 * 0.02 - 2.0)
        };
        let positions: Vec<DVec3> = (0..200).map(at).collect();
        let mut grid = Grid::default();
        grid.sort(&positions, 0.8);
        for &from in &positions {
            let mut visits = vec![0; positions.len()];
            grid.for_each_near(from, |point| visits[point] += 1);
            for (point, position) in positions.iter().enumerate() {
                assert!(visits[point] <= 1);
                assert!(visits[point] == 1 || position.distance(from) > 0.8, "{from} {position}");
            }
        }
    }
}
