//! Meshes of layers of prisms over a triangulated cross-section, each prism cut into three tetrahedra.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use super::icosahedron::{faces_of, icosahedron};
use crate::soup::TetSoup;

/// Radius of the bends of a [`pipe`].
const BEND: f64 = 0.55;

/// Length of its straight parts.
const STRAIGHT: f64 = 1.2;

/// Rounds of smoothing between pillars: the rows of triangles from one to the middle between two, and some.
const ROUNDS: usize = 40;

/// Layers over triangles with ascending corners. `place` tells where each vertex of each layer is, from 0 to `layers`, and is called in
/// their order.
fn prisms(
    triangles: &[[u32; 3]],
    vertices: usize,
    layers: usize,
    mut place: impl FnMut(usize, usize) -> DVec3,
) -> TetSoup {
    let positions = (0..=layers).flat_map(|layer| (0..vertices).map(move |vertex| (vertex, layer)));
    let positions = positions.map(|(vertex, layer)| place(vertex, layer)).collect();
    let mut tetrahedra = Vec::with_capacity(3 * layers * triangles.len());
    for layer in 0..layers as u32 {
        for corners in triangles {
            // Sides are cut from the lower number below to the higher one above, so prisms beside each other agree.
            let [[a, b, c], [d, e, f]] = [layer, layer + 1].map(|layer| corners.map(|k| layer * vertices as u32 + k));
            tetrahedra.extend([[a, b, c, f], [a, b, e, f], [a, d, e, f]]);
        }
    }
    TetSoup { positions, tetrahedra }
}

fn ascending(mut corners: [u32; 3]) -> [u32; 3] {
    corners.sort_unstable();
    corners
}

/// The unit disc as a hexagon of 6 `rings`² triangles, whose sides are bent to circles: places of vertices, from the middle outward,
/// and triangles.
fn hexagonal_disc(rings: usize) -> (Vec<DVec2>, Vec<[u32; 3]>) {
    let number = |ring: usize, place: usize| match ring {
        0 => 0,
        _ => (1 + 3 * ring * (ring - 1) + place % (6 * ring)) as u32,
    };
    let mut places = vec![DVec2::ZERO];
    let mut triangles = Vec::new();
    for ring in 1..=rings {
        let angle = |place: usize| TAU * place as f64 / (6 * ring) as f64;
        let radius = ring as f64 / rings as f64;
        places.extend((0..6 * ring).map(|place| radius * DVec2::from_angle(angle(place))));
        for side in 0..6 {
            let outer = |place: usize| number(ring, side * ring + place);
            let inner = |place: usize| number(ring - 1, side * (ring - 1) + place);
            for place in 0..ring {
                triangles.push(ascending([outer(place), outer(place + 1), inner(place)]));
                if place + 1 < ring {
                    triangles.push(ascending([inner(place), outer(place + 1), inner(place + 1)]));
                }
            }
        }
    }
    (places, triangles)
}

/// The middle line of the pipe at a length from its start, and its direction there: three straight parts, one above another, and two
/// half circles that join them to an S.
fn middle_line(length: f64) -> [DVec3; 2] {
    let bend = PI * BEND;
    let mut rest = length;
    let mut height = -2.0 * BEND;
    for sign in [1.0, -1.0] {
        if rest <= STRAIGHT {
            break;
        }
        rest -= STRAIGHT;
        if rest < bend {
            let (sin, cos) = (rest / BEND).sin_cos();
            let middle = DVec3::new(sign * STRAIGHT / 2.0, height + BEND, 0.0);
            return [middle + BEND * DVec3::new(sign * sin, -cos, 0.0), DVec3::new(sign * cos, sin, 0.0)];
        }
        rest -= bend;
        height += 2.0 * BEND;
    }
    // The second of the straight parts goes back.
    let sign = if height.abs() < BEND { -1.0 } else { 1.0 };
    [DVec3::new(sign * (rest - STRAIGHT / 2.0), height, 0.0), DVec3::new(sign, 0.0, 0.0)]
}

/// A solid pipe in the form of an S in the plane of x and y, around the origin: straight parts of length 1.2, and half circles of radius
/// 0.55 between them. Its cross-section is a circle of `radius` (less than 0.55), `cells` cells from the middle outward. Vertices inside are
/// moved by up to `jitter` cells; up to 0.2 no tetrahedron is inverted.
pub fn pipe(radius: f64, cells: usize, jitter: f64) -> TetSoup {
    let (places, triangles) = hexagonal_disc(cells);
    let rim = places.len() - 6 * cells;
    let length = 3.0 * STRAIGHT + TAU * BEND;
    let cell = radius / cells as f64;
    let layers = (length / cell).round() as usize;
    let mut random = SplitMix64::seed_from_u64(1);
    prisms(&triangles, places.len(), layers, |vertex, layer| {
        let mut along = length * layer as f64 / layers as f64;
        let mut across = radius * places[vertex];
        if vertex < rim && (1..layers).contains(&layer) {
            let mut shift = || cell * jitter * (2.0 * random.random::<f64>() - 1.0);
            across += DVec2::new(shift(), shift());
            along += shift();
        }
        let [middle, direction] = middle_line(along);
        middle + across.x * DVec3::Z.cross(direction) + across.y * DVec3::Z
    })
}

/// The unit sphere without circles of angular radius `hole` around the corners of an icosahedron, as faces of that cut into `cells`²
/// triangles each: directions of vertices, and triangles.
fn pierced_sphere(hole: f64, cells: usize) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let corners = icosahedron();
    // Rows of triangles that are left out at each corner: as many as fit into the hole.
    let side = corners[0].angle_between(corners[faces_of(&corners).next().map_or(1, |face| face[1])]);
    let rows = ((hole / side * cells as f64).round() as usize).clamp(1, cells / 2 - 1);
    let mut numbers: HashMap<[(usize, usize); 3], u32> = HashMap::new();
    let mut directions: Vec<DVec3> = Vec::new();
    // Of each vertex the corner whose hole it is at.
    let mut hole_of: Vec<Option<usize>> = Vec::new();
    let mut triangles = Vec::new();
    for [a, b, c] in faces_of(&corners) {
        let mut vertex = |[i, j]: [usize; 2]| {
            let mut weights = [(a, cells - i - j), (b, i), (c, j)];
            weights.iter_mut().filter(|weight| weight.1 == 0).for_each(|weight| *weight = (0, 0));
            weights.sort_unstable();
            *numbers.entry(weights).or_insert_with(|| {
                let sum: DVec3 = weights.iter().map(|&(corner, weight)| corners[corner] * weight as f64).sum();
                directions.push(sum.normalize());
                let at_hole = weights.iter().find(|&&(_, weight)| weight == cells - rows);
                hole_of.push(at_hole.map(|&(corner, _)| corner));
                directions.len() as u32 - 1
            })
        };
        for (i, j) in (0..cells).flat_map(|i| (0..cells - i).map(move |j| (i, j))) {
            let turned = (i + j + 2 <= cells).then_some([[i + 1, j + 1], [i, j + 1], [i + 1, j]]);
            for corners in [Some([[i, j], [i + 1, j], [i, j + 1]]), turned].into_iter().flatten() {
                let is_in_hole = |&[i, j]: &[usize; 2]| i.max(j).max(cells - i - j) > cells - rows;
                if !corners.iter().any(is_in_hole) {
                    triangles.push(ascending(corners.map(&mut vertex)));
                }
            }
        }
    }
    smooth(&mut directions, &triangles, |vertex, direction| match hole_of[vertex] {
        Some(corner) => {
            let axis = corners[corner];
            hole.cos() * axis + hole.sin() * direction.reject_from_normalized(axis).normalize()
        }
        None => direction.normalize(),
    });
    (directions, triangles)
}

/// Moves each vertex to the mean of its neighbors, and from there to where `settle` puts it, several times.
fn smooth(directions: &mut Vec<DVec3>, triangles: &[[u32; 3]], settle: impl Fn(usize, DVec3) -> DVec3) {
    for _ in 0..ROUNDS {
        let mut sums = vec![DVec3::ZERO; directions.len()];
        for triangle in triangles {
            for k in 0..3 {
                let [a, b] = [triangle[k], triangle[(k + 1) % 3]].map(|vertex| vertex as usize);
                sums[a] += directions[b];
                sums[b] += directions[a];
            }
        }
        *directions = sums.into_iter().enumerate().map(|(vertex, sum)| settle(vertex, sum)).collect();
    }
}

/// What is between two spheres around the origin, of radius 1 and of `inner_radius` (less than 1), without twelve pillars that join
/// these: cones from the origin of angular radius `pillar` around the corners of an icosahedron. Its faces have `cells` cells along
/// each side. Vertices inside are moved by up to `jitter` cells; up to 0.15 no tetrahedron is inverted.
pub fn pillared_cave(inner_radius: f64, pillar: f64, cells: usize, jitter: f64) -> TetSoup {
    let (directions, triangles) = pierced_sphere(pillar, cells);
    // A cell is as high as it is wide in the middle of the wall.
    let cell = 1.1 / cells as f64;
    let layers = ((1.0 / inner_radius).ln() / cell).round().max(1.0) as usize;
    let edges = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [a, c]]);
    let mut sides: HashMap<[u32; 2], usize> = HashMap::new();
    edges.for_each(|edge| *sides.entry(edge).or_default() += 1);
    let mut is_rim = vec![false; directions.len()];
    let open = sides.iter().filter(|&(_, &count)| count == 1);
    open.flat_map(|(edge, _)| edge).for_each(|&vertex| is_rim[vertex as usize] = true);
    let mut random = SplitMix64::seed_from_u64(1);
    prisms(&triangles, directions.len(), layers, |vertex, layer| {
        let mut direction = directions[vertex];
        let mut share = layer as f64 / layers as f64;
        if !is_rim[vertex] && (1..layers).contains(&layer) {
            let mut shift = || jitter * (2.0 * random.random::<f64>() - 1.0);
            direction += cell * DVec3::new(shift(), shift(), shift());
            share += shift() / layers as f64;
        }
        inner_radius.powf(1.0 - share) * direction.normalize()
    })
}
