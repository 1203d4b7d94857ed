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

/// Virtual sources are this many edges away at least. A wave that comes from a cheaper medium is less curved than one from a source
/// at T / w, and nearer by, a source so placed is too near; there a plane wave is the better model.
const FAR: f64 = 4.0;

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
        if distances.iter().all(|distance| distance.is_finite()) {
            let positions = ends.map(|corner| points[corner]);
            let over = over_edge(positions, distances.map(|distance| distance / cost), place);
            least = least.min(over.map_or(f64::INFINITY, |length| cost * length));
        }
    }
    least
}

/// The length over an edge from the virtual source of the lengths at its ends, in the plane of edge and place; none where the ray
/// misses the edge.
fn over_edge([a, b]: [DVec3; 2], [to_a, to_b]: [f64; 2], place: DVec3) -> Option<f64> {
    let edge = b - a;
    let length = edge.length();
    if to_a.min(to_b) >= FAR * length {
        return Wave::from_edge([0; 2], [a, b], [to_a, to_b], 0.0, 1.0).map(|wave| wave.ray(place).distance);
    }
    let direction = edge / length;
    let along = (place - a).dot(direction);
    let apart = (place - a - along * direction).length();
    let slope = (to_b - to_a) / length;
    // Not a number where the slope is above 1, and then the comparison below fails.
    let upward = (1.0 - slope * slope).sqrt();
    let crossing = along - slope * apart / upward;
    (0.0..=length).contains(&crossing).then_some(to_a + slope * along + upward * apart)
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
    let target_height = across.dot(up).abs();
    let target_foot = across - across.dot(up) * up;
    let size = ab.length().max(ac.length()).max(ab.distance(ac));
    let (crossing, length) = if height_squared >= 0.0 && to_a.min(to_b).min(to_c) >= FAR * size {
        let height = height_squared.sqrt();
        let total = height + target_height;
        (foot + (target_foot - foot) * (height / total), total.hypot(foot.distance(target_foot)))
    } else {
        // A plane wave, of the slope that is known in the triangle.
        let slope = ((to_b - to_a) * ac.cross(normal) + (to_c - to_a) * normal.cross(ab)) / (area * area);
        // Not a number where the slope is above 1.
        let upward = (1.0 - slope.length_squared()).sqrt();
        if upward.is_nan() || upward == 0.0 {
            return None;
        }
        (target_foot - slope * (target_height / upward), to_a + slope.dot(target_foot) + upward * target_height)
    };
    let of_b = crossing.cross(ac).dot(up) / area;
    let of_c = ab.cross(crossing).dot(up) / area;
    let is_inside = of_b >= 0.0 && of_c >= 0.0 && of_b + of_c <= 1.0;
    is_inside.then_some(length)
}
