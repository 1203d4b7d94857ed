//! Smooth bodies with handles.

use glam::{DVec2, DVec3};
use heatwalk_surface::Soup;

use super::figure::smooth_min;
use super::implicit;

/// Frame of a tetrahedron, one corner up: a rounded tetrahedron with a hole from its middle through each face, so genus 3.
/// `spacing` is the length of an edge; the body is 3.9 wide.
pub fn high_genus(spacing: f64) -> Soup {
    /// From the middle to a face.
    const FACE: f64 = 1.20;
    const ROUNDING: f64 = 1.1;
    const HOLE: f64 = 0.84;
    const HOLE_RIM: f64 = 0.4;
    let (low, half, far) = (1.0 / 3.0, 2.0_f64.sqrt() / 3.0, 8.0_f64.sqrt() / 3.0);
    let aside = (2.0_f64 / 3.0).sqrt();
    let normals =
        [DVec3::NEG_Y, DVec3::new(far, low, 0.0), DVec3::new(-half, low, aside), DVec3::new(-half, low, -aside)];
    let field = |point: DVec3| {
        let heights = normals.map(|normal| normal.dot(point));
        let below_faces = heights.iter().map(|height| FACE - height);
        let body = below_faces.fold(f64::INFINITY, |a, b| smooth_min(a, b, ROUNDING));
        let beside_holes = heights.iter().map(|height| {
            let along = height.max(0.0);
            (point.length_squared() - along * along).max(0.0).sqrt() - HOLE
        });
        -beside_holes.fold(body, |a, b| smooth_min(a, b, HOLE_RIM))
    };
    let bound = DVec3::splat(2.6);
    let (positions, triangles) = implicit::mesh(&field, -bound, bound, spacing);
    Soup::single("high_genus", positions, triangles)
}

/// A ring around the y axis whose tube swells from a thin back at −x to a bulb at +x. The hole has the radius 0.85;
/// `spacing` is the length of an edge.
pub fn ring(spacing: f64) -> Soup {
    const HOLE: f64 = 0.85;
    const THIN: f64 = 0.10;
    const THICK: f64 = 0.46;
    let field = |point: DVec3| {
        let around = DVec3::new(point.x, 0.0, point.z);
        let radius = around.length();
        // 1 at the front, 0 at the back.
        let front = if radius > 0.0 { (1.0 + point.x / radius) / 2.0 } else { 0.5 };
        let tube = THIN + (THICK - THIN) * front * front.sqrt();
        DVec2::new(radius - HOLE - tube, point.y).length() - tube
    };
    let bound = DVec3::new(2.0, 0.6, 2.0);
    let (positions, triangles) = implicit::mesh(&field, -bound, bound, spacing);
    Soup::single("ring", positions, triangles)
}
