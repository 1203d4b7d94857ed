//! The three commands. Each returns what it has to say.

use std::ops::ControlFlow;
use std::time::Instant;

use anyhow::Result;
use heatwalk::{HeatSolver, Surface, SurfacePoint, descend};
use serde_json::json;

use crate::args::{Command, Dials, Distance, Info, Path};
use crate::input::{Input, point_of_vertex};
use crate::output::Output;
use crate::report::{Report, milliseconds};

pub fn run(command: &Command) -> Result<String> {
    match command {
        Command::Info(arguments) => info(arguments),
        Command::Distance(arguments) => distance(arguments),
        Command::Path(arguments) => path(arguments),
    }
}

fn info(arguments: &Info) -> Result<String> {
    let input = Input::read(&arguments.mesh)?;
    let (surface, build_ms) = build(&input)?;
    let mut report = Report::default();
    report.push_surface(&surface.report);
    report.push_build(&surface.report);
    report.push("mean_edge", surface.mean_edge);
    report.push_parts(&input.file);
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms }));
    Ok(report.render(arguments.mesh.json))
}

fn distance(arguments: &Distance) -> Result<String> {
    let output = arguments.output.as_deref().map(Output::distance).transpose()?;
    let input = Input::read(&arguments.mesh)?;
    input.check_vertices(&arguments.sources)?;
    let (surface, build_ms) = build(&input)?;
    let sources =
        arguments.sources.iter().map(|&vertex| point_of_vertex(&surface, vertex)).collect::<Result<Vec<_>>>()?;
    let (solver, precompute_ms) = factor(surface, &arguments.dials)?;
    let start = Instant::now();
    let distance = solver.distance(&sources)?;
    let asked_ms = milliseconds(start);
    let solve_ms = if arguments.repeat == 1 { asked_ms } else { median_solve_ms(&solver, arguments.repeat)? };

    let surface = solver.surface();
    // Vertices that no triangle uses are as far as another piece.
    let of_input = |point: &Option<u32>| point.map_or(f64::INFINITY, |point| distance.values[point as usize]);
    let of_inputs: Vec<f64> = surface.point_of_input.iter().map(of_input).collect();
    if let Some(output) = output {
        output.write(&input.soup, &of_inputs)?;
    }
    let mut report = Report::default();
    report.push_surface(&surface.report);
    report.push("factor_nonzeros", solver.factor_nonzeros());
    report.push("max_distance", distance.max());
    report.push("unreachable", of_inputs.iter().filter(|value| value.is_infinite()).count());
    report.push(
        "timings_ms",
        json!({ "read": input.read_ms, "build": build_ms, "precompute": precompute_ms, "solve": solve_ms }),
    );
    Ok(report.render(arguments.mesh.json))
}

fn path(arguments: &Path) -> Result<String> {
    let output = arguments.output.as_deref().map(Output::path).transpose()?;
    let input = Input::read(&arguments.mesh)?;
    input.check_vertices(&[arguments.from, arguments.to])?;
    let (surface, build_ms) = build(&input)?;
    let from = point_of_vertex(&surface, arguments.from)?;
    let to = point_of_vertex(&surface, arguments.to)?;
    let (solver, precompute_ms) = factor(surface, &arguments.dials)?;
    let start = Instant::now();
    let distance = solver.distance(&[to])?;
    let solve_ms = milliseconds(start);
    let surface = solver.surface();
    let start = Instant::now();
    let path = descend(surface, &distance, from)?;
    let path_ms = milliseconds(start);
    if let Some(output) = output {
        output.write(&path)?;
    }
    let points: Vec<_> = path.points.iter().map(|point| json!(point.position.to_array())).collect();
    let mut report = Report::default();
    report.push_surface(&surface.report);
    report.push("factor_nonzeros", solver.factor_nonzeros());
    report.push("distance", from.interpolate(surface, &distance.values));
    report.push("length", path.length());
    report.push("points", points);
    report.push(
        "timings_ms",
        json!({
            "read": input.read_ms, "build": build_ms, "precompute": precompute_ms, "solve": solve_ms, "path": path_ms
        }),
    );
    Ok(report.render(arguments.mesh.json))
}

fn build(input: &Input) -> Result<(Surface, f64)> {
    let start = Instant::now();
    let surface = Surface::build(&input.soup)?;
    Ok((surface, milliseconds(start)))
}

fn factor(surface: Surface, dials: &Dials) -> Result<(HeatSolver, f64)> {
    let start = Instant::now();
    let solver = HeatSolver::new(surface, dials.parameters(), &mut |_, _| ControlFlow::Continue(()))?;
    Ok((solver, milliseconds(start)))
}

/// Median time of a solve over `count` single sources, the same ones at every run.
fn median_solve_ms(solver: &HeatSolver, count: u32) -> Result<f64> {
    let points = solver.surface().point_count() as u64;
    let mut state = 1_u64;
    let mut times = Vec::with_capacity(count as usize);
    for _ in 0..count {
        // Multiplier and increment of Knuth's MMIX; its high bits are the random ones.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let source = SurfacePoint::Vertex(((state >> 33) % points) as u32);
        let start = Instant::now();
        // Kept until the clock has stopped, so that the work is not optimised away.
        let distance = solver.distance(&[source])?;
        times.push(milliseconds(start));
        drop(distance);
    }
    times.sort_by(f64::total_cmp);
    Ok(times[times.len() / 2])
}
