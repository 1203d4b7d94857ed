//! Steps along a surface that end at its boundary.

use glam::DVec3;
use heatwalk::Surface;

use crate::flow::Place;

/// Faces that a step enters at most; the rest of it is lost.
const MOST_FACES: usize = 64;

/// Where a step along a surface leads: straight over edges, and along a boundary where it meets one. It never leaves the surface, and
/// crosses no edge of one face.
pub(super) fn slid(surface: &Surface, from: Place, step: DVec3) -> Place {
    let (mut place, mut left) = (from, step);
    for _ in 0..MOST_FACES {
        let [p, q, r] = surface.corners(place.face);
        let (along_q, along_r) = (q - p, r - p);
        let [qq, qr, rr] = [along_q.length_squared(), along_q.dot(along_r), along_r.length_squared()];
        let determinant = qq * rr - qr * qr;
        let [to_q, to_r] = [left.dot(along_q), left.dot(along_r)];
        let [b, c] = [(rr * to_q - qr * to_r) / determinant, (qq * to_r - qr * to_q) / determinant];
        let rates = [-b - c, b, c];
        if !rates.iter().all(|rate| rate.is_finite()) {
            return place;
        }
        let mut exit: Option<(f64, usize)> = None;
        for k in 0..3 {
            let share = -place.weights[k] / rates[k];
            if rates[k] < 0.0 && exit.is_none_or(|(least, _)| share < least) {
                exit = Some((share, k));
            }
        }
        let Some((share, k)) = exit.filter(|&(share, _)| share < 1.0) else {
            return Place { weights: settled([0, 1, 2].map(|k| place.weights[k] + rates[k])), ..place };
        };
        let mut weights = [0, 1, 2].map(|k| place.weights[k] + share * rates[k]);
        weights[k] = 0.0;
        place.weights = settled(weights);
        left *= 1.0 - share;
        let [i, j] = [(k + 1) % 3, (k + 2) % 3];
        let corners = [p, q, r];
        let side = corners[j] - corners[i];
        let halfedge = place.face.halfedge(i);
        let Some(beyond) = surface.edges().around(halfedge).nth(1) else {
            // Along the boundary, up to the next corner.
            let share = left.dot(side) / side.length_squared();
            let at = (place.weights[j] + share).clamp(0.0, 1.0);
            place.weights[i] = 1.0 - at;
            place.weights[j] = at;
            return place;
        };
        let (face, m) = (beyond.triangle(), beyond.corner());
        let is_along = surface.faces()[face][m] == surface.faces()[place.face][i];
        let mut there = [0.0; 3];
        there[m] = place.weights[if is_along { i } else { j }];
        there[(m + 1) % 3] = place.weights[if is_along { j } else { i }];
        // What goes out of the one face goes into the other, as if both lay in a plane.
        let unit = side.normalize();
        let inward = |corner: DVec3| {
            let away = corner - corners[i];
            (away - unit * unit.dot(away)).normalize()
        };
        let out = -left.dot(inward(corners[k]));
        left = unit * unit.dot(left) + out.max(0.0) * inward(surface.corners(face)[(m + 2) % 3]);
        place = Place { face, weights: there };
    }
    place
}

/// Weights without what rounding left below 0, of sum 1.
fn settled(weights: [f64; 3]) -> [f64; 3] {
    let kept = weights.map(|weight| weight.max(0.0));
    let sum: f64 = kept.iter().sum();
    kept.map(|weight| weight / sum)
}
