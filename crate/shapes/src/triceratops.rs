//! A triceratops.

use std::f64::consts::PI;

use glam::{DMat3, DVec3};
use heatwalk_surface::Soup;

use super::figure::{Figure, ball, ellipsoid, ground, limb, turned_ellipsoid};

/// A triceratops with its frill, three horns, a beak and toes. It stands on y = 0 and looks along +x, 4.3 long. Below a
/// `spacing` of 0.036 no horn is lost.
pub fn triceratops(spacing: f64) -> Soup {
    let mut triceratops = trunk();
    for leg in [FORE_LEG, HIND_LEG] {
        add_leg(&mut triceratops, &leg);
    }
    // Feet are flat at the ground; the cut is rounded so that vertices can be projected on it.
    triceratops.carve(0.04, ground());
    add_head(&mut triceratops);
    add_frill_and_horns(&mut triceratops);
    let (positions, triangles) = triceratops.mesh(DVec3::new(-2.4, -0.12, -0.85), DVec3::new(2.3, 2.3, 0.85), spacing);
    Soup::single("triceratops", positions, triangles)
}

const FORE_LEG: [(f64, f64, f64, f64); 4] =
    [(0.56, 0.86, 0.28, 0.24), (0.46, 0.56, 0.40, 0.165), (0.52, 0.26, 0.40, 0.120), (0.54, 0.08, 0.40, 0.135)];
const HIND_LEG: [(f64, f64, f64, f64); 4] =
    [(-0.48, 0.95, 0.26, 0.32), (-0.36, 0.64, 0.36, 0.215), (-0.52, 0.30, 0.36, 0.135), (-0.48, 0.08, 0.36, 0.150)];

fn trunk() -> Figure {
    let mut triceratops = Figure::new(ellipsoid((0.0, 1.00, 0.0), (0.80, 0.47, 0.45)));
    triceratops.unite(0.25, ellipsoid((-0.40, 1.08, 0.0), (0.52, 0.46, 0.40)));
    triceratops.unite(0.25, ellipsoid((0.50, 0.98, 0.0), (0.42, 0.40, 0.37)));
    let tail = [
        (-0.65, 1.08, 0.0, 0.34),
        (-1.05, 0.94, 0.0, 0.235),
        (-1.45, 0.78, 0.0, 0.150),
        (-1.85, 0.68, 0.0, 0.085),
        (-2.20, 0.66, 0.0, 0.036),
    ];
    triceratops.unite(0.2, limb(&tail));
    triceratops.unite(0.2, limb(&[(0.70, 1.02, 0.0, 0.32), (1.05, 1.06, 0.0, 0.27)]));
    triceratops
}

fn add_leg(triceratops: &mut Figure, leg: &[(f64, f64, f64, f64); 4]) {
    triceratops.unite(0.15, limb(leg).on_both_sides());
    let (x, _, z, radius) = leg[3];
    for toe in -1..=2 {
        let (sin, cos) = (0.62 * (f64::from(toe) - 0.35)).sin_cos();
        let at = |reach: f64, y: f64, thickness: f64| (x + reach * cos, y, z + reach * sin, thickness);
        triceratops.unite(0.03, limb(&[at(0.6 * radius, 0.07, 0.06), at(1.35 * radius, 0.03, 0.045)]).on_both_sides());
    }
}

fn add_head(triceratops: &mut Figure) {
    let mut head = |blend, part| triceratops.unite(blend, part);
    head(0.12, limb(&[(1.15, 1.08, 0.0, 0.29), (1.48, 0.96, 0.0, 0.215), (1.78, 0.84, 0.0, 0.140)]));
    // Cheeks with their horns, the lower jaw, the hooked beak.
    head(0.08, limb(&[(1.20, 0.92, 0.20, 0.12), (1.12, 0.78, 0.30, 0.05)]).on_both_sides());
    head(0.06, limb(&[(1.25, 0.80, 0.0, 0.17), (1.60, 0.70, 0.0, 0.105), (1.84, 0.66, 0.0, 0.060)]));
    head(0.05, limb(&[(1.76, 0.88, 0.0, 0.13), (1.95, 0.80, 0.0, 0.080), (2.02, 0.66, 0.0, 0.034)]));
    head(0.05, ball(1.37, 1.12, 0.195, 0.075).on_both_sides());
    head(0.015, ball(1.40, 1.08, 0.215, 0.048).on_both_sides());
    let mouth = [(1.92, 0.70, 0.0, 0.018), (1.80, 0.725, 0.12, 0.018), (1.55, 0.76, 0.185, 0.018)];
    triceratops.carve(0.03, limb(&mouth).on_both_sides());
    triceratops.carve(0.03, ball(1.88, 0.885, 0.085, 0.034).on_both_sides());
}

/// Lean of the frill behind the vertical.
const LEAN: f64 = 0.62;
const FRILL: (f64, f64, f64) = (0.97, 1.44, 0.0);
const FRILL_RADII: (f64, f64, f64) = (0.09, 0.66, 0.68);
const SPIKES: u32 = 15;

fn add_frill_and_horns(triceratops: &mut Figure) {
    let frill = DMat3::from_rotation_z(LEAN);
    triceratops.unite(0.12, turned_ellipsoid(FRILL, FRILL_RADII, frill));
    // Bony points along the rim, from one cheek over the top to the other.
    for spike in 0..SPIKES {
        let angle = PI * (1.28 * f64::from(spike) / f64::from(SPIKES - 1) - 0.14);
        let at = |share: f64| {
            DVec3::from(FRILL)
                + share * (frill * DVec3::new(0.0, FRILL_RADII.1 * angle.sin(), FRILL_RADII.2 * angle.cos()))
        };
        let (root, tip) = (at(0.90), at(1.04));
        triceratops.unite(0.03, limb(&[(root.x, root.y, root.z, 0.065), (tip.x, tip.y, tip.z, 0.042)]));
    }
    let brow =
        [(1.30, 1.20, 0.16, 0.100), (1.46, 1.44, 0.20, 0.080), (1.70, 1.66, 0.24, 0.056), (1.98, 1.78, 0.26, 0.034)];
    triceratops.unite(0.06, limb(&brow).on_both_sides());
    triceratops.unite(0.06, limb(&[(1.70, 0.98, 0.0, 0.095), (1.80, 1.20, 0.0, 0.036)]));
}
