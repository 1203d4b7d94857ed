//! `heatwalk distance`.

use std::time::Instant;

use anyhow::Result;
use heatwalk::{
    Answer, Choice, DistanceOptions, DistanceSolver, HeatSolver, Method, RelativeError, Soup, Source, Surface,
    VertexData, VertexId, Windows, go_on, propagation::ALL,
};
use serde_json::{Value, json};

use crate::args::{Distance, Question};
use crate::locate::Locator;
use crate::output::{Columns, Output};
use crate::question::{Posed, pose};
use crate::report::{Report, milliseconds, object};
use crate::timing::{median_solve_ms, sample};
use crate::volume;

pub fn distance(arguments: &Distance) -> Result<String> {
    let question = &arguments.question;
    if let Some(input) = volume::Input::of(&question.mesh)? {
        return volume::distance(arguments, &input);
    }
    let options = question.distance_options()?;
    let output = arguments.output.as_deref().map(|path| Output::distance(path, arguments.each)).transpose()?;
    let Posed { input, sources, mut prepared, mut report } = pose(question, arguments.axis.up, &options)?;
    if options.method == Method::Heat {
        report.push_stages(&prepared.stages_ms);
    }
    let asked = Asked { solver: &mut prepared.solver, sources: &sources, arguments, options: &options };
    let (columns, solve_ms) = if question.curves.are_given() {
        asked.of_curves(&input.model.soup, &mut report)?
    } else if arguments.each {
        asked.each(&mut report)?
    } else {
        asked.together(&mut report)?
    };
    if let Some(output) = output {
        output.write(&input.model, arguments.axis.up, &columns)?;
    }
    report.push("factor_nonzeros", prepared.solver.heat().map_or(0, HeatSolver::factor_nonzeros));
    if let Some(heat) = prepared.solver.heat() {
        report.push("time_factor", heat.time_factor());
    }
    report.push(
        "timings_ms",
        json!({
            "read": input.read_ms, "build": prepared.build_ms, "precompute": prepared.precompute_ms, "solve": solve_ms
        }),
    );
    Ok(report.render(arguments.question.mesh.json))
}

/// What distances are asked for, of whom.
struct Asked<'a> {
    solver: &'a mut DistanceSolver,
    sources: &'a [Source],
    arguments: &'a Distance,
    options: &'a DistanceOptions,
}

impl Asked<'_> {
    /// From all sources at once. Milliseconds of that, or the median over single sources.
    fn together(self, report: &mut Report) -> Result<(Columns, f64)> {
        let Self { solver, sources, arguments, options } = self;
        let start = Instant::now();
        let answer = solver.distance(sources, options, &mut go_on)?;
        let mut solve_ms = milliseconds(start);
        if arguments.repeat > 1 {
            let vertices = sample(solver.surface(), arguments.repeat);
            report.push("timed_sources", numbers(solver.surface(), &vertices));
            solve_ms = median_solve_ms(&vertices, |source| Ok(solver.distance(&[source], options, &mut go_on)?))?;
        }
        let values = solver.of_inputs(&answer);
        report.extend(facts(&answer, &values, options));
        if arguments.compare {
            let exact = solver.distance(sources, &DistanceOptions::by(Method::Exact), &mut go_on)?;
            report.push_error(error(&answer.distance.values, &exact.distance.values));
        }
        Ok((vec![("distance".to_owned(), values)], solve_ms))
    }

    /// From all curves at once, and the milliseconds that it took.
    fn of_curves(self, soup: &Soup, report: &mut Report) -> Result<(Columns, f64)> {
        let Question { curves, closed, .. } = &self.arguments.question;
        let locator = Locator::new(soup, self.solver.surface());
        let found = curves.distances(&locator, self.solver, *closed)?;
        locator.tell(report);
        let values = self.solver.surface().to_inputs(&found.values, f64::INFINITY);
        report.extend(found.facts(&values));
        Ok((vec![("distance".to_owned(), values)], found.solve_ms))
    }

    /// From each source by itself. Milliseconds of them all.
    fn each(self, report: &mut Report) -> Result<(Columns, f64)> {
        let Self { solver, sources, arguments, options } = self;
        let threads = arguments.question.mesh.threads();
        let start = Instant::now();
        let answers = solver.distances_from_each(sources, options, threads, &mut go_on)?;
        let solve_ms = milliseconds(start);
        let columns = |(number, answer): (usize, &Answer)| (format!("distance_{number}"), solver.of_inputs(answer));
        let columns: Columns = answers.iter().enumerate().map(columns).collect();
        let told = |(answer, (_, values)): (&Answer, &(String, Vec<f64>))| object(facts(answer, values, options));
        report.push("threads", threads.get());
        report.push("each", answers.iter().zip(&columns).map(told).collect::<Vec<_>>());
        Ok((columns, solve_ms))
    }
}

/// What is to be told of an answer, whose values are `of_inputs`.
pub fn facts(answer: &Answer, of_inputs: &[f64], options: &DistanceOptions) -> Vec<(&'static str, Value)> {
    let mut facts = vec![("method", answer.method.name().into())];
    if answer.method != Method::Heat {
        let kept = match (answer.method, options.windows) {
            (Method::Propagation, Windows::AtMost(count)) => count.get().into(),
            _ => ALL.into(),
        };
        facts.extend([("windows", kept), ("windows_crossed", answer.windows.into())]);
    }
    if answer.method != Method::Exact {
        facts.push(("exact_below", answer.distance.exact_below.into()));
    }
    facts.push(("max_distance", answer.distance.max().into()));
    facts.push(("unreachable", of_inputs.iter().filter(|value| value.is_infinite()).count().into()));
    facts
}

fn error(values: &VertexData<f64>, exact: &VertexData<f64>) -> RelativeError {
    // What was left at infinity is not compared.
    let pairs = values.iter().zip(exact).filter(|(value, _)| value.is_finite());
    let (values, exact): (Vec<f64>, Vec<f64>) = pairs.unzip();
    RelativeError::between(&values, &exact)
}

/// Vertices by their numbers in the input, for others to be timed on the same.
fn numbers(surface: &Surface, vertices: &[VertexId]) -> Vec<u32> {
    vertices.iter().map(|&vertex| surface.inputs_of_vertex(vertex)[0].0).collect()
}
