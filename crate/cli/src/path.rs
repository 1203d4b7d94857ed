//! `heatwalk path`.

use std::sync::Arc;
use std::time::Instant;

use anyhow::Result;
use heatwalk::exact::shortest_path;
use heatwalk::{MultiSource, Surface, SurfacePoint, descend, straighten};
use serde_json::json;

use crate::args::Path;
use crate::exact;
use crate::input::Input;
use crate::output::Output;
use crate::report::{Report, milliseconds};
use crate::timing::{Factored, build, factor};

/// A path, the distance that belongs to it, and what they took.
struct Found {
    path: heatwalk::Path,
    distance: f64,
    factor_nonzeros: usize,
    precompute_ms: f64,
    solve_ms: f64,
    path_ms: f64,
}

pub fn path(arguments: &Path) -> Result<String> {
    let output = arguments.output.as_deref().map(Output::path).transpose()?;
    let input = Input::read(&arguments.mesh.mesh, &arguments.mesh.parts)?;
    arguments.from.check(&input.soup)?;
    arguments.to.check(&input.soup)?;
    let (surface, build_ms) = build(&input)?;
    let from = arguments.from.on(&input.soup, &surface)?;
    let to = arguments.to.on(&input.soup, &surface)?;
    let found = if arguments.exact { exactly(&surface, from, to)? } else { by_heat(&surface, from, to, arguments)? };
    if let Some(output) = output {
        output.write(&found.path)?;
    }
    let points: Vec<_> = found.path.points.iter().map(|point| json!(point.position.to_array())).collect();
    let mut report = Report::default();
    report.push_surface(surface.report());
    report.push("factor_nonzeros", found.factor_nonzeros);
    report.push("distance", found.distance);
    report.push("length", found.path.length());
    report.push("points", points);
    report.push(
        "timings_ms",
        json!({
            "read": input.read_ms, "build": build_ms, "precompute": found.precompute_ms, "solve": found.solve_ms,
            "path": found.path_ms
        }),
    );
    Ok(report.render(arguments.mesh.json))
}

fn by_heat(surface: &Arc<Surface>, from: SurfacePoint, to: SurfacePoint, arguments: &Path) -> Result<Found> {
    let parameters = arguments.options.parameters(arguments.solver, MultiSource::default());
    let Factored { solver, precompute_ms, .. } = factor(surface, parameters)?;
    let start = Instant::now();
    let distance = solver.distance(&[to])?;
    let solve_ms = milliseconds(start);
    let start = Instant::now();
    let mut path = descend(surface, &distance, from)?;
    if arguments.straighten {
        path = straighten(surface, &path)?;
    }
    Ok(Found {
        path,
        distance: distance.at(surface, from)?,
        factor_nonzeros: solver.factor_nonzeros(),
        precompute_ms,
        solve_ms,
        path_ms: milliseconds(start),
    })
}

fn exactly(surface: &Arc<Surface>, from: SurfacePoint, to: SurfacePoint) -> Result<Found> {
    let (geometry, precompute_ms) = exact::geometry(surface);
    let start = Instant::now();
    let path = shortest_path(&geometry, from, &[to])?;
    // One search gives distance and path.
    let solve_ms = milliseconds(start);
    Ok(Found { distance: path.length(), path, factor_nonzeros: 0, precompute_ms, solve_ms, path_ms: 0.0 })
}
