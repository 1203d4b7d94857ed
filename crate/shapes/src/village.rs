//! A village on soft hills: houses, and yards with walls and gates, as one height field.

use glam::{DVec2, DVec3};
use heatwalk_surface::Soup;

use super::parametric::grid;

/// Cells along each side.
const CELLS: u32 = 120;

/// Heights over the ground, and how much a roof rises on a cell.
const WALL: f64 = 0.045;
const GATE: f64 = 0.025;
const HOUSE: f64 = 0.075;
const ROOF: f64 = 0.011;

/// Corners of rectangles of cells: least and greatest `x`, least and greatest `z`.
type Rectangle = [u32; 4];

const HOUSES: [Rectangle; 6] =
    [[27, 39, 30, 40], [74, 92, 18, 28], [82, 94, 44, 56], [86, 98, 82, 96], [16, 30, 84, 94], [42, 54, 88, 104]];
/// Walls run around them.
const YARDS: [Rectangle; 2] = [[20, 62, 22, 58], [70, 108, 72, 108]];
/// In the walls of the yards, one each.
const GATES: [Rectangle; 2] = [[44, 50, 58, 58], [70, 70, 86, 92]];

/// A square of side 2 with a village on it, facing up.
pub fn village() -> Soup {
    let mut soup = grid(CELLS, CELLS);
    "village".clone_into(&mut soup.parts[0].name);
    for position in &mut soup.positions {
        let place = DVec2::new(position.x, -position.z);
        let cell = (f64::from(CELLS) * place).round().as_uvec2();
        let [x, z] = [2.0 * place.x - 1.0, 1.0 - 2.0 * place.y];
        *position = DVec3::new(x, hills(x, z) + built([cell.x, CELLS - cell.y]), z);
    }
    soup
}

fn hills(x: f64, z: f64) -> f64 {
    0.05 * (2.1 * x + 0.4).sin() * (1.7 * z - 0.3).cos() + 0.03 * (4.3 * x - 2.9 * z).sin()
}

/// Height of what stands on a corner of cells.
fn built(corner: [u32; 2]) -> f64 {
    if let Some(&[low, high, near, far]) = HOUSES.iter().find(|&&house| is_in(house, corner)) {
        // The ridge runs along the longer side.
        let [x, z] = corner;
        let away = if high - low < far - near { (x - low).min(high - x) } else { (z - near).min(far - z) };
        return HOUSE + ROOF * f64::from(away);
    }
    if GATES.iter().any(|&gate| is_in(gate, corner)) {
        return GATE;
    }
    if YARDS.iter().any(|&yard| is_around(yard, corner)) { WALL } else { 0.0 }
}

fn is_in([low, high, near, far]: Rectangle, [x, z]: [u32; 2]) -> bool {
    (low..=high).contains(&x) && (near..=far).contains(&z)
}

fn is_around(yard: Rectangle, corner: [u32; 2]) -> bool {
    let [low, high, near, far] = yard;
    is_in(yard, corner) && !is_in([low + 1, high - 1, near + 1, far - 1], corner)
}
