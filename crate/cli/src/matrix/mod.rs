//! `heatwalk matrix`: rows of distances, written as they come.

mod fingerprint;
mod npy;
mod npz;
mod parcels;
mod part;
mod row;
mod sink;

use std::time::Instant;

use anyhow::{Context, Result, ensure};
use heatwalk::{
    Choice, DistanceSolver, Element, InputVertex, SampleCount, Surface, VertexId, farthest_samples, go_on, row_source,
};
use serde_json::json;

use self::fingerprint::{Question, fingerprint};
use self::row::Layout;
use self::sink::Sink;
use crate::args::Matrix;
use crate::input::Input;
use crate::lists::listed;
use crate::locate::Locator;
use crate::output::{MatrixFormat, Output};
use crate::place::Place;
use crate::progress::Ticker;
use crate::question::walkable;
use crate::report::{Report, milliseconds};
use crate::timing::prepare;
use crate::volume;

/// Bytes of rows that wait to be written, unless one a thread is more.
const WAITING: usize = 64 << 20;

/// Rows a thread that are found before they are written: enough that threads seldom wait for the last of them.
const ROWS_PER_THREAD: usize = 32;

/// Distances from each of many sources.
pub fn matrix(arguments: &Matrix) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "a matrix is of distances on a surface, not inside")?;
    let options = arguments.distance_options()?;
    let output = Output::matrix(&arguments.output)?;
    if let Some(file) = &arguments.parcels {
        let (mut report, times) = parcels::matrix(arguments, file, &output)?;
        told_times(&mut report, times);
        return Ok(report.render(arguments.mesh.json));
    }
    let is_limited = arguments.max_distance.is_some();
    ensure!(
        is_limited || !matches!(output.format, MatrixFormat::Npz),
        "an .npz file is a sparse matrix: give --max-distance, or write all distances to an .npy file"
    );
    let given: Option<Vec<Place>> = arguments.sources.as_deref().map(|file| listed(file, "source")).transpose()?;
    let targets = arguments.targets.as_deref().map(|file| vertices(&listed(file, "target")?)).transpose()?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    let targets = targets.unwrap_or_else(|| (0..soup.positions.len()).collect());
    let checked = given.iter().flatten().copied().chain(targets.iter().map(|&vertex| Place::Vertex(vertex)));
    checked.into_iter().try_for_each(|place| place.check(soup))?;

    let (solver, mut report, build_ms) = walkable(&input, &arguments.mesh, &arguments.solving, arguments.axis.up)?;
    let mut prepared = prepare((solver, build_ms), &options)?;
    let solver = &mut prepared.solver;
    let places = match (given, arguments.landmarks) {
        (Some(places), _) => places,
        (None, Some(count)) => landmarks(solver, count)?,
        (None, None) => (0..soup.positions.len()).map(Place::Vertex).collect(),
    };
    let locator = Locator::new(soup, solver.surface());
    let on_surface = |place: &Place| match place {
        Place::Coordinates(_) => locator.point(place).map(Some),
        place => Ok(row_source(place.of_surface()?, soup, solver.surface())?),
    };
    let sources = places.iter().map(on_surface).collect::<Result<Vec<_>>>()?;
    locator.tell(&mut report);
    let columns = targets.iter().map(|&vertex| solver.surface().vertex_of_input(InputVertex::from_index(vertex)));
    let columns: Vec<Option<VertexId>> = columns.collect();

    let layout = Layout::new(output.format, arguments.dtype, is_limited, &targets);
    let question = Question { places: &places, sources: &sources, columns: &columns, options: &options };
    let start = Instant::now();
    let written = write(solver, &question, (arguments, &layout))?;
    report.push("method", options.method.name());
    report.push("rows", sources.len());
    report.push("columns", columns.len());
    report.push("rows_before", written.before);
    if arguments.landmarks.is_some() {
        report.push("landmarks", places.iter().filter_map(Place::vertex).collect::<Vec<_>>());
    }
    report.push("threads", arguments.mesh.threads().get());
    told_times(&mut report, [input.read_ms, prepared.build_ms, prepared.precompute_ms, milliseconds(start)]);
    Ok(report.render(arguments.mesh.json))
}

fn told_times(report: &mut Report, [read, build, precompute, rows]: [f64; 4]) {
    report.push("timings_ms", json!({ "read": read, "build": build, "precompute": precompute, "rows": rows }));
}

/// What was done.
struct Written {
    /// Rows that an earlier run had finished.
    before: usize,
}

/// Finds the rows that are not written yet, some at a time, and writes them in their order.
fn write(
    solver: &mut DistanceSolver,
    question: &Question<'_>,
    (arguments, layout): (&Matrix, &Layout),
) -> Result<Written> {
    let Question { places, sources, columns, options } = question;
    let threads = arguments.mesh.threads();
    let shape = [sources.len(), columns.len()];
    let fingerprint = fingerprint(solver, question, layout)?;
    let mut sink = Sink::open(&arguments.output, &layout.head(shape), &fingerprint)?;
    let before = sink.rows();
    let mut ticker = Ticker::new("rows", sources.len(), before);
    let most = (WAITING / layout.bytes_per_row(columns.len()).max(1)).min(ROWS_PER_THREAD * threads.get());
    let some = most.max(threads.get());
    while sink.rows() < sources.len() {
        let first = sink.rows();
        let some = some.min(sources.len() - first);
        let row = |number: usize, values: &[f64]| layout.row(&places[first + number], values);
        let rows =
            solver.map_rows(&sources[first..first + some], columns, (options, threads), row, &mut |_, share| {
                ticker.tell(first, some, share)
            })?;
        let kept = sink.kept();
        let appended = sink.append(&rows);
        if appended.with_context(|| format!("{first} of {} rows are finished{kept}", sources.len()))?.is_break() {
            return Ok(Written { before });
        }
    }
    ticker.end();
    sink.finish(layout, shape)?;
    Ok(Written { before })
}

/// Vertices that are places of a list.
fn vertices(places: &[Place]) -> Result<Vec<usize>> {
    let vertex = |place: &Place| {
        place.vertex().with_context(|| format!("{place} is no vertex; targets are vertices, sources are places"))
    };
    places.iter().map(vertex).collect()
}

/// Vertices spread over the surface, counted as in the file.
fn landmarks(solver: &mut DistanceSolver, count: usize) -> Result<Vec<Place>> {
    let first = solver.surface().first_vertex();
    let samples = farthest_samples(solver.exact_geometry(), first, SampleCount::Exactly(count), &mut go_on)?;
    let surface: &Surface = solver.surface();
    let number = |&vertex: &VertexId| Place::Vertex(surface.inputs_of_vertex(vertex)[0].index());
    Ok(samples.vertices.iter().map(number).collect())
}
