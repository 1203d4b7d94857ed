//! Tetrahedra of hostile form, and what is done with them.

use anyhow::{Context, Result};
use glam::DVec3;
use heatwalk::VertexId;
use heatwalk_volume::io::{self, write};
use heatwalk_volume::{TetMesh, TetPoint, TetSoup, VolumeMethod, VolumeOptions, VolumeSolver, shapes};

use crate::surfaces::two_hubs;
use crate::{Operation, does};

/// A form by its name, of about so many tetrahedra.
pub type Family = (&'static str, fn(usize) -> TetSoup);

pub const FAMILIES: [Family; 4] = [
    ("cube of tetrahedra", |count| shapes::cube((count as f64 / 6.0).cbrt().ceil() as usize, 0.2)),
    ("tetrahedra around an edge", around_edge),
    ("tetrahedra around a vertex", around_vertex),
    ("slices", slices),
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

/// A prism cut across into flat ones, of three tetrahedra each.
fn slices(count: usize) -> TetSoup {
    let slices = count as u32 / 3;
    let positions = (0..=slices).flat_map(|slice| {
        let z = f64::from(slice) / f64::from(slices);
        [DVec3::new(0.0, 0.0, z), DVec3::new(1.0, 0.0, z), DVec3::new(0.0, 1.0, z)]
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
