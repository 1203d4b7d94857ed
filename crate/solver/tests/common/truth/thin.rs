//! Flat convex meshes with thin triangles: distances are straight lines.

use std::collections::HashMap;
use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::rows::{Rows, Seam};
use super::{Case, Random};

/// How thin triangles are: heights as shares of lengths.
pub const THINNEST: f64 = 1e-8;
pub const LEAST_THIN: f64 = 1e-2;

/// Altitudes of triangles below this share of their longest side are no more than rounding after a few cuts.
const ROUNDED: f64 = 1e-10;

pub fn case(seed: u64) -> Case {
    let mut random = Random::new(seed);
    let (kind, make): (_, fn(&mut Random) -> Flat) = random.pick(&[
        ("strips", strips),
        ("needles", needles),
        ("slivers", slivers),
        ("sewn T-junctions", junctions),
        ("collinear boundary", collinear),
        ("graded", graded),
    ]);
    let (points, triangles) = make(&mut random);
    let positions = points.iter().map(|point| point.extend(0.0)).collect::<Vec<DVec3>>();
    Case::placed(kind, &mut random, (positions, triangles), Some(points))
}

type Flat = (Vec<DVec2>, Vec<[u32; 3]>);

/// Bands of height 10⁻² to 10⁻⁸, alone or amid others.
fn strips(random: &mut Random) -> Flat {
    let thin = random.log_between(THINNEST, LEAST_THIN);
    let share_of_thick = random.pick(&[0.0, 0.1, 0.5]);
    let points = random.pick(&[0, 0, 1, 4]);
    let mut rows = Rows::default();
    let mut height = 0.0;
    for _ in 0..random.count(2, 24) {
        let inner = random.count(0, points);
        rows.push(&random.cuts(inner), height, Seam::Any, random);
        height +=
            if random.chance(share_of_thick) { random.between(0.05, 0.5) } else { thin * random.between(0.5, 2.0) };
    }
    (rows.points, rows.triangles)
}

/// Triangles around a corner, and rings around it.
fn needles(random: &mut Random) -> Flat {
    let thin = random.log_between(THINNEST, LEAST_THIN);
    let mut angles = vec![0.0];
    for _ in 0..random.count(3, 24) {
        let step = if random.chance(0.2) { random.between(0.1, 0.6) } else { thin * random.between(0.5, 2.0) };
        let next = angles[angles.len() - 1] + step;
        if next < PI {
            angles.push(next);
        }
    }
    let rings = random.count(1, 4);
    let mut radii: Vec<f64> = (1..rings).map(|_| random.log_between(1e-3, 0.9)).chain([1.0]).collect();
    radii.sort_by(f64::total_cmp);
    let mut rows = Rows::default();
    rows.push(&[0.0], 0.0, Seam::Any, random);
    let mut ring = Vec::new();
    for radius in radii {
        let seam = if ring.is_empty() { Seam::Any } else { Seam::Quads };
        let first = rows.points.len();
        // Placed by their angles below.
        ring.clone_from(&angles);
        rows.push(&ring, 0.0, seam, random);
        for (point, angle) in rows.points[first..].iter_mut().zip(&angles) {
            *point = DVec2::from_angle(*angle) * radius;
        }
    }
    (rows.points, rows.triangles)
}

/// A polygon whose triangles are cut near their sides and corners, and whose edges are flipped.
fn slivers(random: &mut Random) -> Flat {
    let corners = random.count(3, 8);
    let mut angles: Vec<f64> = (0..corners).map(|k| (k as f64 + random.between(0.0, 0.7)) / corners as f64).collect();
    angles.sort_by(f64::total_cmp);
    let mut points: Vec<DVec2> = angles.iter().map(|angle| DVec2::from_angle(2.0 * PI * angle)).collect();
    let mut triangles: Vec<[u32; 3]> = (2..corners as u32).map(|k| [0, k - 1, k]).collect();
    for _ in 0..random.count(3, 30) {
        let at = random.below(triangles.len());
        let [a, b, c] = triangles[at];
        let mut weight =
            || if random.chance(0.5) { random.log_between(THINNEST, LEAST_THIN) } else { random.between(0.2, 1.0) };
        let weights = [weight(), weight(), weight()];
        let sum: f64 = weights.iter().sum();
        let point = [a, b, c].iter().zip(weights).map(|(&corner, weight)| points[corner as usize] * weight / sum).sum();
        let new = points.len() as u32;
        points.push(point);
        let cut = [[a, b, new], [b, c, new], [c, a, new]];
        if cut.iter().all(|&triangle| is_proper(&points, triangle)) {
            triangles[at] = cut[0];
            triangles.extend([cut[1], cut[2]]);
        } else {
            points.pop();
        }
    }
    for _ in 0..random.count(0, 3 * triangles.len()) {
        flip(&points, &mut triangles, random);
    }
    (points, triangles)
}

/// Flips a random edge, where the triangles beside it make a convex quad.
fn flip(points: &[DVec2], triangles: &mut [[u32; 3]], random: &mut Random) {
    let (first, k) = (random.below(triangles.len()), random.below(3));
    let [a, b, c] = [0, 1, 2].map(|step| triangles[first][(k + step) % 3]);
    let sides: HashMap<[u32; 2], (usize, u32)> = triangles
        .iter()
        .enumerate()
        .flat_map(|(face, &[p, q, r])| [([p, q], (face, r)), ([q, r], (face, p)), ([r, p], (face, q))])
        .collect();
    let Some(&(second, d)) = sides.get(&[b, a]) else { return };
    let flipped = [[a, d, c], [d, b, c]];
    if flipped.iter().all(|&triangle| is_proper(points, triangle)) {
        [triangles[first], triangles[second]] = flipped;
    }
}

/// Counter-clockwise, and no thinner than rounding.
fn is_proper(points: &[DVec2], triangle: [u32; 3]) -> bool {
    let [p, q, r] = triangle.map(|corner| points[corner as usize]);
    let longest = p.distance_squared(q).max(q.distance_squared(r)).max(r.distance_squared(p));
    (q - p).perp_dot(r - p) > ROUNDED * longest
}

/// Rows whose sides are cut at other points below and above, and sewn by triangles of no area.
fn junctions(random: &mut Random) -> Flat {
    let mut rows = Rows::default();
    let mut height = 0.0;
    for _ in 0..random.count(2, 6) {
        let inner = random.count(0, 4);
        rows.push(&random.cuts(inner), height, Seam::Any, random);
        if random.chance(0.7) {
            let inner = random.count(1, 5);
            rows.push_again(&random.cuts(inner), random);
        }
        height += if random.chance(0.3) { random.log_between(1e-6, 1e-1) } else { random.between(0.1, 1.0) };
    }
    (rows.points, rows.triangles)
}

/// Many points on a straight boundary, with few beside them.
fn collinear(random: &mut Random) -> Flat {
    let mut rows = Rows::default();
    let mut height = 0.0;
    for _ in 0..random.count(1, 3) {
        for (low, high) in [(4, 24), (0, 2)] {
            let inner = random.count(low, high);
            rows.push(&random.cuts(inner), height, Seam::Any, random);
            height += random.log_between(THINNEST, LEAST_THIN);
        }
        height += random.pick(&[0.0, 0.3]);
    }
    (rows.points, rows.triangles)
}

/// Cells that grow from 10⁻⁵ or so to 1 around a point.
fn graded(random: &mut Random) -> Flat {
    let mut lines = || {
        let mut lines = vec![0.0, 1.0];
        let (middle, finest) = (random.between(0.0, 1.0), random.log_between(1e-6, 1e-3));
        let growth = random.between(2.0, 20.0);
        let mut step = finest;
        while step < 1.0 {
            lines.extend([middle - step, middle + step].into_iter().filter(|at| (1e-7..1.0 - 1e-7).contains(at)));
            step *= growth;
        }
        lines.sort_by(f64::total_cmp);
        lines
    };
    let [along, across] = [lines(), lines()];
    let mut rows = Rows::default();
    for height in across {
        rows.push(&along, height, Seam::Quads, random);
    }
    (rows.points, rows.triangles)
}
