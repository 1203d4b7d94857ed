//! The way of a window across a face.

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
    pub fn to_left(&self, [base, _, left]: [&Side; 3]) -> Option<Beam> {
        let Self { beam, begins, ends, .. } = self;
        if *begins >= 0.0 {
            return None;
        }
        let (cos, sin) = (base.cos, base.sin);
        let hit = |at: f64| hit(at, at - beam.x, beam.depth, [cos, -sin], left.length);
        let (x, depth) = (beam.x * cos - beam.depth * sin, beam.x * sin + beam.depth * cos);
        let end = if *ends >= 0.0 { left.length } else { hit(beam.end) };
        Some(Beam { begin: hit(beam.begin), end, x, depth, ..*beam })
    }

    /// What leaves by the edge at the half-edge's end, as the half-edge across that edge sees it. `sides` are those that
    /// it [sees](super::geometry::Frame::seen_from).
    #[inline]
    pub fn to_right(&self, [base, right, _]: [&Side; 3]) -> Option<Beam> {
        let Self { beam, begins, ends, .. } = self;
        if *ends <= 0.0 {
            return None;
        }
        let (along, cos, sin) = (right.length, right.cos, right.sin);
        let hit = |at: f64| along - hit(base.length - at, at - beam.x, beam.depth, [cos, sin], along);
        let from_end = base.length - beam.x;
        let (x, depth) = (along - (from_end * cos - beam.depth * sin), from_end * sin + beam.depth * cos);
        let begin = if *begins <= 0.0 { 0.0 } else { hit(beam.begin) };
        Some(Beam { begin, end: hit(beam.end), x, depth, ..*beam })
    }
}

/// How far from the common end of two edges a ray meets the second, of length `along`. It leaves the first at `at`
/// from that end, with `forward` along the first edge's half-edge and `up` into the face; `sin` is negative where the end
/// is the half-edge's first.
fn hit(at: f64, forward: f64, up: f64, [cos, sin]: [f64; 2], along: f64) -> f64 {
    let towards = cos * up + sin * forward;
    if towards > 0.0 { smaller(at * up / towards, along) } else { along }
}
