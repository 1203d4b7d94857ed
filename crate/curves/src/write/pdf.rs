//! Drawings at true scale as PDF 1.4 (ISO 32000-1): a page as large as the drawing, with its scale and a ruler of 100 mm below it.

use std::fmt::Write as _;

use glam::DVec2;
use heatwalk_surface::Unit;

use crate::field::Field;
use crate::isolines::Isolines;
use crate::sheet::Sheet;
use crate::write::unit::millimeters;
use crate::write::view::{View, seen};

/// Points of a millimeter.
const POINTS: f64 = 72.0 / 25.4;
/// The longest side of a page, in millimeters: 14,400 points (annex C.2).
const LONGEST: f64 = 5080.0;
/// Around the drawing, and below it for the ruler.
const MARGIN: f64 = 10.0;
const FOOT: f64 = 16.0;
/// The ruler, its steps, and the height of its ticks: at steps, and at its ends and its middle.
const RULER: u32 = 100;
const STEP: u32 = 10;
const TICKS: [f64; 2] = [2.0, 4.0];
/// Of lines, and of letters.
const LINE_WIDTH: f64 = 0.2;
const LETTERS: f64 = 4.0;

/// Lines that are drawn one by one, in units of the drawing, Y down; and whether each goes back to its first point.
type Lines = Vec<(Vec<DVec2>, bool)>;

// Writing to a String cannot fail.

/// What is seen of isolines, see [`svg`](super::svg()).
pub fn pdf(isolines: &Isolines, field: &Field, view: &View, unit: Unit) -> Vec<u8> {
    let lines = seen(isolines, field, view).flat_map(|curves| curves.into_iter().flatten());
    let lines = lines.map(|line| (line, false)).collect();
    document(&lines, view.size, millimeters(unit) * view.pixel)
}

/// Plane shapes.
pub fn sheet_pdf(sheet: &Sheet, unit: Unit) -> Vec<u8> {
    let down = |points: &Vec<DVec2>| points.iter().map(|point| DVec2::new(point.x, sheet.size.y - point.y)).collect();
    let lines = sheet.planes.iter().flat_map(|plane| &plane.loops).map(|points| (down(points), true)).collect();
    document(&lines, sheet.size, millimeters(unit))
}

/// By how much a drawing is smaller than what it shows: 1, or the least of 2, 5, 10, 20 and so on by which it fits on a page.
fn reduction(millimeters: DVec2) -> f64 {
    let fits = |by: &f64| (millimeters / *by + DVec2::new(2.0 * MARGIN, 2.0 * MARGIN + FOOT)).max_element() <= LONGEST;
    let steps = (0..300).flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * 10.0_f64.powi(power)));
    steps.into_iter().find(fits).unwrap_or(f64::INFINITY)
}

/// `scale`: millimeters of a unit of the lines and of their `size`.
fn document(lines: &Lines, size: DVec2, scale: f64) -> Vec<u8> {
    let by = reduction(size * scale);
    let drawn = size * scale / by;
    let page = DVec2::new(drawn.x.max(f64::from(RULER)), drawn.y + FOOT) + 2.0 * MARGIN;
    let foot = page.y - MARGIN;
    let mut content = format!(
        "BT /F {} Tf {} {} Td ({RULER} mm     1 : {by}) Tj ET\n",
        LETTERS * POINTS,
        MARGIN * POINTS,
        (MARGIN + 1.5 * TICKS[1]) * POINTS
    );
    // From here on in millimeters from the upper left corner.
    let _ = writeln!(content, "{POINTS} 0 0 -{POINTS} 0 {} cm {LINE_WIDTH} w 1 j 1 J", page.y * POINTS);
    let _ = writeln!(content, "{MARGIN} {foot} m {} {foot} l", MARGIN + f64::from(RULER));
    for at in (0..=RULER).step_by(STEP as usize) {
        let height = TICKS[usize::from(at % (RULER / 2) == 0)];
        let _ = writeln!(content, "{0} {foot} m {0} {1} l", MARGIN + f64::from(at), foot - height);
    }
    content.push_str("S\n");
    for (line, is_closed) in lines {
        for (index, point) in line.iter().enumerate() {
            let [x, y] = (*point * (scale / by) + MARGIN).to_array();
            let _ = write!(content, "{x:.4} {y:.4} {} ", if index == 0 { 'm' } else { 'l' });
        }
        content.push_str(if *is_closed { "s\n" } else { "S\n" });
    }
    let [width, height] = (page * POINTS).to_array();
    file(&[
        "<< /Type /Catalog /Pages 2 0 R >>".to_owned(),
        "<< /Type /Pages /Kids [3 0 R] /Count 1 >>".to_owned(),
        format!(
            "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {width} {height}] /Contents 4 0 R /Resources << /Font << /F 5 0 R >> >> >>"
        ),
        format!("<< /Length {} >>\nstream\n{content}endstream", content.len()),
        "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>".to_owned(),
    ])
}

/// A file of objects, the first of which is the catalog, with the table of where they begin (7.5).
fn file(objects: &[String]) -> Vec<u8> {
    let mut text = String::from("%PDF-1.4\n");
    let mut places = format!("xref\n0 {}\n0000000000 65535 f \n", objects.len() + 1);
    for (index, object) in objects.iter().enumerate() {
        let _ = writeln!(places, "{:010} 00000 n ", text.len());
        let _ = writeln!(text, "{} 0 obj\n{object}\nendobj", index + 1);
    }
    let start = text.len();
    let _ = write!(text, "{places}trailer\n<< /Size {} /Root 1 0 R >>\nstartxref\n{start}\n%%EOF\n", objects.len() + 1);
    text.into_bytes()
}
