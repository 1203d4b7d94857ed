//! The index of a mesh against exact distances: size, time, and error of pairs at random.
//!
//! `cargo run --release -p heatwalk-index --example against_exact -- MESH [THREADS]`

use std::error::Error;
use std::hint::black_box;
use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use heatwalk::exact::exact_distance;
use heatwalk::{Surface, VertexId, go_on};
use heatwalk_index::DistanceIndex;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

/// Sources, each with all vertices.
const SOURCES: usize = 20;

/// Pairs that are timed.
const TIMED: usize = 1_000_000;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mesh = arguments.first().ok_or("give a mesh")?;
    let threads = arguments.get(1).map_or(Ok(NonZeroUsize::MIN), |threads| threads.parse())?;
    let soup = heatwalk_files::read_surface(Path::new(mesh))?.soup;
    let surface = Arc::new(Surface::build(&soup)?);
    let start = Instant::now();
    let index = DistanceIndex::build(&surface, threads, &mut go_on)?;
    let seconds = start.elapsed().as_secs_f64();
    let mut bytes = Vec::new();
    index.write(&mut bytes)?;
    let labels = index.label_count() as f64 / surface.vertex_count() as f64;
    println!(
        "{} faces: {seconds:.1} s, {:.1} MB, {labels:.0} labels a vertex",
        surface.face_count(),
        bytes.len() as f64 / 1e6
    );

    let mut random = SplitMix64::seed_from_u64(1);
    let (mut count, mut sum, mut told, mut most, mut wrong) = (0_u64, 0.0, 0.0, 0.0_f64, 0_u64);
    for _ in 0..SOURCES {
        let source = random.random_range(0..surface.vertex_count());
        let exact = exact_distance(&surface, &[VertexId(source as u32)], &mut go_on)?;
        let from = surface.inputs_of_vertex(VertexId(source as u32))[0].0 as usize;
        for vertex in surface.vertices().filter(|vertex| vertex.0 as usize != source) {
            let distance = exact[vertex];
            if distance.is_infinite() {
                continue;
            }
            let bounds = index.distance(from, surface.inputs_of_vertex(vertex)[0].0 as usize)?;
            let error = (bounds.upper - distance) / distance;
            count += 1;
            sum += error.abs();
            most = most.max(error.abs());
            told += (bounds.upper - bounds.lower) / distance;
            wrong += u64::from(bounds.lower > distance * (1.0 + 1e-9) || bounds.upper < distance * (1.0 - 1e-9));
        }
    }
    let percent = |sum: f64| 100.0 * sum / count as f64;
    println!(
        "{count} pairs: error {:.5} % in the mean, {:.2} % at most; told {:.3} % in the mean; {wrong} out of bounds",
        percent(sum),
        100.0 * most,
        percent(told)
    );

    let inputs = soup.positions.len();
    let pairs: Vec<[usize; 2]> = (0..TIMED).map(|_| [0; 2].map(|_| random.random_range(0..inputs))).collect();
    let start = Instant::now();
    for &[from, to] in &pairs {
        black_box(index.distance(from, to)?);
    }
    println!("{:.3} µs a pair", start.elapsed().as_secs_f64() * 1e6 / TIMED as f64);
    Ok(())
}
