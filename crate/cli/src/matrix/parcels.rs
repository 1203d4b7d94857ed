//! A matrix of parcels.

use std::path::Path;
use std::time::Instant;

use anyhow::{Result, bail, ensure};
use heatwalk::{Choice, Element, InputVertex, ParcelDistance, VertexId};

use super::npy;
use crate::args::Matrix;
use crate::input::Input;
use crate::labels::{self, Between};
use crate::number::Number;
use crate::output::{MatrixFormat, Output};
use crate::progress::Ticker;
use crate::question::walkable;
use crate::report::{Report, milliseconds};
use crate::timing::prepare;

/// The distances between all parcels of a file: what is told of them, and the milliseconds of reading, building, preparation and answers.
pub fn matrix(arguments: &Matrix, file: &Path, output: &Output<MatrixFormat>) -> Result<(Report, [f64; 4])> {
    ensure!(
        arguments.max_distance.is_none(),
        "--max-distance leaves distances out, of which --parcels takes all; leave one of both out"
    );
    let options = arguments.distance_options()?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    let labels = labels::of_surface(file, soup.positions.len())?;
    let with_vertices = |&label: &usize| labels.is_parcel(label) && labels.vertices(label).next().is_some();
    let parcels: Vec<usize> = (0..labels.names.len()).filter(with_vertices).collect();
    ensure!(!parcels.is_empty(), "{}: no vertex is in a parcel", file.display());
    let names: Vec<&str> = parcels.iter().map(|&label| labels.names[label].as_str()).collect();

    let (solver, mut report, build_ms) = walkable(&input, &arguments.mesh, &arguments.solving, arguments.axis.up)?;
    let mut prepared = prepare((solver, build_ms), &options)?;
    let solver = &mut prepared.solver;
    let vertex = |input| solver.surface().vertex_of_input(InputVertex::from_index(input));
    let vertices: Vec<Vec<VertexId>> =
        parcels.iter().map(|&label| labels.vertices(label).filter_map(vertex).collect()).collect();
    let between = match arguments.between.unwrap_or_default() {
        Between::Mean => ParcelDistance::Mean,
        Between::Minimum => ParcelDistance::Minimum,
    };
    let threads = arguments.mesh.threads();
    let start = Instant::now();
    let mut ticker = Ticker::new("parcels", parcels.len(), 0);
    let distances = solver.parcel_distances(&vertices, between, (&options, threads), &mut |_, share| {
        ticker.tell(0, parcels.len(), share)
    })?;
    ticker.end();
    output.save(&match output.format {
        MatrixFormat::Npy => npy(&distances, parcels.len(), arguments.dtype),
        MatrixFormat::Csv => csv(&names, &distances, arguments.dtype),
        MatrixFormat::Npz => bail!("a matrix of parcels is not sparse; write it to an .npy or .csv file"),
    })?;
    report.push("method", options.method.name());
    report.push("parcels", names);
    report.push("vertices_of_parcels", vertices.iter().map(Vec::len).collect::<Vec<_>>());
    report.push("threads", threads.get());
    Ok((report, [input.read_ms, prepared.build_ms, prepared.precompute_ms, milliseconds(start)]))
}

fn npy(distances: &[f64], count: usize, number: Number) -> Vec<u8> {
    let mut bytes = npy::header(number.descriptor(), &format!("({count}, {count})"));
    distances.iter().for_each(|&distance| number.push(distance, &mut bytes));
    bytes
}

fn csv(names: &[&str], distances: &[f64], number: Number) -> Vec<u8> {
    let cell = |name: &str| {
        let is_plain = !name.contains([',', '"', '\n', '\r']);
        if is_plain { name.to_owned() } else { format!("\"{}\"", name.replace('"', "\"\"")) }
    };
    let head: String = names.iter().map(|name| format!(",{}", cell(name))).collect();
    let row = |(name, row): (&&str, &[f64])| {
        let numbers: String = row.iter().map(|&distance| format!(",{}", number.written(distance))).collect();
        format!("{}{numbers}\n", cell(name))
    };
    let rows: String = names.iter().zip(distances.chunks_exact(names.len())).map(row).collect();
    format!("parcel{head}\n{rows}").into_bytes()
}
