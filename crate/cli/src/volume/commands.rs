//! `heatwalk info` and `path` on tetrahedra.

use std::sync::Arc;
use std::time::Instant;

use anyhow::{Result, bail};
use glam::DVec3;
use heatwalk::MultiSource;
use heatwalk::go_on;
use heatwalk_volume::{MeshReport, TetMesh, TetPoint, VolumeOptions, VolumeSolver};
use serde_json::{Value, json};

use super::input::{Input, point, refuse, refuse_bridging, volume_options};
use crate::args::{Info, Path};
use crate::output::Output;
use crate::place::Place;
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
    let inside = |route: Vec<Place>| route.into_iter().map(|place| point(place, &input.soup, &mesh)).collect();
    let routes = arguments.routes().map(inside).collect::<Result<Vec<Vec<TetPoint>>>>()?;
    let mut said = Report::default();
    push_mesh(&mut said, mesh.report());
    let costs = solving.ground.inside(&input.soup, &mesh)?;
    let (mut solver, precompute_ms) = prepare(&mesh, costs.as_deref(), &options)?;
    let found = routes.iter().map(|places| Found::along(&mut solver, places, &options)).collect::<Result<Vec<_>>>()?;
    if let Some(output) = output {
        let lines: Vec<_> = found.iter().map(|found| found.points.clone()).collect();
        output.write_several(&lines, "path", arguments.axis.up)?;
    }
    said.push("factor_nonzeros", solver.factor_nonzeros());
    said.push_paths(&arguments.to, found.iter().map(|found| found.facts(costs.is_some())).collect());
    let sum = |time: fn(&Found) -> f64| found.iter().map(time).sum::<f64>();
    said.push(
        "timings_ms",
        json!({
            "read": input.read_ms, "build": build_ms, "precompute": precompute_ms,
            "solve": sum(|found| found.solve_ms), "path": sum(|found| found.path_ms)
        }),
    );
    Ok(said.render(arguments.mesh.json))
}

/// A path through places, and what it took in milliseconds.
#[derive(Default)]
struct Found {
    points: Vec<DVec3>,
    method: &'static str,
    distance: f64,
    length: f64,
    cost: f64,
    solve_ms: f64,
    path_ms: f64,
}

impl Found {
    fn along(solver: &mut VolumeSolver, places: &[TetPoint], options: &VolumeOptions) -> Result<Self> {
        let mut found = Self::default();
        for ends in places.windows(2) {
            let start = Instant::now();
            let answer = solver.distance(&ends[1..], options)?;
            found.solve_ms += milliseconds(start);
            let start = Instant::now();
            let leg = solver.path(&answer, ends[0])?;
            found.path_ms += milliseconds(start);
            found.method = answer.method.name();
            found.distance += solver.at(&answer, ends[0])?;
            found.length += leg.length;
            found.cost += leg.cost;
            found.points.extend(leg.points);
        }
        // Each leg begins where the one before ends.
        found.points.dedup();
        Ok(found)
    }

    /// What is to be told; `has_cost`: whether the ground has costs.
    fn facts(&self, has_cost: bool) -> Vec<(&'static str, Value)> {
        let mut facts =
            vec![("method", json!(self.method)), ("distance", json!(self.distance)), ("length", json!(self.length))];
        facts.extend(has_cost.then(|| ("cost", json!(self.cost))));
        facts.push(("points", self.points.iter().map(|point| json!(point.to_array())).collect()));
        facts
    }
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
