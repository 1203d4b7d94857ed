//! Generated meshes: what a page or a test needs without a file. All are deterministic. Most are made of grids whose cells are cut
//! into six tetrahedra each (Kuhn 1960), so that the same shape with twice the cells has the vertices of the coarser one where
//! nothing is jittered; [`pipe`] and [`pillared_cave`] of layers of prisms.

mod icosahedron;
mod layers;

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use glam::DVec3;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use crate::soup::TetSoup;
use icosahedron::{faces_of, icosahedron};

pub use layers::{pillared_cave, pipe};

/// Steps from corner to corner of a cell's tetrahedra: the six orders of the axes.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// A grid in a cube, mapped into space.
struct Grid<'a> {
    /// Cells along each axis.
    cells: [usize; 3],
    /// Whether the second axis closes on itself.
    is_closed: bool,
    /// Whether a cell is there.
    has: &'a dyn Fn([usize; 3]) -> bool,
    /// How far vertices inside are moved along each axis at most, as a share of a cell.
    jitter: f64,
    /// From the unit cube to space.
    map: &'a dyn Fn(DVec3) -> DVec3,
}

impl Grid<'_> {
    fn soup(&self) -> TetSoup {
        let [nx, ny, nz] = self.cells;
        // Along a closed axis, the last row of vertices is the first.
        let rows = if self.is_closed { ny } else { ny + 1 };
        let number = |[x, y, z]: [usize; 3]| ((x * rows + y % rows) * (nz + 1) + z) as u32;
        let count = (nx + 1) * rows * (nz + 1);
        let mut cells_around = vec![0_u8; count];
        let mut tetrahedra = Vec::with_capacity(6 * nx * ny * nz);
        for x in 0..nx {
            for y in 0..ny {
                for z in 0..nz {
                    if !(self.has)([x, y, z]) {
                        continue;
                    }
                    for corner in 0..8 {
                        let corner = [x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2)];
                        cells_around[number(corner) as usize] += 1;
                    }
                    for order in ORDERS {
                        let mut corner = [x, y, z];
                        let mut next = |axis: usize| {
                            corner[axis] += 1;
                            number(corner)
                        };
                        tetrahedra.push([number([x, y, z]), next(order[0]), next(order[1]), next(order[2])]);
                    }
                }
            }
        }
        let mut random = SplitMix64::seed_from_u64(1);
        let mut positions = vec![DVec3::ZERO; count];
        for x in 0..=nx {
            for y in 0..rows {
                for z in 0..=nz {
                    let index = number([x, y, z]) as usize;
                    let shift = DVec3::from_array([0; 3].map(|_| self.jitter * (2.0 * random.random::<f64>() - 1.0)));
                    let shift = if cells_around[index] == 8 { shift } else { DVec3::ZERO };
                    let cells = DVec3::new(nx as f64, ny as f64, nz as f64);
                    positions[index] = (self.map)((DVec3::new(x as f64, y as f64, z as f64) + shift) / cells);
                }
            }
        }
        TetSoup { positions, tetrahedra }
    }
}

/// A cube of edge 2 around the origin, of 6 `cells`³ tetrahedra. Vertices inside are moved by up to `jitter` cells along each axis;
/// up to 0.2 no tetrahedron is inverted.
pub fn cube(cells: usize, jitter: f64) -> TetSoup {
    let map = |point: DVec3| 2.0 * point - DVec3::ONE;
    Grid { cells: [cells; 3], is_closed: false, has: &|_| true, jitter, map: &map }.soup()
}

/// The unit ball, of 20 `cells`³ tetrahedra: an icosahedron of 20 tetrahedra that meet in the middle, each cut into `cells`³.
pub fn ball(cells: usize, jitter: f64) -> TetSoup {
    icosahedral(cells, 0, jitter, &|share| share)
}

/// What is between two spheres around the origin, of radius 1 and of `inner_radius` (less than 1), of 140 `cells`³ tetrahedra.
pub fn cave(inner_radius: f64, cells: usize, jitter: f64) -> TetSoup {
    icosahedral(2 * cells, cells, jitter, &|share| inner_radius + (1.0 - inner_radius) * (2.0 * share - 1.0))
}

/// The layers from `first` on of an icosahedron cut into `layers`, mapped to spheres whose radius `radius` tells from the share of
/// layers.
fn icosahedral(layers: usize, first: usize, jitter: f64, radius: &dyn Fn(f64) -> f64) -> TetSoup {
    let corners = icosahedron();
    let mut soup = TetSoup::default();
    let mut numbers: HashMap<[(usize, usize); 3], u32> = HashMap::new();
    let mut random = SplitMix64::seed_from_u64(1);
    for [a, b, c] in faces_of(&corners) {
        let mut vertex = |[x, y, z]: [usize; 3]| {
            // Weights of a, b and c in layer x. A vertex is known by those that are not 0, also in another face.
            let mut weights = [(a, x - y), (b, y - z), (c, z)];
            weights.iter_mut().filter(|weight| weight.1 == 0).for_each(|weight| *weight = (0, 0));
            weights.sort_unstable();
            *numbers.entry(weights).or_insert_with(|| {
                let mut direction: DVec3 =
                    weights.iter().map(|&(corner, weight)| corners[corner] * weight as f64).sum();
                let mut layer = x as f64;
                if x > first && x < layers {
                    let mut shift = || jitter * (2.0 * random.random::<f64>() - 1.0);
                    direction += DVec3::new(shift(), shift(), shift());
                    layer += shift();
                }
                soup.positions.push(radius(layer / layers as f64) * direction.normalize_or_zero());
                soup.positions.len() as u32 - 1
            })
        };
        for x in first..layers {
            for (y, z) in (0..=x).flat_map(|y| (0..=y).map(move |z| (y, z))) {
                for order in ORDERS {
                    let mut corner = [x, y, z];
                    let mut steps = [corner; 4];
                    for (step, &axis) in order.iter().enumerate() {
                        corner[axis] += 1;
                        steps[step + 1] = corner;
                    }
                    if steps.iter().all(|&[x, y, z]| x >= y && y >= z) {
                        soup.tetrahedra.push(steps.map(&mut vertex));
                    }
                }
            }
        }
    }
    soup
}

/// The disc of the second and third coordinates in a square of edge 2.
fn disc(y: f64, z: f64) -> [f64; 2] {
    [y * (1.0 - z * z / 2.0).sqrt(), z * (1.0 - y * y / 2.0).sqrt()]
}

/// A straight solid tube along x, from −`half_length` to it, of radius 1; `cells` cells across, as long ones along it.
pub fn straight_tube(half_length: f64, cells: usize, jitter: f64) -> TetSoup {
    let along = (half_length * cells as f64).round() as usize;
    let map = |point: DVec3| {
        let point = 2.0 * point - DVec3::ONE;
        let [y, z] = disc(point.y, point.z);
        DVec3::new(half_length * point.x, y, z)
    };
    Grid { cells: [along, cells, cells], is_closed: false, has: &|_| true, jitter, map: &map }.soup()
}

/// A solid pipe that is bent by `angle` (less than 2π) around the y axis: its middle line is at distance 1 from the axis, and
/// `radius` (less than 1) is its own. It has `cells` cells across.
pub fn bent_tube(radius: f64, angle: f64, cells: usize, jitter: f64) -> TetSoup {
    let along = (angle / (2.0 * radius) * cells as f64).round() as usize;
    let map = |point: DVec3| {
        let square = 2.0 * point - DVec3::ONE;
        let [y, z] = disc(square.y, square.z);
        let (from_axis, turn) = (1.0 + radius * z, angle * point.x);
        DVec3::new(from_axis * turn.cos(), radius * y, -from_axis * turn.sin())
    };
    Grid { cells: [along, cells, cells], is_closed: false, has: &|_| true, jitter, map: &map }.soup()
}

/// A cube of edge 2 around the origin with a cylindrical hole of `radius` (less than 1) along z. It has `cells` layers of cells
/// from hole to cube, 8 times as many around it and twice as many along it.
pub fn pierced_cube(radius: f64, cells: usize, jitter: f64) -> TetSoup {
    let map = |point: DVec3| {
        let (sin, cos) = (TAU * point.y + PI / 4.0).sin_cos();
        let at_cube = 1.0 / sin.abs().max(cos.abs());
        let from_axis = radius + (at_cube - radius) * point.x;
        DVec3::new(from_axis * cos, from_axis * sin, 2.0 * point.z - 1.0)
    };
    Grid { cells: [cells, 8 * cells, 2 * cells], is_closed: true, has: &|_| true, jitter, map: &map }.soup()
}

const NAMES: [&str; 6] = ["cube", "ball", "pipe", "bent_pipe", "cave", "pierced_cube"];

/// The names that [`by_name`] takes.
pub fn names() -> &'static [&'static str] {
    &NAMES
}

/// A mesh at its default resolution, 30,000 to 90,000 tetrahedra; none for a name that is not in [`names`].
pub fn by_name(name: &str) -> Option<TetSoup> {
    Some(match name {
        "cube" => cube(20, 0.2),
        "ball" => ball(14, 0.2),
        "pipe" => pipe(0.33, 5, 0.1),
        "bent_pipe" => bent_tube(0.35, 1.5 * PI, 12, 0.15),
        "cave" => pillared_cave(0.5, 0.28, 12, 0.1),
        "pierced_cube" => pierced_cube(0.4, 8, 0.15),
        _ => return None,
    })
}
