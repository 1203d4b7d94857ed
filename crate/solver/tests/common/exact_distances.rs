//! Exact polyhedral distances by another program: of small meshes, which lie in the repository, and of large ones in the
//! folder that the environment variable HEATWALK_MESHES names.

#[cfg(not(target_arch = "wasm32"))]
use std::path::{Path, PathBuf};

use heatwalk::Soup;
#[cfg(not(target_arch = "wasm32"))]
use heatwalk_model::io;

use super::meshes::{NAMES, mesh};

/// A mesh, and what other programs say of distances on it.
pub struct Known {
    pub name: &'static str,
    pub soup: Soup,
    pub fields: Vec<Field>,
}

/// Distances from one vertex of the input.
pub struct Field {
    pub source: usize,
    /// `#V`, by pygeodesic.
    pub exact: Vec<f64>,
    /// Mean and maximum relative error of geometry-central's robust heat method, in per cent.
    pub robust: [f64; 2],
}

macro_rules! kept {
    ($($mesh:literal $source:literal),*) => {
        [$(($mesh, $source, include_bytes!(concat!("../data/", $mesh, ".", $source, ".npy")).as_slice())),*]
    };
}

const KEPT: [(&str, usize, &[u8]); 10] = kept![
    "bunny" 0, "bunny" 919,
    "hemisphere" 0, "hemisphere" 400,
    "high_genus" 0, "high_genus" 400,
    "triceratops" 0, "triceratops" 400,
    "slivers" 0, "slivers" 750
];

/// The meshes of the repository.
pub fn kept() -> Vec<Known> {
    let of_mesh = |name| {
        let fields = KEPT.iter().filter(|kept| kept.0 == name);
        let fields =
            fields.map(|&(_, source, npy)| Field { source, exact: numbers(npy), robust: robust(name, source) });
        Known { name, soup: mesh(name), fields: fields.collect() }
    };
    NAMES.into_iter().map(of_mesh).collect()
}

/// Lines of `mesh,source,mean,maximum`.
fn robust(name: &str, source: usize) -> [f64; 2] {
    let lines = include_str!("../data/robust.csv").lines();
    let start = format!("{name},{source},");
    let mut found = lines.filter_map(|line| line.strip_prefix(&start)).flat_map(|rest| rest.split(','));
    [(); 2].map(|()| found.next().and_then(|number| number.parse().ok()).expect("two numbers for every field"))
}

/// One-dimensional float64 array: ten bytes of magic, version and header length, a header, then the values.
fn numbers(npy: &[u8]) -> Vec<f64> {
    let header = u16::from_le_bytes([npy[8], npy[9]]) as usize;
    let values = npy[10 + header..].chunks_exact(8);
    values.map(|chunk| f64::from_le_bytes(chunk.try_into().expect("eight bytes"))).collect()
}

/// The meshes in `HEATWALK_MESHES/exact`, with potpourri3d 1.4.0's errors at `use_robust=True`.
#[cfg(not(target_arch = "wasm32"))]
pub fn large() -> Vec<Known> {
    let known = |(name, fields): (&'static str, [(usize, [f64; 2]); 2])| {
        let folder = folder("exact");
        let fields = fields.map(|(source, robust)| {
            let exact = numbers(&read(&folder.join(format!("{name}.src{source}.npy"))));
            Field { source, exact, robust }
        });
        Known { name, soup: read_mesh(&folder.join(format!("{name}.off"))), fields: fields.into() }
    };
    let all = [
        ("cow", [(0, [1.873, 18.45]), (1452, [1.590, 16.86])]),
        ("spot", [(0, [1.689, 19.55]), (1465, [1.284, 34.71])]),
        ("half_sphere", [(0, [1.011, 21.57]), (1025, [0.909, 23.20])]),
        ("bunny", [(0, [1.460, 15.27]), (7145, [1.317, 12.45])]),
        ("horse_97k", [(0, [0.882, 11.52]), (24242, [0.984, 16.39])]),
    ];
    all.into_iter().map(known).collect()
}

/// A folder of HEATWALK_MESHES.
#[cfg(not(target_arch = "wasm32"))]
pub fn folder(name: &str) -> PathBuf {
    let meshes = std::env::var_os("HEATWALK_MESHES").expect("HEATWALK_MESHES names the folder of the large meshes");
    PathBuf::from(meshes).join(name)
}

/// A mesh of one file.
#[cfg(not(target_arch = "wasm32"))]
pub fn read_mesh(path: &Path) -> Soup {
    io::read(&path.to_string_lossy(), &read(path), &|_| None).expect("a readable mesh").soup
}

#[cfg(not(target_arch = "wasm32"))]
fn read(path: &Path) -> Vec<u8> {
    std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
