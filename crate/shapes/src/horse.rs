//! A standing horse.

use glam::{DMat3, DVec3};
use heatwalk_surface::Soup;

use super::figure::{Figure, ball, ellipsoid, ground, limb, turned_ellipsoid};

/// A horse with an arched neck, a mane, a long tail and four hoofs. It stands on y = 0 and looks along +x, 2.6 high.
/// Below a `spacing` of 0.028 no ear is lost.
pub fn horse(spacing: f64) -> Soup {
    let mut horse = trunk();
    add_legs(&mut horse);
    add_neck_and_tail(&mut horse);
    add_head(&mut horse);
    let (positions, triangles) = horse.mesh(DVec3::new(-1.3, -0.1, -0.5), DVec3::new(1.75, 2.7, 0.5), spacing);
    Soup::single("horse", positions, triangles)
}

fn trunk() -> Figure {
    let mut horse = Figure::new(ellipsoid((-0.02, 1.24, 0.0), (0.60, 0.32, 0.28)));
    // Chest, withers, croup.
    horse.unite(0.2, ellipsoid((0.42, 1.24, 0.0), (0.32, 0.36, 0.24)));
    horse.unite(0.2, ellipsoid((0.30, 1.50, 0.0), (0.26, 0.10, 0.09)));
    horse.unite(0.2, ellipsoid((-0.52, 1.31, 0.0), (0.34, 0.30, 0.27)));
    horse.unite(0.1, ellipsoid((0.62, 1.18, 0.10), (0.14, 0.18, 0.12)).on_both_sides());
    horse
}

fn add_legs(horse: &mut Figure) {
    let shoulder = DMat3::from_rotation_z(-0.35);
    horse.unite(0.12, turned_ellipsoid((0.44, 1.20, 0.14), (0.18, 0.36, 0.13), shoulder).on_both_sides());
    horse.unite(0.12, ellipsoid((-0.56, 1.12, 0.14), (0.25, 0.34, 0.15)).on_both_sides());
    let fore = [
        (0.42, 1.00, 0.16, 0.14),
        (0.45, 0.84, 0.17, 0.095),
        (0.46, 0.60, 0.17, 0.066),
        (0.47, 0.54, 0.17, 0.068),
        (0.45, 0.44, 0.17, 0.050),
        (0.45, 0.24, 0.17, 0.046),
        (0.45, 0.18, 0.17, 0.058),
        (0.50, 0.09, 0.17, 0.050),
    ];
    let hind = [
        (-0.46, 1.00, 0.17, 0.17),
        (-0.46, 0.88, 0.18, 0.125),
        (-0.66, 0.66, 0.17, 0.075),
        (-0.70, 0.59, 0.17, 0.070),
        (-0.67, 0.48, 0.17, 0.054),
        (-0.66, 0.24, 0.17, 0.049),
        (-0.66, 0.18, 0.17, 0.060),
        (-0.61, 0.09, 0.17, 0.052),
    ];
    for leg in [fore, hind] {
        horse.unite(0.1, limb(&leg).on_both_sides());
        let (x, _, z, _) = leg[7];
        horse.unite(0.015, limb(&[(x + 0.005, 0.09, z, 0.062), (x + 0.03, 0.0, z, 0.090)]).on_both_sides());
    }
    // Hoofs are flat at the ground; the cut is rounded so that vertices can be projected on it.
    horse.carve(0.03, ground());
}

fn add_neck_and_tail(horse: &mut Figure) {
    let neck = [
        (0.46, 1.32, 0.0, 0.28),
        (0.66, 1.60, 0.0, 0.215),
        (0.79, 1.90, 0.0, 0.165),
        (0.90, 2.12, 0.0, 0.140),
        (1.04, 2.20, 0.0, 0.125),
    ];
    horse.unite(0.16, limb(&neck));
    // The mane: a crest of tufts from the forelock to the withers.
    let crest = [
        (1.14, 2.32, 0.0, 0.040),
        (0.99, 2.38, 0.0, 0.050),
        (0.82, 2.32, 0.0, 0.056),
        (0.66, 2.12, 0.0, 0.060),
        (0.56, 1.90, 0.0, 0.060),
        (0.44, 1.68, 0.0, 0.054),
        (0.30, 1.57, 0.0, 0.040),
    ];
    horse.unite(0.06, limb(&crest));
    let tail = [
        (-0.78, 1.46, 0.0, 0.075),
        (-0.94, 1.44, 0.0, 0.075),
        (-1.04, 1.28, 0.0, 0.090),
        (-1.07, 1.00, 0.0, 0.105),
        (-1.05, 0.72, 0.0, 0.095),
        (-1.03, 0.50, 0.0, 0.060),
        (-1.02, 0.40, 0.0, 0.028),
    ];
    horse.unite(0.06, limb(&tail));
}

fn add_head(horse: &mut Figure) {
    let mut head = |blend, part| horse.unite(blend, part);
    head(0.08, limb(&[(1.06, 2.20, 0.0, 0.140), (1.32, 1.92, 0.0, 0.100), (1.46, 1.76, 0.0, 0.085)]));
    // The round cheeks, the muzzle, the chin.
    let along = DMat3::from_rotation_z(-0.8);
    head(0.06, turned_ellipsoid((1.08, 2.04, 0.055), (0.19, 0.14, 0.075), along).on_both_sides());
    head(0.05, turned_ellipsoid((1.48, 1.73, 0.0), (0.10, 0.10, 0.092), along));
    head(0.04, limb(&[(1.20, 1.93, 0.0, 0.085), (1.40, 1.69, 0.0, 0.055)]));
    head(0.04, ellipsoid((1.16, 2.205, 0.095), (0.06, 0.04, 0.035)).on_both_sides());
    head(0.02, ball(1.18, 2.165, 0.098, 0.036).on_both_sides());
    let ear = [(0.98, 2.30, 0.075, 0.050), (0.98, 2.40, 0.095, 0.056), (1.02, 2.54, 0.085, 0.022)];
    head(0.03, limb(&ear).on_both_sides());
    horse.carve(0.02, limb(&[(1.06, 2.40, 0.105, 0.022), (1.05, 2.46, 0.10, 0.014)]).on_both_sides());
    horse.carve(0.02, ball(1.535, 1.755, 0.065, 0.026).on_both_sides());
    horse.carve(0.05, limb(&[(1.52, 1.645, 0.0, 0.018), (1.42, 1.70, 0.085, 0.018)]).on_both_sides());
}
