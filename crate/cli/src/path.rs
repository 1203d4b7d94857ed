//! `heatwalk path`.

use std::time::Instant;

use anyhow::{Context, Result};
use heatwalk::exact::shortest_path;
use heatwalk::{
    Bezier, Choice, DistanceOptions, DistanceSolver, HeatSolver, Method, PathKind, Place as On, Surface, SurfacePoint,
    bezier, go_on,
};
use serde_json::{Value, json};

use crate::args::Path;
use crate::input::Input;
use crate::locate::Locator;
use crate::output::Output;
use crate::place::Place;
use crate::question::walkable;
use crate::report::milliseconds;
use crate::timing::prepare;
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

impl Found {
    /// The path and then the next one, which begins at its end.
    fn followed_by(self, surface: &Surface, next: &Self) -> Self {
        Self {
            distance: self.distance + next.distance,
            is_interpolated: self.is_interpolated || next.is_interpolated,
            solve_ms: self.solve_ms + next.solve_ms,
            path_ms: self.path_ms + next.path_ms,
            path: self.path.followed_by(surface, &next.path),
            method: next.method,
        }
    }

    /// What is to be told; `cost`: of the path, where the ground has costs.
    fn facts(&self, cost: Option<f64>) -> Vec<(&'static str, Value)> {
        let points: Vec<Value> = self.path.positions().iter().map(|point| json!(point.to_array())).collect();
        let mut facts = vec![
            ("method", json!(self.method.name())),
            ("distance", json!(self.distance)),
            ("distance_interpolated", json!(self.is_interpolated)),
            ("length", json!(self.path.length())),
        ];
        facts.extend(cost.map(|cost| ("cost", json!(cost))));
        facts.push(("points", points.into()));
        facts
    }
}

pub fn path(arguments: &Path) -> Result<String> {
    if let Some(input) = volume::Input::of(&arguments.mesh)? {
        return volume::path(arguments, &input);
    }
    let options = arguments.distance_options()?;
    let output = arguments.output.as_deref().map(Output::path).transpose()?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    arguments.routes().flatten().try_for_each(|place| place.check(soup))?;
    let (solver, mut report, build_ms) = walkable(&input, &arguments.mesh, &arguments.solving, arguments.axis.up)?;
    let locator = Locator::new(soup, solver.surface());
    let on_surface = |route: Vec<Place>| route.iter().map(|place| locator.point(place)).collect();
    let routes = arguments.routes().map(on_surface).collect::<Result<Vec<Vec<SurfacePoint>>>>()?;
    locator.tell(&mut report);
    let mut prepared = prepare((solver, build_ms), &options)?;
    let found = routes.iter().map(|places| along(&mut prepared.solver, places, (arguments, &options)));
    let found = found.collect::<Result<Vec<Found>>>()?;
    if let Some(output) = output {
        let lines: Vec<_> = found.iter().map(|found| found.path.positions()).collect();
        output.write_several(&lines, "path", arguments.axis.up)?;
    }
    report.push("factor_nonzeros", prepared.solver.heat().map_or(0, HeatSolver::factor_nonzeros));
    let facts = |found: &Found| found.facts(prepared.solver.costs().map(|_| prepared.solver.cost_of(&found.path)));
    report.push_paths(&arguments.to, found.iter().map(facts).collect());
    let sum = |time: fn(&Found) -> f64| found.iter().map(time).sum::<f64>();
    report.push(
        "timings_ms",
        json!({
            "read": input.read_ms, "build": prepared.build_ms, "precompute": prepared.precompute_ms,
            "solve": sum(|found| found.solve_ms), "path": sum(|found| found.path_ms)
        }),
    );
    Ok(report.render(arguments.mesh.json))
}

/// The path through these places.
fn along(
    solver: &mut DistanceSolver,
    places: &[SurfacePoint],
    (arguments, options): (&Path, &DistanceOptions),
) -> Result<Found> {
    if arguments.bezier {
        return controlled(solver, places);
    }
    let legs = places.windows(2).map(|ends| match arguments.exact {
        true => exactly(solver, ends[0], ends[1]),
        false => by_descent(solver, ends[0], ends[1], (arguments, options)),
    });
    let legs = legs.collect::<Result<Vec<Found>>>()?;
    let surface = solver.surface();
    let found = legs.into_iter().reduce(|before, leg| before.followed_by(surface, &leg));
    found.context("a path has two ends")
}

fn by_descent(
    solver: &mut DistanceSolver,
    from: SurfacePoint,
    to: SurfacePoint,
    (arguments, options): (&Path, &DistanceOptions),
) -> Result<Found> {
    let start = Instant::now();
    let answer = solver.distance(&[to], options, &mut go_on)?;
    let solve_ms = milliseconds(start);
    let start = Instant::now();
    let is_exact = answer.method == Method::Exact;
    let kind = if is_exact || arguments.straighten { PathKind::Straightened } else { PathKind::Descent };
    let path = solver.path(&answer, from, kind)?;
    let length = solver.cost_of(&path);
    if is_exact {
        // Values of vertices are exact; what lies between them is not, but the path is.
        let path_ms = milliseconds(start);
        return Ok(Found { path, distance: length, is_interpolated: false, method: answer.method, solve_ms, path_ms });
    }
    let interpolated = answer.distance.at(solver.surface(), from)?;
    // In the face of the source, and near it, values of corners tell nothing of what is between; the path does.
    let is_at_vertex = matches!(from.place(), On::Vertex(_));
    let distance = if is_at_vertex { interpolated } else { interpolated.min(length) };
    let is_interpolated = !is_at_vertex && distance < length;
    Ok(Found { path, distance, is_interpolated, method: answer.method, solve_ms, path_ms: milliseconds(start) })
}

fn exactly(solver: &mut DistanceSolver, from: SurfacePoint, to: SurfacePoint) -> Result<Found> {
    let start = Instant::now();
    let path = shortest_path(solver.exact_geometry(), from, &[to])?;
    // One search gives distance and path.
    let solve_ms = milliseconds(start);
    let distance = solver.cost_of(&path);
    Ok(Found { path, distance, is_interpolated: false, method: Method::Exact, solve_ms, path_ms: 0.0 })
}

/// The Bézier curve of these places.
fn controlled(solver: &mut DistanceSolver, places: &[SurfacePoint]) -> Result<Found> {
    let start = Instant::now();
    let Bezier { path, .. } = bezier(solver.exact_geometry(), places, &mut go_on)?;
    let path_ms = milliseconds(start);
    let distance = path.length();
    Ok(Found { path, distance, is_interpolated: false, method: Method::Exact, solve_ms: 0.0, path_ms })
}
