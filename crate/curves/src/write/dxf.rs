//! AutoCAD DXF of release 12 (AC1009), which every program reads: a POLYLINE a curve, a layer a value.

use std::fmt::{Display, Write as _};

use glam::DVec3;
use heatwalk_surface::Unit;

use super::unit::insertion_unit;
use crate::isolines::{Isolines, Kind};
use crate::sheet::Sheet;
use crate::strips::Strips;

/// Longest name of a layer in release 12.
const LONGEST_NAME: usize = 31;

/// Bits of a POLYLINE's flags (group code 70).
const CLOSED: u8 = 1;
const SPATIAL: u8 = 8;
/// Flag of a VERTEX of a polyline in space.
const SPATIAL_VERTEX: u8 = 32;

/// Curves in space, one layer an isoline: `ISOLINE_2_0_5` is the third one, at 0.5; `GIRTH` that of a girth, `LOOP_1` that of a loop, `BORDER_0_4`
/// that between these two cells.
pub fn dxf(isolines: &Isolines, unit: Option<Unit>) -> Vec<u8> {
    let layer = |(index, value): (usize, f64)| match isolines.kind {
        Kind::Isolines => name(&format!("ISOLINE_{index}"), value),
        Kind::Girth | Kind::Paths(_) | Kind::Borders(_) => isolines.name(index).to_uppercase(),
    };
    let layers: Vec<String> = isolines.isolines.iter().map(|isoline| isoline.value).enumerate().map(layer).collect();
    let mut file = File::begin(&layers, unit);
    for (isoline, layer) in isolines.isolines.iter().zip(&layers) {
        for curve in &isoline.curves {
            file.polyline(layer, curve.points.iter().copied(), curve.is_closed, SPATIAL);
        }
    }
    file.end()
}

/// Plane shapes as closed polylines, one layer a strip: `STRIP_2_0_5` is the third one, which begins at 0.5.
pub fn sheet_dxf(sheet: &Sheet, strips: &Strips, unit: Option<Unit>) -> Vec<u8> {
    let layer = |strip: usize| name(&format!("STRIP_{strip}"), strips.bounds(strip)[0].unwrap_or(0.0));
    let layers: Vec<String> = (0..strips.ranges.len()).map(layer).collect();
    let mut file = File::begin(&layers, unit);
    for plane in &sheet.planes {
        for points in &plane.loops {
            file.polyline(&layers[plane.strip], points.iter().map(|point| point.extend(0.0)), true, 0);
        }
    }
    file.end()
}

/// A name in letters, digits, `-` and `_`, as layers must have.
fn name(begin: &str, value: f64) -> String {
    let value = format!("{value}").replace('.', "_");
    let mut name = format!("{begin}_{value}");
    name.truncate(LONGEST_NAME);
    name
}

/// A file that grows: lines in pairs, a group code and a value.
struct File(String);

impl File {
    fn begin(layers: &[String], unit: Option<Unit>) -> Self {
        let mut file = Self(String::new());
        file.pairs(&[(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009")]);
        if let Some(unit) = unit {
            // Newer than this release, whose readers pass over variables that they do not know.
            file.pairs(&[(9, "$INSUNITS")]);
            file.pair(70, insertion_unit(unit));
        }
        file.pairs(&[(0, "ENDSEC")]);
        file.pairs(&[(0, "SECTION"), (2, "TABLES"), (0, "TABLE"), (2, "LAYER")]);
        file.pair(70, layers.len());
        for (index, layer) in layers.iter().enumerate() {
            file.pairs(&[(0, "LAYER"), (2, layer), (70, "0")]);
            // Red to magenta of the color index, in turn; 7, black or white, is left to what has no color.
            file.pair(62, index % 6 + 1);
            file.pair(6, "CONTINUOUS");
        }
        file.pairs(&[(0, "ENDTAB"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]);
        file
    }

    fn polyline(&mut self, layer: &str, points: impl Iterator<Item = DVec3>, is_closed: bool, flags: u8) {
        self.pairs(&[(0, "POLYLINE"), (8, layer), (66, "1"), (10, "0.0"), (20, "0.0"), (30, "0.0")]);
        self.pair(70, flags | if is_closed { CLOSED } else { 0 });
        for point in points {
            self.pairs(&[(0, "VERTEX"), (8, layer)]);
            for (code, coordinate) in [(10, point.x), (20, point.y), (30, point.z)] {
                // Always with a decimal point or an exponent, by which readers know a real number.
                self.pair(code, format_args!("{coordinate:?}"));
            }
            if flags & SPATIAL != 0 {
                self.pair(70, SPATIAL_VERTEX);
            }
        }
        self.pairs(&[(0, "SEQEND"), (8, layer)]);
    }

    fn end(mut self) -> Vec<u8> {
        self.pairs(&[(0, "ENDSEC"), (0, "EOF")]);
        self.0.into_bytes()
    }

    fn pairs(&mut self, pairs: &[(u16, &str)]) {
        pairs.iter().for_each(|(code, value)| self.pair(*code, value));
    }

    fn pair(&mut self, code: u16, value: impl Display) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.0, "{code:>3}\n{value}");
    }
}
