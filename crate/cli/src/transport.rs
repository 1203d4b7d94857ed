//! `heatwalk transport`.

use std::time::Instant;

use anyhow::Result;
use glam::DVec3;
use heatwalk::{Choice, Method, go_on, transport as carried};
use serde_json::json;

use crate::args::Transport;
use crate::input::Input;
use crate::locate::Locator;
use crate::output::Output;
use crate::question::{diffusion, joined};
use crate::report::milliseconds;
use crate::volume;

/// Carries vectors to all vertices.
pub fn transport(arguments: &Transport) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "vectors are carried along a surface, not inside")?;
    let output = arguments.output.as_deref().map(|path| Output::of_vertices(path, "vectors")).transpose()?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    arguments.vectors.iter().try_for_each(|at| at.place.check(soup))?;
    let (mut solver, mut report, build_ms) = joined(&input, &arguments.mesh, &arguments.bridging)?;
    let locator = Locator::new(soup, solver.surface());
    let placed = arguments.vectors.iter().map(|at| Ok((locator.point(&at.place)?, at.vector)));
    let placed = placed.collect::<Result<Vec<_>>>()?;
    locator.tell(&mut report);
    let start = Instant::now();
    let vectors = if arguments.method == Method::Heat.name() {
        diffusion(&solver)?.transport(&placed, &mut go_on)?
    } else {
        carried(solver.exact_geometry(), &placed, &mut go_on)?
    };
    let transport_ms = milliseconds(start);
    let (surface, up) = (solver.surface(), arguments.axis.up);
    let column = |part: fn(DVec3) -> f64| {
        surface.to_inputs(&vectors.iter().map(|&vector| part(up.turned(vector))).collect(), f64::NAN)
    };
    let [x, y, z] = [column(|vector| vector.x), column(|vector| vector.y), column(|vector| vector.z)];
    report.push("method", arguments.method.as_str());
    report.push("without_vector", x.iter().filter(|number| number.is_nan()).count());
    if let Some(output) = output {
        output.write(&[("x", x), ("y", y), ("z", z)])?;
    }
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "transport": transport_ms }));
    Ok(report.render(arguments.mesh.json))
}
