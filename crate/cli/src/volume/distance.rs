//! `heatwalk distance` on tetrahedra.

use std::time::Instant;

use anyhow::{Context, Result, ensure};
use heatwalk::{Choice, Method, RelativeError, Up};
use heatwalk_volume::{
    TetMesh, TetSource, VolumeDistance, VolumeMethod, VolumeOptions, VolumeSolver, boundary_distance,
};
use serde_json::{Value, json};

use super::commands::{build, prepare, push_mesh};
use super::input::{Input, along, refuse, source, volume_options};
use crate::args::Distance;
use crate::complaint::complain;
use crate::output::{Columns, Output};
use crate::report::{Report, milliseconds, object};

pub fn distance(arguments: &Distance, input: &Input) -> Result<String> {
    if arguments.question.curves.are_given() {
        return of_boundary(arguments, input);
    }
    let options = options(arguments)?;
    let output = arguments.output.as_deref().map(|path| Output::volume(path, arguments.each)).transpose()?;
    let question = &arguments.question;
    let (mesh, build_ms) = build(input)?;
    let mut sources =
        question.places()?.iter().map(|place| source(place, &input.soup, &mesh)).collect::<Result<Vec<_>>>()?;
    for line in &question.lines {
        sources.extend(along(line, &input.soup, &mesh, question.closed)?);
    }
    let mut said = Report::default();
    push_mesh(&mut said, mesh.report());
    let costs = question.solving.ground.inside(&input.soup, &mesh)?;
    let (mut solver, precompute_ms) = prepare(&mesh, costs.as_deref(), &options)?;
    let (columns, solve_ms) = if arguments.each {
        each(&mut solver, &sources, &options, &mut said)?
    } else {
        together(&mut solver, &sources, (arguments, &options), &mut said)?
    };
    if let Some(output) = output {
        output.write_volume(&input.soup, &columns)?;
    }
    said.push("factor_nonzeros", solver.factor_nonzeros());
    if let Some(factor) = solver.time_factor() {
        said.push("time_factor", factor);
    }
    said.push(
        "timings_ms",
        json!({ "read": input.read_ms, "build": build_ms, "precompute": precompute_ms, "solve": solve_ms }),
    );
    Ok(said.render(question.mesh.json))
}

/// From the boundary.
fn of_boundary(arguments: &Distance, input: &Input) -> Result<String> {
    let question = &arguments.question;
    ensure!(
        question.curves.are_boundaries(),
        "inside of tetrahedra there are no curves; give --curve boundary for all of the boundary"
    );
    let options = options(arguments)?;
    ensure!(
        options.method == VolumeMethod::March,
        "distance from the boundary is exact; leave --method heat to --source"
    );
    ensure!(options.max_distance == f64::INFINITY, "--max-distance has no effect with --curve");
    let output = arguments.output.as_deref().map(|path| Output::volume(path, false)).transpose()?;
    let (mesh, build_ms) = build(input)?;
    let costs = question.solving.ground.inside(&input.soup, &mesh)?;
    ensure!(costs.is_none(), "distance from the boundary is that of straight lines; leave costs to --source");
    let start = Instant::now();
    let values = mesh.to_inputs(&boundary_distance(&mesh)?, f64::INFINITY);
    let solve_ms = milliseconds(start);
    let mut said = Report::default();
    push_mesh(&mut said, mesh.report());
    said.push("method", Method::Exact.name());
    said.push("max_distance", values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max));
    said.push("unreachable", values.iter().filter(|value| value.is_infinite()).count());
    if let Some(output) = output {
        output.write_volume(&input.soup, &[("distance".to_owned(), values)])?;
    }
    said.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "solve": solve_ms }));
    Ok(said.render(question.mesh.json))
}

fn options(arguments: &Distance) -> Result<VolumeOptions> {
    let question = &arguments.question;
    refuse(&[
        ("--exact", question.exact),
        ("--signed", question.curves.signed),
        ("--repeat", arguments.repeat > 1),
        ("--up", arguments.axis.up != Up::default()),
    ])?;
    let options = volume_options(&question.solving, question.heat_option(), question.multi.unwrap_or_default())?;
    ensure!(
        !arguments.compare || options.method == VolumeMethod::Heat,
        "--compare tells how far the heat method is from the march: give --method heat"
    );
    Ok(VolumeOptions { max_distance: question.max_distance.unwrap_or(f64::INFINITY), ..options })
}

/// From all sources at once, and milliseconds of that.
fn together(
    solver: &mut VolumeSolver,
    sources: &[TetSource],
    (arguments, options): (&Distance, &VolumeOptions),
    said: &mut Report,
) -> Result<(Columns, f64)> {
    let start = Instant::now();
    let answer = solver.distance(sources, options)?;
    let solve_ms = milliseconds(start);
    warn(&answer);
    let values = of_inputs(solver.mesh(), &answer);
    said.extend(facts(&answer, &values));
    if arguments.compare {
        let marched = solver.distance(sources, &VolumeOptions::default())?;
        said.push_error(RelativeError::between(&answer.values, &marched.values));
    }
    Ok((vec![("distance".to_owned(), values)], solve_ms))
}

/// From each source by itself, and milliseconds of them all.
fn each(
    solver: &mut VolumeSolver,
    sources: &[TetSource],
    options: &VolumeOptions,
    said: &mut Report,
) -> Result<(Columns, f64)> {
    let (mut columns, mut answers, mut solve_ms) = (Columns::new(), Vec::new(), 0.0);
    for (number, &source) in sources.iter().enumerate() {
        let start = Instant::now();
        let answer = solver.distance(&[source], options).with_context(|| format!("source {number}"))?;
        solve_ms += milliseconds(start);
        warn(&answer);
        let values = of_inputs(solver.mesh(), &answer);
        answers.push(object(facts(&answer, &values)));
        columns.push((format!("distance_{number}"), values));
    }
    said.push("each", answers);
    Ok((columns, solve_ms))
}

/// Tells of a march that would have been too much work.
fn warn(answer: &VolumeDistance) {
    if answer.method == VolumeMethod::March && answer.exact_below < f64::INFINITY {
        let below = answer.exact_below;
        complain(&format!(
            "warning: too much is in the way of straight lines; distances above {below} are ways along edges"
        ));
    }
}

/// What is to be told of an answer, whose values are `of_inputs`.
fn facts(answer: &VolumeDistance, of_inputs: &[f64]) -> [(&'static str, Value); 4] {
    [
        ("method", answer.method.name().into()),
        ("exact_below", answer.exact_below.into()),
        ("max_distance", answer.max().into()),
        ("unreachable", of_inputs.iter().filter(|value| value.is_infinite()).count().into()),
    ]
}

/// Vertices that no tetrahedron uses are as far as another component.
fn of_inputs(mesh: &TetMesh, answer: &VolumeDistance) -> Vec<f64> {
    mesh.to_inputs(&answer.values, f64::INFINITY)
}
