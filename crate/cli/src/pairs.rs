//! `heatwalk pairs`.

use std::time::Instant;

use anyhow::Result;
use heatwalk::go_on;
use serde_json::json;

use crate::args::Pairs;
use crate::input::Input;
use crate::lists::listed;
use crate::locate::Locator;
use crate::output::Output;
use crate::place::Pair;
use crate::question::joined;
use crate::report::milliseconds;
use crate::volume;

/// Exact distances of pairs of places.
pub fn pairs(arguments: &Pairs) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "pairs are on a surface, not inside")?;
    let output = arguments.output.as_deref().map(Output::pairs).transpose()?;
    let pairs: Vec<Pair> = listed(&arguments.pairs, "pair")?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    pairs.iter().flat_map(|pair| &pair.0).try_for_each(|place| place.check(soup))?;
    let (mut solver, mut report, build_ms) = joined(&input, &arguments.mesh, &arguments.bridging)?;
    let locator = Locator::new(soup, solver.surface());
    let on_surface = |Pair([from, to]): &Pair| Ok([locator.point(from)?, locator.point(to)?]);
    let places = pairs.iter().map(on_surface).collect::<Result<Vec<_>>>()?;
    locator.tell(&mut report);
    let start = Instant::now();
    let distances = solver.distances_of_pairs(&places, arguments.mesh.threads(), &mut go_on)?;
    let pairs_ms = milliseconds(start);
    if let Some(output) = output {
        output.write(&pairs, &distances)?;
    }
    report.push("pairs", pairs.len());
    let finite = distances.iter().copied().filter(|distance| distance.is_finite());
    report.push("max_distance", finite.fold(0.0, f64::max));
    report.push("unreachable", distances.iter().filter(|distance| distance.is_infinite()).count());
    report.push("distances", distances);
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "pairs": pairs_ms }));
    Ok(report.render(arguments.mesh.json))
}
