//! Curves as they are seen, and plane shapes, as Scalable Vector Graphics 1.1. Where the unit is known, user units are millimeters.

use std::fmt::Write as _;

use glam::DVec2;
use heatwalk_surface::Unit;

use crate::field::Field;
use crate::isolines::Isolines;
use crate::sheet::Sheet;
use crate::strips::Strips;
use crate::write::unit::millimeters;
use crate::write::view::{PIXELS, View, seen};

/// Share of a picture's smaller side that lines are wide.
const LINE_WIDTH: f64 = 0.0015;

// Writing to a String cannot fail.

/// What is seen of isolines on the outside of the surface, a group each: parts that are behind others are left out. At true scale
/// where there is one.
pub fn svg(isolines: &Isolines, field: &Field, view: &View, unit: Option<Unit>) -> Vec<u8> {
    let scale = unit.map(|unit| millimeters(unit) * view.pixel);
    let factor = scale.unwrap_or(1.0);
    // To a thousandth of a pixel.
    let digits = 3 + (-factor.log10()).ceil().max(0.0) as usize;
    let mut text = String::new();
    for (index, curves) in seen(isolines, field, view).enumerate() {
        let _ = writeln!(text, "<g id=\"{}\">", isolines.name(index));
        for lines in curves.iter().filter(|lines| !lines.is_empty()) {
            text.push_str("<path d=\"");
            for line in lines {
                for (index, point) in line.iter().enumerate() {
                    let [x, y] = (factor * *point).to_array();
                    let _ = write!(text, "{}{x:.digits$} {y:.digits$}", if index == 0 { 'M' } else { 'L' });
                }
            }
            text.push_str("\"/>\n");
        }
        text.push_str("</g>\n");
    }
    document(&text, view.size, scale, "")
}

/// Plane shapes, a group a strip, at true scale where the unit of the field is known.
pub fn sheet_svg(sheet: &Sheet, strips: &Strips, unit: Option<Unit>) -> Vec<u8> {
    let scale = unit.map(millimeters);
    let factor = scale.unwrap_or(1.0);
    let mut text = String::new();
    for plane in &sheet.planes {
        let _ = write!(text, "<path class=\"{}\" d=\"", strips.name(plane.strip));
        for points in &plane.loops {
            let mut letter = 'M';
            for point in points {
                let _ = write!(text, "{letter}{} {}", factor * point.x, factor * (sheet.size.y - point.y));
                letter = 'L';
            }
            text.push('Z');
        }
        text.push_str("\"/>\n");
    }
    document(&text, sheet.size, scale, " fill-rule=\"evenodd\"")
}

/// `scale`: millimeters of a unit of `size`, in which the content is then; without, the picture has 1000 pixels along its longer side.
fn document(content: &str, size: DVec2, scale: Option<f64>, attributes: &str) -> Vec<u8> {
    let (user, drawn, suffix) = match scale {
        Some(scale) => (size * scale, size * scale, "mm"),
        None => (size, size * (PIXELS / size.max_element()), ""),
    };
    let width = LINE_WIDTH * user.min_element();
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{2}{suffix}\" height=\"{3}{suffix}\" viewBox=\"0 0 {0} {1}\">\n\
         <g fill=\"none\" stroke=\"black\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{attributes}>\n\
         {content}</g>\n</svg>\n",
        user.x, user.y, drawn.x, drawn.y
    )
    .into_bytes()
}
