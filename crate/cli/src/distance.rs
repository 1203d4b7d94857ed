//! `heatwalk distance`.

use std::sync::Arc;
use std::time::Instant;

use anyhow::{Result, bail};
use heatwalk::propagation::Propagation;
use heatwalk::{Choice, ExactSearch, Method, PropagationOptions, RelativeError, Source, Surface, VertexData, VertexId};
use serde_json::json;

use crate::args::Distance;
use crate::exact;
use crate::input::Input;
use crate::output::Output;
use crate::report::{Report, milliseconds};
use crate::timing::{Factored, build, factor, median_solve_ms, sample};

/// Windows that an exact search may propagate by default: about a second.
const AFFORDABLE_WINDOWS: usize = 8_000_000;

/// Distances, `#V`, and what they took.
struct Solved {
    values: VertexData<f64>,
    precompute_ms: f64,
    solve_ms: f64,
}

pub fn distance(arguments: &Distance) -> Result<String> {
    let method = if arguments.exact { Method::Exact } else { arguments.method };
    if method == Method::Heat && arguments.max_distance.is_some() {
        bail!("--max-distance needs another --method than heat, which finds all distances at once");
    }
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
    let Solved { values, precompute_ms, solve_ms } = match exact_search(method) {
        Some(search) => by_windows(&surface, &sources, arguments, search, &mut report)?,
        None => by_heat(&surface, &sources, arguments, &mut report)?,
    };

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

/// How far a method searches exactly; `None` for heat.
fn exact_search(method: Method) -> Option<ExactSearch> {
    match method {
        Method::Heat => None,
        Method::Auto => Some(ExactSearch::AtMost(AFFORDABLE_WINDOWS)),
        Method::Propagation => Some(ExactSearch::Automatic),
        Method::Exact => Some(ExactSearch::AtMost(usize::MAX)),
    }
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
    report.push("method", Method::Heat.name());
    report.push_stages(&stages_ms);
    report.push("factor_nonzeros", solver.factor_nonzeros());
    report.push("time_factor", solver.time_factor());
    report.push("exact_below", distance.exact_below);
    if arguments.compare {
        push_errors(&distance.values, &exact::distances(solver.exact_geometry(), sources)?, report);
    }
    Ok(Solved { values: distance.values, precompute_ms, solve_ms })
}

/// By windows: exactly as far as `exact` goes, by a few of each half-edge beyond.
fn by_windows(
    surface: &Arc<Surface>,
    sources: &[Source],
    arguments: &Distance,
    exact: ExactSearch,
    report: &mut Report,
) -> Result<Solved> {
    let farthest = arguments.max_distance.unwrap_or(f64::INFINITY);
    let (geometry, precompute_ms) = exact::geometry(surface);
    let start = Instant::now();
    let options = PropagationOptions { windows: arguments.windows, exact };
    let mut propagation = Propagation::new(Arc::clone(&geometry), sources, options)?;
    propagation.advance(farthest, usize::MAX);
    let asked_ms = milliseconds(start);
    let within = |&value: &f64| if value <= farthest { value } else { f64::INFINITY };
    let values: VertexData<f64> = propagation.values().iter().map(within).collect();
    let (is_exact, exact_below) = (propagation.is_exact(), propagation.exact_below());
    let solve_ms = match arguments.repeat {
        1 => asked_ms,
        count => median_solve_ms(&timed(surface, count, report), |source| {
            propagation.restart(&[source])?;
            propagation.advance(farthest, usize::MAX);
            Ok(propagation.values().clone())
        })?,
    };
    report.push("factor_nonzeros", 0);
    report.push("method", if is_exact { Method::Exact } else { Method::Propagation }.name());
    if !is_exact {
        report.push("windows", arguments.windows.to_string());
        report.push("exact_below", exact_below);
    }
    if arguments.compare {
        push_errors(&values, &exact::distances(&geometry, sources)?, report);
    }
    Ok(Solved { values, precompute_ms, solve_ms })
}

fn push_errors(values: &VertexData<f64>, exact: &VertexData<f64>, report: &mut Report) {
    // What was left at infinity is not compared.
    let pairs = values.iter().zip(exact).filter(|(value, _)| value.is_finite());
    let (values, exact): (Vec<f64>, Vec<f64>) = pairs.unzip();
    let error = RelativeError::between(&values, &exact);
    report.push("mean_error_percent", 100.0 * error.mean);
    report.push("max_error_percent", 100.0 * error.max);
}

/// The vertices that the median solve is taken over. The report tells them, for others to be timed on the same.
fn timed(surface: &Surface, count: u32, report: &mut Report) -> Vec<VertexId> {
    let vertices = sample(surface, count);
    let input = |&vertex: &VertexId| surface.inputs_of_vertex(vertex)[0].0;
    report.push("timed_sources", vertices.iter().map(input).collect::<Vec<_>>());
    vertices
}
