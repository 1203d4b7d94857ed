//! What holds of distances in meshes full of holes: `cargo run --release -p heatwalk-volume --example riddled [PAIRS [POINTS [SHARE]]]`.
//! Meshes are the Delaunay tetrahedra of points at random in a cube, of which a share is taken out at random: 10 to 120 and 10 to 50 %
//! unless told otherwise. For each method it prints of how many pairs of vertices, 100,000 unless told otherwise, the distance is above
//! the shortest way along edges or below the straight line, and by how much the distances from one to the other and back differ,
//! relative to the larger one.

#[path = "../tests/common/mod.rs"]
mod common;

use std::env;
use std::time::Instant;

use common::riddled::{along_edges, riddled};
use heatwalk::VertexId;
use heatwalk_volume::{TetMesh, VolumeMethod, VolumeOptions, VolumeSolver};
use rand::SeedableRng;
use rand_xoshiro::SplitMix64;

const PAIRS: usize = 100_000;

/// Points of each mesh, in turn.
const POINTS: [usize; 5] = [10, 20, 40, 80, 120];

/// What is taken out of each, in turn.
const SHARES: [f64; 5] = [0.1, 0.2, 0.3, 0.4, 0.5];

/// Vertices of each mesh that pairs are made of, at most.
const SOURCES: usize = 120;

/// Rounding of sums of lengths.
const ROUNDING: f64 = 1e-12;

fn main() {
    let argument = |number| env::args().nth(number).map(|text| text.parse::<f64>().expect("a number"));
    let pairs = argument(1).map_or(PAIRS, |count| count as usize);
    let points = argument(2).map_or(POINTS.to_vec(), |points| vec![points as usize]);
    let shares = argument(3).map_or(SHARES.to_vec(), |share| vec![share]);
    println!(
        "| method | meshes | pairs | above edges | below straight | asymmetry mean / max (%) | above 1 % | ms a source |"
    );
    println!("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |");
    for method in [VolumeMethod::March, VolumeMethod::Heat] {
        measure(method, pairs, &points, &shares);
    }
}

fn measure(method: VolumeMethod, most: usize, points: &[usize], shares: &[f64]) {
    let mut random = SplitMix64::seed_from_u64(37);
    let (mut pairs, mut above, mut below, mut wide) = (0, 0, 0, 0);
    let (mut sum, mut largest, mut ms, mut sources) = (0.0, 0.0_f64, 0.0, 0);
    let mut meshes = 0;
    while pairs < most {
        let points_of = points[meshes % points.len()];
        let share = shares[(meshes + meshes / points.len()) % shares.len()];
        meshes += 1;
        let mesh = TetMesh::build(&riddled(points_of, share, &mut random)).expect("a mesh of points at random");
        let edges = along_edges(&mesh);
        let mut solver = VolumeSolver::new(mesh);
        let mesh = solver.mesh().clone();
        let start = Instant::now();
        let count = mesh.vertex_count().min(SOURCES);
        let values: Vec<Vec<f64>> = (0..count)
            .map(|source| {
                solver.distance(&[VertexId(source as u32)], &VolumeOptions::by(method)).expect("a vertex").values
            })
            .collect();
        ms += start.elapsed().as_secs_f64() * 1e3;
        sources += count;
        for (from, to) in (0..count).flat_map(|from| (0..from).map(move |to| (from, to))) {
            if pairs == most || edges[from][to].is_infinite() {
                continue;
            }
            pairs += 1;
            let there_and_back = [values[from][to], values[to][from]];
            let straight = mesh.positions()[from].distance(mesh.positions()[to]);
            let (low, high) = (there_and_back[0].min(there_and_back[1]), there_and_back[0].max(there_and_back[1]));
            // Not a number counts as both.
            let (is_short, is_long) = (high <= edges[from][to] * (1.0 + ROUNDING), low >= straight * (1.0 - ROUNDING));
            above += usize::from(!is_short);
            below += usize::from(!is_long);
            let asymmetry = (high - low) / high;
            sum += asymmetry;
            largest = largest.max(asymmetry);
            wide += usize::from(asymmetry > 0.01);
        }
    }
    println!(
        "| {method} | {meshes} | {pairs} | {above} | {below} | {:.4} / {:.2} | {wide} | {:.3} |",
        100.0 * sum / pairs as f64,
        100.0 * largest,
        ms / sources as f64
    );
}
