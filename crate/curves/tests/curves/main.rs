//! Isolines, strips and unrolled shapes against what is known of planes, spheres, cylinders and cones.

mod borders;
mod decals;
mod isolines;
mod refined;
mod unrolled;

use std::f64::consts::TAU;

use glam::DVec3;
use heatwalk_curves::Field;
use heatwalk_surface::{Soup, Surface};

/// A welded shape with a value at each vertex.
fn field(soup: &Soup, distance: impl Fn(DVec3) -> f64) -> Field {
    let surface = Surface::build(soup).unwrap();
    let triangles = surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect();
    let distances = surface.positions().iter().map(|&position| distance(position)).collect();
    Field::new(surface.positions().iter().copied().collect(), triangles, distances).unwrap()
}

fn area(positions: &[DVec3], triangles: &[[u32; 3]]) -> f64 {
    let of = |&[a, b, c]: &[u32; 3]| {
        let [a, b, c] = [a, b, c].map(|corner| positions[corner as usize]);
        0.5 * (b - a).cross(c - a).length()
    };
    triangles.iter().map(of).sum()
}

/// An open tube of radius 1 around Z, from 0 to `height`, triangulated; its facets are flat.
fn tube(around: u32, rings: u32, height: f64) -> Soup {
    let place = |ring: u32, index: u32| {
        let angle = TAU * f64::from(index) / f64::from(around);
        DVec3::new(angle.cos(), angle.sin(), height * f64::from(ring) / f64::from(rings))
    };
    let positions = (0..=rings).flat_map(|ring| (0..around).map(move |index| place(ring, index))).collect();
    let square = |ring: u32, index: u32| {
        let next = (index + 1) % around;
        let [a, b, c, d] =
            [ring * around + index, ring * around + next, (ring + 1) * around + next, (ring + 1) * around + index];
        [[a, b, c], [a, c, d]]
    };
    let triangles = (0..rings).flat_map(|ring| (0..around).flat_map(move |index| square(ring, index))).collect();
    Soup::single("tube", positions, triangles)
}

/// The area of a plane shape, without its holes.
fn plane_area(loops: &[Vec<glam::DVec2>]) -> f64 {
    let of = |outline: &Vec<glam::DVec2>| -> f64 {
        let next = |index: usize| outline[(index + 1) % outline.len()];
        0.5 * outline.iter().enumerate().map(|(index, point)| point.perp_dot(next(index))).sum::<f64>()
    };
    loops.iter().map(of).sum()
}
