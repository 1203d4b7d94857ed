//! What changes of a question cost beside precompute and a solve from one source: a source more, a line of sources,
//! another time, another boundary condition. Prints milliseconds, as JSON.
//!
//! `cargo run --release -p heatwalk --example queries -- MESH`

use std::error::Error;
use std::fs;
use std::time::Instant;

use heatwalk::{Boundary, Element, HeatSolver, Parameters, Place, Surface, TimeStep, VertexId, edge_path, go_on};
use heatwalk_model::io;
use serde_json::{Value, json};

const SINGLES: usize = 10;
const MANY: usize = 20;
const ADDED: usize = 5;
const LINES: usize = 3;
const LINE: usize = 100;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("give a mesh")?;
    let soup = io::read(&path, &fs::read(&path)?, &|_| None)?.soup;
    let start = Instant::now();
    let mut solver = HeatSolver::new(Surface::build(&soup)?, Parameters::default(), &mut go_on)?;
    let precompute = milliseconds(start);
    let mut places = places(solver.surface());

    let mut singles = Vec::new();
    for place in places.by_ref().take(SINGLES) {
        singles.push(time(|| solver.distance(&[place]))?);
    }
    let mut sources: Vec<Place> = places.by_ref().take(MANY).collect();
    solver.distance(&sources)?;
    let mut additions = Vec::new();
    for place in places.by_ref().take(ADDED) {
        sources.push(place);
        additions.push(time(|| solver.distance(&sources))?);
        sources.pop();
    }
    let mut lines = Vec::new();
    for place in places.by_ref().take(LINES) {
        let line = line(&solver, place)?;
        lines.push(time(|| solver.distance(&line))?);
    }
    println!(
        "{}",
        json!({
            "precompute": precompute,
            "solve": median(singles),
            "source_added_to_20": median(additions),
            "line_of_100": median(lines),
            "time": changes(&mut solver, |parameters| parameters.time_step = TimeStep::Factor(3.0))?,
            "boundary": match solver.surface().report().boundary_loops {
                0 => Value::Null,
                _ => changes(&mut solver, |parameters| parameters.boundary = Boundary::Dirichlet)?,
            },
        })
    );
    Ok(())
}

/// A change of parameters for the first time, back, and for the second time.
fn changes(solver: &mut HeatSolver, change: impl Fn(&mut Parameters)) -> heatwalk::Result<Value> {
    let before = solver.parameters();
    let mut after = before;
    change(&mut after);
    let mut times = Vec::new();
    for parameters in [after, before, after, before] {
        times.push(time(|| solver.set_parameters(parameters, &mut go_on))?);
    }
    Ok(json!({ "first": times[0], "back": times[1], "again": times[2] }))
}

/// The line along edges from a place towards the one farthest from it, as far as it has `LINE` points.
fn line(solver: &HeatSolver, place: Place) -> heatwalk::Result<Vec<Place>> {
    let Place::Vertex(from) = place else { unreachable!("places are vertices") };
    let reached = solver.distance(&[place])?;
    let finite = |vertex: &VertexId| reached.values[*vertex].is_finite();
    let nearer = |a: &VertexId, b: &VertexId| reached.values[*a].total_cmp(&reached.values[*b]);
    let farthest = reached.values.ids().filter(finite).max_by(nearer).unwrap_or(from);
    let points = edge_path(solver.surface(), from, farthest)?;
    // The first is a source that was asked for already.
    Ok(points.into_iter().skip(1).take(LINE).map(Place::Vertex).collect())
}

/// Points all over the surface, none of them twice while there are enough.
fn places(surface: &Surface) -> impl Iterator<Item = Place> + use<> {
    let count = surface.vertex_count();
    // Steps of the golden section fill a range evenly.
    let step = (count as f64 * 0.618_033_988_749_894_9) as usize;
    (1..).map(move |index: usize| Place::Vertex(VertexId::from_index(index * step % count)))
}

fn time<A>(work: impl FnOnce() -> heatwalk::Result<A>) -> heatwalk::Result<f64> {
    let start = Instant::now();
    work()?;
    Ok(milliseconds(start))
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
