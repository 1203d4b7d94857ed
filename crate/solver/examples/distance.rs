//! A surface from arrays, its exact distance from a vertex and the shortest path back from another.
//!
//! `cargo run --release -p heatwalk --example distance`

use heatwalk::glam::DVec3;
use heatwalk::{DistanceOptions, DistanceSolver, PathKind, Soup, Surface, VertexId, go_on};

/// Vertices along each side.
const SIDE: u32 = 101;

fn main() -> heatwalk::Result<()> {
    // A square of side 1 with a round hill in its middle.
    let place = |number: u32| f64::from(number) / f64::from(SIDE - 1);
    let height = |x: f64, y: f64| 0.4 * (-20.0 * ((x - 0.5).powi(2) + (y - 0.5).powi(2))).exp();
    let positions = (0..SIDE * SIDE).map(|vertex| {
        let [x, y] = [vertex % SIDE, vertex / SIDE].map(place);
        DVec3::new(x, y, height(x, y))
    });
    let cells = (0..(SIDE - 1) * (SIDE - 1)).map(|cell| cell / (SIDE - 1) * SIDE + cell % (SIDE - 1));
    let triangles = cells.flat_map(|a| [[a, a + 1, a + SIDE], [a + 1, a + SIDE + 1, a + SIDE]]);

    let surface = Surface::build(&Soup::single("hill", positions.collect(), triangles.collect()))?;
    let mut solver = DistanceSolver::new(surface);
    let (first, last) = (VertexId(0), VertexId(SIDE * SIDE - 1));
    let answer = solver.distance(&[first], &DistanceOptions::default(), &mut go_on)?;
    let path = solver.path(&answer, last, PathKind::Exact)?;
    println!("From corner to corner: {:.6}, straight {:.6}", answer.distance.values[last], 2_f64.sqrt());
    println!("The path has {} points and the length {:.6}.", path.points.len(), path.length());
    Ok(())
}
