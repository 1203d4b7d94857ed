//! Random windows for tests.

#[cfg(not(target_arch = "wasm32"))]
use heatwalk_surface::Soup;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use super::window::Beam;

/// Numbers from 0 to 1.
pub struct Numbers(SplitMix64);

impl Numbers {
    pub fn new(seed: u64) -> Self {
        Self(SplitMix64::seed_from_u64(seed))
    }

    pub fn next(&mut self) -> f64 {
        self.0.random()
    }

    /// A window of a half-edge of length 1 that sees its source at up to 1.5 from the half-edge.
    pub fn window(&mut self, offset: f64) -> Beam {
        let [begin, end] = [0.5 * self.next(), 0.5 + 0.5 * self.next()];
        Beam { begin, end, x: 2.0 * self.next() - 0.5, depth: 0.02 + 1.5 * self.next(), offset, root: 0 }
    }
}

/// Windows that fill a half-edge of length 1, one after the other, as behind vertices of little curvature: their sources are the same but
/// for some hundredths.
pub fn fan(numbers: &mut Numbers, count: usize) -> Vec<Beam> {
    let (x, depth) = (2.0 * numbers.next() - 0.5, 1.0 + 2.0 * numbers.next());
    let mut ends: Vec<f64> = (1..count).map(|_| numbers.next()).chain([0.0, 1.0]).collect();
    ends.sort_by(f64::total_cmp);
    let mut near = |place: f64| place + 0.02 * (numbers.next() - 0.5);
    (0..count)
        .map(|number| {
            let (begin, end) = (ends[number], ends[number + 1]);
            Beam { begin, end, x: near(x), depth: near(depth), offset: near(1.0), root: number as u32 }
        })
        .collect()
}

/// The least distance by windows that cover a place.
pub fn least(windows: &[Beam], place: f64) -> f64 {
    let covers = |window: &&Beam| window.begin <= place && place <= window.end;
    windows.iter().filter(covers).map(|window| window.at(place)).fold(f64::INFINITY, f64::min)
}

/// With every kind of bend: a terrain has saddles and reflex vertices, holes, one for so many triangles, and a fin more of them.
#[cfg(not(target_arch = "wasm32"))]
pub fn torn_terrain(size: u32, triangles_per_hole: usize) -> Soup {
    let mut soup = heatwalk_shapes::terrain(size);
    let mut index = 0;
    soup.triangles.retain(|_| {
        index += 1;
        index % triangles_per_hole != 0
    });
    let [a, b, _] = soup.triangles[soup.triangles.len() / 2];
    soup.positions.push(soup.positions[a as usize] * 1.1);
    soup.triangles.push([a, b, soup.positions.len() as u32 - 1]);
    soup
}
