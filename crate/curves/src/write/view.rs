//! Curves as they are seen.

use glam::{DMat4, DVec2, DVec3, DVec4};

use crate::field::Field;
use crate::isolines::{Curve, Isolines};
use crate::write::occlusion::Occluders;

/// Along the longer side of a picture.
pub(super) const PIXELS: f64 = 1000.0;

/// Share of the size of a picture by which its sides are apart from what is seen, where the picture is made to fit.
const MARGIN: f64 = 0.03;

/// Whence curves are seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// From the field's unit to clip space: −1 to 1 across the picture and in depth, Y up, Z toward the eye.
    pub clip_from_field: DMat4,
    /// Width and height of the picture, in pixels.
    pub size: DVec2,
    /// How long a pixel is in the field's unit.
    pub pixel: f64,
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
        Some(Self { clip_from_field, size: extent / pixel, pixel })
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

/// What is seen of each curve on the outside of the surface: lines in pixels, Y down. What is behind other parts is left out.
pub(super) fn seen<'a>(
    isolines: &'a Isolines,
    field: &'a Field,
    view: &'a View,
) -> impl Iterator<Item = Vec<Vec<Vec<DVec2>>>> + 'a {
    let triangles = 0..field.triangles().len();
    let placed: Vec<Option<[DVec3; 3]>> = triangles.map(|triangle| view.triangle(field.corners(triangle))).collect();
    let occluders = Occluders::new(placed.iter().copied().flatten().collect());
    let lines = move |curve: &Curve| {
        let mut lines: Vec<Vec<DVec2>> = Vec::new();
        for ([from, to], &triangle) in curve.segments().zip(&curve.triangles) {
            let is_front = placed[triangle as usize].is_some_and(is_front);
            let ends = view.place(from).zip(view.place(to)).filter(|_| is_front);
            let Some((from, to)) = ends else { continue };
            for ends in occluders.visible(from, to) {
                let [start, end] = ends.map(|share| from.lerp(to, share).truncate());
                match lines.last_mut() {
                    Some(line) if line.last() == Some(&start) => line.push(end),
                    _ => lines.push(vec![start, end]),
                }
            }
        }
        lines
    };
    isolines.isolines.iter().map(move |isoline| isoline.curves.iter().map(&lines).collect())
}
