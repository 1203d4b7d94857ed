//! `heatwalk isolines`.

use std::time::Instant;

use anyhow::{Result, bail};
use glam::DVec3;
use heatwalk::{Answer, Error, FaceId, Place, Surface, Unit, VertexData, go_on};
use heatwalk_curves::{
    Field, Isolines, Levels, MOST_ROUNDS, Places, Refined, Sheet, Strips, TRUE_TO, is_continuous, write,
};
use serde_json::json;

use crate::args;
use crate::curve::Found;
use crate::distance::facts;
use crate::locate::Locator;
use crate::output::{CurveFormat, Output, SheetFormat};
use crate::question::{Posed, pose};
use crate::report::milliseconds;
use crate::volume;

pub fn isolines(arguments: &args::Isolines) -> Result<String> {
    let question = &arguments.question;
    if volume::Input::of(&question.mesh)?.is_some() {
        bail!("isolines are curves on a surface, and {} holds tetrahedra", question.mesh.mesh.display());
    }
    let options = question.distance_options()?;
    let output = arguments.output.as_deref();
    let output = output.map(|path| Output::curves(path, arguments.strips, arguments.unroll)).transpose()?;
    let Posed { input, sources, mut prepared, mut report } = pose(question, arguments.axis.up, &options)?;
    let (asked, facts_told, solve_ms) = if question.curves.are_given() {
        let locator = Locator::new(&input.model.soup, prepared.solver.surface());
        let found = question.curves.distances(&locator, &mut prepared.solver, question.closed)?;
        locator.tell(&mut report);
        let values = prepared.solver.surface().to_inputs(&found.values, f64::INFINITY);
        let told = found.facts(&values);
        let solve_ms = found.solve_ms;
        (Asked::Curves(found), told, solve_ms)
    } else {
        let start = Instant::now();
        let answer = prepared.solver.distance(&sources, &options, &mut go_on)?;
        let solve_ms = milliseconds(start);
        let told = facts(&answer, &prepared.solver.of_inputs(&answer), &options);
        (Asked::Sources(answer), told, solve_ms)
    };

    let start = Instant::now();
    let surface = prepared.solver.surface();
    let positions = surface.positions().iter().map(|&position| arguments.axis.up.turned(position)).collect();
    let faces: Vec<FaceId> = surface.faces().ids().filter(|&face| asked.is_continuous_on(surface, face)).collect();
    let triangles = faces.iter().map(|&face| surface.faces()[face].map(|vertex| vertex.0)).collect();
    let field = Field::new(positions, triangles, asked.values().iter().copied().collect())?;
    let levels = match (arguments.spacing, arguments.count) {
        (Some(spacing), _) => Levels::spaced(spacing, field.largest())?,
        (_, Some(count)) => Levels::counted(count, field.largest())?,
        (None, None) => Levels::at(&arguments.values)?,
    };
    let of_surface = |places: &Places| -> Vec<Place> {
        let place = |(&triangle, &weights): (&u32, &[f64; 3])| Place::Face { face: faces[triangle as usize], weights };
        places.triangles.iter().zip(&places.weights).map(place).collect()
    };
    let refined = match &asked {
        Asked::Curves(found) => {
            Some(field.refined(&levels, MOST_ROUNDS, |places| found.at(&of_surface(places)).map(Some)))
        }
        Asked::Sources(answer) => match prepared.solver.place_distances(answer) {
            Ok(distances) => distances.map(|distances| {
                field.refined(&levels, MOST_ROUNDS, |places| distances.at_all(&of_surface(places)).map(Some))
            }),
            Err(Error::NotExact) => None,
            Err(error) => return Err(error.into()),
        },
    };
    let Refined { field, is_true } = refined.transpose()?.unwrap_or(Refined { field, is_true: false });
    let isolines = Isolines::trace(&field, &levels);
    let isolines_ms = milliseconds(start);
    if let Some(output) = output {
        let (bytes, left_out) = bytes(output.format, &isolines, &field, &levels, input.unit.unit, arguments)?;
        output.save(&bytes)?;
        if arguments.unroll {
            report.push("left_out", left_out);
        }
    }

    report.extend(facts_told);
    let exact = format!("exact to about {TRUE_TO} of the length");
    report.push("curves", if is_true { exact } else { "chords of triangles".to_owned() });
    if !question.mesh.json {
        report.push("isolines", isolines.isolines.len());
    }
    let isoline = |isoline: &heatwalk_curves::Isoline| {
        json!({
            "value": isoline.value,
            "length": isoline.length,
            "enclosed_area": isoline.enclosed_area,
            "curves": isoline.curves.len(),
            "closed": isoline.curves.iter().filter(|curve| curve.is_closed).count(),
        })
    };
    if question.mesh.json {
        report.push("isolines", isolines.isolines.iter().map(isoline).collect::<Vec<_>>());
    }
    report.push(
        "timings_ms",
        json!({
            "read": input.read_ms, "build": prepared.build_ms, "precompute": prepared.precompute_ms, "solve": solve_ms,
            "isolines": isolines_ms
        }),
    );
    let table = if question.mesh.json { String::new() } else { in_lines(&isolines) };
    Ok(report.render(question.mesh.json) + &table)
}

/// What isolines are of.
enum Asked {
    Sources(Answer),
    Curves(Found),
}

impl Asked {
    fn values(&self) -> &VertexData<f64> {
        match self {
            Self::Sources(answer) => &answer.distance.values,
            Self::Curves(found) => &found.values,
        }
    }

    /// Whether distance does not jump from positive to negative on a face, as it does beyond the ends of curves with a sign.
    fn is_continuous_on(&self, surface: &Surface, face: FaceId) -> bool {
        let Self::Curves(Found { values, .. }) = self else { return true };
        is_continuous(surface.corners(face), surface.faces()[face].map(|vertex| values[vertex]))
    }
}

/// The file, and the strips that are left out of it since they are curved.
fn bytes(
    format: CurveFormat,
    isolines: &Isolines,
    field: &Field,
    levels: &Levels,
    unit: Option<Unit>,
    arguments: &args::Isolines,
) -> Result<(Vec<u8>, Vec<String>)> {
    let view = || match write::View::from_direction(field, arguments.view, DVec3::Y) {
        Some(view) => Ok(view),
        None => bail!("there is nothing to see from {}", arguments.view),
    };
    let known = || match unit {
        Some(unit) => Ok(unit),
        None => bail!("a PDF is at true scale, and nothing says what unit the lengths have; choose one by --unit"),
    };
    let mut left_out = Vec::new();
    let bytes = match format {
        CurveFormat::Obj => write::obj(isolines, unit),
        CurveFormat::Dxf => write::dxf(isolines, unit),
        CurveFormat::Csv => write::csv(isolines, unit),
        CurveFormat::Glb => write::glb(isolines),
        CurveFormat::Svg => write::svg(isolines, field, &view()?, unit),
        CurveFormat::Pdf => write::pdf(isolines, field, &view()?, known()?),
        CurveFormat::StripsObj => write::strips_obj(&Strips::cut(field, levels)?, unit),
        CurveFormat::Unrolled(format) => {
            let strips = Strips::cut(field, levels)?;
            let sheet = Sheet::unroll(field, &strips)?;
            left_out = sheet.strips_left_out().into_iter().map(|strip| strips.name(strip)).collect();
            match format {
                SheetFormat::Svg => write::sheet_svg(&sheet, &strips, unit),
                SheetFormat::Dxf => write::sheet_dxf(&sheet, &strips, unit),
                SheetFormat::Pdf => write::sheet_pdf(&sheet, known()?),
            }
        }
    };
    Ok((bytes, left_out))
}

/// A line an isoline.
fn in_lines(isolines: &Isolines) -> String {
    let line = |isoline: &heatwalk_curves::Isoline| {
        let closed = isoline.curves.iter().filter(|curve| curve.is_closed).count();
        format!(
            "at {:<19} length {}, encloses {}; {} curves, {closed} closed\n",
            isoline.value,
            isoline.length,
            isoline.enclosed_area,
            isoline.curves.len()
        )
    };
    isolines.isolines.iter().map(line).collect()
}
