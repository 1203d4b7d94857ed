//! `heatwalk walk`.

use std::time::Instant;

use anyhow::Result;
use heatwalk::{InputPlace, Straightest, straightest};
use serde_json::json;

use crate::args::Walk;
use crate::input::Input;
use crate::locate::Locator;
use crate::output::Output;
use crate::place::Place;
use crate::report::{Report, milliseconds};
use crate::timing::build;
use crate::volume;

/// Walks as straight as the surface lets it.
pub fn walk(arguments: &Walk) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "a walk is on a surface, not inside")?;
    let output = arguments.output.as_deref().map(Output::path).transpose()?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    arguments.from.check(soup)?;
    if let Some(triangle) = arguments.triangle {
        Place::Triangle { triangle, weights: [1.0, 0.0, 0.0] }.check(soup)?;
    }
    let (surface, build_ms) = build(&input, arguments.mesh.weld, arguments.mesh.threads())?;
    let locator = Locator::new(soup, &surface);
    let from = locator.point(&arguments.from)?;
    let face = arguments.triangle.map(|triangle| surface.require_face(soup, triangle)).transpose()?;
    let start = Instant::now();
    let Straightest { path, direction, is_at_boundary } =
        straightest(&surface, from, face, arguments.direction, arguments.length)?;
    let walk_ms = milliseconds(start);
    if let Some(output) = output {
        output.write(path.positions().into_iter(), arguments.axis.up)?;
    }
    let mut report = Report::default();
    report.push_surface(surface.report());
    input.tell(&mut report);
    locator.tell(&mut report);
    if let Some(end) = path.points.last() {
        report.push("end", json!(end.position.to_array()));
        report.push("place", Place::from(InputPlace::of(end.location, end.face, soup, &surface)).to_string());
    }
    report.push("direction", json!(direction.to_array()));
    report.push("length", path.length());
    report.push("at_boundary", is_at_boundary);
    let points: Vec<_> = path.positions().iter().map(|point| json!(point.to_array())).collect();
    report.push("points", points);
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "walk": walk_ms }));
    Ok(report.render(arguments.mesh.json))
}
