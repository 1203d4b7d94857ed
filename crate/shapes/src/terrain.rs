//! A hilly height field of value noise.

use glam::{DVec2, DVec3};
use heatwalk_surface::Soup;

use super::parametric::grid;

const SEED: u32 = 0x9e37_79b9;
const OCTAVES: u32 = 5;

/// Terrain over a square of side 2 with `cells × cells` quads, facing up.
pub fn terrain(cells: u32) -> Soup {
    let mut soup = grid(cells, cells);
    "terrain".clone_into(&mut soup.parts[0].name);
    for position in &mut soup.positions {
        let place = DVec2::new(position.x, -position.z);
        *position = DVec3::new(2.0 * place.x - 1.0, height(place), 1.0 - 2.0 * place.y);
    }
    soup
}

fn height(place: DVec2) -> f64 {
    let mut sum = 0.0;
    let mut amplitude = 0.5;
    let mut frequency = 3.0;
    for octave in 0..OCTAVES {
        // Folding the first octaves about their mean makes ridges; the fine ones stay round.
        let noise = value_noise(place * frequency, octave);
        sum += amplitude * if octave < 2 { 1.0 - (2.0 * noise - 1.0).abs() } else { noise };
        amplitude *= 0.42;
        frequency *= 2.03;
    }
    0.8 * sum * sum
}

/// Smooth noise in 0..1 from random values at the integer lattice.
fn value_noise(place: DVec2, octave: u32) -> f64 {
    let cell = place.floor();
    let t = place - cell;
    // The quintic fade has no second derivative at the lattice, so no creases show.
    let fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let corner = |x: u32, y: u32| random(cell.x as u32 + x, cell.y as u32 + y, octave);
    let lower = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * fade.x;
    let upper = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * fade.x;
    lower + (upper - lower) * fade.y
}

/// A fixed random number in 0..1 for each lattice point (the finaliser of MurmurHash3).
fn random(x: u32, y: u32, octave: u32) -> f64 {
    let mut hash = SEED ^ x.wrapping_mul(0x85eb_ca6b) ^ y.wrapping_mul(0xc2b2_ae35) ^ octave.wrapping_mul(0x27d4_eb2f);
    hash = (hash ^ hash >> 16).wrapping_mul(0x85eb_ca6b);
    hash = (hash ^ hash >> 13).wrapping_mul(0xc2b2_ae35);
    f64::from(hash ^ hash >> 16) / f64::from(u32::MAX)
}
