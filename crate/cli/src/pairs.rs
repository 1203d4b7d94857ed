//! `heatwalk pairs`.

use std::path::Path;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use heatwalk::{BridgeRule, go_on};
use heatwalk_index::Bounds;
use serde_json::json;

use crate::args::{Bridging, Pairs};
use crate::index::read;
use crate::input::Input;
use crate::lists::listed;
use crate::locate::Locator;
use crate::output::{Output, PairsCsv};
use crate::place::{Pair, Place};
use crate::question::joined;
use crate::report::{Report, milliseconds};
use crate::timing::build;
use crate::volume;

/// Exact distances of pairs of places.
pub fn pairs(arguments: &Pairs) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "pairs are on a surface, not inside")?;
    let output = arguments.output.as_deref().map(Output::pairs).transpose()?;
    let pairs: Vec<Pair> = listed(&arguments.pairs, "pair")?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    pairs.iter().flat_map(|pair| &pair.0).try_for_each(|place| place.check(soup))?;
    if let Some(index) = &arguments.index {
        return indexed(index, (arguments, output), &pairs, &input);
    }
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
    push_distances(&mut report, distances);
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "pairs": pairs_ms }));
    Ok(report.render(arguments.mesh.json))
}

/// Distances of vertices from an index, no less than those and longer by less than is told.
fn indexed(
    file: &Path,
    (arguments, output): (&Pairs, Option<Output<PairsCsv>>),
    pairs: &[Pair],
    input: &Input,
) -> Result<String> {
    let Bridging { rule, links } = &arguments.bridging;
    ensure!(*rule == BridgeRule::default() && *links == 0, "an index knows no bridges; leave --bridge and --link out");
    let vertex = |place: &Place| {
        place.vertex().with_context(|| {
            format!("{place} is no vertex; an index answers for vertices, pairs without --index for places")
        })
    };
    let vertices = pairs.iter().map(|Pair([from, to])| Ok([vertex(from)?, vertex(to)?])).collect::<Result<Vec<_>>>()?;
    let (surface, build_ms) = build(input, arguments.mesh.weld, arguments.mesh.threads())?;
    let start = Instant::now();
    let index = read(file, &surface)?;
    let read_ms = milliseconds(start);
    let start = Instant::now();
    let bounds = vertices.iter().map(|&[from, to]| Ok(index.distance(from, to)?)).collect::<Result<Vec<Bounds>>>()?;
    let pairs_ms = milliseconds(start);
    if let Some(output) = output {
        output.write_bounds(pairs, &bounds)?;
    }
    let mut report = Report::default();
    report.push_surface(surface.report());
    input.tell(&mut report);
    report.push("at_least", bounds.iter().map(|bounds| bounds.lower).collect::<Vec<_>>());
    push_distances(&mut report, bounds.iter().map(|bounds| bounds.upper).collect());
    let timings = json!({ "read": input.read_ms, "build": build_ms, "read_index": read_ms, "pairs": pairs_ms });
    report.push("timings_ms", timings);
    Ok(report.render(arguments.mesh.json))
}

fn push_distances(report: &mut Report, distances: Vec<f64>) {
    report.push("pairs", distances.len());
    let finite = distances.iter().copied().filter(|distance| distance.is_finite());
    report.push("max_distance", finite.fold(0.0, f64::max));
    report.push("unreachable", distances.iter().filter(|distance| distance.is_infinite()).count());
    report.push("distances", distances);
}
