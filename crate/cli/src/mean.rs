//! `heatwalk mean`.

use std::time::Instant;

use anyhow::Result;
use heatwalk::{InputPlace, Mean as Found, go_on, mean as found};
use serde_json::json;

use crate::args::Mean;
use crate::input::Input;
use crate::lists::with_listed;
use crate::locate::Locator;
use crate::place::Place;
use crate::question::joined;
use crate::report::milliseconds;
use crate::volume;

/// Finds the mean of weighted places.
pub fn mean(arguments: &Mean) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "a mean is on a surface, not inside")?;
    let places = with_listed(&arguments.sources, &arguments.source_files, "place")?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    places.iter().try_for_each(|source| source.place.check(soup))?;
    let (mut solver, mut report, build_ms) = joined(&input, &arguments.mesh, &arguments.bridging)?;
    let locator = Locator::new(soup, solver.surface());
    let weighted = places.iter().map(|at| Ok((locator.point(&at.place)?, at.weight)));
    let weighted = weighted.collect::<Result<Vec<_>>>()?;
    locator.tell(&mut report);
    let start = Instant::now();
    let Found { place, variance } = found(solver.exact_geometry(), &weighted, &mut go_on)?;
    let mean_ms = milliseconds(start);
    let surface = solver.surface();
    let face = place.faces(surface)[0];
    report.push("place", Place::from(InputPlace::of(place, face, soup, surface)).to_string());
    report.push("position", json!(place.position(surface).to_array()));
    report.push("variance", variance);
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "mean": mean_ms }));
    Ok(report.render(arguments.mesh.json))
}
