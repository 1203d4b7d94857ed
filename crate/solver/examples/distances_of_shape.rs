//! Distances on shape:torus, as the page of Heatwalk shows them: a line of vertex,distance each.

use heatwalk::{
    DistanceOptions, DistanceSolver, ExactRadius, InputVertex, Method, Parameters, Place, Surface, TimeStep, go_on,
};
use heatwalk_shapes::by_name;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = by_name("torus")?;
    let surface = Surface::build(&model.soup)?;
    let vertex = |input| surface.vertex_of_input(InputVertex(input)).ok_or("a vertex without a triangle");
    let sources = [(Place::Vertex(vertex(7)?), 0.0)];
    let mut solver = DistanceSolver::new(surface);
    let heat = Parameters {
        operator: "plain".parse()?,
        time_step: TimeStep::Factor(10.0),
        boundary: "average".parse()?,
        sources: "summed".parse()?,
        exact_radius: ExactRadius::Edges(f64::INFINITY),
        ..Parameters::default()
    };
    let options = DistanceOptions { heat, ..DistanceOptions::by(Method::Heat) };
    let distance = solver.distance(&sources, &options, &mut go_on)?.distance;
    for input in 0..model.soup.positions.len() as u32 {
        let vertex = solver.surface().vertex_of_input(InputVertex(input));
        println!("{input},{}", vertex.map_or(f64::INFINITY, |vertex| distance.values[vertex]));
    }
    Ok(())
}
