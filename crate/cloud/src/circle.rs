//! Circles through three points.

use glam::DVec3;

/// Radius; infinite where the points lie on a line.
pub fn circumradius([a, b, c]: [DVec3; 3]) -> f64 {
    let [u, v] = [b - a, c - a];
    u.length() * v.length() * (u - v).length() / (2.0 * u.cross(v).length())
}
