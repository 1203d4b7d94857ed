//! Plane geometry of single triangles. Edge `i` is opposite corner `i`, counter-clockwise.

use glam::DVec3;

use crate::scale::scale;

/// Cotangents of corner angles are cut at ± this. It bounds angles from below by 10⁻⁵ rad, about 0.0006°: thinner
/// triangles are noise of the file, and weights of 10¹⁶ would drown those of their neighbours in rounding.
const COTAN_LIMIT: f64 = 1e5;

/// Unit vector along `vector`, zero for zero; safe where the squared length would under- or overflow.
#[inline]
pub fn unit(vector: DVec3) -> DVec3 {
    let scale = vector.abs().max_element();
    if scale > 0.0 { (vector / scale).normalize() } else { DVec3::ZERO }
}

/// Length, safe where its square would under- or overflow.
#[inline]
pub fn length(vector: DVec3) -> f64 {
    let squared = vector.length_squared();
    if (1e-280..1e280).contains(&squared) {
        return squared.sqrt();
    }
    let scale = scale(vector.abs().max_element());
    (vector * scale).length() / scale
}

/// Length of a plane vector, safe where its square would under- or overflow.
#[inline]
pub fn hypotenuse(x: f64, y: f64) -> f64 {
    let squared = x * x + y * y;
    if (1e-280..1e280).contains(&squared) {
        return squared.sqrt();
    }
    let scale = scale(x.abs().max(y.abs()));
    let (x, y) = (x * scale, y * scale);
    (x * x + y * y).sqrt() / scale
}

/// Area of the triangle with these side lengths, 0 where they violate the triangle inequality. W. Kahan,
/// "Miscalculating area and angles of a needle-like triangle" (2014): accurate for any shape.
#[inline]
pub fn area_of_lengths([a, b, c]: [f64; 3]) -> f64 {
    let (long, short) = if a > b { (a, b) } else { (b, a) };
    let (a, middle) = if c > long { (c, long) } else { (long, c) };
    let (b, c) = if middle > short { (middle, short) } else { (short, middle) };
    let product = |a: f64, b: f64, c: f64| ((a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))).max(0.0);
    // Fourth powers of lengths need not be numbers.
    if (1e-60..1e60).contains(&a) {
        return 0.25 * product(a, b, c).sqrt();
    }
    let scale = scale(a);
    0.25 * product(a * scale, b * scale, c * scale).sqrt() / scale / scale
}

/// The edges opposite each corner.
#[inline]
pub fn edges([p, q, r]: [DVec3; 3]) -> [DVec3; 3] {
    [r - q, p - r, q - p]
}

/// Twice the area, along the unit normal.
#[inline]
pub fn area_vector([p, q, r]: [DVec3; 3]) -> DVec3 {
    (q - p).cross(r - p)
}

/// Angle at the first corner, radians.
pub fn angle([p, q, r]: [DVec3; 3]) -> f64 {
    let (a, b) = (unit(q - p), unit(r - p));
    length(a.cross(b)).atan2(a.dot(b))
}

/// Cuts the cotangents of a triangle's corner angles at ± `COTAN_LIMIT`. They stay those of a triangle, so that its
/// stiffness matrix stays positive semidefinite.
pub fn limit_cotans(mut cotans: [f64; 3]) -> [f64; 3] {
    if cotans.iter().all(|cotan| cotan.abs() <= COTAN_LIMIT) {
        return cotans;
    }
    let widest = (0..3).min_by(|&i, &j| cotans[i].total_cmp(&cotans[j])).unwrap_or(0);
    let [i, j] = [(widest + 1) % 3, (widest + 2) % 3];
    for corner in [i, j] {
        cotans[corner] = cotans[corner].min(COTAN_LIMIT);
    }
    // Angles sum to π, so cot α cot β + cot β cot γ + cot γ cot α = 1.
    cotans[widest] = (1.0 - cotans[i] * cotans[j]) / (cotans[i] + cotans[j]);
    cotans
}

/// Gradient of the linear function with these corner values; zero where it has no finite one.
#[inline]
pub fn gradient(corners: [DVec3; 3], values: [f64; 3]) -> DVec3 {
    let area = area_vector(corners);
    let [_, b, c] = edges(corners);
    let along = b * (values[1] - values[0]) + c * (values[2] - values[0]);
    let gradient = unit(area).cross(along) / length(area);
    if gradient.is_finite() { gradient } else { DVec3::ZERO }
}
