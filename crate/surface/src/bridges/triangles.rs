//! Two triangles in space: their nearest points, where they cross, and points spread over the places where they are near.
//!
//! The nearest points of two triangles that do not cross are those of a corner and a triangle or of two sides (Ericson,
//! "Real-Time Collision Detection", 2005, section 5.1.10). Everything is told by barycentric weights, so that a point on an edge or at a corner has weights of exactly 0.

use glam::DVec3;

use crate::index::Bounds;
use crate::triangle::area_vector;

#[cfg(test)]
mod tests;

/// Parts that a side is cut into at most, where points are spread.
const MOST_CUTS: f64 = 256.0;

/// The same inside a triangle, where points may be this many times as far apart as on the rim of an overlap: what goes from
/// one triangle to the other and comes from outside the overlap crosses its rim.
const MOST_INNER_CUTS: f64 = 32.0;
const INNER_SPACING: f64 = 6.0;

/// Cosine of the angle from which on planes are steep to each other: 30°.
const STEEP: f64 = 0.866;

/// Square of the sine of the angle up to which the common normal of two segments is taken for noise: rounding turns it by some
/// 10⁻¹³ then.
const PARALLEL: f64 = 1e-6;

/// A bound on a square that is passed by more than rounding.
const ROUNDED: f64 = 1.0 + 1e-9;

/// Corners.
pub type Triangle = [DVec3; 3];

/// Barycentric weights of a point of each of two triangles.
pub type Weights = [[f64; 3]; 2];

/// Of the corners of a triangle and its sides, from each corner to the next, those that it tells of: of the triangles that share
/// one, a single one does.
#[derive(Debug, Clone, Copy)]
pub struct Features {
    pub corners: [bool; 3],
    pub sides: [bool; 3],
    /// Sides where the surface ends or bends.
    pub rims: [bool; 3],
}

impl Features {
    pub const ALL: Self = Self { corners: [true; 3], sides: [true; 3], rims: [true; 3] };
}

/// A point of each of two triangles, and the distance of these points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    pub weights: Weights,
    pub distance: f64,
}

impl Pair {
    #[inline]
    fn new(triangles: &[Triangle; 2], weights: Weights) -> Self {
        let distance = point(&triangles[0], weights[0]).distance(point(&triangles[1], weights[1]));
        Self { weights, distance }
    }
}

/// The point with these weights.
#[inline]
pub fn point(triangle: &Triangle, weights: [f64; 3]) -> DVec3 {
    triangle[0] * weights[0] + triangle[1] * weights[1] + triangle[2] * weights[2]
}

/// Distance of the middles of two triangles.
#[inline]
pub fn offset(triangles: &[Triangle; 2]) -> f64 {
    let [first, second] = triangles.map(|[a, b, c]| a + b + c);
    first.distance(second) / 3.0
}

/// Length of the longest side.
pub fn longest_side([p, q, r]: &Triangle) -> f64 {
    p.distance_squared(*q).max(q.distance_squared(*r)).max(r.distance_squared(*p)).sqrt()
}

/// Weights of a point on the side from corner `k` to the next.
#[inline]
pub fn on_side(k: usize, share: f64) -> [f64; 3] {
    let mut weights = [0.0; 3];
    weights[k] = 1.0 - share;
    weights[(k + 1) % 3] = share;
    weights
}

/// The side from corner `k` to the next.
#[inline]
fn side(triangle: &Triangle, k: usize) -> [DVec3; 2] {
    [triangle[k], triangle[(k + 1) % 3]]
}

/// The share of the way along a segment of positive length where it is nearest to a point.
#[inline]
pub fn nearest_on_segment(point: DVec3, [start, end]: [DVec3; 2]) -> f64 {
    let along = end - start;
    ((point - start).dot(along) / along.length_squared()).clamp(0.0, 1.0)
}

/// The point of a triangle that is nearest to a point: below it, or else on a side. `normal`: twice the area, along the unit
/// normal.
#[inline]
pub fn nearest_on_triangle(from: DVec3, triangle: &Triangle, normal: DVec3) -> [f64; 3] {
    if let Some(weights) = weights_inside(from, triangle, normal) {
        return weights;
    }
    let mut best = (0, 0.0, f64::INFINITY);
    for k in 0..3 {
        let (start, end) = (triangle[k], triangle[(k + 1) % 3]);
        let share = nearest_on_segment(from, [start, end]);
        let squared = from.distance_squared(start * (1.0 - share) + end * share);
        if squared < best.2 {
            best = (k, share, squared);
        }
    }
    on_side(best.0, best.1)
}

/// The shares of the way along two segments, beyond their ends too, where their lines are nearest to each other; any, or no
/// numbers, where these are parallel. `None` where they are farther apart than `within`.
#[inline]
fn common_perpendicular(first: [DVec3; 2], second: [DVec3; 2], within: f64) -> Option<[f64; 2]> {
    let (along, across, between) = (first[1] - first[0], second[1] - second[0], second[0] - first[0]);
    let normal = along.cross(across);
    let squared = normal.length_squared();
    let height = between.dot(normal);
    let is_far = height * height > within * within * squared * ROUNDED;
    if is_far && squared > PARALLEL * (along.length_squared() * across.length_squared()) {
        return None;
    }
    Some([between.cross(across).dot(normal) / squared, between.cross(along).dot(normal) / squared])
}

/// Whether a place is on a segment and not beyond its ends, in shares of the way along it.
#[inline]
fn is_on(share: f64) -> bool {
    (0.0..=1.0).contains(&share)
}

/// The shares of the way along two segments of positive length where they are nearest to each other: inside both, where
/// their common perpendicular is, or else at an end of one.
#[inline]
fn nearest_on_segments(first: [DVec3; 2], second: [DVec3; 2], [one, other]: [f64; 2]) -> [f64; 2] {
    let (along, across) = (first[1] - first[0], second[1] - second[0]);
    let mut best = ([0.0; 2], f64::INFINITY);
    let mut take = |one: f64, other: f64| {
        let apart = (first[0] + along * one).distance_squared(second[0] + across * other);
        if apart < best.1 {
            best = ([one, other], apart);
        }
    };
    take(0.0, nearest_on_segment(first[0], second));
    take(1.0, nearest_on_segment(first[1], second));
    take(nearest_on_segment(second[0], first), 0.0);
    take(nearest_on_segment(second[1], first), 1.0);
    // Where segments are parallel but for rounding, the line between tells nothing, and ends are as near.
    if is_on(one) && is_on(other) {
        take(one, other);
    }
    best.0
}

/// How far apart two triangles are for sure.
#[derive(Debug, Clone, Copy)]
pub struct Separation {
    /// A lower bound of their distance.
    pub least: f64,
    /// Whether one of them is on one side of the plane of the other.
    pub is_by_plane: bool,
}

/// A lower bound of the distance of two triangles with these unit normals, where they may be no farther apart than `within`: as
/// far as one is from the plane of the other, and beyond a side of it (separating axes; Gottschalk and others, "OBBTree", 1996).
#[inline]
pub fn separation(triangles: [&Triangle; 2], normals: [DVec3; 2], within: f64) -> Option<Separation> {
    let mut heights = [0.0; 2];
    for of in 0..2 {
        let (least, most) = range(triangles[1 - of], normals[of], triangles[of][0]);
        let height = if least > -most { least } else { -most };
        if height > within {
            return None;
        }
        heights[of] = if height > 0.0 { height } else { 0.0 };
    }
    let most = within * within * ROUNDED;
    let [first, second] = triangles;
    let least = beyond_sides(first, normals[0], second, heights[0] * heights[0], most)?;
    let other = beyond_sides(second, normals[1], first, heights[1] * heights[1], most)?;
    let squared = if least > other { least } else { other };
    Some(Separation { least: squared.sqrt(), is_by_plane: heights != [0.0; 2] })
}

/// The square of how far a triangle is for sure from another one, given the square of its height above that one's plane: how far it
/// is beyond a side, too. `None` where that is more than `most`.
#[inline(always)]
fn beyond_sides([a, b, c]: &Triangle, normal: DVec3, other: &Triangle, height: f64, most: f64) -> Option<f64> {
    let middle = other[0] + other[1] + other[2];
    let first = beyond_side([*a, *b], normal, other, middle, height);
    if first > most {
        return None;
    }
    let second = beyond_side([*b, *c], normal, other, middle, height);
    if second > most {
        return None;
    }
    let third = beyond_side([*c, *a], normal, other, middle, height);
    let squared = if first > second { first } else { second };
    let squared = if third > squared { third } else { squared };
    (squared <= most).then_some(squared)
}

/// The same for one side. `middle`: that of the other triangle, three times.
#[inline(always)]
fn beyond_side([start, end]: [DVec3; 2], normal: DVec3, other: &Triangle, middle: DVec3, height: f64) -> f64 {
    let outward = (end - start).cross(normal);
    // What is beyond a side has its middle there.
    if outward.dot(middle - 3.0 * start) <= 0.0 {
        return height;
    }
    let (beyond, _) = range(other, outward, start);
    // The normal is at right angles to what leads out of the side in the plane.
    if beyond > 0.0 { height + beyond * beyond / outward.length_squared() } else { height }
}

/// The least and the greatest coordinate of a triangle's corners along an axis from an origin.
#[inline]
fn range([a, b, c]: &Triangle, axis: DVec3, origin: DVec3) -> (f64, f64) {
    let along = |corner: DVec3| axis.dot(corner - origin);
    let (a, b, c) = (along(*a), along(*b), along(*c));
    let (least, most) = if a < b { (a, b) } else { (b, a) };
    (if c < least { c } else { least }, if c > most { c } else { most })
}

/// Whether the planes of triangles with these unit normals are at an angle of more than 30°.
pub fn are_steep([first, second]: [DVec3; 2]) -> bool {
    first.dot(second).abs() < STEEP
}

/// The nearest points of two triangles that do not cross, where they are no farther apart than `within`, of those that are at
/// these features. Any that are no farther apart than `enough` will do.
pub fn nearest(triangles: &[Triangle; 2], features: [Features; 2], within: f64, enough: f64) -> Option<Pair> {
    let mut best = None;
    let mut take = |pair: Pair| {
        best = Some(pair);
        if pair.distance <= enough { f64::NEG_INFINITY } else { pair.distance }
    };
    let within = for_corners(triangles, features.map(|own| own.corners), within, &mut take);
    if within >= 0.0 {
        for_sides(triangles, features.map(|own| own.sides), within, true, &mut take);
    }
    best
}

/// Shows each of these corners of one with the nearest point of the other, where these are no farther apart than `within`, which
/// becomes what `found` says, and in the end is given back.
#[inline]
fn for_corners(
    triangles: &[Triangle; 2],
    which: [[bool; 3]; 2],
    mut within: f64,
    found: &mut impl FnMut(Pair) -> f64,
) -> f64 {
    for of in (0..2).filter(|&of| which[of] != [false; 3]) {
        let (triangle, other) = (&triangles[of], &triangles[1 - of]);
        let around = Bounds::of_points(*other);
        let normal = area_vector(*other);
        let squared = normal.length_squared();
        for k in (0..3).filter(|&k| which[of][k]) {
            let corner = triangle[k];
            let height = normal.dot(corner - other[0]);
            let is_far = height * height > within * within * squared
                || around.squared_distance(Bounds::at(corner)) > within * within;
            if within < 0.0 || is_far {
                continue;
            }
            let mut own = [0.0; 3];
            own[k] = 1.0;
            let others = nearest_on_triangle(corner, other, normal);
            let pair = Pair::new(triangles, if of == 0 { [own, others] } else { [others, own] });
            if pair.distance <= within {
                within = found(pair);
            }
        }
    }
    within
}

/// The same with the nearest points of each of these sides of one and each of the other; without ends of sides unless `with_ends`.
#[inline]
fn for_sides(
    triangles: &[Triangle; 2],
    which: [[bool; 3]; 2],
    mut within: f64,
    with_ends: bool,
    found: &mut impl FnMut(Pair) -> f64,
) {
    if which.contains(&[false; 3]) {
        return;
    }
    let [triangle, other_triangle] = triangles;
    let of_side = |k: usize| Bounds::of_points(side(other_triangle, k));
    let boxes = [of_side(0), of_side(1), of_side(2)];
    for i in (0..3).filter(|&i| which[0][i]) {
        let own = side(triangle, i);
        let own_box = Bounds::of_points(own);
        for j in (0..3).filter(|&j| which[1][j]) {
            if within < 0.0 || own_box.squared_distance(boxes[j]) > within * within {
                continue;
            }
            let other = side(other_triangle, j);
            let Some(perpendicular) = common_perpendicular(own, other, within) else { continue };
            if !with_ends && !perpendicular.into_iter().all(is_on) {
                continue;
            }
            let [first, second] = nearest_on_segments(own, other, perpendicular);
            let pair = Pair::new(triangles, [on_side(i, first), on_side(j, second)]);
            if pair.distance <= within {
                within = found(pair);
            }
        }
    }
}

/// The ends of the segment in which two triangles cross; `None` where they do not, or lie in one plane.
pub fn crossing(triangles: &[Triangle; 2]) -> Option<[Weights; 2]> {
    let mut first: Option<Weights> = None;
    let mut ends: Option<[Weights; 2]> = None;
    let mut longest = -1.0;
    for of in 0..2 {
        let (triangle, other) = (&triangles[of], &triangles[1 - of]);
        let normal = area_vector(*other);
        let heights = triangle.map(|corner| normal.dot(corner - other[0]));
        for k in 0..3 {
            let [start, end] = [heights[k], heights[(k + 1) % 3]];
            if (start > 0.0) == (end > 0.0) {
                continue;
            }
            let own = on_side(k, start / (start - end));
            let Some(others) = weights_inside(point(triangle, own), other, normal) else { continue };
            let weights = if of == 0 { [own, others] } else { [others, own] };
            let from = *first.get_or_insert(weights);
            let length = point(&triangles[0], from[0]).distance_squared(point(&triangles[0], weights[0]));
            // All ends lie on one line, and there are two of them: the one that is farthest from the first is the other.
            if length > longest {
                longest = length;
                ends = Some([from, weights]);
            }
        }
    }
    ends
}

/// Weights of a point of the plane of a triangle, where it is inside. `normal`: twice the area, along the unit normal.
#[inline]
fn weights_inside(point: DVec3, [a, b, c]: &Triangle, normal: DVec3) -> Option<[f64; 3]> {
    let to = [*a - point, *b - point, *c - point];
    let mut areas = [0.0; 3];
    for k in 0..3 {
        areas[k] = normal.dot(to[(k + 1) % 3].cross(to[(k + 2) % 3]));
        if areas[k] < 0.0 {
            return None;
        }
    }
    let sum = areas[0] + areas[1] + areas[2];
    (sum > 0.0).then(|| areas.map(|area| area / sum))
}

/// The point at this share of the way between two points of the triangles.
pub fn between([start, end]: &[Weights; 2], share: f64) -> Weights {
    let mix = |of: usize, k: usize| start[of][k] * (1.0 - share) + end[of][k] * share;
    [0, 1].map(|of| [0, 1, 2].map(|k| mix(of, k)))
}

/// Points spread over the places where two triangles, the smaller first, are no farther apart than a tolerance: corners and
/// crossings of sides, points at the spacing on sides where a surface ends or bends, and points inside. Returns how many points on
/// sides and inside were tried.
pub fn spread(
    triangles: &[Triangle; 2],
    features: [Features; 2],
    tolerance: f64,
    spacing: f64,
    found: &mut impl FnMut(Pair),
) -> usize {
    let mut tried = 0;
    for_corners(triangles, features.map(|own| own.corners), tolerance, &mut |pair| {
        found(pair);
        tolerance
    });
    // At the end of a side the corner tells the same.
    for_sides(triangles, features.map(|own| own.sides), tolerance, false, &mut |pair| {
        if pair.weights.iter().all(|weights| weights.iter().all(|&weight| weight < 1.0)) {
            found(pair);
        }
        tolerance
    });
    for of in 0..2 {
        let (triangle, other) = (&triangles[of], &triangles[1 - of]);
        let near = Bounds::of_points(*other).grown(DVec3::splat(tolerance));
        let normal = area_vector(*other);
        let mut take_own = |own: [f64; 3]| {
            tried += 1;
            let place = point(triangle, own);
            if near.holds(place) {
                let others = nearest_on_triangle(place, other, normal);
                let pair = Pair::new(triangles, if of == 0 { [own, others] } else { [others, own] });
                if pair.distance <= tolerance {
                    found(pair);
                }
            }
        };
        for k in (0..3).filter(|&k| features[of].rims[k]) {
            let [start, end] = side(triangle, k);
            let Some([enters, leaves]) = near.clip([start, end]) else { continue };
            let length = start.distance(end) * (leaves - enters);
            let cuts = (length / spacing).ceil().clamp(1.0, MOST_CUTS) as u32;
            for cut in 0..=cuts {
                take_own(on_side(k, enters + (leaves - enters) * f64::from(cut) / f64::from(cuts)));
            }
        }
        if of == 0 {
            let cuts = (longest_side(triangle) / (INNER_SPACING * spacing)).ceil().min(MOST_INNER_CUTS) as u32;
            for i in 0..cuts {
                let row = cuts - i;
                let at = |j: u32| [i, j, row - j].map(|part| f64::from(part) / f64::from(cuts));
                let Some([enters, leaves]) = near.clip([0, row].map(|j| point(triangle, at(j)))) else { continue };
                // The corners are taken already.
                let first = ((enters * f64::from(row)).floor() as u32).max(u32::from(i == 0));
                let last = ((leaves * f64::from(row)).ceil() as u32).min(row - u32::from(i == 0));
                (first..=last).for_each(|j| take_own(at(j)));
            }
        }
    }
    tried
}
