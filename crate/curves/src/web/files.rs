//! Files of curves.

use glam::DVec3;
use heatwalk::{Unit, Up};
use heatwalk_bindings::{Failure, Result};

use crate::field::Field;
use crate::isolines::Isolines;
use crate::write;

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
    // What is drawn like this, in the file.
    let in_file = |drawn: DVec3| DVec3::from_array(DVec3::AXES.map(|axis| up.turned(axis).dot(drawn)));
    let view = write::View::from_direction(field, in_file(toward_eye), in_file(DVec3::Y));
    let view = view.ok_or_else(|| Failure::misuse("a direction has a length"))?;
    if kind != "pdf" {
        return Ok(write::svg(curves, field, &view, unit));
    }
    Ok(write::pdf(curves, field, &view, unit.ok_or_else(without_unit)?))
}

/// The unit of a symbol; none of the empty one.
pub fn unit_of(symbol: &str) -> Option<Unit> {
    Unit::ALL.into_iter().find(|unit| unit.symbol() == symbol)
}

/// A PDF is at true scale.
pub fn without_unit() -> Failure {
    Failure::misuse("a PDF needs the unit of the lengths")
}
