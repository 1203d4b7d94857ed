//! Distances on a plane of two media, as a Markdown table: errors against Snell's law, in per cent (mean / largest beyond ten
//! edges from the source), and the time of a field in milliseconds, the least of some runs. Heat with its factors.
//!
//! `cargo run --release -p heatwalk --example costs`

#[path = "../tests/common/mod.rs"]
mod common;

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

use common::media::{jittered_square, least_cost, two_media};
use common::nearest;
use glam::DVec3;
use heatwalk::{Costs, DistanceOptions, DistanceSolver, Method, Surface, VertexId, go_on};

/// Runs of which the least time counts.
const RUNS: usize = 5;

fn main() -> Result<(), Box<dyn Error>> {
    println!("| source | costs | edges across | auto | heat | auto, ms | heat, ms |");
    println!("|---|---:|---:|---|---|---:|---:|");
    for (x, ground) in [(0.2, "cheap ground"), (0.8, "dear ground")] {
        for cost in [2.0, 10.0, 100.0] {
            for edges in [50, 100, 200] {
                let surface = Arc::new(Surface::build(&jittered_square(edges, 1))?);
                let costs = two_media(&surface, cost);
                let source = nearest(&surface, DVec3::new(x, 0.5, 0.0));
                let [auto, heat] =
                    [Method::Auto, Method::Heat].map(|method| measured(&surface, &costs, source, method));
                let ((auto, auto_ms), (heat, heat_ms)) = (auto?, heat?);
                let [auto, heat] = [auto, heat].map(|values| errors(&surface, source, &values, (cost, edges)));
                println!("| {ground} | 1 : {cost} | {edges} | {auto} | {heat} | {auto_ms:.1} | {heat_ms:.1} |");
            }
        }
    }
    Ok(())
}

/// The distance of each vertex, and the milliseconds of asking for it the first time.
fn measured(
    surface: &Arc<Surface>,
    costs: &Costs,
    source: VertexId,
    method: Method,
) -> Result<(Vec<f64>, f64), Box<dyn Error>> {
    let (mut values, mut least) = (Vec::new(), f64::INFINITY);
    for _ in 0..RUNS {
        let start = Instant::now();
        let mut solver = DistanceSolver::new(Arc::clone(surface)).weighted(costs.clone());
        values = solver.distance(&[source], &DistanceOptions::by(method), &mut go_on)?.distance.values.into_vec();
        least = least.min(start.elapsed().as_secs_f64() * 1e3);
    }
    Ok((values, least))
}

fn errors(surface: &Surface, source: VertexId, values: &[f64], (cost, edges): (f64, u32)) -> String {
    let at = |vertex| surface.position(vertex).truncate();
    let (mut sum, mut far) = (0.0, 0.0_f64);
    for vertex in surface.vertices().filter(|&vertex| vertex != source) {
        let expected = least_cost(at(source), at(vertex), cost);
        let error = 100.0 * (values[vertex.0 as usize] / expected - 1.0).abs();
        sum += error;
        if (at(vertex) - at(source)).length() > 10.0 / f64::from(edges) {
            far = far.max(error);
        }
    }
    format!("{:.3} / {far:.2}", sum / (values.len() - 1) as f64)
}
