//! `heatwalk path`.

use std::time::Instant;

use anyhow::Result;
use heatwalk::exact::shortest_path;
use heatwalk::{
    Answer, Choice, Costs, DistanceOptions, DistanceSolver, HeatSolver, Method, Place, SurfacePoint, descend, refract,
    straighten,
};
use serde_json::json;

use crate::args::Path;
use crate::input::Input;
use crate::output::Output;
use crate::report::{Report, milliseconds};
use crate::timing::{build, go_on, join, prepare};
use crate::volume;

/// A path, the distance that belongs to it, and what they took.
struct Found {
    path: heatwalk::Path,
    distance: f64,
    /// Whether the distance is one between those of the vertices around.
    is_interpolated: bool,
    method: Method,
    solve_ms: f64,
    path_ms: f64,
}

pub fn path(arguments: &Path) -> Result<String> {
    if let Some(input) = volume::Input::of(&arguments.mesh)? {
        return volume::path(arguments, &input);
    }
    let options = arguments.distance_options()?;
    let output = arguments.output.as_deref().map(Output::path).transpose()?;
    let input = Input::of(&arguments.mesh)?;
    arguments.from.check(&input.soup)?;
    arguments.to.check(&input.soup)?;
    let (surface, built_ms) = build(&input, arguments.mesh.weld, arguments.mesh.threads())?;
    let ground = arguments.ground.on(&input.soup, &surface, arguments.up)?;
    let from = arguments.from.on(&input.soup, &ground.surface)?;
    let to = arguments.to.on(&input.soup, &ground.surface)?;
    let joined = join(&surface, &arguments.bridging, arguments.mesh.threads());
    let mut report = Report::default();
    report.push_surface(surface.report());
    report.push_unit(input.unit);
    report.push_warnings(&input.file.warnings);
    report.push_bridges(&joined.bridges, joined.contacts, &joined.links);
    let build_ms = built_ms + joined.join_ms;
    let solver = ground.solver(&surface, joined.bridges, arguments.mesh.threads());
    let mut prepared = prepare((solver, build_ms), &options)?;
    let found = if arguments.exact {
        exactly(&mut prepared.solver, from, to)?
    } else {
        by_descent(&mut prepared.solver, from, to, (arguments, &options))?
    };
    if let Some(output) = output {
        output.write(found.path.positions().into_iter(), arguments.up)?;
    }
    let points: Vec<_> = found.path.positions().iter().map(|point| json!(point.to_array())).collect();
    report.push("method", found.method.name());
    report.push("factor_nonzeros", prepared.solver.heat().map_or(0, HeatSolver::factor_nonzeros));
    report.push("distance", found.distance);
    report.push("distance_interpolated", found.is_interpolated);
    report.push("length", found.path.length());
    if let Some(costs) = prepared.solver.costs() {
        report.push("cost", costs.of_path(prepared.solver.surface(), &found.path));
    }
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
    if method == Method::Exact {
        // Values of vertices are exact, what lies between them is not.
        return exactly(solver, from, to);
    }
    let solve_ms = milliseconds(start);
    let start = Instant::now();
    let surface = solver.surface();
    let mut path = descend(surface, &distance, from)?;
    if arguments.straighten {
        path = match solver.costs() {
            Some(costs) => refract(surface, costs, &path)?,
            None => straighten(surface, &path)?,
        };
    }
    let length = solver.costs().map_or_else(|| path.length(), |costs| costs.of_path(surface, &path));
    let interpolated = distance.at(surface, from)?;
    // In the face of the source, and near it, values of corners tell nothing of what is between; the path does.
    let is_at_vertex = matches!(from.place(), Place::Vertex(_));
    let distance = if is_at_vertex { interpolated } else { interpolated.min(length) };
    let is_interpolated = !is_at_vertex && distance < length;
    Ok(Found { path, distance, is_interpolated, method, solve_ms, path_ms: milliseconds(start) })
}

fn exactly(solver: &mut DistanceSolver, from: SurfacePoint, to: SurfacePoint) -> Result<Found> {
    let start = Instant::now();
    let path = shortest_path(solver.exact_geometry(), from, &[to])?;
    // One search gives distance and path.
    let solve_ms = milliseconds(start);
    let cost = solver.costs().and_then(Costs::constant).unwrap_or(1.0);
    let distance = cost * path.length();
    Ok(Found { path, distance, is_interpolated: false, method: Method::Exact, solve_ms, path_ms: 0.0 })
}
