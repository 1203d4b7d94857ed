//! Files of curves.

use glam::DVec3;
use heatwalk::{Unit, Up};
use heatwalk_bindings::{Failure, Result};
use heatwalk_curves::{Field, Isolines, write};
use wasm_bindgen::prelude::*;

/// What lengths in a file are told in.
#[derive(Clone, Copy)]
#[wasm_bindgen]
pub struct FileUnit {
    pub(super) scale: f64,
    pub(super) unit: Option<Unit>,
}

#[wasm_bindgen]
impl FileUnit {
    /// `scale`: by what lengths are multiplied for it; its symbol may be empty.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(scale: f64, symbol: &str) -> Self {
        Self { scale, unit: unit_of(symbol) }
    }
}

/// "obj", "dxf", "csv" or "glb".
pub fn curve_file(kind: &str, curves: &Isolines, unit: Option<Unit>) -> Result<Vec<u8>> {
    Ok(match kind {
        "obj" => write::obj(curves, unit),
        "dxf" => write::dxf(curves, unit),
        "csv" => write::csv(curves, unit),
        "glb" => write::glb(curves),
        _ => return Err(Failure::misuse("there is no such file of curves")),
    })
}

/// "svg" or "pdf" of what is seen of curves on the surface of a field from far away, in this direction as it is drawn where the axis
/// `up` is drawn upward.
pub fn picture(
    kind: &str,
    (curves, field): (&Isolines, &Field),
    (toward_eye, up): (&[f64], &str),
    unit: Option<Unit>,
) -> Result<Vec<u8>> {
    let up: Up = up.parse()?;
    let toward_eye = toward_eye.try_into().map(DVec3::from_array);
    let toward_eye = toward_eye.map_err(|_| Failure::misuse("a direction is three numbers"))?;
    let view = write::View::from_direction(field, in_file(up, toward_eye), in_file(up, DVec3::Y));
    let view = view.ok_or_else(|| Failure::misuse("a direction has a length"))?;
    if kind != "pdf" {
        return Ok(write::svg(curves, field, &view, unit));
    }
    Ok(write::pdf(curves, field, &view, unit.ok_or_else(without_unit)?))
}

/// The direction in the file of what is drawn in another, where this axis is drawn upward.
pub(super) fn in_file(up: Up, drawn: DVec3) -> DVec3 {
    DVec3::from_array(DVec3::AXES.map(|axis| up.turned(axis).dot(drawn)))
}

/// A file of curves on the surface of a field, as [`curve_file`] and [`picture`] write them, with all lengths in this unit.
pub(super) fn scaled_file(
    kind: &str,
    (curves, field): (&Isolines, &Field),
    (toward_eye, up): (&[f64], &str),
    FileUnit { scale, unit }: FileUnit,
) -> Result<Vec<u8>> {
    let curves = curves.scaled(scale);
    if kind != "svg" && kind != "pdf" {
        return curve_file(kind, &curves, unit);
    }
    let positions = field.positions().iter().map(|&position| scale * position).collect();
    let field = Field::new(positions, field.triangles().to_vec(), field.distances().to_vec())?;
    picture(kind, (&curves, &field), (toward_eye, up), unit)
}

/// The unit of a symbol; none of the empty one.
pub fn unit_of(symbol: &str) -> Option<Unit> {
    Unit::ALL.into_iter().find(|unit| unit.symbol() == symbol)
}

/// A PDF is at true scale.
pub fn without_unit() -> Failure {
    Failure::misuse("a PDF needs the unit of the lengths")
}
