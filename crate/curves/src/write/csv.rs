//! Points of isolines as a table.

use std::fmt::Write as _;

use heatwalk_surface::Unit;

use super::unit::column;
use crate::isolines::Isolines;

/// CSV with a row a point: the curve, counted from 0 over all isolines, its value, 1 where it is closed and 0 elsewhere, and
/// the position, the last two in the unit that the head says. Numbers have 17 significant digits, which give every double back.
pub fn csv(isolines: &Isolines, unit: Option<Unit>) -> Vec<u8> {
    let mut text = format!(
        "curve,{},closed,{}\n",
        column("value", unit),
        ["x", "y", "z"].map(|axis| column(axis, unit)).join(",")
    );
    let curves = isolines.isolines.iter().flat_map(|isoline| isoline.curves.iter().map(|curve| (isoline.value, curve)));
    for (index, (value, curve)) in curves.enumerate() {
        let is_closed = u8::from(curve.is_closed);
        for point in &curve.points {
            // Writing to a String cannot fail.
            let _ =
                writeln!(text, "{index},{value:.16e},{is_closed},{:.16e},{:.16e},{:.16e}", point.x, point.y, point.z);
        }
    }
    text.into_bytes()
}
