//! `heatwalk distance`.

use std::sync::Arc;
use std::time::Instant;

use anyhow::Result;
use heatwalk::{RelativeError, Source, Surface, VertexData, VertexId};
use serde_json::json;

use crate::args::Distance;
use crate::exact;
use crate::input::Input;
use crate::output::Output;
use crate::report::{Report, milliseconds};
use crate::timing::{Factored, build, factor, median_solve_ms, sample};

/// Distances, `#V`, and what they took.
struct Solved {
    values: VertexData<f64>,
    precompute_ms: f64,
    solve_ms: f64,
}

pub fn distance(arguments: &Distance) -> Result<String> {
    let output = arguments.output.as_deref().map(Output::distance).transpose()?;
    let input = Input::read(&arguments.mesh.mesh, &arguments.mesh.parts)?;
    arguments.sources.iter().try_for_each(|source| source.place.check(&input.soup))?;
    arguments.lines.iter().try_for_each(|line| line.check(&input.soup))?;
    let (surface, build_ms) = build(&input)?;
    let mut sources =
        arguments.sources.iter().map(|source| source.on(&input.soup, &surface)).collect::<Result<Vec<_>>>()?;
    for line in &arguments.lines {
        sources.extend(line.on(&surface, arguments.closed)?);
    }

    let mut report = Report::default();
    report.push_surface(surface.report());
    let solve = if arguments.exact { exactly } else { by_heat };
    let Solved { values, precompute_ms, solve_ms } = solve(&surface, &sources, arguments, &mut report)?;

    // Vertices that no triangle uses are as far as another component.
    let of_input = |vertex: &Option<VertexId>| vertex.map_or(f64::INFINITY, |vertex| values[vertex]);
    let of_inputs: Vec<f64> = surface.vertices_of_inputs().iter().map(of_input).collect();
    if let Some(output) = output {
        output.write(&input.soup, &of_inputs)?;
    }
    let finite = values.iter().copied().filter(|value| value.is_finite());
    report.push("max_distance", finite.fold(0.0, f64::max));
    report.push("unreachable", of_inputs.iter().filter(|value| value.is_infinite()).count());
    report.push(
        "timings_ms",
        json!({ "read": input.read_ms, "build": build_ms, "precompute": precompute_ms, "solve": solve_ms }),
    );
    Ok(report.render(arguments.mesh.json))
}

fn by_heat(surface: &Arc<Surface>, sources: &[Source], arguments: &Distance, report: &mut Report) -> Result<Solved> {
    let parameters = arguments.options.parameters(arguments.solver, arguments.multi);
    let Factored { solver, precompute_ms, stages_ms } = factor(surface, parameters)?;
    let start = Instant::now();
    let distance = solver.distance(sources)?;
    let asked_ms = milliseconds(start);
    let solve_ms = match arguments.repeat {
        1 => asked_ms,
        count => median_solve_ms(&timed(surface, count, report), |source| Ok(solver.distance(&[source])?))?,
    };
    report.push_stages(&stages_ms);
    report.push("factor_nonzeros", solver.factor_nonzeros());
    report.push("time_factor", solver.time_factor());
    report.push("exact_below", distance.exact_below);
    if arguments.compare {
        let exact = exact::distances(solver.exact_geometry(), sources)?;
        let error = RelativeError::between(&distance.values, &exact);
        report.push("mean_error_percent", 100.0 * error.mean);
        report.push("max_error_percent", 100.0 * error.max);
    }
    Ok(Solved { values: distance.values, precompute_ms, solve_ms })
}

fn exactly(surface: &Arc<Surface>, sources: &[Source], arguments: &Distance, report: &mut Report) -> Result<Solved> {
    let (geometry, precompute_ms) = exact::geometry(surface);
    let start = Instant::now();
    let values = exact::distances(&geometry, sources)?;
    let asked_ms = milliseconds(start);
    let solve_ms = match arguments.repeat {
        1 => asked_ms,
        count => {
            let vertices = timed(surface, count, report);
            median_solve_ms(&vertices, |source| exact::distances(&geometry, &[source]))?
        }
    };
    report.push("factor_nonzeros", 0);
    Ok(Solved { values, precompute_ms, solve_ms })
}

/// The vertices that the median solve is taken over. The report tells them, for others to be timed on the same.
fn timed(surface: &Surface, count: u32, report: &mut Report) -> Vec<VertexId> {
    let vertices = sample(surface, count);
    let input = |&vertex: &VertexId| surface.inputs_of_vertex(vertex)[0].0;
    report.push("timed_sources", vertices.iter().map(input).collect::<Vec<_>>());
    vertices
}
