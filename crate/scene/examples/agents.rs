//! Times steps of agents: `cargo run --release -p heatwalk-scene --example agents [-- COUNT]`.
//!
//! Agents start at random on a bumpy torus of about 100,000 triangles and go to one vertex; steps of a sixtieth of a second.

use std::sync::Arc;
use std::time::Instant;

use heatwalk::{DistanceOptions, DistanceSolver, Element, Surface, VertexId, go_on};
use heatwalk_scene::Agents;
use heatwalk_shapes as shapes;

const RADIUS: f64 = 0.008;
const SPEED: f64 = 0.15;
const STEPS: usize = 600;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let count = std::env::args().nth(1).map_or(Ok(10_000), |count| count.parse())?;
    let surface = Arc::new(Surface::build(&shapes::torus(1.0, 0.35, 500, 100))?);
    let answer =
        DistanceSolver::new(Arc::clone(&surface)).distance(&[VertexId(0)], &DistanceOptions::default(), &mut go_on)?;
    let mut agents = Agents::new(Arc::clone(&surface));
    agents.follow(&answer.distance, None)?;
    for number in 0..count {
        let vertex = VertexId::from_index(number * 7919 % surface.vertex_count());
        agents.add(&surface.point(vertex)?, RADIUS, SPEED)?;
    }
    println!("{count} agents on {} triangles", surface.face_count());
    for part in 1..=3 {
        let mut seconds: Vec<f64> = (0..STEPS)
            .map(|_| {
                let begun = Instant::now();
                agents.update(1.0 / 60.0).map(|()| begun.elapsed().as_secs_f64())
            })
            .collect::<Result<_, _>>()?;
        seconds.sort_by(f64::total_cmp);
        let arrived = agents.agents().iter().filter(|agent| agent.has_arrived).count();
        let [median, most] = [STEPS / 2, STEPS * 95 / 100].map(|k| seconds[k] * 1e3);
        println!("steps {}: median {median:.2} ms, 95 % {most:.2} ms; {arrived} arrived", part * STEPS);
    }
    Ok(())
}
