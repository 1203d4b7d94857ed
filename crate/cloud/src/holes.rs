//! Small holes between triangles that fit together, filled.

use glam::DVec3;

use crate::circle::circumradius;
use crate::fans::Fans;

/// Edges of the largest loop that is a hole.
const LARGEST: usize = 24;

/// Triangles that fill a hole fold back over those around it where their normals are farther apart than this cosine tells.
const FOLDED: f64 = 0.0;

/// Fills those of some boundary loops that have few edges, as far as triangles fit. Triangles agree in orientation.
pub fn fill(fans: &mut Fans<'_>, positions: &[DVec3], loops: Vec<Vec<u32>>) {
    for around in loops.into_iter().filter(|around| around.len() <= LARGEST) {
        cut_ears(fans, positions, around);
    }
}

/// Cuts ears off a loop, that with the smallest circle around it first: those that fit around their points, else, where planes tell too
/// little, as on thin parts, those that fold back over nothing.
fn cut_ears(fans: &mut Fans<'_>, positions: &[DVec3], mut around: Vec<u32>) {
    while around.len() >= 3 {
        let count = around.len();
        let ear = |k: usize| [around[(k + 1) % count], around[k], around[(k + count - 1) % count]];
        let radius = |k: &usize| circumradius(ear(*k).map(|vertex| positions[vertex as usize])).to_bits();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(radius);
        let fitting = order.iter().copied().find(|&k| fans.take(ear(k)));
        let cut = fitting.or_else(|| order.into_iter().find(|&k| fans.take_unless_folded(ear(k), FOLDED)));
        match cut {
            Some(k) if count > 3 => drop(around.remove(k)),
            _ => return,
        }
    }
}
