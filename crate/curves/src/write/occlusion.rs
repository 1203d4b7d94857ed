//! Which parts of a surface are behind others in a picture.

use std::ops::Range;

use glam::{DVec2, DVec3};

/// Share of the depth of a picture, −1 to 1, by which a triangle must be nearer than a point to hide it: a point on a triangle is
/// off its plane by rounding.
const NEARER: f64 = 1e-6;

/// Places along a segment that are looked at first; a part that is hidden between two of them is not seen as such.
const SAMPLES: usize = 5;

/// Share of a segment by which the outer ones are away from its ends, which lie on edges of triangles that may hide them.
const INSET: f64 = 1e-6;

/// Halvings of the stretch in which a segment goes out of sight: a thousandth of a stretch is far below a pixel.
const HALVINGS: usize = 10;

/// Triangles in a picture, halved again and again by where they are, with a box around each half. A box lies along the longest side
/// of its triangles, so that one around slivers is as thin as these.
pub(super) struct Occluders {
    /// Pixels, and depth toward the eye; those of a node in a row.
    corners: Vec<[DVec3; 3]>,
    /// Each before those of its halves; empty without triangles.
    nodes: Vec<Node>,
}

/// Some triangles and the box around them.
struct Node {
    /// Unit vector along the box.
    axis: DVec2,
    /// Along the axis and square to it.
    low: DVec2,
    high: DVec2,
    /// Of a plane like theirs, depth by pixel; 0 where that is steep.
    slope: DVec2,
    /// The largest depth above that plane through the origin.
    nearest: f64,
    triangles: Range<usize>,
    /// The node of the second half, the first half's being the next one; none for a leaf.
    second: Option<usize>,
}

/// Triangles of a leaf, at most.
const LEAF: usize = 4;

impl Node {
    fn around(corners: &[[DVec3; 3]], triangles: Range<usize>) -> Self {
        let sides = corners.iter().flat_map(|&[a, b, c]| [b - a, c - b, a - c]).map(DVec3::truncate);
        let longest = sides.max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
        let axis = longest.and_then(DVec2::try_normalize).unwrap_or(DVec2::X);
        let slope = corners.get(corners.len() / 2).map_or(DVec2::ZERO, slope);
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let mut nearest = f64::NEG_INFINITY;
        for corner in corners.iter().flatten() {
            let at = along(axis, *corner);
            (low, high, nearest) = (low.min(at), high.max(at), nearest.max(corner.z - slope.dot(corner.truncate())));
        }
        Self { axis, low, high, slope, nearest, triangles, second: None }
    }

    /// Whether one of its triangles may be before a point.
    fn may_hide(&self, point: DVec3) -> bool {
        let at = along(self.axis, point);
        self.nearest + self.slope.dot(point.truncate()) > point.z
            && at.cmpge(self.low).all()
            && at.cmple(self.high).all()
    }
}

/// Depth by pixel of planes that are steeper is not used: rounding of thousands of pixels times this is far below [`NEARER`].
const STEEPEST: f64 = 100.0;

/// How the depth of a triangle changes in the picture; 0 where that is steep.
fn slope([a, b, c]: &[DVec3; 3]) -> DVec2 {
    let normal = (*b - *a).cross(*c - *a);
    let slope = -normal.truncate() / normal.z;
    if slope.length() < STEEPEST { slope } else { DVec2::ZERO }
}

/// A point of the picture along an axis and square to it.
fn along(axis: DVec2, point: DVec3) -> DVec2 {
    DVec2::new(axis.dot(point.truncate()), axis.perp_dot(point.truncate()))
}

impl Occluders {
    /// Of corners in pixels, with their depth toward the eye.
    pub fn new(mut corners: Vec<[DVec3; 3]>) -> Self {
        let mut nodes = Vec::new();
        if !corners.is_empty() {
            add(&mut nodes, &mut corners, 0);
        }
        Self { corners, nodes }
    }

    /// The parts of a segment that nothing hides, as shares of it from its start.
    pub fn visible(&self, from: DVec3, to: DVec3) -> Vec<[f64; 2]> {
        let is_seen = |share: f64| !self.hides(from.lerp(to, share));
        let within = |share: f64| share.clamp(INSET, 1.0 - INSET);
        let shares: Vec<f64> = (0..SAMPLES).map(|index| within(index as f64 / (SAMPLES - 1) as f64)).collect();
        let seen: Vec<bool> = shares.iter().map(|&share| is_seen(share)).collect();
        let mut parts = Vec::new();
        let mut start = seen[0].then_some(0.0);
        for index in 1..SAMPLES {
            if seen[index] == seen[index - 1] {
                continue;
            }
            let [mut low, mut high] = [shares[index - 1], shares[index]];
            for _ in 0..HALVINGS {
                let middle = 0.5 * low + 0.5 * high;
                if is_seen(middle) == seen[index - 1] { low = middle } else { high = middle }
            }
            match start.take() {
                Some(start) => parts.push([start, low]),
                None => start = Some(high),
            }
        }
        parts.extend(start.map(|start| [start, 1.0]));
        parts
    }

    /// Whether a triangle is before a point.
    fn hides(&self, point: DVec3) -> bool {
        self.any(point, |corners| is_before(corners, point))
    }

    /// Whether something is true of a triangle that may be before a point.
    fn any(&self, point: DVec3, mut is_true: impl FnMut(&[DVec3; 3]) -> bool) -> bool {
        let mut open: Vec<usize> = self.nodes.first().map(|_| 0).into_iter().collect();
        while let Some(index) = open.pop() {
            let node = &self.nodes[index];
            if !node.may_hide(point) {
                continue;
            }
            match node.second {
                Some(second) => open.extend([second, index + 1]),
                None if self.corners[node.triangles.clone()].iter().any(&mut is_true) => return true,
                None => {}
            }
        }
        false
    }
}

/// Adds the node of some triangles, the first of which has this number, and those of its halves.
fn add(nodes: &mut Vec<Node>, corners: &mut [[DVec3; 3]], first: usize) {
    let own = nodes.len();
    nodes.push(Node::around(corners, first..first + corners.len()));
    if corners.len() <= LEAF {
        return;
    }
    let place = |[a, b, c]: &[DVec3; 3]| (*a + *b + *c).truncate();
    let low = corners.iter().map(place).fold(DVec2::INFINITY, DVec2::min);
    let high = corners.iter().map(place).fold(DVec2::NEG_INFINITY, DVec2::max);
    let axis = if (high - low).x > (high - low).y { DVec2::X } else { DVec2::Y };
    let middle = corners.len() / 2;
    corners.select_nth_unstable_by(middle, |a, b| axis.dot(place(a)).total_cmp(&axis.dot(place(b))));
    let (before, after) = corners.split_at_mut(middle);
    add(nodes, before, first);
    nodes[own].second = Some(nodes.len());
    add(nodes, after, first + middle);
}

/// Whether a triangle covers a point and is nearer to the eye there.
fn is_before(corners: &[DVec3; 3], point: DVec3) -> bool {
    let [a, b, c] = corners.map(|corner| corner.truncate() - point.truncate());
    let areas = [b.perp_dot(c), c.perp_dot(a), a.perp_dot(b)];
    let whole: f64 = areas.iter().sum();
    if whole == 0.0 || areas.iter().any(|&area| area * whole < 0.0) {
        return false;
    }
    let depth: f64 = corners.iter().zip(areas).map(|(corner, area)| corner.z * area / whole).sum();
    depth > point.z + NEARER
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    /// Triangles around a point, in a picture of a thousand pixels.
    fn fan(count: usize) -> Vec<[DVec3; 3]> {
        let rim = |index: usize| {
            let angle = TAU * index as f64 / count as f64;
            DVec3::new(500.0 + 400.0 * angle.cos(), 500.0 + 300.0 * angle.sin(), 0.0)
        };
        (0..count).map(|index| [DVec3::new(500.0, 500.0, 0.0), rim(index), rim(index + 1)]).collect()
    }

    /// Triangles on one side, each turned further around it, and so behind the one before.
    fn book(count: usize) -> Vec<[DVec3; 3]> {
        let tip = |index: usize| {
            let angle = 0.5 * TAU * index as f64 / count as f64;
            DVec3::new(500.0 + 400.0 * angle.cos(), 500.0, -angle.sin())
        };
        let spine = [DVec3::new(500.0, 900.0, 0.0), DVec3::new(500.0, 100.0, 0.0)];
        (0..count).map(|index| [spine[0], spine[1], tip(index)]).collect()
    }

    /// Triangles that are looked at for whether the middle of one is hidden, on average.
    fn looked_at(corners: &[[DVec3; 3]]) -> f64 {
        let occluders = Occluders::new(corners.to_vec());
        let mut count = 0;
        for [a, b, c] in corners {
            let middle = (*a + *b + *c) / 3.0;
            let hides = |triangle: &[DVec3; 3]| {
                count += 1;
                is_before(triangle, middle)
            };
            let is_hidden = occluders.any(middle, hides);
            assert_eq!(is_hidden, corners.iter().any(|triangle| is_before(triangle, middle)));
        }
        count as f64 / corners.len() as f64
    }

    #[test]
    fn what_is_looked_at_does_not_grow_with_the_triangles_around_a_point_or_a_side() {
        for make in [fan, book] {
            let [few, many] = [250, 4000].map(|count| looked_at(&make(count)));
            // With the power 0.3 of their number, as the bar for the whole says.
            assert!(many <= few.max(LEAF as f64) * 16_f64.powf(0.3), "{few} and {many}");
        }
    }
}
