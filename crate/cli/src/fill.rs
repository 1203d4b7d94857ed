//! `heatwalk fill`.

use std::time::Instant;

use anyhow::{Result, ensure};
use heatwalk::go_on;
use heatwalk_volume::fill::{Estimate, FillReport, Resolution, Solid};
use serde_json::json;

use crate::args::Fill;
use crate::input::Input;
use crate::output::Output;
use crate::report::{Report, milliseconds, push_fields};
use crate::timing::build;
use crate::volume;

pub fn fill(arguments: &Fill) -> Result<String> {
    let output = arguments.output.as_deref().map(Output::fill).transpose()?;
    let resolution = match (arguments.resolution, arguments.tetrahedra) {
        (_, Some(count)) => Resolution::Tetrahedra(count),
        (cells, None) => Resolution::Cells(cells.unwrap_or_default()),
    };
    ensure!(
        volume::Input::of(&arguments.mesh).map_or(true, |inner| inner.is_none()),
        "{} holds tetrahedra already; give a closed surface to fill",
        arguments.mesh.mesh.display()
    );
    let input = Input::of(&arguments.mesh)?;
    let threads = arguments.mesh.threads();
    let (surface, mut build_ms) = build(&input, arguments.mesh.weld, threads)?;
    let start = Instant::now();
    let solid = Solid::new(&input.model.soup, &surface, threads)?;
    build_ms += milliseconds(start);
    let estimate = solid.estimate(resolution)?;
    let start = Instant::now();
    let filled = solid.fill(resolution, &mut go_on)?;
    let fill_ms = milliseconds(start);
    if let Some(output) = output {
        output.write_filled(&filled.soup)?;
    }
    if !arguments.mesh.json {
        return Ok(in_words(&filled.report));
    }
    let mut report = Report::default();
    report.push_surface(surface.report());
    input.tell(&mut report);
    push(&mut report, &filled.report, &estimate);
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "fill": fill_ms }));
    Ok(report.render(true))
}

fn push(report: &mut Report, filled: &FillReport, estimate: &Estimate) {
    report.push("estimated_tetrahedra", estimate.tetrahedra);
    report.push("tetrahedron_vertices", filled.vertices);
    push_fields!(
        report,
        filled { tetrahedra, cells, cell_side, volume, surface_volume, dihedral_angles, deviation, holes }
    );
}

fn in_words(filled: &FillReport) -> String {
    let [least, greatest] = filled.dihedral_angles;
    let volume = filled.surface_volume.map_or(String::new(), |surface| {
        let share = 100.0 * (filled.volume / surface - 1.0);
        match format!("{:.2}", share.abs()).as_str() {
            "0.00" => ", as much as the surface encloses".to_owned(),
            percent => format!(", {percent} % {} than the surface encloses", if share < 0.0 { "less" } else { "more" }),
        }
    });
    let holes = match filled.holes {
        0 => String::new(),
        1 => " A hole of the surface was closed.".to_owned(),
        holes => format!(" {holes} holes of the surface were closed."),
    };
    format!(
        "{} tetrahedra over {} vertices fill a volume of {:.6}{volume}. Their dihedral angles are between {least:.1}° and \
         {greatest:.1}°. The boundary is within {:.2} of a cell of the surface; a cell is {:.6} wide.{holes}\n",
        filled.tetrahedra,
        filled.vertices,
        filled.volume,
        filled.deviation / filled.cell_side,
        filled.cell_side
    )
}
