//! Which parts of a surface are behind others in a picture.

use std::ops::Range;

use glam::{DVec2, DVec3};

/// Share of the depth of a picture, −1 to 1, by which a triangle must be nearer than a point to hide it: a point on a triangle is
/// off its plane by rounding.
const NEARER: f64 = 1e-6;

/// Depth by pixel of planes that are steeper is not used.
const STEEPEST: f64 = 100.0;

/// Depth by which a plane may seem farther than it is: far above the rounding of thousands of pixels on the steepest, far below
/// [`NEARER`].
const ROUNDING: f64 = 1e-9;

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
    /// Each after those of its halves; empty without triangles.
    nodes: Vec<Node>,
}

/// Some triangles and the box around them.
struct Node {
    /// Unit vector along the box.
    axis: DVec2,
    /// Along the axis and square to it.
    low: DVec2,
    high: DVec2,
    /// Below it are all triangles, each of them as far as it goes.
    above: Plane,
    pile: Option<Box<Pile>>,
    triangles: Range<usize>,
    /// The node of the first half, the second half's being the one before this; none for a leaf.
    half: Option<usize>,
}

/// Triangles of a leaf, at most.
const LEAF: usize = 4;

/// Triangles are piled up where their areas are more than so many times that of their box: points there are in as many triangles, or
/// beside all of them but in the box.
const PILED: f64 = 4.0;

impl Node {
    /// `longest`: of the sides; `half`: the node of the first half.
    fn around(corners: &[[DVec3; 3]], triangles: Range<usize>, longest: DVec2, half: Option<usize>) -> Self {
        let axis = longest.try_normalize().unwrap_or(DVec2::X);
        let slope = corners.get(corners.len() / 2).and_then(slope).unwrap_or_default();
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (mut offset, mut areas) = (f64::NEG_INFINITY, 0.0);
        for triangle in corners {
            for corner in triangle {
                let at = along(axis, *corner);
                (low, high, offset) = (low.min(at), high.max(at), offset.max(corner.z - slope.dot(corner.truncate())));
            }
            areas += 0.5 * twice_area(triangle).abs();
        }
        let is_piled = corners.len() > LEAF && areas > PILED * (high - low).element_product();
        let pile = is_piled.then(|| Box::new(Pile::of(corners)));
        Self { axis, low, high, above: Plane { slope, offset }, pile, triangles, half }
    }

    /// Whether one of its triangles may be before a point.
    fn may_hide(&self, point: DVec3) -> bool {
        let at = along(self.axis, point);
        self.above.is_before(point)
            && at.cmpge(self.low).all()
            && at.cmple(self.high).all()
            && self.pile.as_ref().is_none_or(|pile| pile.may_hide(point))
    }
}

/// A plane that is not seen from its side.
struct Plane {
    /// Depth by pixel.
    slope: DVec2,
    /// Depth at the origin.
    offset: f64,
}

impl Plane {
    /// Whether it is nearer than a point by as much as hides that, but for rounding.
    fn is_before(&self, point: DVec3) -> bool {
        self.offset + self.slope.dot(point.truncate()) > point.z + NEARER - ROUNDING
    }
}

/// What bounds triangles that lie one above another more closely than a box.
struct Pile {
    /// Across each side of the triangle in the middle of their list, away from it, and how far the triangles go there.
    sides: [(DVec2, f64); 3],
    /// Below it are all triangles that have a corner or two in common, where they have these.
    hinge: Option<Plane>,
}

impl Pile {
    fn of(corners: &[[DVec3; 3]]) -> Self {
        let mut sides = outward(&corners[corners.len() / 2]).map(|out| (out, f64::NEG_INFINITY));
        for corner in corners.iter().flatten() {
            for (out, reach) in &mut sides {
                *reach = reach.max(out.dot(corner.truncate()));
            }
        }
        Self { sides, hinge: hinge(corners) }
    }

    fn may_hide(&self, point: DVec3) -> bool {
        self.sides.iter().all(|&(out, reach)| out.dot(point.truncate()) <= reach)
            && self.hinge.as_ref().is_none_or(|plane| plane.is_before(point))
    }
}

/// The steepest of the planes of triangles that have a corner or a side in common and lie on one side of it. Near it, all are near that
/// plane, which goes through it.
fn hinge(corners: &[[DVec3; 3]]) -> Option<Plane> {
    let middle = &corners[corners.len() / 2];
    let is_common = |corner: &DVec3| corners.iter().all(|triangle| triangle.contains(corner));
    let common: Vec<DVec3> = middle.iter().copied().filter(is_common).collect();
    let pivot = *common.first()?;
    let from_pivot = |corner: DVec3| corner - pivot;
    let (slope, inward) = match common[1..] {
        [] => (slope(middle)?, middle.iter().copied().map(from_pivot).sum::<DVec3>().truncate()),
        [other, ..] => {
            let third = middle.iter().find(|corner| !common.contains(corner))?;
            let (side, across) = (from_pivot(other), from_pivot(other).truncate().perp());
            let along = side.truncate() * (side.z / across.length_squared());
            (along, across * across.dot(from_pivot(*third).truncate()).signum())
        }
    };
    let mut steeper = f64::NEG_INFINITY;
    for &corner in corners.iter().flatten().filter(|corner| !common.contains(corner)) {
        let from = from_pivot(corner);
        let depth = inward.dot(from.truncate());
        if depth <= 0.0 {
            return None;
        }
        steeper = steeper.max((from.z - slope.dot(from.truncate())) / depth);
    }
    let slope = Some(slope + steeper * inward).filter(is_flat)?;
    Some(Plane { slope, offset: pivot.z - slope.dot(pivot.truncate()) })
}

fn is_flat(slope: &DVec2) -> bool {
    slope.length() < STEEPEST
}

/// How the depth of a triangle changes in the picture; none where that is steep.
fn slope([a, b, c]: &[DVec3; 3]) -> Option<DVec2> {
    let normal = (*b - *a).cross(*c - *a);
    Some(-normal.truncate() / normal.z).filter(is_flat)
}

/// Of a triangle in the picture, positive where its corners go around from X to Y.
fn twice_area([a, b, c]: &[DVec3; 3]) -> f64 {
    (*b - *a).truncate().perp_dot((*c - *a).truncate())
}

/// Across the sides of a triangle in the picture, away from it; of any length.
fn outward(corners: &[DVec3; 3]) -> [DVec2; 3] {
    let turn = -twice_area(corners).signum();
    sides(corners).map(|side| turn * side.perp())
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
            // As if the picture were as deep as it is wide or high.
            let extent = extent(corners.iter().flatten().copied());
            let pixels = if extent.z > 0.0 { extent.truncate().max_element() / extent.z } else { 0.0 };
            add(&mut nodes, &mut corners, 0, pixels);
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
        let mut open: Vec<usize> = self.nodes.len().checked_sub(1).into_iter().collect();
        while let Some(index) = open.pop() {
            let node = &self.nodes[index];
            if !node.may_hide(point) {
                continue;
            }
            match node.half {
                Some(half) => open.extend([index - 1, half]),
                None if self.corners[node.triangles.clone()].iter().any(&mut is_true) => return true,
                None => {}
            }
        }
        false
    }
}

/// Adds the nodes of the halves of some triangles, the first of which has this number, and then their own. Returns the longest side.
fn add(nodes: &mut Vec<Node>, corners: &mut [[DVec3; 3]], first: usize, pixels: f64) -> DVec2 {
    let (longest, half) = if corners.len() > LEAF {
        let (before, after) = halves(corners, pixels);
        let middle = first + before.len();
        let longest = add(nodes, before, first, pixels);
        let half = nodes.len() - 1;
        (longer([longest, add(nodes, after, middle, pixels)]), Some(half))
    } else {
        (longer(corners.iter().flat_map(sides)), None)
    };
    nodes.push(Node::around(corners, first..first + corners.len(), longest, half));
    longest
}

/// Parts triangles by where their middles are, in the picture or in depth, which is `pixels` for each of its unit.
fn halves(corners: &mut [[DVec3; 3]], pixels: f64) -> (&mut [[DVec3; 3]], &mut [[DVec3; 3]]) {
    let scale = DVec3::new(1.0, 1.0, pixels);
    let place = |[a, b, c]: &[DVec3; 3]| (*a + *b + *c) * scale;
    let axis = DVec3::AXES[extent(corners.iter().map(place)).max_position()];
    let middle = corners.len() / 2;
    corners.select_nth_unstable_by(middle, |a, b| axis.dot(place(a)).total_cmp(&axis.dot(place(b))));
    corners.split_at_mut(middle)
}

fn extent(points: impl Iterator<Item = DVec3> + Clone) -> DVec3 {
    points.clone().fold(DVec3::NEG_INFINITY, DVec3::max) - points.fold(DVec3::INFINITY, DVec3::min)
}

fn sides(corners: &[DVec3; 3]) -> [DVec2; 3] {
    let [a, b, c] = corners.map(DVec3::truncate);
    [b - a, c - b, a - c]
}

fn longer(sides: impl IntoIterator<Item = DVec2>) -> DVec2 {
    sides.into_iter().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared())).unwrap_or_default()
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

    /// Triangles on one side, all around it, seen from above.
    fn book_from_above(count: usize) -> Vec<[DVec3; 3]> {
        let tip = |index: usize| {
            let (y, x) = (TAU * index as f64 / count as f64).sin_cos();
            DVec3::new(500.0 + 400.0 * x, 500.0 + 250.0 * y, 0.8 * y)
        };
        let spine = [DVec3::new(500.0, 800.0, -0.3), DVec3::new(500.0, 200.0, 0.3)];
        (0..count).map(|index| [spine[0], spine[1], tip(index)]).collect()
    }

    /// Triangles one above another, each a little lower in the picture than the one before.
    fn stack(count: usize) -> Vec<[DVec3; 3]> {
        let shift = |index: usize| DVec3::new(0.0, -300.0, 1.0) * (index as f64 / count as f64);
        let first = [DVec3::new(500.0, 900.0, 0.0), DVec3::new(900.0, 800.0, 0.0), DVec3::new(100.0, 800.0, 0.0)];
        (0..count).map(|index| first.map(|corner| corner + shift(index))).collect()
    }

    /// Triangles that are looked at for whether a place of one is hidden, on average.
    fn looked_at(corners: &[[DVec3; 3]]) -> f64 {
        let occluders = Occluders::new(corners.to_vec());
        let shares = [INSET, 0.3, 0.9];
        let mut count = 0;
        for [a, b, c] in corners {
            for share in shares {
                let place = (0.5 * *a + 0.5 * *b).lerp(*c, share);
                let hides = |triangle: &[DVec3; 3]| {
                    count += 1;
                    is_before(triangle, place)
                };
                let is_hidden = occluders.any(place, hides);
                assert_eq!(is_hidden, corners.iter().any(|triangle| is_before(triangle, place)));
            }
        }
        count as f64 / (shares.len() * corners.len()) as f64
    }

    #[test]
    fn what_is_looked_at_does_not_grow_with_the_triangles_around_a_point_or_a_side_or_in_a_stack() {
        for make in [fan, book, book_from_above, stack] {
            let [few, many] = [250, 4000].map(|count| looked_at(&make(count)));
            // With the power 0.3 of their number, as the bar for the whole says.
            assert!(many <= few.max(LEAF as f64) * 16_f64.powf(0.3), "{few} and {many}");
        }
    }
}
