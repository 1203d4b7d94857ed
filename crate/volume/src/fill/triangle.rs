//! A triangle seen from a point.

use bytemuck::Zeroable;
use glam::DVec3;

/// Corners, counter-clockwise from outside.
pub type Triangle = [DVec3; 3];

/// The solid angle that a triangle takes up, positive for a point behind it (Van Oosterom & Strackee, "The solid angle of a
/// plane triangle", 1983).
#[inline]
pub fn solid_angle(triangle: &Triangle, point: DVec3) -> f64 {
    let [a, b, c] = triangle.map(|corner| corner - point);
    let [la, lb, lc] = [a.length(), b.length(), c.length()];
    let determinant = a.dot(b.cross(c));
    let denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    2.0 * determinant.atan2(denominator)
}

/// The way from a point to the nearest one of a triangle (Ericson, "Real-Time Collision Detection", section 5.1.5).
#[inline]
pub fn to_nearest(&[a, b, c]: &Triangle, point: DVec3) -> DVec3 {
    let (ab, ac, ap) = (b - a, c - a, point - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return -ap;
    }
    let bp = point - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return -bp;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return ab * (d1 / (d1 - d3)) - ap;
    }
    let cp = point - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return -cp;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return ac * (d2 / (d2 - d6)) - ap;
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))) - bp;
    }
    let scale = 1.0 / (va + vb + vc);
    ab * (vb * scale) + ac * (vc * scale) - ap
}

/// Twice the area, along the normal.
#[inline]
pub fn area_vector([a, b, c]: &Triangle) -> DVec3 {
    (b - a).cross(c - a)
}

/// Where a segment crosses a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Zeroable)]
pub struct Crossing {
    /// The share of the way along the segment.
    pub share: f64,
    /// How far apart the ends of the segment are across the triangle's plane.
    pub rise: f64,
}

impl Crossing {
    /// The share at which the segment crosses the triangle's plane where that is moved this far to its end, as if the rise were
    /// `least_rise` where it is less.
    pub fn share_beyond(self, way: f64, least_rise: f64) -> f64 {
        (self.share + way / self.rise.max(least_rise)).clamp(0.0, 1.0)
    }
}

/// Where a segment crosses a triangle (Möller & Trumbore, "Fast, minimum storage ray/triangle intersection", 1997); none where it is
/// parallel.
#[inline]
pub fn crossing(&[a, b, c]: &Triangle, start: DVec3, along: DVec3) -> Option<Crossing> {
    let (ab, ac, to) = (b - a, c - a, start - a);
    let normal = along.cross(ac);
    let determinant = ab.dot(normal);
    if determinant == 0.0 {
        return None;
    }
    let u = to.dot(normal) / determinant;
    let turned = to.cross(ab);
    let v = along.dot(turned) / determinant;
    let share = ac.dot(turned) / determinant;
    let is_crossed = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && (0.0..=1.0).contains(&share);
    is_crossed.then(|| Crossing { share, rise: determinant.abs() / ab.cross(ac).length() })
}
