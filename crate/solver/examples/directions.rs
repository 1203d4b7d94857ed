//! The log map against exact paths: how long it takes beside the distances, and the angles between.
//!
//! `cargo run --release -p heatwalk --example directions -- MESH...`

use std::error::Error;
use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use glam::DVec2;
use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{Element, Surface, VertexId, go_on, log_map};
use heatwalk_model::io;

const RUNS: usize = 9;

fn main() -> Result<(), Box<dyn Error>> {
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
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
    let source = VertexId::from_index(surface.vertex_count() / 3);
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..RUNS {
        let start = Instant::now();
        let mut front = Wavefront::new(Arc::clone(&geometry), &[source])?;
        while !front.advance(f64::INFINITY, 20_000)? {}
        std::hint::black_box(front.into_values());
        times[0].push(start.elapsed().as_secs_f64());
        let start = Instant::now();
        std::hint::black_box(log_map(&geometry, source, None, &mut go_on)?);
        times[1].push(start.elapsed().as_secs_f64());
    }
    times.iter_mut().for_each(|times| times.sort_by(f64::total_cmp));
    let [field, log] = [0, 1].map(|k| times[k][RUNS / 2]);
    println!("{name}: {:.1} ms, {:.1} ms, {:.3}", field * 1e3, log * 1e3, log / field);
    let _ = DVec2::X;
    Ok(())
}
