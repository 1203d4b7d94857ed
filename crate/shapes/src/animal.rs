//! A cow.

use glam::{DMat3, DVec3};
use heatwalk_surface::Soup;

use super::figure::{Figure, ball, ellipsoid, ground, limb, turned_ellipsoid};

/// A cow with horns, ears, an udder, cloven hoofs and a tail with its tuft. It stands on y = 0 and looks along +x, 2.9
/// long. Below a `spacing` of 0.026 no horn is lost.
pub fn animal(spacing: f64) -> Soup {
    let mut cow = trunk();
    add_legs(&mut cow);
    add_udder_and_tail(&mut cow);
    add_head(&mut cow);
    let (positions, triangles) = cow.mesh(DVec3::new(-1.35, -0.1, -0.6), DVec3::new(1.8, 2.25, 0.6), spacing);
    Soup::single("animal", positions, triangles)
}

fn trunk() -> Figure {
    let mut cow = Figure::new(ellipsoid((-0.12, 1.05, 0.0), (0.80, 0.37, 0.37)));
    cow.unite(0.2, ellipsoid((0.46, 1.10, 0.0), (0.36, 0.36, 0.29)));
    cow.unite(0.2, ellipsoid((-0.68, 1.13, 0.0), (0.31, 0.29, 0.32)));
    // The straight back, the hip bones, the brisket.
    cow.unite(0.2, limb(&[(-0.90, 1.35, 0.0, 0.08), (0.0, 1.33, 0.0, 0.10), (0.55, 1.36, 0.0, 0.09)]));
    cow.unite(0.2, ball(-0.58, 1.32, 0.19, 0.06).on_both_sides());
    cow.unite(0.15, ellipsoid((0.62, 0.86, 0.0), (0.22, 0.22, 0.15)));
    cow.unite(0.18, limb(&[(0.60, 1.16, 0.0, 0.27), (0.86, 1.38, 0.0, 0.195), (1.02, 1.52, 0.0, 0.165)]));
    // The dewlap.
    cow.unite(0.12, ellipsoid((0.80, 1.07, 0.0), (0.22, 0.21, 0.06)));
    cow
}

fn add_legs(cow: &mut Figure) {
    let fore = [
        (0.48, 0.95, 0.17, 0.17),
        (0.52, 0.64, 0.21, 0.100),
        (0.51, 0.42, 0.21, 0.076),
        (0.51, 0.19, 0.21, 0.058),
        (0.53, 0.10, 0.21, 0.072),
    ];
    let hind = [
        (-0.64, 0.88, 0.20, 0.17),
        (-0.62, 0.66, 0.23, 0.115),
        (-0.82, 0.45, 0.22, 0.074),
        (-0.78, 0.19, 0.22, 0.058),
        (-0.76, 0.10, 0.22, 0.072),
    ];
    cow.unite(0.12, ellipsoid((-0.70, 0.97, 0.17), (0.24, 0.32, 0.16)).on_both_sides());
    for leg in [fore, hind] {
        cow.unite(0.12, limb(&leg).on_both_sides());
        let (x, _, z, _) = leg[4];
        for claw in [-0.046, 0.046] {
            let balls = [(x + 0.01, 0.09, z + claw, 0.048), (x + 0.065, 0.02, z + 1.1 * claw, 0.056)];
            cow.unite(0.02, limb(&balls).on_both_sides());
        }
    }
    // Hoofs are flat at the ground; the cut is rounded so that vertices can be projected on it.
    cow.carve(0.03, ground());
}

fn add_udder_and_tail(cow: &mut Figure) {
    cow.unite(0.10, ellipsoid((-0.40, 0.67, 0.0), (0.24, 0.16, 0.18)));
    for x in [-0.32, -0.47] {
        cow.unite(0.04, limb(&[(x, 0.56, 0.08, 0.045), (x, 0.45, 0.09, 0.030)]).on_both_sides());
    }
    let tail = [
        (-0.93, 1.36, 0.0, 0.070),
        (-1.08, 1.27, 0.0, 0.048),
        (-1.14, 1.00, 0.0, 0.038),
        (-1.15, 0.66, 0.0, 0.036),
        (-1.15, 0.55, 0.0, 0.070),
        (-1.15, 0.44, 0.0, 0.062),
        (-1.14, 0.32, 0.0, 0.025),
    ];
    cow.unite(0.06, limb(&tail));
}

fn add_head(cow: &mut Figure) {
    let mut head = |blend, part| cow.unite(blend, part);
    head(0.08, limb(&[(1.08, 1.60, 0.0, 0.165), (1.30, 1.49, 0.0, 0.130), (1.52, 1.37, 0.0, 0.105)]));
    head(0.08, ball(1.09, 1.63, 0.07, 0.115).on_both_sides());
    head(0.06, limb(&[(1.10, 1.46, 0.05, 0.12), (1.42, 1.31, 0.03, 0.075)]).on_both_sides());
    head(0.06, turned_ellipsoid((1.55, 1.34, 0.0), (0.10, 0.115, 0.135), DMat3::from_rotation_z(-0.5)));
    // Eyes below their brows.
    head(0.04, ball(1.20, 1.645, 0.125, 0.050).on_both_sides());
    head(0.02, ball(1.225, 1.595, 0.125, 0.038).on_both_sides());
    let ear = DMat3::from_rotation_y(0.35) * DMat3::from_rotation_x(0.35);
    head(0.05, turned_ellipsoid((1.00, 1.62, 0.29), (0.042, 0.085, 0.17), ear).on_both_sides());
    let horn =
        [(1.05, 1.72, 0.09, 0.062), (1.03, 1.79, 0.21, 0.056), (1.06, 1.93, 0.30, 0.044), (1.14, 2.08, 0.28, 0.026)];
    head(0.03, limb(&horn).on_both_sides());
    cow.carve(0.03, ellipsoid((1.065, 1.63, 0.31), (0.035, 0.05, 0.12)).on_both_sides());
    cow.carve(0.02, ball(1.655, 1.355, 0.06, 0.030).on_both_sides());
    cow.carve(0.02, limb(&[(1.66, 1.265, 0.0, 0.016), (1.52, 1.245, 0.12, 0.016)]).on_both_sides());
}
