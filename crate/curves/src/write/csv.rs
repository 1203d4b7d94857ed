//! Points of isolines as a table.

use std::fmt::Write as _;

use heatwalk_surface::Unit;

use super::unit::column;
use crate::isolines::{Isolines, Kind};

/// CSV with a row a point: the curve, counted from 0 over all isolines, its value, or the cells that it is between, 1 where it is
/// closed and 0 elsewhere, and the position, value and position in the unit that the head says. Numbers have 17 significant digits,
/// which give every double back.
pub fn csv(isolines: &Isolines, unit: Option<Unit>) -> Vec<u8> {
    let of = |index: usize| match &isolines.kind {
        Kind::Borders(cells) => format!("{},{}", cells[index][0], cells[index][1]),
        Kind::Isolines | Kind::Girth | Kind::Paths(_) => format!("{:.16e}", isolines.isolines[index].value),
    };
    let told = if matches!(isolines.kind, Kind::Borders(_)) { "cell,other".to_owned() } else { column("value", unit) };
    let mut text = format!("curve,{told},closed,{}\n", ["x", "y", "z"].map(|axis| column(axis, unit)).join(","));
    let curves = isolines.isolines.iter().enumerate();
    let curves = curves.flat_map(|(index, isoline)| isoline.curves.iter().map(move |curve| (index, curve)));
    for (number, (index, curve)) in curves.enumerate() {
        let (told, is_closed) = (of(index), u8::from(curve.is_closed));
        for point in &curve.points {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{number},{told},{is_closed},{:.16e},{:.16e},{:.16e}", point.x, point.y, point.z);
        }
    }
    text.into_bytes()
}
