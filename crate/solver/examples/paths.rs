//! Paths between 2000 random pairs of vertices of each mesh given, as a Markdown table: whether they arrive, how much
//! longer than exact they are before and after straightening, and whether they end up locally shortest.
//!
//! `cargo run --release -p heatwalk --example paths -- MESH...`

#[path = "../tests/common/shortness.rs"]
mod shortness;

use std::error::Error;
use std::f64::consts::PI;
use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use heatwalk::exact::exact_distance;
use heatwalk::{Element, HeatSolver, Parameters, Place, Surface, VertexId, descend, go_on, straighten};
use heatwalk_model::io;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

const SOURCES: usize = 40;
const STARTS_PER_SOURCE: usize = 50;

/// A path counts as locally shortest when no vertex can be passed by an angle smaller than π by more than this, and it
/// runs beside no straight line by more than this in mean edges.
const TOLERANCE: f64 = 1e-6;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| mesh | arrived | shortest / exact | excess before, median / 95 % / max | after | locally shortest | ms |"
    );
    println!("|---|---|---|---|---|---|---|");
    for path in std::env::args().skip(1) {
        measure(Path::new(&path))?;
    }
    Ok(())
}

fn measure(path: &Path) -> Result<(), Box<dyn Error>> {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().unwrap_or(Path::new(""));
    let soup = io::read(&name, &fs::read(path)?, &|uri| fs::read(folder.join(uri)).ok())?.soup;
    let surface = Arc::new(Surface::build(&soup)?);
    let solver = HeatSolver::new(Arc::clone(&surface), Parameters::default(), &mut go_on)?;
    let mut random = SplitMix64::seed_from_u64(1);
    let mut random = || VertexId::from_index(random.random_range(0..surface.vertex_count()));
    let (mut pairs, mut arrived, mut shortest) = (0, 0, 0);
    let (mut least, mut milliseconds) = (f64::INFINITY, 0.0);
    let mut excesses = [Vec::new(), Vec::new()];
    for _ in 0..SOURCES {
        let source = Place::Vertex(random());
        let exact = exact_distance(&surface, &[source], &mut go_on)?;
        let distance = solver.distance(&[source])?;
        for _ in 0..STARTS_PER_SOURCE {
            let from = random();
            let exact = exact[from];
            if !(exact.is_finite() && exact > 0.0) {
                continue;
            }
            pairs += 1;
            let start = Instant::now();
            let descent = descend(&surface, &distance, Place::Vertex(from))?;
            let straight = straighten(&surface, &descent)?;
            milliseconds += start.elapsed().as_secs_f64() * 1e3;
            shortness::check_valid(&surface, &straight);
            let end = straight.points[straight.points.len() - 1].position;
            arrived += usize::from(end == source.position(&surface));
            let is_straight = shortness::largest_kink(&surface, &straight) < TOLERANCE;
            shortest += usize::from(is_straight && shortness::sharpest_turn(&surface, &straight) > PI - TOLERANCE);
            for (excess, path) in excesses.iter_mut().zip([&descent, &straight]) {
                excess.push(100.0 * (path.length() / exact - 1.0));
                least = least.min(path.length() / exact);
            }
        }
    }
    let [before, after] = excesses.map(|mut excess| {
        excess.sort_by(f64::total_cmp);
        let at = |share: f64| excess[((excess.len() - 1) as f64 * share) as usize];
        format!("{:.4} / {:.2} / {:.1} %", at(0.5), at(0.95), at(1.0))
    });
    println!(
        "| {name} | {arrived} of {pairs} | 1 − {:.1e} | {before} | {after} | {shortest} | {:.2} |",
        1.0 - least,
        milliseconds / f64::from(pairs)
    );
    Ok(())
}
