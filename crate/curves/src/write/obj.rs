//! Wavefront OBJ ("Object Files (.obj)", Alias|Wavefront, appendix B1): elements `l`, `f` and groups `g`.

use std::fmt::Write as _;

use heatwalk_surface::Unit;

use super::unit::comment;
use crate::isolines::{Isolines, Kind, PathKind};
use crate::strips::Strips;

// Writing to a String cannot fail.

/// A group an isoline, or one of the girth, a line a curve; a closed one returns to its first point.
pub fn obj(isolines: &Isolines, unit: Option<Unit>) -> Vec<u8> {
    let title = match isolines.kind {
        Kind::Isolines => "isolines of a distance",
        Kind::Girth => "girth of a surface",
        Kind::Paths(PathKind::HandleLoops) => "loops around the handles of a surface",
        Kind::Paths(PathKind::Loop) => "loop through places of a surface",
        Kind::Paths(PathKind::Bezier) => "Bézier curve on a surface",
        Kind::Borders(_) => "borders of cells",
    };
    let mut text = format!("# {title} by Heatwalk\n{}", comment("#", unit));
    let mut first = 1;
    for (index, isoline) in isolines.isolines.iter().enumerate() {
        let _ = writeln!(text, "g {}", isolines.name(index));
        for curve in &isoline.curves {
            for point in &curve.points {
                let _ = writeln!(text, "v {} {} {}", point.x, point.y, point.z);
            }
            let end = first + curve.points.len();
            text.push('l');
            for index in (first..end).chain(curve.is_closed.then_some(first)) {
                let _ = write!(text, " {index}");
            }
            text.push('\n');
            first = end;
        }
    }
    text.into_bytes()
}

/// A group a strip, with its triangles; vertices on isolines belong to the strips on both sides.
pub fn strips_obj(strips: &Strips, unit: Option<Unit>) -> Vec<u8> {
    let mut text = format!("# strips between isolines by Heatwalk\n{}", comment("#", unit));
    for point in &strips.positions {
        let _ = writeln!(text, "v {} {} {}", point.x, point.y, point.z);
    }
    for (strip, range) in strips.ranges.iter().enumerate().filter(|(_, range)| !range.is_empty()) {
        let _ = writeln!(text, "g {}", strips.name(strip));
        for [a, b, c] in &strips.triangles[range.clone()] {
            let _ = writeln!(text, "f {} {} {}", u64::from(*a) + 1, u64::from(*b) + 1, u64::from(*c) + 1);
        }
    }
    text.into_bytes()
}
