//! `heatwalk cells`.

use std::time::Instant;

use anyhow::{Result, bail};
use glam::DVec3;
use heatwalk::{Cells as Found, FaceId, Surface, Unit, Up, VertexData, cell_map, cells as found, go_on};
use heatwalk_curves::{Borders, Field, Isolines, write};
use serde_json::json;

use crate::args::Cells;
use crate::input::Input;
use crate::lists::with_listed;
use crate::locate::Locator;
use crate::output::{CurveFormat, Output};
use crate::question::joined;
use crate::report::milliseconds;
use crate::volume;

/// What is nearest to each source, and where others become nearer.
pub fn cells(arguments: &Cells) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "cells are of a surface, not of the inside")?;
    let output = arguments.output.as_deref().map(|path| Output::of_vertices(path, "cells")).transpose()?;
    let borders = arguments.borders.as_deref().map(Output::borders).transpose()?;
    let places = with_listed(&arguments.sources, &arguments.source_files, "source")?;
    let input = Input::of(&arguments.mesh)?;
    let soup = &input.model.soup;
    places.iter().try_for_each(|source| source.place.check(soup))?;
    let (mut solver, mut report, build_ms) = joined(&input, &arguments.mesh, &arguments.bridging)?;
    let locator = Locator::new(soup, solver.surface());
    let sources = places.iter().map(|source| locator.source(source)).collect::<Result<Vec<_>>>()?;
    locator.tell(&mut report);
    let start = Instant::now();
    let geometry = solver.exact_geometry();
    let surface = geometry.surface();
    let has_borders = arguments.areas || borders.is_some();
    let (cells, map) = if has_borders {
        let map = cell_map(geometry, &sources, &mut go_on)?;
        (map.cells.clone(), Some(map))
    } else {
        (found(geometry, &sources, &mut go_on)?, None)
    };
    let cells_ms = milliseconds(start);

    let mut borders_ms = 0.0;
    if let Some(map) = map {
        let start = Instant::now();
        let field = field(surface, &cells, arguments.axis.up)?;
        let nearest: Vec<Option<u32>> = cells.nearest.iter().copied().collect();
        let starts: Vec<u32> =
            sources.iter().flat_map(|source| source.place().faces(surface)).map(|face| face.0).collect();
        let traced =
            Borders::trace(&field, (&nearest, sources.len()), &starts, |face, weights| map.at(FaceId(face), weights))?;
        borders_ms = milliseconds(start);
        let length = traced.curves.isolines.iter().fold(0.0, |sum, border| sum + border.length);
        report.push("border_length", length);
        report.push("areas", traced.areas);
        if let Some(output) = borders {
            output.save(&bytes(output.format, &traced.curves, &field, input.unit.unit, arguments.view)?)?;
        }
    }
    let numbers: VertexData<f64> = cells.nearest.iter().map(|&cell| cell.map_or(f64::NAN, f64::from)).collect();
    let numbers = surface.to_inputs(&numbers, f64::NAN);
    let values = surface.to_inputs(&cells.distances, f64::INFINITY);
    let of_cell = |cell: usize| numbers.iter().filter(|&&number| number == cell as f64).count();
    let reached = values.iter().copied().filter(|distance| distance.is_finite());
    report.push("cells", sources.len());
    report.push("vertices_of_cells", (0..sources.len()).map(of_cell).collect::<Vec<_>>());
    report.push("covering_radius", reached.fold(0.0, f64::max));
    report.push("unreachable", values.iter().filter(|distance| distance.is_infinite()).count());
    if let Some(output) = output {
        output.write_cells(&numbers, &values)?;
    }
    report.push(
        "timings_ms",
        json!({ "read": input.read_ms, "build": build_ms, "cells": cells_ms, "borders": borders_ms }),
    );
    Ok(report.render(arguments.mesh.json))
}

/// The surface as it is written, with the distances.
fn field(surface: &Surface, cells: &Found, up: Up) -> Result<Field> {
    let positions = surface.positions().iter().map(|&position| up.turned(position)).collect();
    let triangles = surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect();
    Ok(Field::new(positions, triangles, cells.distances.iter().copied().collect())?)
}

fn bytes(format: CurveFormat, curves: &Isolines, field: &Field, unit: Option<Unit>, toward: DVec3) -> Result<Vec<u8>> {
    Ok(match format {
        CurveFormat::Dxf => write::dxf(curves, unit),
        CurveFormat::Csv => write::csv(curves, unit),
        CurveFormat::Svg => match write::View::from_direction(field, toward, DVec3::Y) {
            Some(view) => write::svg(curves, field, &view, unit),
            None => bail!("there is nothing to see from {toward}"),
        },
        _ => write::obj(curves, unit),
    })
}
