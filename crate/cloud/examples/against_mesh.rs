//! How far exact distances on the surface of a mesh's vertices alone are from those on the mesh:
//! `cargo run --release -p heatwalk-cloud --example against_mesh -- MESH [NOISE] [normals]`, NOISE as a share of the mean edge; with the
//! normals of the mesh at its vertices, or without.

use std::num::NonZeroUsize;
use std::sync::Arc;
use std::thread::available_parallelism;
use std::time::Instant;

use glam::DVec3;
use heatwalk::exact::exact_distance;
use heatwalk::{InputVertex, RelativeError, Soup, Surface, go_on};
use heatwalk_cloud::Cloud;
use heatwalk_model::io;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().ok_or("give a mesh file")?;
    let (words, numbers): (Vec<_>, Vec<_>) = arguments.partition(|argument| argument == "normals");
    let noise: f64 = numbers.first().map_or(Ok(0.0), |noise| noise.parse())?;
    let soup = io::read(&name, &std::fs::read(&name)?, &|_| None)?.soup;
    let mesh = Arc::new(Surface::build(&soup)?);
    let mut random = SplitMix64::seed_from_u64(1);
    let mut moved = || (random.random::<f64>() - 0.5) * 2.0 * noise * mesh.mean_edge();
    let points: Vec<DVec3> =
        soup.positions.iter().map(|&position| position + DVec3::new(moved(), moved(), moved())).collect();

    let start = Instant::now();
    let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let normals = if words.is_empty() { Vec::new() } else { normals(&soup) };
    let cloud = Cloud::join_oriented("cloud", points, &normals, threads)?;
    println!("{}, in {:.2} s", cloud.report, start.elapsed().as_secs_f64());
    let joined = Arc::new(Surface::build(&cloud.soup)?);
    println!(
        "components {}, Euler characteristic {}",
        joined.report().components,
        joined.report().euler_characteristic
    );

    let source = InputVertex(0);
    let distances = |surface: &Arc<Surface>| -> heatwalk::Result<Vec<f64>> {
        Ok(surface.to_inputs(&exact_distance(surface, &[source], &mut go_on)?, f64::INFINITY))
    };
    let (true_ones, found) = (distances(&mesh)?, distances(&joined)?);
    let reached = || true_ones.iter().zip(&found).filter(|(_, found)| found.is_finite());
    let error = RelativeError::between(reached().map(|(_, found)| found), reached().map(|(known, _)| known));
    println!("mean error {:.3} %, largest {:.2} %", 100.0 * error.mean, 100.0 * error.max);
    let unreached = true_ones.iter().zip(&found).filter(|(known, found)| known.is_finite() && found.is_infinite());
    println!("{} points not reached that are on the mesh", unreached.count());
    Ok(())
}

/// At each vertex, the mean of those of the triangles around by their areas.
fn normals(soup: &Soup) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; soup.positions.len()];
    for corners in &soup.triangles {
        let [a, b, c] = corners.map(|vertex| soup.positions[vertex as usize]);
        corners.iter().for_each(|&vertex| normals[vertex as usize] += (b - a).cross(c - a));
    }
    normals
}
