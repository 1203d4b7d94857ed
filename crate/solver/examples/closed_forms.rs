//! Error of the distance at default settings where the exact one has a closed form: spheres of rising resolution and a
//! long strip, as Markdown.
//!
//! `cargo run --release -p heatwalk --example closed_forms`

use std::error::Error;

use glam::DVec3;
use heatwalk::{HeatSolver, Parameters, Place, RelativeError, Soup, Surface, VertexId, go_on};
use heatwalk_shapes as shapes;

/// Vertices that measure the spheres: one of the twelve with five neighbours, and another.
const SPHERE_SOURCES: [VertexId; 2] = [VertexId(0), VertexId(777)];

fn main() -> Result<(), Box<dyn Error>> {
    println!("| surface | source | m | mean % | maximum % |");
    println!("|---|---:|---:|---:|---:|");
    for subdivisions in 5..=8 {
        let arc = |p: DVec3, q: DVec3| p.cross(q).length().atan2(p.dot(q));
        measure("unit sphere", &shapes::icosphere(subdivisions), &SPHERE_SOURCES, arc)?;
    }
    measure("strip 9 × 1200", &shapes::strip(9.0, 1200.0, 9), &[0, 5].map(VertexId), DVec3::distance)
}

fn measure(
    name: &str,
    soup: &Soup,
    sources: &[VertexId],
    exact: impl Fn(DVec3, DVec3) -> f64,
) -> Result<(), Box<dyn Error>> {
    let surface = Surface::build(soup)?;
    let solver = HeatSolver::new(surface, Parameters::default(), &mut go_on)?;
    let positions = solver.surface().positions();
    for &source in sources {
        let distance = solver.distance(&[Place::Vertex(source)])?;
        let exact: Vec<f64> = positions.iter().map(|&position| exact(position, positions[source])).collect();
        let RelativeError { mean, max } = RelativeError::between(&distance.values, &exact);
        let (vertices, factor) = (positions.len(), solver.time_factor());
        println!("| {name}, {vertices} vertices | {source} | {factor:.2} | {:.3} | {:.3} |", 100.0 * mean, 100.0 * max);
    }
    Ok(())
}
