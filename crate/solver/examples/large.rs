//! What a large surface takes: a torus of so many million triangles, 10 if not given. With `--exact`, exact distances, which take
//! minutes; with `--rough`, on a surface like that of a scan, whose vertices are off by up to a tenth of an edge.
//!
//! `cargo run --release -p heatwalk --example large [-- MILLIONS] [--exact] [--rough]`
//!
//! Prints seconds, and the most gigabytes that the process has held until then, where the system tells.

use std::error::Error;
use std::f64::consts::TAU;
use std::fs;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::thread::available_parallelism;
use std::time::Instant;

use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{Place, Propagation, PropagationOptions, Soup, Surface, VertexId};
use heatwalk_shapes as shapes;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

fn main() -> Result<(), Box<dyn Error>> {
    let (options, numbers): (Vec<_>, Vec<_>) = std::env::args().skip(1).partition(|word| word.starts_with("--"));
    let millions: f64 = numbers.first().map_or(Ok(10.0), |number| number.parse())?;
    let rows = (millions * 1e6 / 4.0).sqrt() as u32;
    let mut soup = shapes::torus(2.0, 0.7, 2 * rows, rows);
    if options.iter().any(|option| option == "--rough") {
        roughen(&mut soup, 0.1 * TAU * 0.7 / f64::from(rows));
    }
    println!("{} triangles", soup.triangles.len());

    let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
    timed("built on 1 thread", || built(&soup, NonZeroUsize::MIN))?;
    let geometry = timed(&format!("built on {threads} threads"), || built(&soup, threads))?;
    drop(soup);
    let [first, other] = [0, 77].map(|vertex| Place::Vertex(VertexId(vertex)));
    if options.iter().any(|option| option == "--exact") {
        timed("exact field", || {
            let mut front = Wavefront::new(Arc::clone(&geometry), &[first])?;
            front.advance(f64::INFINITY, usize::MAX)?;
            Ok(front.windows())
        })?;
        return Ok(());
    }
    let mut propagation = timed("first field", || {
        let mut propagation = Propagation::new(Arc::clone(&geometry), &[first], PropagationOptions::default())?;
        propagation.advance(f64::INFINITY, usize::MAX)?;
        Ok(propagation)
    })?;
    timed("another field", || {
        propagation.restart(&[other])?;
        propagation.advance(f64::INFINITY, usize::MAX)?;
        Ok(())
    })?;
    Ok(())
}

/// From positions to a surface that can be asked.
fn built(soup: &Soup, threads: NonZeroUsize) -> heatwalk::Result<Arc<ExactGeometry>> {
    Ok(Arc::new(ExactGeometry::on_threads(Surface::build_on(soup, threads)?, threads)))
}

/// Moves each vertex by up to `amount` along each axis, always in the same way.
fn roughen(soup: &mut Soup, amount: f64) {
    let mut random = SplitMix64::seed_from_u64(1);
    for coordinate in soup.positions.iter_mut().flat_map(|position| position.as_mut()) {
        *coordinate += amount * random.random_range(-1.0..1.0);
    }
}

/// The result, after a line on what it took.
fn timed<T>(what: &str, work: impl FnOnce() -> heatwalk::Result<T>) -> heatwalk::Result<T> {
    let start = Instant::now();
    let result = work()?;
    let seconds = start.elapsed().as_secs_f64();
    let gigabytes = most_gigabytes().map_or(String::new(), |number| format!("  {number:.2} GB"));
    println!("{what:20} {seconds:8.2} s{gigabytes}");
    Ok(result)
}

fn most_gigabytes() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: f64 = line.split_whitespace().next()?.parse().ok()?;
    Some(kibibytes * 1024.0 / 1e9)
}
