//! A human skull on a stand.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DMat3, DVec3};
use heatwalk_surface::Soup;

use super::figure::{Figure, Part, ball, ellipsoid, limb, turned_ellipsoid};
use super::parametric::revolve;

/// Looking along +x, 2.1 high. Part 0, "skull": cranium, face and upper teeth in one piece, whose two handles are the
/// zygomatic arches. Part 1, "lower jaw", with its teeth. Part 2, "hollows": open bowls that line the orbits and the
/// opening of the nose. Part 3, "stand": a round plinth with a stem.
pub fn skull(spacing: f64) -> Soup {
    let mut soup = Soup::default();
    let half_width = DVec3::new(0.0, 0.0, 0.95);
    let (low, high) = (DVec3::new(-1.15, 0.25, 0.0), DVec3::new(1.2, 2.25, 0.0));
    let (positions, triangles) = upper_skull().mesh(low - half_width, high + half_width, spacing);
    soup.add(positions, &triangles);
    soup.end_part("skull");
    let (low, high) = (DVec3::new(-0.2, -0.12, 0.0), DVec3::new(1.2, 1.1, 0.0));
    let (positions, triangles) = lower_jaw().mesh(low - half_width, high + half_width, spacing);
    soup.add(positions, &triangles);
    soup.end_part("lower jaw");
    for side in [1.0, -1.0] {
        add_bowl(&mut soup, ORBIT * DVec3::new(1.0, 1.0, side), 0.95 * ORBIT_RADII, orbit_turn(side));
    }
    // Shallower than the opening, whose back and sides it crosses.
    add_bowl(&mut soup, DVec3::new(0.81, 0.81, 0.0), DVec3::new(0.08, 0.19, 0.135), DMat3::IDENTITY);
    soup.end_part("hollows");
    revolve(&mut soup, &STAND, 128);
    soup.end_part("stand");
    soup
}

/// Half an ellipsoid, open towards its +x and turned: its inside is its front.
fn add_bowl(soup: &mut Soup, centre: DVec3, radii: DVec3, turn: DMat3) {
    const ROWS: u32 = 10;
    const COLUMNS: u32 = 36;
    let start = soup.positions.len() as u32;
    let place = |unit: DVec3| centre + turn * (radii * unit);
    soup.positions.push(place(DVec3::NEG_X));
    for row in 1..=ROWS {
        let (across, depth) = (FRAC_PI_2 * f64::from(row) / f64::from(ROWS)).sin_cos();
        soup.positions.extend((0..COLUMNS).map(|column| {
            let (sin, cos) = (TAU * f64::from(column) / f64::from(COLUMNS)).sin_cos();
            place(DVec3::new(-depth, across * cos, across * sin))
        }));
    }
    let vertex = |row: u32, column: u32| start + 1 + (row - 1) * COLUMNS + column % COLUMNS;
    for column in 0..COLUMNS {
        soup.triangles.push([start, vertex(1, column), vertex(1, column + 1)]);
        for row in 1..ROWS {
            let [a, b] = [vertex(row, column), vertex(row + 1, column)];
            let [c, d] = [vertex(row + 1, column + 1), vertex(row, column + 1)];
            soup.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
}

/// Profile of the stand, `(radius, y)`, from the top of the stem to the edge of the underside.
const STAND: [(f64, f64); 16] = [
    (0.10, 0.80),
    (0.10, 0.30),
    (0.11, 0.20),
    (0.14, 0.11),
    (0.20, 0.04),
    (0.30, 0.0),
    (0.45, -0.015),
    (1.02, -0.02),
    (1.055, -0.025),
    (1.08, -0.04),
    (1.095, -0.065),
    (1.10, -0.10),
    (1.095, -0.135),
    (1.08, -0.16),
    (1.055, -0.175),
    (1.02, -0.18),
];

/// Middle of the ellipsoid that hollows the orbit on the side of +z.
const ORBIT: DVec3 = DVec3::new(0.80, 1.02, 0.325);
const ORBIT_RADII: DVec3 = DVec3::new(0.42, 0.185, 0.195);

/// Orbits look a little outwards; `side` is the sign of z.
fn orbit_turn(side: f64) -> DMat3 {
    DMat3::from_rotation_y(-0.38 * side)
}

fn upper_skull() -> Figure {
    let mut skull = cranium();
    add_face(&mut skull);
    skull.unite(0.05, limb(&arch(0.0, 0.55, 0.075)));
    for angle in TEETH {
        skull.unite(0.02, tooth(angle, 0.44));
    }
    skull
}

fn cranium() -> Figure {
    let mut skull = Figure::new(ellipsoid((-0.03, 1.42, 0.0), (0.91, 0.66, 0.65)));
    // Parietal bones, forehead, occiput, base.
    skull.unite(0.3, ellipsoid((-0.25, 1.46, 0.0), (0.68, 0.60, 0.69)));
    skull.unite(0.35, ellipsoid((0.35, 1.43, 0.0), (0.50, 0.57, 0.52)));
    skull.unite(0.2, ellipsoid((-0.58, 1.15, 0.0), (0.38, 0.36, 0.46)));
    skull.unite(0.2, ellipsoid((-0.12, 0.92, 0.0), (0.55, 0.20, 0.42)));
    // The temples.
    skull.carve(0.2, ellipsoid((0.32, 1.06, 0.77), (0.30, 0.36, 0.21)).on_both_sides());
    skull
}

fn add_face(skull: &mut Figure) {
    // Upper jaw.
    skull.unite(0.2, ellipsoid((0.52, 0.78, 0.0), (0.38, 0.34, 0.32)));
    skull.unite(0.1, ellipsoid((0.68, 0.62, 0.0), (0.24, 0.20, 0.29)));
    // Brow, down the outer rim of the eye, cheekbone.
    let brow = [
        (0.87, 1.20, 0.06, 0.085),
        (0.89, 1.26, 0.22, 0.080),
        (0.81, 1.26, 0.42, 0.075),
        (0.68, 1.12, 0.56, 0.070),
        (0.67, 0.94, 0.57, 0.075),
        (0.72, 0.82, 0.48, 0.095),
        (0.76, 0.74, 0.32, 0.100),
    ];
    skull.unite(0.1, limb(&brow).on_both_sides());
    let zygomatic_arch =
        [(0.68, 0.84, 0.54, 0.085), (0.48, 0.83, 0.68, 0.058), (0.20, 0.86, 0.71, 0.055), (-0.06, 0.92, 0.62, 0.075)];
    skull.unite(0.08, limb(&zygomatic_arch).on_both_sides());
    // The mastoid behind the joint.
    skull.unite(0.1, limb(&[(-0.20, 0.95, 0.52, 0.13), (-0.14, 0.72, 0.48, 0.07)]).on_both_sides());
    // The wall between the eye and the temple.
    skull.unite(0.1, ellipsoid((0.48, 1.04, 0.40), (0.24, 0.24, 0.16)).on_both_sides());
    skull.carve(0.06, turned_ellipsoid(ORBIT.into(), ORBIT_RADII.into(), orbit_turn(1.0)).on_both_sides());
    // Bridge of the nose, and the opening below it.
    skull.unite(0.06, limb(&[(0.84, 1.20, 0.0, 0.09), (0.93, 1.05, 0.0, 0.062)]));
    skull.carve(0.04, ellipsoid((0.94, 0.83, 0.0), (0.26, 0.17, 0.095)));
    skull.carve(0.04, ellipsoid((0.92, 0.75, 0.065), (0.26, 0.10, 0.085)).on_both_sides());
}

/// Places of the teeth of one half along the ellipse of the jaws; radians from the middle.
const TEETH: [f64; 6] = [0.17, 0.50, 0.82, 1.10, 1.36, 1.61];

/// x and z on that ellipse, or within it.
fn along_jaws(angle: f64, inset: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [0.45 + (0.46 - inset) * cos, (0.34 - inset) * sin]
}

/// One on either side.
fn tooth(angle: f64, y: f64) -> Part {
    let [x, z] = along_jaws(angle, 0.0);
    turned_ellipsoid((x, y, z), (0.055, 0.115, 0.074), DMat3::from_rotation_y(-angle)).on_both_sides()
}

/// A limb along that ellipse, from the last tooth on one side to that on the other.
fn arch(inset: f64, y: f64, radius: f64) -> Vec<(f64, f64, f64, f64)> {
    let place = |step: i32| {
        let [x, z] = along_jaws(0.4 * f64::from(step), inset);
        (x, y, z, radius)
    };
    (-4..=4).map(place).collect()
}

fn lower_jaw() -> Figure {
    let half = [
        (0.16, 0.28, 0.50, 0.085),
        (0.36, 0.18, 0.45, 0.085),
        (0.60, 0.14, 0.36, 0.090),
        (0.82, 0.11, 0.21, 0.100),
        (0.91, 0.11, 0.0, 0.105),
    ];
    let other_half = half.iter().rev().skip(1).map(|&(x, y, z, radius)| (x, y, -z, radius));
    let body: Vec<_> = half.iter().copied().chain(other_half).collect();
    let mut jaw = Figure::new(limb(&body));
    let upright = DMat3::from_rotation_z(0.15);
    jaw.unite(0.08, turned_ellipsoid((0.13, 0.52, 0.51), (0.15, 0.38, 0.055), upright).on_both_sides());
    jaw.unite(0.05, limb(&[(0.05, 0.76, 0.51, 0.065), (0.0, 0.92, 0.50, 0.075)]).on_both_sides());
    jaw.unite(0.08, ball(0.95, 0.08, 0.0, 0.075));
    // The bone of the teeth, and a wall behind both rows, so that no gap between them opens the mouth.
    for (inset, y, radius) in [(0.0, 0.15, 0.085), (0.05, 0.34, 0.055)] {
        jaw.unite(0.05, limb(&arch(inset, y, radius)));
    }
    for angle in TEETH {
        jaw.unite(0.02, tooth(angle, 0.24));
    }
    jaw
}
