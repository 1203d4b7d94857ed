//! `heatwalk info` and `path` on tetrahedra.

use std::sync::Arc;
use std::time::Instant;

use anyhow::{Result, bail};
use heatwalk::MultiSource;
use heatwalk::go_on;
use heatwalk_volume::{MeshReport, TetMesh, VolumeOptions, VolumeSolver};
use serde_json::json;

use super::input::{Input, point, refuse, refuse_bridging, volume_options};
use crate::args::{Info, Path};
use crate::output::Output;
use crate::report::{Report, milliseconds, push_fields};

pub fn info(arguments: &Info, input: &Input) -> Result<String> {
    refuse_bridging(&arguments.bridging)?;
    let (mesh, build_ms) = build(input)?;
    let report = mesh.report();
    let mut said = Report::default();
    push_mesh(&mut said, report);
    let quality = mesh.quality();
    said.push("volume", report.volume);
    said.push("least_dihedral_angle", quality.least_angle);
    said.push("largest_dihedral_angle", quality.largest_angle);
    said.push("mean_least_dihedral_angle", quality.mean_least_angle);
    said.push("boundary_faces", report.boundary_faces);
    said.push("mean_edge", mesh.mean_edge());
    said.push("unreferenced_vertices", report.unreferenced_vertices);
    said.push("split_hexahedra", input.cells.hexahedra);
    said.push("split_prisms", input.cells.prisms);
    said.push("split_pyramids", input.cells.pyramids);
    said.push("curved_cells", input.cells.curved);
    push_fields!(said, report { flat_tetrahedra, duplicate_tetrahedra, inverted_tetrahedra });
    said.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms }));
    Ok(said.render(arguments.mesh.json))
}

pub fn path(arguments: &Path, input: &Input) -> Result<String> {
    let solving = &arguments.solving;
    refuse(&[("--exact", arguments.exact), ("--bezier", arguments.bezier)])?;
    let options = volume_options(solving, solving.heat_option(), MultiSource::default())?;
    if arguments.straighten {
        bail!("--straighten has no effect inside of tetrahedra, where paths are as short as they get");
    }
    let output = arguments.output.as_deref().map(Output::path).transpose()?;
    let (mesh, build_ms) = build(input)?;
    let places = arguments.places().map(|&place| point(place, &input.soup, &mesh)).collect::<Result<Vec<_>>>()?;
    let mut said = Report::default();
    push_mesh(&mut said, mesh.report());
    let costs = solving.ground.inside(&input.soup, &mesh)?;
    let (mut solver, precompute_ms) = prepare(&mesh, costs.as_deref(), &options)?;
    let (mut points, mut method) = (Vec::new(), "");
    let [mut distance, mut length, mut cost, mut solve_ms, mut path_ms] = [0.0; 5];
    for ends in places.windows(2) {
        let start = Instant::now();
        let answer = solver.distance(&ends[1..], &options)?;
        solve_ms += milliseconds(start);
        let start = Instant::now();
        let leg = solver.path(&answer, ends[0])?;
        path_ms += milliseconds(start);
        method = answer.method.name();
        distance += solver.at(&answer, ends[0])?;
        length += leg.length;
        cost += leg.cost;
        points.extend(leg.points);
    }
    // Each leg begins where the one before ends.
    points.dedup();
    if let Some(output) = output {
        output.write(points.iter().copied(), arguments.axis.up)?;
    }
    said.push("method", method);
    said.push("factor_nonzeros", solver.factor_nonzeros());
    said.push("distance", distance);
    said.push("length", length);
    if costs.is_some() {
        said.push("cost", cost);
    }
    said.push("points", points.iter().map(|point| json!(point.to_array())).collect::<Vec<_>>());
    said.push(
        "timings_ms",
        json!({
            "read": input.read_ms, "build": build_ms, "precompute": precompute_ms, "solve": solve_ms, "path": path_ms
        }),
    );
    Ok(said.render(arguments.mesh.json))
}

pub fn build(input: &Input) -> Result<(Arc<TetMesh>, f64)> {
    let start = Instant::now();
    let mesh = TetMesh::build(&input.soup)?;
    Ok((Arc::new(mesh), milliseconds(start)))
}

/// The solver with all that it needs, and what that took in milliseconds.
pub fn prepare(mesh: &Arc<TetMesh>, costs: Option<&[f64]>, options: &VolumeOptions) -> Result<(VolumeSolver, f64)> {
    let start = Instant::now();
    let mut solver = match costs {
        Some(costs) => VolumeSolver::with_costs(Arc::clone(mesh), costs)?,
        None => VolumeSolver::new(Arc::clone(mesh)),
    };
    solver.prepare(options, &mut go_on)?;
    Ok((solver, milliseconds(start)))
}

/// The counts that every command gives.
pub fn push_mesh(said: &mut Report, report: &MeshReport) {
    said.push("vertices", report.input_vertices);
    said.push("tetrahedra", report.tetrahedra);
    said.push("components", report.components);
}
