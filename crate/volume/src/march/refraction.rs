//! Distance that goes from cost to cost: a tetrahedron's corner from the others.
//!
//! The virtual source of each tetrahedron is placed at distances T / w behind what is known, so that waves refract by themselves,
//! since distance T is continuous where the cost w is not.

use glam::DVec3;

use super::wave::Wave;
use crate::mesh::FACES;

/// A refracted distance replaces a straight one only if it is below it by this share: rounding of a virtual source that is many
/// edges away.
pub(super) const MARGIN: f64 = 1e-9;

/// The distance at corner `target` of a tetrahedron of this cost, from what is known (else infinite) of the others: through the
/// face where all three are known and the ray from their virtual source passes it, else over the edges.
pub(super) fn arrival(points: [DVec3; 4], known: [f64; 4], target: usize, cost: f64) -> f64 {
    let face = FACES[target];
    let place = points[target];
    let through = through_face(face.map(|corner| points[corner]), face.map(|corner| known[corner] / cost), place);
    if let Some(length) = through {
        return cost * length;
    }
    let mut least = f64::INFINITY;
    for k in 0..3 {
        let ends = [face[k], face[(k + 1) % 3]];
        let distances = ends.map(|corner| known[corner]);
        let single = distances[0] + cost * points[ends[0]].distance(place);
        least = least.min(single);
        if distances.iter().all(|distance| distance.is_finite())
            && let Some(wave) = Wave::from_edge([0; 2], ends.map(|corner| points[corner]), distances, 0.0, cost)
        {
            least = least.min(wave.ray(place).distance);
        }
    }
    least
}

/// The length from the virtual source of three lengths to a place on the other side of their triangle; none where there is no
/// such source, or the line misses the triangle.
fn through_face([a, b, c]: [DVec3; 3], [to_a, to_b, to_c]: [f64; 3], place: DVec3) -> Option<f64> {
    if !(to_a.is_finite() && to_b.is_finite() && to_c.is_finite()) {
        return None;
    }
    let (ab, ac, across) = (b - a, c - a, place - a);
    let normal = ab.cross(ac);
    let area = normal.length();
    let up = normal / area;
    // In the triangle's plane, |p|² − |p − ab|² = to_a² − to_b², and likewise for c.
    let right_b = 0.5 * ((to_a - to_b) * (to_a + to_b) + ab.length_squared());
    let right_c = 0.5 * ((to_a - to_c) * (to_a + to_c) + ac.length_squared());
    let foot = (right_b * ac.cross(normal) + right_c * normal.cross(ab)) / (area * area);
    let height_squared = to_a * to_a - foot.length_squared();
    // Written so that not a number has no source.
    if !(height_squared >= 0.0) {
        return None;
    }
    let (height, target_height) = (height_squared.sqrt(), across.dot(up).abs());
    let target_foot = across - across.dot(up) * up;
    let total = height + target_height;
    let crossing = foot + (target_foot - foot) * (height / total);
    let of_b = crossing.cross(ac).dot(up) / area;
    let of_c = ab.cross(crossing).dot(up) / area;
    let is_inside = of_b >= 0.0 && of_c >= 0.0 && of_b + of_c <= 1.0;
    is_inside.then(|| total.hypot(foot.distance(target_foot)))
}
