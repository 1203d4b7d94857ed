//! `heatwalk log-map`.

use std::time::Instant;

use anyhow::Result;
use glam::DVec2;
use heatwalk::{Choice, Method, Windows, go_on, log_map as mapped, propagated_log_map};
use serde_json::json;

use crate::args::LogMap;
use crate::input::Input;
use crate::locate::Locator;
use crate::output::Output;
use crate::question::{diffusion, joined};
use crate::report::milliseconds;
use crate::volume;

/// Directions and lengths of the shortest paths from a source.
pub fn log_map(arguments: &LogMap) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "a log map is of a surface, not of the inside")?;
    let output = arguments.output.as_deref().map(|path| Output::of_vertices(path, "log maps")).transpose()?;
    let input = Input::of(&arguments.mesh)?;
    arguments.source.check(&input.model.soup)?;
    let (mut solver, mut report, build_ms) = joined(&input, &arguments.mesh, &arguments.bridging)?;
    let locator = Locator::new(&input.model.soup, solver.surface());
    let source = locator.point(&arguments.source)?;
    locator.tell(&mut report);
    let start = Instant::now();
    let (method, direction) = (arguments.method.as_str(), arguments.direction);
    let map = if method == Method::Heat.name() {
        diffusion(&solver)?.log_map(source, direction, &mut go_on)?
    } else if method == Method::Propagation.name() {
        propagated_log_map(solver.exact_geometry(), source, direction, Windows::default(), &mut go_on)?
    } else {
        mapped(solver.exact_geometry(), source, direction, &mut go_on)?
    };
    let map_ms = milliseconds(start);
    let surface = solver.surface();
    let column = |part: fn(&DVec2) -> f64| surface.to_inputs(&map.coordinates.iter().map(part).collect(), f64::NAN);
    let [u, v] = [column(|place| place.x), column(|place| place.y)];
    report.push("method", method);
    report.push("u_axis", json!(map.axes[0].to_array()));
    report.push("v_axis", json!(map.axes[1].to_array()));
    let reached = map.distances.iter().copied().filter(|distance| distance.is_finite());
    report.push("max_distance", reached.fold(0.0, f64::max));
    report.push("unreachable", u.iter().filter(|number| number.is_nan()).count());
    if let Some(output) = output {
        output.write(&[("u", u), ("v", v)])?;
    }
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "log_map": map_ms }));
    Ok(report.render(arguments.mesh.json))
}
