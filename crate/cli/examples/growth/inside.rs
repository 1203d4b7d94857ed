//! Tetrahedra of hostile form, and what is done with them.

use std::f64::consts::TAU;

use anyhow::{Context, Result};
use glam::{DMat3, DVec3};
use heatwalk::VertexId;
use heatwalk_volume::io::{self, write};
use heatwalk_volume::{TetMesh, TetPoint, TetSoup, VolumeMethod, VolumeOptions, VolumeSolver, shapes};

use crate::surfaces::two_hubs;
use crate::{Operation, does};

/// A form by its name, of about so many tetrahedra.
pub type Family = (&'static str, fn(usize) -> TetSoup);

pub const FAMILIES: [Family; 7] = [
    ("cube of tetrahedra", |count| shapes::cube((count as f64 / 6.0).cbrt().ceil() as usize, 0.2)),
    ("tetrahedra around an edge", around_edge),
    ("tetrahedra around a vertex", around_vertex),
    ("slices", |count| twisted_slices(count, 0.0)),
    ("three quarters around an edge", three_quarters),
    ("waves around a vertex", waves_around_vertex),
    ("twisted slices", |count| twisted_slices(count, 3.0 * TAU)),
];

fn around_edge(count: usize) -> TetSoup {
    let rim = two_hubs(2 * count);
    let (above, below) = (0, rim.positions.len() as u32 - 1);
    let next = |corner: u32| corner % count as u32 + 1;
    let tetrahedra = (1..=count as u32).map(|corner| [above, below, corner, next(corner)]).collect();
    TetSoup { positions: rim.positions, tetrahedra }
}

fn around_vertex(count: usize) -> TetSoup {
    let mut rim = two_hubs(count);
    let middle = rim.positions.len() as u32;
    rim.positions.push(DVec3::ZERO);
    let tetrahedra = rim.triangles.iter().map(|&[a, b, c]| [middle, a, b, c]).collect();
    TetSoup { positions: rim.positions, tetrahedra }
}

/// The edge is one that paths bend around.
fn three_quarters(count: usize) -> TetSoup {
    let on_circle = |corner: usize| {
        let (y, x) = (0.75 * TAU * corner as f64 / count as f64).sin_cos();
        DVec3::new(x, y, 0.0)
    };
    let positions = (0..=count).map(on_circle).chain([DVec3::Z, DVec3::NEG_Z]).collect();
    let [above, below] = [1, 2].map(|after| (count + after) as u32);
    let tetrahedra = (0..count as u32).map(|corner| [below, above, corner, corner + 1]).collect();
    TetSoup { positions, tetrahedra }
}

/// The rim goes up and down, so that paths bend around its lower corners.
fn waves_around_vertex(count: usize) -> TetSoup {
    let mut soup = around_vertex(count);
    let corners = soup.positions.len() - 3;
    soup.positions[1..=corners].iter_mut().step_by(2).for_each(|place| *place *= 0.5);
    soup
}

/// A prism that turns by so much, in radians, cut across into flat ones, of three tetrahedra each.
fn twisted_slices(count: usize, turn: f64) -> TetSoup {
    let slices = count as u32 / 3;
    let positions = (0..=slices).flat_map(|slice| {
        let z = f64::from(slice) / f64::from(slices);
        let turned = DMat3::from_rotation_z(turn * z);
        [DVec3::ZERO, DVec3::X, DVec3::Y].map(|corner| turned * corner + z * DVec3::Z)
    });
    let tetrahedra = (0..slices).flat_map(|slice| {
        let [a, b, c, d, e, f] = [0, 1, 2, 3, 4, 5].map(|k| 3 * slice + k);
        [[a, b, c, d], [b, c, d, e], [c, d, e, f]]
    });
    TetSoup { positions: positions.collect(), tetrahedra: tetrahedra.collect() }
}

/// Makes what an operation works on.
pub type Prepare = fn(&TetSoup) -> Result<Operation>;

pub const OPERATIONS: [(&str, Prepare); 5] = [
    ("read", |soup| {
        let file = write::msh(soup, None);
        does(move || io::read("a.msh", &file, &|_| None))
    }),
    ("build", |soup| {
        let soup = soup.clone();
        does(move || TetMesh::build(&soup))
    }),
    ("march", |soup| distance(soup, VolumeMethod::March)),
    ("heat", |soup| distance(soup, VolumeMethod::Heat)),
    ("path", |soup| {
        let mut solver = VolumeSolver::new(TetMesh::build(soup)?);
        let distance = solver.distance(&[VertexId(1)], &VolumeOptions::default())?;
        let reached = (0..distance.values.len()).filter(|&vertex| distance.values[vertex] < f64::INFINITY);
        let farthest = reached.max_by(|&a, &b| distance.values[a].total_cmp(&distance.values[b]));
        let from = VertexId(farthest.context("a vertex")? as u32);
        does(move || solver.path(&distance, TetPoint::Vertex(from)))
    }),
];

fn distance(soup: &TetSoup, method: VolumeMethod) -> Result<Operation> {
    let mut solver = VolumeSolver::new(TetMesh::build(soup)?);
    does(move || solver.distance(&[VertexId(1)], &VolumeOptions::by(method)))
}
