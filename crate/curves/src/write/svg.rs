//! Curves as they are seen, and plane shapes, as Scalable Vector Graphics 1.1.

use std::fmt::Write as _;

use glam::{DMat4, DVec2, DVec3, DVec4};
use heatwalk_surface::Unit;

use crate::field::Field;
use crate::isolines::Isolines;
use crate::sheet::Sheet;
use crate::strips::Strips;
use crate::write::occlusion::Occluders;
use crate::write::unit::millimeters;

/// Along the longer side of a picture.
const PIXELS: f64 = 1000.0;

/// Share of a picture's smaller side that lines are wide.
const LINE_WIDTH: f64 = 0.0015;

/// Share of the size of a picture by which its sides are apart from what is seen, where the picture is made to fit.
const MARGIN: f64 = 0.03;

/// Whence curves are seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// From the field's unit to clip space: −1 to 1 across the picture and in depth, Y up, Z toward the eye.
    pub clip_from_field: DMat4,
    /// Width and height of the picture, in pixels.
    pub size: DVec2,
    /// How long a pixel is in the field's unit; `None` where that depends on how far away something is.
    pub pixel: Option<f64>,
}

impl View {
    /// From far away in this direction, with the axis `up` upward, everything in the picture; 1000 pixels along its longer
    /// side. None for a direction without length.
    pub fn from_direction(field: &Field, toward_eye: DVec3, up: DVec3) -> Option<Self> {
        let back = toward_eye.try_normalize()?;
        // From above or below, any direction across is right.
        let right = up.cross(back).try_normalize().unwrap_or_else(|| up.any_orthonormal_vector());
        let up = back.cross(right);
        let seen =
            || field.positions().iter().map(|point| DVec3::new(point.dot(right), point.dot(up), point.dot(back)));
        let (low, high) = (seen().reduce(DVec3::min)?, seen().reduce(DVec3::max)?);
        let largest = (high - low).truncate().max_element();
        let extent = if largest > 0.0 { (high - low).truncate() + 2.0 * MARGIN * largest } else { DVec2::ONE };
        let center = 0.5 * low + 0.5 * high;
        let row = |axis: DVec3, offset: f64, scale: f64| (scale * axis).extend(-scale * offset);
        let rows = [
            row(right, center.x, 2.0 / extent.x),
            row(up, center.y, 2.0 / extent.y),
            row(back, center.z, if high.z > low.z { 2.0 / (high.z - low.z) } else { 0.0 }),
            DVec4::W,
        ];
        let [x, y, z, w] = rows;
        let clip_from_field = DMat4::from_cols(x, y, z, w).transpose();
        let pixel = extent.max_element() / PIXELS;
        Some(Self { clip_from_field, size: extent / pixel, pixel: Some(pixel) })
    }

    /// Where a point is in the picture, in pixels, Y down, and its depth toward the eye; none for one behind the eye.
    fn place(&self, point: DVec3) -> Option<DVec3> {
        let clip = self.clip_from_field * point.extend(1.0);
        let at = DVec2::new(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
        (clip.w > 0.0).then_some((at * self.size).extend(clip.z / clip.w))
    }

    /// The same of a triangle.
    fn triangle(&self, corners: [DVec3; 3]) -> Option<[DVec3; 3]> {
        let [Some(a), Some(b), Some(c)] = corners.map(|corner| self.place(corner)) else { return None };
        Some([a, b, c])
    }
}

/// Whether a triangle in a picture shows its outside.
fn is_front([a, b, c]: [DVec3; 3]) -> bool {
    // Clockwise where Y points down.
    (b - a).truncate().perp_dot((c - a).truncate()) < 0.0
}

/// What is seen of isolines on the outside of the surface, a group each: parts that are behind others are left out. At true scale
/// where there is one.
pub fn svg(isolines: &Isolines, field: &Field, view: &View, unit: Option<Unit>) -> Vec<u8> {
    let triangles = 0..field.triangles().len();
    let placed: Vec<Option<[DVec3; 3]>> = triangles.map(|triangle| view.triangle(field.corners(triangle))).collect();
    let occluders = Occluders::new(placed.iter().copied().flatten().collect());
    let mut text = String::new();
    for isoline in &isolines.isolines {
        let _ = writeln!(text, "<g id=\"isoline_{}\">", isoline.value);
        for curve in &isoline.curves {
            let mut path = Path::default();
            for ([from, to], &triangle) in curve.segments().zip(&curve.triangles) {
                let is_front = placed[triangle as usize].is_some_and(is_front);
                let ends = view.place(from).zip(view.place(to)).filter(|_| is_front);
                let Some((from, to)) = ends else { continue };
                for [start, end] in occluders.visible(from, to) {
                    path.segment([start, end].map(|share| from.lerp(to, share).truncate()));
                }
            }
            path.end(&mut text);
        }
        text.push_str("</g>\n");
    }
    let scale = unit.zip(view.pixel).map(|(unit, pixel)| millimeters(unit) * pixel);
    document(&text, view.size, scale, "")
}

/// Plane shapes, a group a strip, in the field's unit and at true scale where that is known.
pub fn sheet_svg(sheet: &Sheet, strips: &Strips, unit: Option<Unit>) -> Vec<u8> {
    let mut text = String::new();
    for plane in &sheet.planes {
        let _ = write!(text, "<path class=\"{}\" d=\"", strips.name(plane.strip));
        for points in &plane.loops {
            let mut letter = 'M';
            for point in points {
                let _ = write!(text, "{letter}{} {}", point.x, sheet.size.y - point.y);
                letter = 'L';
            }
            text.push('Z');
        }
        text.push_str("\"/>\n");
    }
    document(&text, sheet.size, unit.map(millimeters), " fill-rule=\"evenodd\"")
}

/// A `path` element that grows by segments.
#[derive(Default)]
struct Path {
    data: String,
    at: Option<DVec2>,
}

impl Path {
    /// Goes on to a segment that is seen, with a gap where it does not begin where the last one ended.
    fn segment(&mut self, [from, to]: [DVec2; 2]) {
        if self.at != Some(from) {
            let _ = write!(self.data, "M{:.3} {:.3}", from.x, from.y);
        }
        let _ = write!(self.data, "L{:.3} {:.3}", to.x, to.y);
        self.at = Some(to);
    }

    fn end(self, text: &mut String) {
        if !self.data.is_empty() {
            let _ = writeln!(text, "<path d=\"{}\"/>", self.data);
        }
    }
}

/// `size`: in the units of the content, whatever these are. `scale`: how long they are in millimeters; without, the picture has 1000
/// pixels along its longer side.
fn document(content: &str, size: DVec2, scale: Option<f64>, attributes: &str) -> Vec<u8> {
    let width = LINE_WIDTH * size.min_element();
    let (drawn, suffix) = match scale {
        Some(scale) => (size * scale, "mm"),
        None => (size * (PIXELS / size.max_element()), ""),
    };
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{2}{suffix}\" height=\"{3}{suffix}\" viewBox=\"0 0 {0} {1}\">\n\
         <g fill=\"none\" stroke=\"black\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{attributes}>\n\
         {content}</g>\n</svg>\n",
        size.x, size.y, drawn.x, drawn.y
    )
    .into_bytes()
}
