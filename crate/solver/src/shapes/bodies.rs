//! Bodies of smoothly united capsules and ellipsoids (Quílez, "Distance functions" and "Smooth minimum").

use glam::DVec3;

use super::implicit;
use crate::soup::Soup;

/// Distance to two balls joined by the cone that touches both; exact.
struct RoundCone {
    start: DVec3,
    axis: DVec3,
    start_radius: f64,
    end_radius: f64,
    length_squared: f64,
}

impl RoundCone {
    fn new((start, start_radius): (DVec3, f64), (end, end_radius): (DVec3, f64)) -> Self {
        let axis = end - start;
        Self { start, axis, start_radius, end_radius, length_squared: axis.length_squared() }
    }

    fn distance(&self, point: DVec3) -> f64 {
        let shrink = self.start_radius - self.end_radius;
        let side_squared = self.length_squared - shrink * shrink;
        let relative = point - self.start;
        let y = relative.dot(self.axis);
        let z = y - self.length_squared;
        let x_squared = (relative * self.length_squared - self.axis * y).length_squared();
        let y_squared = y * y * self.length_squared;
        let z_squared = z * z * self.length_squared;
        let k = shrink.signum() * shrink * shrink * x_squared;
        if z.signum() * side_squared * z_squared > k {
            (x_squared + z_squared).sqrt() / self.length_squared - self.end_radius
        } else if y.signum() * side_squared * y_squared < k {
            (x_squared + y_squared).sqrt() / self.length_squared - self.start_radius
        } else {
            ((x_squared * side_squared / self.length_squared).sqrt() + y * shrink) / self.length_squared
                - self.start_radius
        }
    }
}

/// About the distance to an axis-parallel ellipsoid; exact to first order at its surface.
fn ellipsoid(point: DVec3, centre: DVec3, radii: DVec3) -> f64 {
    let scaled = (point - centre) / radii;
    let slope = (scaled / radii).length();
    if slope == 0.0 { -radii.min_element() } else { scaled.length() * (scaled.length() - 1.0) / slope }
}

/// The smaller of two distances, with the crease rounded over the width `blend`.
fn smooth_min(a: f64, b: f64, blend: f64) -> f64 {
    let overlap = (blend - (a - b).abs()).max(0.0) / blend;
    a.min(b) - overlap * overlap * blend / 4.0
}

/// A limb: round cones along a chain of balls.
fn chain(balls: &[(DVec3, f64)]) -> Vec<RoundCone> {
    balls.windows(2).map(|pair| RoundCone::new(pair[0], pair[1])).collect()
}

/// Distance to a limb. Cones that share a ball swell there by a quarter of `blend`, so it should be narrow.
fn limb(cones: &[RoundCone], point: DVec3, blend: f64) -> f64 {
    cones.iter().map(|cone| cone.distance(point)).fold(f64::INFINITY, |a, b| smooth_min(a, b, blend))
}

/// Frame of a tetrahedron with balls at its corners: genus 3. `spacing` is the length of an edge; the body is 4 wide.
pub fn high_genus(spacing: f64) -> Soup {
    const BLEND: f64 = 0.25;
    const BLEND_IN_BAR: f64 = 0.1;
    let corners = [(1.0, 1.0, 1.0), (1.0, -1.0, -1.0), (-1.0, 1.0, -1.0), (-1.0, -1.0, 1.0)]
        .map(|(x, y, z)| 1.25 * DVec3::new(x, y, z));
    let mut bars = Vec::new();
    for a in 0..4 {
        for b in a + 1..4 {
            let middle = (corners[a] + corners[b]) / 2.0 * 1.12;
            bars.push(chain(&[(corners[a], 0.40), (middle, 0.24), (corners[b], 0.40)]));
        }
    }
    let field = |point: DVec3| {
        let bars = bars.iter().map(|bar| limb(bar, point, BLEND_IN_BAR));
        bars.fold(f64::INFINITY, |a, b| smooth_min(a, b, BLEND))
    };
    let (positions, triangles) = implicit::mesh(&field, DVec3::splat(-2.0), DVec3::splat(2.0), spacing);
    Soup::single("high_genus", positions, triangles)
}

/// A finger ring around the y axis whose band grows towards a signet at +x. The inner radius is about 0.85; `spacing` is
/// the length of an edge.
pub fn ring(spacing: f64) -> Soup {
    let field = |point: DVec3| {
        let around = DVec3::new(point.x, 0.0, point.z);
        let radius = around.length();
        // 1 at the front, 0 at the back.
        let front = if radius > 0.0 { (1.0 + point.x / radius) / 2.0 } else { 0.5 };
        let growth = front.powi(4);
        let (half_width, thickness) = (0.13 + 0.24 * growth, 0.13 + 0.06 * growth);
        let (across, out) = (point.y / half_width, (radius - 1.0) / thickness);
        // An ellipse as the section, scaled to about a distance.
        let band = ((across * across + out * out).sqrt() - 1.0) * thickness.min(half_width);
        let signet = ellipsoid(point, DVec3::new(1.14, 0.0, 0.0), DVec3::new(0.13, 0.36, 0.40));
        smooth_min(band, signet, 0.1)
    };
    let bound = DVec3::new(1.6, 0.6, 1.6);
    let (positions, triangles) = implicit::mesh(&field, -bound, bound, spacing);
    Soup::single("ring", positions, triangles)
}

/// A small cow: four legs, neck, head with ears and horns, and a tail with its tuft. It stands on y = 0 and looks along
/// +x, 2 long. Below a `spacing` of 0.024 no horn is lost.
pub fn animal(spacing: f64) -> Soup {
    let body = Animal::new();
    let field = |point: DVec3| body.distance(point);
    let (positions, triangles) =
        implicit::mesh(&field, DVec3::new(-1.15, -0.1, -0.5), DVec3::new(1.45, 2.1, 0.5), spacing);
    Soup::single("animal", positions, triangles)
}

/// Limbs of the right half and the middle; the left half mirrors them.
struct Animal {
    neck: Vec<RoundCone>,
    head: Vec<RoundCone>,
    legs: Vec<RoundCone>,
    tail: Vec<RoundCone>,
    ear: Vec<RoundCone>,
    horn: Vec<RoundCone>,
}

impl Animal {
    fn new() -> Self {
        let chain_of = |balls: &[(f64, f64, f64, f64)]| {
            let balls: Vec<_> = balls.iter().map(|&(x, y, z, radius)| (DVec3::new(x, y, z), radius)).collect();
            chain(&balls)
        };
        let mut legs = chain_of(&[
            (0.40, 0.92, 0.15, 0.15),
            (0.42, 0.52, 0.18, 0.082),
            (0.41, 0.16, 0.18, 0.056),
            (0.43, 0.045, 0.18, 0.082),
        ]);
        legs.extend(chain_of(&[
            (-0.46, 0.98, 0.13, 0.19),
            (-0.40, 0.68, 0.18, 0.125),
            (-0.56, 0.44, 0.18, 0.068),
            (-0.51, 0.16, 0.18, 0.055),
            (-0.48, 0.045, 0.18, 0.080),
        ]));
        Self {
            neck: chain_of(&[(0.52, 1.14, 0.0, 0.22), (0.74, 1.36, 0.0, 0.165), (0.92, 1.52, 0.0, 0.14)]),
            head: chain_of(&[(0.95, 1.58, 0.0, 0.155), (1.10, 1.46, 0.0, 0.125), (1.23, 1.36, 0.0, 0.112)]),
            legs,
            tail: chain_of(&[
                (-0.70, 1.20, 0.0, 0.060),
                (-0.86, 1.14, 0.0, 0.042),
                (-0.93, 0.94, 0.0, 0.036),
                (-0.95, 0.68, 0.0, 0.034),
                (-0.95, 0.58, 0.0, 0.060),
                (-0.97, 0.46, 0.0, 0.026),
            ]),
            ear: chain_of(&[(0.90, 1.63, 0.12, 0.035), (0.87, 1.64, 0.21, 0.055), (0.85, 1.61, 0.31, 0.028)]),
            horn: chain_of(&[
                (0.93, 1.68, 0.07, 0.048),
                (0.92, 1.78, 0.15, 0.043),
                (0.95, 1.88, 0.18, 0.036),
                (1.00, 1.95, 0.15, 0.027),
            ]),
        }
    }

    fn distance(&self, point: DVec3) -> f64 {
        let mirrored = DVec3::new(point.x, point.y, point.z.abs());
        let part = |centre: (f64, f64, f64), radii: (f64, f64, f64), point: DVec3| {
            ellipsoid(point, centre.into(), radii.into())
        };
        let mut body = part((0.0, 0.98, 0.0), (0.60, 0.32, 0.29), point);
        body = smooth_min(body, part((0.40, 1.03, 0.0), (0.30, 0.33, 0.27), point), 0.15);
        body = smooth_min(body, part((-0.44, 1.05, 0.0), (0.31, 0.31, 0.28), point), 0.15);
        body = smooth_min(body, part((-0.28, 0.68, 0.0), (0.14, 0.10, 0.11), point), 0.08);
        body = smooth_min(body, limb(&self.neck, point, 0.03), 0.2);
        // Hoofs are cut flat at the ground; the cut is rounded so that vertices can be projected on it.
        let legs = -smooth_min(-limb(&self.legs, mirrored, 0.03), mirrored.y, 0.03);
        body = smooth_min(body, legs, 0.1);
        body = smooth_min(body, limb(&self.tail, point, 0.01), 0.06);
        let mut head = limb(&self.head, point, 0.03);
        head = smooth_min(head, part((1.26, 1.33, 0.0), (0.10, 0.095, 0.125), point), 0.05);
        head = smooth_min(head, limb(&self.ear, mirrored, 0.015), 0.05);
        head = smooth_min(head, limb(&self.horn, mirrored, 0.01), 0.03);
        smooth_min(body, head, 0.08)
    }
}
