//! `heatwalk table`: Table 1 of the report, for any meshes.

use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::Arc;

use anyhow::{Context, Result};
use heatwalk::{
    DistanceOptions, DistanceSolver, LinearSolver, Method, MultiSource, RelativeError, UnitRule, VertexId, WeldRule,
    go_on,
};
use heatwalk_base::parallel::ONE;
use serde_json::{Value, json};

use crate::answer::Answer;
use crate::args::Table;
use crate::input::Input;
use crate::markdown;
use crate::sentence::sentence;
use crate::timing::{Prepared, build, median_solve_ms, prepare, sample};

/// Conjugate gradients take seconds a source on a large mesh, so their median is over so many sources at most.
const MOST_ITERATED: u32 = 3;

/// What one linear solver takes on one mesh.
struct Figures {
    precompute_ms: f64,
    solve_ms: f64,
    error: Option<RelativeError>,
}

/// A mesh whose file could be read and built. The solvers fail independently.
struct Measured {
    triangles: usize,
    iterated: Result<Figures>,
    factored: Result<Figures>,
}

pub fn table(arguments: &Table) -> Answer {
    let rows: Vec<(String, Result<Measured>)> =
        arguments.meshes.iter().map(|mesh| (name(mesh), measure(mesh, arguments))).collect();
    let failures = rows.iter().flat_map(|(_, measured)| sentences(measured)).collect();
    let text = if arguments.json { as_json(&rows) } else { as_markdown(&rows, arguments) };
    Answer { text, failures, ..Answer::default() }
}

/// What went wrong with a mesh.
fn sentences(measured: &Result<Measured>) -> Vec<String> {
    let errors = match measured {
        Ok(Measured { iterated, factored, .. }) => vec![iterated.as_ref().err(), factored.as_ref().err()],
        Err(error) => vec![Some(error)],
    };
    errors.into_iter().flatten().map(sentence).collect()
}

fn name(mesh: &str) -> String {
    Path::new(mesh).file_name().map_or_else(|| mesh.to_owned(), |name| name.to_string_lossy().into_owned())
}

/// A file that exists is taken by its name, whatever that has after a `#`.
fn path_and_parts(mesh: &str) -> (&str, Vec<usize>) {
    let part = mesh.rsplit_once('#').and_then(|(path, part)| Some((path, vec![part.parse().ok()?])));
    part.filter(|_| !Path::new(mesh).exists()).unwrap_or((mesh, Vec::new()))
}

fn measure(mesh: &str, arguments: &Table) -> Result<Measured> {
    let (path, parts) = path_and_parts(mesh);
    let input = Input::read(Path::new(path), &parts, UnitRule::default(), NonZeroUsize::MIN)
        .with_context(|| mesh.to_owned())?;
    let (surface, build_ms) = build(&input, WeldRule::default(), ONE).with_context(|| mesh.to_owned())?;
    // The first vertex in the order of the file, wherever it is in memory.
    let source = surface.vertices_of_inputs().iter().flatten().next().copied().unwrap_or(VertexId(0));
    let exactly = DistanceOptions::by(Method::Exact);
    let exact = || DistanceSolver::new(Arc::clone(&surface)).distance(&[source], &exactly, &mut go_on);
    let exact = arguments.exact.then(exact).transpose()?;
    let figures = |linear_solver, sources| -> Result<Figures> {
        let heat = arguments.options.parameters(linear_solver, MultiSource::default());
        let options = DistanceOptions { heat, ..DistanceOptions::by(Method::Heat) };
        let Prepared { mut solver, precompute_ms, .. } =
            prepare((DistanceSolver::new(Arc::clone(&surface)), build_ms), &options)?;
        let mut solve = |source| Ok(solver.distance(&[source], &options, &mut go_on)?.distance.values);
        let solve_ms = median_solve_ms(&sample(&surface, sources), &mut solve)?;
        let error = match &exact {
            Some(exact) => Some(RelativeError::between(&solve(source)?, &exact.distance.values)),
            None => None,
        };
        Ok(Figures { precompute_ms: build_ms + precompute_ms, solve_ms, error })
    };
    let named = |figures: Result<Figures>| figures.with_context(|| mesh.to_owned());
    Ok(Measured {
        triangles: surface.face_count(),
        iterated: named(figures(LinearSolver::ConjugateGradients, arguments.repeat.min(MOST_ITERATED))),
        factored: named(figures(LinearSolver::Cholesky, arguments.repeat)),
    })
}

fn as_json(rows: &[(String, Result<Measured>)]) -> String {
    let figures = |figures: &Result<Figures>| match figures {
        Ok(Figures { precompute_ms, solve_ms, error }) => {
            let mut object = json!({ "precompute_ms": precompute_ms, "solve_ms": solve_ms });
            if let Some(error) = error {
                object["mean_error_percent"] = (100.0 * error.mean).into();
                object["max_error_percent"] = (100.0 * error.max).into();
            }
            object
        }
        Err(error) => json!({ "error": sentence(error) }),
    };
    let row = |(name, measured): &(String, Result<Measured>)| match measured {
        Ok(Measured { triangles, iterated, factored }) => json!({
            "name": name, "triangles": triangles, "conjugate_gradients": figures(iterated), "cholesky": figures(factored)
        }),
        Err(error) => json!({ "name": name, "error": sentence(error) }),
    };
    format!("{}\n", Value::Array(rows.iter().map(row).collect()))
}

fn as_markdown(rows: &[(String, Result<Measured>)], arguments: &Table) -> String {
    let mut header = vec!["mesh", "triangles", "CG precompute (ms)", "CG solve (ms)"];
    header.extend(["Cholesky precompute (ms)", "Cholesky solve (ms)"]);
    if arguments.exact {
        header.extend(["CG error mean / max (%)", "Cholesky error mean / max (%)"]);
    }
    let mut lines = vec![header.into_iter().map(str::to_owned).collect()];
    lines.extend(rows.iter().map(|(name, measured)| {
        let Ok(Measured { triangles, iterated, factored }) = measured else {
            return vec![name.clone()];
        };
        let solvers = [iterated, factored].map(|figures| figures.as_ref().ok());
        let mut cells = vec![name.clone(), triangles.to_string()];
        for figures in solvers {
            let times = figures.map(|figures| [figures.precompute_ms, figures.solve_ms].map(milliseconds));
            cells.extend(times.unwrap_or([markdown::MISSING; 2].map(str::to_owned)));
        }
        if arguments.exact {
            cells.extend(solvers.map(|figures| match figures.and_then(|figures| figures.error) {
                Some(RelativeError { mean, max }) => format!("{:.2} / {:.2}", 100.0 * mean, 100.0 * max),
                None => markdown::MISSING.to_owned(),
            }));
        }
        cells
    }));
    let (iterated, factored) = (arguments.repeat.min(MOST_ITERATED), arguments.repeat);
    let mut text = markdown::table(&lines);
    text += &format!(
        "\nPrecompute: from positions to ready operators. Solve: median over single sources, {factored} with Cholesky, \
         {iterated} with conjugate gradients (CG).\n"
    );
    if arguments.exact {
        text += "Error: against exact distances from the first vertex, relative. To CG heat below 10⁻¹² of its \
                 maximum is noise, so it loses the far field.\n";
    }
    text
}

/// Three digits or so.
fn milliseconds(time: f64) -> String {
    let digits = match time {
        ..10.0 => 2,
        ..100.0 => 1,
        _ => 0,
    };
    format!("{time:.digits$}")
}
