//! Distances on a "cow".glb, as the page of Heatwalk shows them: a line of vertex,distance each.

use heatwalk::{
    BridgeRule, Bridges, DistanceOptions, DistanceSolver, InputTriangle, InputVertex, Method, Place, Surface, Windows,
    go_on,
};
use heatwalk_model::io;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = io::read("a \"cow\".glb", &std::fs::read("a \"cow\".glb")?, &|file| std::fs::read(file).ok())?;
    let model = model.chosen(&[1])?;
    let model = model.posed(1, 0.5)?;
    let surface = Surface::build(&model.soup)?;
    let vertex = |input| surface.vertex_of_input(InputVertex(input)).ok_or("a vertex without a triangle");
    let face = |index| surface.face_of_triangle(InputTriangle(index)).ok_or("a triangle without area");
    let sources = [
        (Place::Vertex(vertex(7)?), 0.0),
        (Place::Face { face: face(3)?, weights: [0.25, 0.25, 0.5] }, 2.0),
        (Place::Vertex(vertex(8)?), 0.125),
    ];
    let bridges = Bridges::find(&surface, BridgeRule::Within(0.01));
    let mut links = bridges.links(&surface);
    links.truncate(2);
    let bridges = bridges.linked(&surface, &links);
    let mut solver = DistanceSolver::new(surface).bridged(bridges);
    let windows = Windows::AtMost(4.try_into()?);
    let options = DistanceOptions { windows, ..DistanceOptions::by(Method::Propagation) };
    let distance = solver.distance(&sources, &options, &mut go_on)?.distance;
    for input in 0..model.soup.positions.len() as u32 {
        let vertex = solver.surface().vertex_of_input(InputVertex(input));
        println!("{input},{}", vertex.map_or(f64::INFINITY, |vertex| distance.values[vertex]));
    }
    Ok(())
}
