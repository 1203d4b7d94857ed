//! What formats say about the unit of their lengths.

use heatwalk_surface::Unit;

/// How long the unit is in millimeters, in which SVG has physical sizes.
pub fn millimeters(unit: Unit) -> f64 {
    match unit {
        Unit::Micrometer => 1e-3,
        Unit::Millimeter => 1.0,
        Unit::Centimeter => 10.0,
        Unit::Inch => 25.4,
        Unit::Foot => 304.8,
        Unit::Meter => 1e3,
        Unit::Kilometer => 1e6,
    }
}

/// The value of `$INSUNITS` in a DXF file.
pub fn insertion_unit(unit: Unit) -> u8 {
    match unit {
        Unit::Inch => 1,
        Unit::Foot => 2,
        Unit::Millimeter => 4,
        Unit::Centimeter => 5,
        Unit::Meter => 6,
        Unit::Kilometer => 7,
        Unit::Micrometer => 13,
    }
}

/// The head of a column of lengths.
pub fn column(name: &str, unit: Option<Unit>) -> String {
    unit.map_or_else(|| name.to_owned(), |unit| format!("{name} ({})", unit.symbol()))
}

/// A line of a comment; none without a unit.
pub fn comment(begin: &str, unit: Option<Unit>) -> String {
    unit.map_or_else(String::new, |unit| format!("{begin} lengths in {}\n", unit.symbol()))
}

/// The same in the head of a PLY file.
pub fn with_ply_comment(mut file: Vec<u8>, unit: Option<Unit>) -> Vec<u8> {
    let lines = file.iter().enumerate().filter(|(_, byte)| **byte == b'\n');
    // After the lines "ply" and "format".
    if let Some((end, _)) = lines.take(2).last() {
        file.splice(end + 1..end + 1, comment("comment", unit).into_bytes());
    }
    file
}
