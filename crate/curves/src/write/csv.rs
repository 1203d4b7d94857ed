//! Points of isolines as a table.

use std::fmt::Write as _;

use crate::isolines::Isolines;

/// CSV with a row a point: the curve, counted from 0 over all isolines, its value, 1 where it is closed and 0 elsewhere, and
/// the position. Numbers have 17 significant digits, which give every double back.
pub fn csv(isolines: &Isolines) -> Vec<u8> {
    let mut text = String::from("curve,value,closed,x,y,z\n");
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
