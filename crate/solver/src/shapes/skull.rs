//! A human skull on a stand.

use glam::{DMat3, DVec3};

use super::figure::{Figure, ball, ellipsoid, limb, turned_ellipsoid};
use super::parametric::revolve;
use crate::soup::{Part, Soup};

/// Part 0, "skull": cranium, face and lower jaw in one piece, looking along +x, 2.1 high. It has four handles: the two
/// zygomatic arches, and the lower jaw, which meets the rest at both joints and at the teeth. Part 1, "stand": a round
/// plinth with a stem.
pub fn skull(spacing: f64) -> Soup {
    let mut skull = cranium();
    add_face(&mut skull);
    add_lower_jaw(&mut skull);
    add_teeth(&mut skull);
    let (positions, triangles) = skull.mesh(DVec3::new(-1.15, -0.12, -0.95), DVec3::new(1.2, 2.25, 0.95), spacing);
    let mut soup = Soup::single("skull", positions, triangles);
    let bones = soup.triangles.len();
    revolve(&mut soup, &STAND, 128);
    soup.parts.push(Part { name: "stand".to_owned(), triangles: bones..soup.triangles.len() });
    soup
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
    let outward = DMat3::from_rotation_y(-0.38);
    skull.carve(0.06, turned_ellipsoid((0.80, 1.02, 0.325), (0.42, 0.185, 0.195), outward).on_both_sides());
    // Bridge of the nose, and the opening below it.
    skull.unite(0.06, limb(&[(0.84, 1.20, 0.0, 0.09), (0.93, 1.05, 0.0, 0.062)]));
    skull.carve(0.04, ellipsoid((0.94, 0.83, 0.0), (0.26, 0.17, 0.095)));
    skull.carve(0.04, ellipsoid((0.92, 0.75, 0.065), (0.26, 0.10, 0.085)).on_both_sides());
}

fn add_lower_jaw(skull: &mut Figure) {
    let half = [
        (0.16, 0.28, 0.50, 0.085),
        (0.36, 0.18, 0.45, 0.085),
        (0.60, 0.14, 0.36, 0.090),
        (0.82, 0.11, 0.21, 0.100),
        (0.91, 0.11, 0.0, 0.105),
    ];
    let other_half = half.iter().rev().skip(1).map(|&(x, y, z, radius)| (x, y, -z, radius));
    let body: Vec<_> = half.iter().copied().chain(other_half).collect();
    skull.unite(0.06, limb(&body));
    let upright = DMat3::from_rotation_z(0.15);
    skull.unite(0.08, turned_ellipsoid((0.13, 0.52, 0.51), (0.15, 0.38, 0.055), upright).on_both_sides());
    skull.unite(0.05, limb(&[(0.05, 0.76, 0.51, 0.065), (0.0, 0.92, 0.50, 0.075)]).on_both_sides());
    skull.unite(0.08, ball(0.95, 0.08, 0.0, 0.075));
}

/// Places of the teeth of one half along the ellipse of the jaws; radians from the middle.
const TEETH: [f64; 6] = [0.17, 0.50, 0.82, 1.10, 1.36, 1.61];

fn add_teeth(skull: &mut Figure) {
    let along_jaw = |angle: f64, inset: f64, y: f64, radius: f64| {
        let (sin, cos) = angle.sin_cos();
        (0.45 + (0.46 - inset) * cos, y, (0.34 - inset) * sin, radius)
    };
    // Gums, and bone behind the teeth, so that no gap between them opens the mouth.
    for (inset, y, radius) in [(0.0, 0.54, 0.075), (0.02, 0.34, 0.055), (0.0, 0.15, 0.085)] {
        let arch: Vec<_> = (-4..=4).map(|step| along_jaw(0.4 * f64::from(step), inset, y, radius)).collect();
        skull.unite(0.05, limb(&arch));
    }
    for angle in TEETH {
        let (x, _, z, _) = along_jaw(angle, 0.0, 0.0, 0.0);
        skull.unite(0.02, limb(&[(x, 0.50, z, 0.054), (x, 0.395, z, 0.064)]).on_both_sides());
        skull.unite(0.02, limb(&[(x, 0.19, z, 0.054), (x, 0.270, z, 0.062)]).on_both_sides());
    }
}
