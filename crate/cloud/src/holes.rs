//! Small holes between triangles that fit together, filled.

use glam::DVec3;
use heatwalk_base::sort;

use crate::circle::circumradius;
use crate::fans::Fans;
use crate::plane::Plane;

/// Length of the longest loop that is a hole to be filled, in spacings of its points.
const LONGEST: f64 = 24.0;

/// Triangles that fill a hole fold back over those around it where their normals are farther apart than this cosine tells. On parts as thin
/// as points are apart, the two sides are as far apart across a hole of few points, which ends no surface.
const FOLDED: f64 = 0.0;
const FOLDED_IF_FEW: f64 = -0.9;
const FEW: usize = 10;

/// Fills those of some boundary loops that are short, as far as triangles fit. Triangles agree in orientation.
pub fn fill(fans: &mut Fans<'_>, positions: &[DVec3], planes: &[Plane], loops: Vec<Vec<u32>>) {
    let is_short = |around: &Vec<u32>| {
        let at = |k: usize| positions[around[k % around.len()] as usize];
        let length: f64 = (0..around.len()).map(|k| at(k).distance(at(k + 1))).sum();
        let spacing: f64 = around.iter().map(|&point| planes[point as usize].spacing).sum();
        length * around.len() as f64 <= LONGEST * spacing
    };
    for around in loops.into_iter().filter(is_short) {
        cut_ears(fans, positions, around);
    }
}

/// Cuts ears off a loop, that with the smallest circle around it first: those that fit around their points, else, where planes tell too
/// little, as on thin parts, those that fold back over nothing.
fn cut_ears(fans: &mut Fans<'_>, positions: &[DVec3], mut around: Vec<u32>) {
    let folded = if around.len() <= FEW { FOLDED_IF_FEW } else { FOLDED };
    while around.len() >= 3 {
        let count = around.len();
        let ear = |k: usize| [around[(k + 1) % count], around[k], around[(k + count - 1) % count]];
        let radius = |k: &usize| circumradius(ear(*k).map(|vertex| positions[vertex as usize])).to_bits();
        let mut order: Vec<usize> = (0..count).collect();
        sort::sort_by_key(&mut order, radius);
        let fitting = order.iter().copied().find(|&k| fans.take(ear(k)));
        let cut = fitting.or_else(|| order.into_iter().find(|&k| fans.take_unless_folded(ear(k), folded)));
        match cut {
            Some(k) if count > 3 => drop(around.remove(k)),
            _ => return,
        }
    }
}
