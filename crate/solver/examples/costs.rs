//! Distances on a plane of two media, as a Markdown table: errors against Snell's law, in per cent (mean / largest beyond ten
//! edges from the source), and the time of a field in milliseconds, the least of some runs. Heat with its factors. Then what paths
//! cost more than the distance says, in per cent (mean / largest), where each face has a cost of its own: refracted descents, and
//! paths of the solver.
//!
//! `cargo run --release -p heatwalk --example costs`

#[path = "../tests/common/mod.rs"]
mod common;

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

use common::media::{jittered_square, least_cost, two_media};
use common::nearest;
use common::truth::Random;
use glam::DVec3;
use heatwalk::{
    Costs, DistanceOptions, DistanceSolver, Element, Method, PathKind, Surface, VertexId, descend, go_on, refract,
    tobler,
};
use heatwalk_shapes as shapes;

/// Runs of which the least time counts.
const RUNS: usize = 5;

/// Paths of each surface.
const PATHS: usize = 400;

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
    println!("\n| surface | costs | refracted descent | path |");
    println!("|---|---|---|---|");
    let ball = Arc::new(Surface::build(&shapes::icosphere(5))?);
    let mut random = Random::new(1);
    let of_face = (0..ball.face_count()).map(|_| random.between(1.0, 10.0));
    let at_random = Costs::new(&ball, of_face.collect())?;
    println!("| sphere | 1 to 10 at random | {} |", excess(&ball, &at_random)?);
    let terrain = Arc::new(Surface::build(&shapes::by_name("terrain")?.soup)?);
    let of_slope = Costs::of_slope(&terrain, DVec3::Y, tobler)?;
    println!("| terrain | of its slopes | {} |", excess(&terrain, &of_slope)?);
    Ok(())
}

/// What refracted descents and what paths cost more than the distance says, from some vertices.
fn excess(surface: &Arc<Surface>, costs: &Costs) -> Result<String, Box<dyn Error>> {
    let mut solver = DistanceSolver::new(Arc::clone(surface)).weighted(costs.clone());
    let answer = solver.distance(&[VertexId(0)], &DistanceOptions::default(), &mut go_on)?;
    let (mut sums, mut most) = ([0.0; 2], [0.0_f64; 2]);
    for index in 0..PATHS {
        let from = VertexId::from_index(1 + index * (surface.vertex_count() - 1) / PATHS);
        let paths = [
            refract(surface, costs, &descend(surface, &answer.distance, from)?)?,
            solver.path(&answer, from, PathKind::Straightened)?,
        ];
        for (path, (sum, most)) in paths.iter().zip(sums.iter_mut().zip(&mut most)) {
            let excess = 100.0 * (solver.cost_of(path) / answer.distance.values[from] - 1.0);
            *sum += excess / PATHS as f64;
            *most = most.max(excess);
        }
    }
    Ok(sums.iter().zip(most).map(|(mean, most)| format!("{mean:.3} / {most:.2}")).collect::<Vec<_>>().join(" | "))
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
