//! `heatwalk path`.

use std::time::Instant;

use anyhow::Result;
use heatwalk::exact::shortest_path;
use heatwalk::{
    Answer, Choice, DistanceOptions, DistanceSolver, HeatSolver, Method, SurfacePoint, descend, straighten,
};
use serde_json::json;

use crate::args::Path;
use crate::input::Input;
use crate::output::Output;
use crate::report::{Report, milliseconds};
use crate::timing::{build, go_on, join, prepare};

/// A path, the distance that belongs to it, and what they took.
struct Found {
    path: heatwalk::Path,
    distance: f64,
    method: Method,
    solve_ms: f64,
    path_ms: f64,
}

pub fn path(arguments: &Path) -> Result<String> {
    let options = arguments.distance_options()?;
    let output = arguments.output.as_deref().map(Output::path).transpose()?;
    let input = Input::of(&arguments.mesh)?;
    arguments.from.check(&input.soup)?;
    arguments.to.check(&input.soup)?;
    let (surface, built_ms) = build(&input, arguments.mesh.weld, arguments.mesh.threads())?;
    let from = arguments.from.on(&input.soup, &surface)?;
    let to = arguments.to.on(&input.soup, &surface)?;
    let joined = join(&surface, &arguments.bridging, arguments.mesh.threads());
    let mut report = Report::default();
    report.push_surface(surface.report());
    report.push_unit(&input.soup);
    report.push_bridges(&joined.bridges, joined.contacts, &joined.links);
    let build_ms = built_ms + joined.join_ms;
    let mut prepared = prepare((&surface, joined.bridges, build_ms), &options, arguments.mesh.threads())?;
    let found = if arguments.exact {
        exactly(&mut prepared.solver, from, to)?
    } else {
        by_descent(&mut prepared.solver, from, to, (arguments, &options))?
    };
    if let Some(output) = output {
        output.write(&found.path, arguments.up)?;
    }
    let points: Vec<_> = found.path.points.iter().map(|point| json!(point.position.to_array())).collect();
    report.push("method", found.method.name());
    report.push("factor_nonzeros", prepared.solver.heat().map_or(0, HeatSolver::factor_nonzeros));
    report.push("distance", found.distance);
    report.push("length", found.path.length());
    report.push("points", points);
    report.push(
        "timings_ms",
        json!({
            "read": input.read_ms, "build": prepared.build_ms, "precompute": prepared.precompute_ms,
            "solve": found.solve_ms, "path": found.path_ms
        }),
    );
    Ok(report.render(arguments.mesh.json))
}

fn by_descent(
    solver: &mut DistanceSolver,
    from: SurfacePoint,
    to: SurfacePoint,
    (arguments, options): (&Path, &DistanceOptions),
) -> Result<Found> {
    let start = Instant::now();
    let Answer { distance, method, .. } = solver.distance(&[to], options, &mut go_on)?;
    let solve_ms = milliseconds(start);
    let start = Instant::now();
    let surface = solver.surface();
    let mut path = descend(surface, &distance, from)?;
    if arguments.straighten {
        path = straighten(surface, &path)?;
    }
    Ok(Found { path, distance: distance.at(surface, from)?, method, solve_ms, path_ms: milliseconds(start) })
}

fn exactly(solver: &mut DistanceSolver, from: SurfacePoint, to: SurfacePoint) -> Result<Found> {
    let start = Instant::now();
    let path = shortest_path(solver.exact_geometry(), from, &[to])?;
    // One search gives distance and path.
    let solve_ms = milliseconds(start);
    Ok(Found { distance: path.length(), path, method: Method::Exact, solve_ms, path_ms: 0.0 })
}
