//! The way of a window across a face.

use std::hint::select_unpredictable;

use heatwalk_base::lanes::{Choice, Lanes};

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

    /// Whether the ray to the opposite corner misses the interval by no more than [`GRAZE`] of its length along the half-edge, roughly,
    /// and `grain` aside of it.
    pub fn sees_corner(&self, grain: f64) -> bool {
        larger(self.begins, -self.ends) <= (self.aside.abs() + self.height) * (GRAZE * self.height + grain)
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

    /// Both of these, without a branch: for windows that come in no order, each of which takes its way by chance.
    #[inline(always)]
    pub fn exits(&self, [base, right, left]: [&Side; 3]) -> Exits {
        let &Self { beam, begins, ends, .. } = self;
        let nothing = Lanes::both(0.0);
        let is_left = Lanes::new([begins, ends]).is_below(nothing);
        let pick = |of_left: f64, of_right: f64| is_left.choose(Lanes::both(of_left), Lanes::both(of_right));
        let (cos, sin) = (pick(base.cos, right.cos), pick(-base.sin, right.sin));
        let length = pick(left.length, right.length);
        let (at, up) = (Lanes::new([beam.begin, beam.end]), Lanes::both(beam.depth));
        let from_corner = is_left.choose(at, Lanes::both(base.length) - at);
        let towards = cos * up + sin * (at - Lanes::both(beam.x));
        let place = nothing.is_below(towards).choose(length.smaller(from_corner * up / towards), length);
        let [begin, end] = is_left.choose(place, Lanes::both(right.length) - place).to_array();

        let (cos, sin) = (Lanes::new([base.cos, right.cos]), Lanes::new([base.sin, right.sin]));
        let from_corner = Lanes::new([beam.x, base.length - beam.x]);
        let [along_left, along_right] = (from_corner * cos - up * sin).to_array();
        Exits {
            is_open: nothing.is_below(Lanes::new([-begins, ends])),
            begin: nothing.is_below(Lanes::new([-begins, begins])).choose(Lanes::both(begin), nothing),
            end: nothing.is_below(Lanes::new([-ends, ends])).choose(Lanes::both(end), Lanes::both(left.length)),
            x: Lanes::new([along_left, right.length - along_right]),
            depth: from_corner * sin + up * cos,
            offset: beam.offset,
            root: beam.root,
        }
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

/// What leaves a face by the edge at the half-edge's begin, and by that at its end, as the half-edges across these see it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exits {
    /// Whether there is any; the rest is of no meaning where there is none.
    pub is_open: Choice,
    begin: Lanes,
    end: Lanes,
    x: Lanes,
    depth: Lanes,
    offset: f64,
    root: u32,
}

impl Exits {
    /// The one at the half-edge's begin or end, `k` 0 or 1.
    #[inline(always)]
    pub fn beam(&self, k: usize) -> Beam {
        let [begin, end, x, depth] = [self.begin, self.end, self.x, self.depth].map(|lanes| lanes.to_array()[k]);
        Beam { begin, end, x, depth, offset: self.offset, root: self.root }
    }

    /// [`Beam::bent_at`] of both.
    #[inline(always)]
    pub fn bent_at(&self, x: Lanes) -> Lanes {
        let at = self.end.smaller(self.begin.larger(x));
        let aside = at - self.x;
        Lanes::both(self.offset) + (aside * aside + self.depth * self.depth).sqrt() + (x - at).abs()
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
