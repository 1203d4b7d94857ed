//! The way of a window across a face.

use std::hint::select_unpredictable;

use super::geometry::Side;
use super::window::{Beam, GRAZE};
use crate::extremum::{larger, smaller};

/// A window that crosses a face, and how it lies to the ray to the opposite corner.
#[derive(Debug)]
pub(crate) struct Crossing {
    pub beam: Beam,
    /// The opposite corner as the source sees it, along the half-edge and away from it.
    aside: f64,
    height: f64,
    /// `height` times the place along the half-edge where the interval begins, and where it ends, less that of the ray.
    begins: f64,
    ends: f64,
}

impl Crossing {
    /// Into a face whose opposite corner is there.
    pub fn new(beam: Beam, opposite: [f64; 2]) -> Self {
        let (aside, height) = (opposite[0] - beam.x, opposite[1] + beam.depth);
        let from_ray = |at: f64| (at - beam.x) * height - aside * beam.depth;
        Self { aside, height, begins: from_ray(beam.begin), ends: from_ray(beam.end), beam }
    }

    /// Where the ray to the opposite corner crosses the half-edge's line.
    pub fn splits(&self) -> f64 {
        self.beam.x + self.aside * self.beam.depth / self.height
    }

    /// Whether the ray to the opposite corner misses the interval by no more than [`GRAZE`] of its length, roughly.
    pub fn sees_corner(&self) -> bool {
        larger(self.begins, -self.ends) <= GRAZE * self.height * (self.aside.abs() + self.height)
    }

    /// What leaves by the edge at the half-edge's begin, as the half-edge across that edge sees it. `sides` are those that
    /// it [sees](super::geometry::Frame::seen_from).
    #[inline]
    pub fn to_left(&self, sides: [&Side; 3]) -> Option<Beam> {
        let Self { beam, begins, ends, .. } = self;
        let hit = |at: f64| self.hit(at, left_of(sides, at));
        (*begins < 0.0).then(|| {
            let end = if *ends >= 0.0 { sides[2].length } else { hit(beam.end) };
            self.left(sides, hit(beam.begin), end)
        })
    }

    /// What leaves by the edge at the half-edge's end, as the half-edge across that edge sees it. `sides` are those that
    /// it [sees](super::geometry::Frame::seen_from).
    #[inline]
    pub fn to_right(&self, sides: [&Side; 3]) -> Option<Beam> {
        let Self { beam, begins, ends, .. } = self;
        let hit = |at: f64| sides[1].length - self.hit(at, right_of(sides, at));
        (*ends > 0.0).then(|| {
            let begin = if *begins <= 0.0 { 0.0 } else { hit(beam.begin) };
            self.right(sides, begin, hit(beam.end))
        })
    }

    /// Both of these, each with whether there is any, without a branch: for windows that come in no order, each of which
    /// takes its way by chance.
    #[inline(always)]
    pub fn exits(&self, sides: [&Side; 3]) -> [(bool, Beam); 2] {
        let Self { beam, begins, ends, .. } = self;
        let hit = |at: f64, is_left: bool| {
            let place = self.hit(at, select_unpredictable(is_left, left_of(sides, at), right_of(sides, at)));
            select_unpredictable(is_left, place, sides[1].length - place)
        };
        let (begin, end) = (hit(beam.begin, *begins < 0.0), hit(beam.end, *ends < 0.0));
        let to_left = self.left(sides, begin, select_unpredictable(*ends < 0.0, end, sides[2].length));
        let to_right = self.right(sides, select_unpredictable(*begins > 0.0, begin, 0.0), end);
        [(*begins < 0.0, to_left), (*ends > 0.0, to_right)]
    }

    /// The window on the edge at the half-edge's begin, between these places there.
    #[inline(always)]
    fn left(&self, [base, ..]: [&Side; 3], begin: f64, end: f64) -> Beam {
        let Beam { x, depth, .. } = self.beam;
        let (cos, sin) = (base.cos, base.sin);
        Beam { begin, end, x: x * cos - depth * sin, depth: x * sin + depth * cos, ..self.beam }
    }

    /// The window on the edge at the half-edge's end, between these places there.
    #[inline(always)]
    fn right(&self, [base, right, _]: [&Side; 3], begin: f64, end: f64) -> Beam {
        let (from_end, depth) = (base.length - self.beam.x, self.beam.depth);
        let (cos, sin) = (right.cos, right.sin);
        let x = right.length - (from_end * cos - depth * sin);
        Beam { begin, end, x, depth: from_end * sin + depth * cos, ..self.beam }
    }

    /// How far from its corner the ray through the place `at` of the half-edge meets an edge.
    #[inline(always)]
    fn hit(&self, at: f64, edge: Edge) -> f64 {
        let (forward, up) = (at - self.beam.x, self.beam.depth);
        let towards = edge.cos * up + edge.sin * forward;
        let place = smaller(edge.from_corner * up / towards, edge.length);
        select_unpredictable(towards > 0.0, place, edge.length)
    }
}

/// An edge as a ray meets it that leaves the half-edge at some place.
#[derive(Clone, Copy)]
struct Edge {
    /// How far from the common corner the ray leaves the half-edge.
    from_corner: f64,
    /// Cosine and sine of the angle at that corner; the sine negative where it is the half-edge's first.
    cos: f64,
    sin: f64,
    length: f64,
}

#[inline(always)]
fn left_of([base, _, left]: [&Side; 3], at: f64) -> Edge {
    Edge { from_corner: at, cos: base.cos, sin: -base.sin, length: left.length }
}

#[inline(always)]
fn right_of([base, right, _]: [&Side; 3], at: f64) -> Edge {
    Edge { from_corner: base.length - at, cos: right.cos, sin: right.sin, length: right.length }
}
