//! Strips: what a straight segment of a curve lights by parallel rays, at a right angle to it. Distance along an edge is linear there
//! (Bommes & Kobbelt, "Accurate computation of geodesic distance fields for polygonal curves on triangle meshes", 2007).

use super::geometry::Side;
use super::overlap::zero;
use super::window::{Beam, GRAZE, length};
use crate::extremum::{larger, smaller};

/// A window that strips leave no more of than is seen under this angle, radians, is dropped: they reach what is there within [`GRAZE`].
const GAP: f64 = 2e-7;

/// An interval of a half-edge that a segment lights from behind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Strip {
    /// Where the interval begins and ends, along the half-edge.
    pub begin: f64,
    pub end: f64,
    /// Distance of the half-edge's begin by these rays.
    pub base: f64,
    /// Direction of the rays, of length 1: along the half-edge and into its face, the latter positive.
    pub along: f64,
    pub up: f64,
    /// The side of the segment.
    pub root: u32,
}

impl Strip {
    /// Distance of the position `x` of the half-edge.
    pub fn at(&self, x: f64) -> f64 {
        self.base + self.along * x
    }

    /// The least distance in the interval.
    pub fn nearest(&self) -> f64 {
        smaller(self.at(self.begin), self.at(self.end))
    }

    /// Where the segment lies that lights the position `x`, as a source would: along the half-edge, and behind it.
    pub fn foot(&self, x: f64) -> [f64; 2] {
        let distance = self.at(x);
        [x - self.along * distance, self.up * distance]
    }

    /// The same for a part of the interval.
    fn part(&self, begin: f64, end: f64) -> Self {
        Self { begin, end, ..*self }
    }

    /// The same on a half-edge in the opposite direction.
    pub fn mirrored(self, length: f64) -> Self {
        let (begin, end) = (length - self.end, length - self.begin);
        Self { begin, end, base: self.at(length), along: -self.along, ..self }
    }

    /// Whether it is broader than rounding. Also false where something is not a number.
    pub fn is_wide(&self, grain: f64) -> bool {
        (self.end - self.begin) * self.up > grain
    }

    /// Cuts off what is farther than by way of the half-edge's ends, whose distances are `limit`. Returns whether anything is left.
    pub fn clip(&mut self, length: f64, limit: [f64; 2], grain: f64) -> bool {
        if self.at(self.begin) > limit[0] + self.begin {
            self.begin = larger(self.begin, (self.base - limit[0]) / (1.0 - self.along));
        }
        if self.at(self.end) > limit[1] + (length - self.end) {
            self.end = smaller(self.end, (limit[1] + length - self.base) / (1.0 + self.along));
        }
        self.is_wide(grain)
    }

    /// Where the ray to a place above the half-edge crosses that, and where it does so within the interval, if it misses that by no
    /// more than rounding; with the distance of the place.
    pub fn sees(&self, [x, y]: [f64; 2], grain: f64) -> Option<(f64, f64)> {
        let crosses = self.splits([x, y]);
        let at = smaller(larger(crosses, self.begin), self.end);
        let value = self.at(at) + length(x - at, y);
        ((crosses - at).abs() * self.up <= GRAZE * value + grain).then_some((at, value))
    }

    /// Where the ray to a place above the half-edge crosses the half-edge's line.
    fn splits(&self, [x, y]: [f64; 2]) -> f64 {
        x - y * self.along / self.up
    }

    /// What leaves a face by the edges at the half-edge's begin and at its end, as the half-edges across these see it. `sides` are those
    /// that the half-edge [sees](super::geometry::Frame::seen_from), `opposite` its opposite corner.
    pub fn exits(&self, [base, right, left]: [&Side; 3], opposite: [f64; 2]) -> [Option<Self>; 2] {
        let split = self.splits(opposite);
        // From the corner that both edges share.
        let hit = |from_corner: f64, up: f64, edge: f64| smaller(from_corner * self.up / up, edge);
        let to_left = || {
            let (along, up) = turned([self.along, self.up], base);
            let end = if self.end < split { hit(self.end, up, left.length) } else { left.length };
            (up > 0.0).then(|| Self { begin: hit(self.begin, up, left.length), end, along, up, ..*self })
        };
        let to_right = || {
            let (back, up) = turned([-self.along, self.up], right);
            let place = |at: f64| right.length - hit(base.length - at, up, right.length);
            let begin = if self.begin > split { place(self.begin) } else { 0.0 };
            let base = self.at(base.length) + back * right.length;
            (up > 0.0).then(|| Self { begin, end: place(self.end), base, along: -back, up, ..*self })
        };
        [(self.begin < split).then(to_left).flatten(), (self.end > split).then(to_right).flatten()]
    }
}

/// A direction as the edge at a corner sees it, which leaves the corner at its angle.
fn turned([along, up]: [f64; 2], corner: &Side) -> (f64, f64) {
    (along * corner.cos + up * corner.sin, up * corner.cos - along * corner.sin)
}

/// Of strips in any order, what each reaches sooner than all others, in order along the half-edge.
pub(super) fn nearest_of(strips: &[Strip]) -> Vec<Strip> {
    match strips {
        [] | [_] => strips.to_vec(),
        _ => {
            let [first, second] = [&strips[..strips.len() / 2], &strips[strips.len() / 2..]].map(nearest_of);
            merged(&first, &second)
        }
    }
}

/// The same of two lists that are so.
pub(super) fn merged(first: &[Strip], second: &[Strip]) -> Vec<Strip> {
    let mut nearest: Vec<Strip> = Vec::with_capacity(first.len() + second.len());
    let mut rest = [first, second].map(|list| list.iter().copied());
    let mut heads = rest.each_mut().map(Iterator::next);
    while let [Some(one), Some(other)] = heads {
        let sooner = usize::from(other.begin < one.begin);
        let [one, other] = if sooner == 0 { [one, other] } else { [other, one] };
        let (from, to) = (smaller(other.begin, one.end), smaller(one.end, other.end));
        push(&mut nearest, one.part(one.begin, from));
        if from < to {
            let leads = [from, to].map(|x| one.at(x) - other.at(x));
            let change = from + (to - from) * larger(0.0, smaller(leads[0] / (leads[0] - leads[1]), 1.0));
            let (a, b) = if leads[0] <= 0.0 { (one, other) } else { (other, one) };
            let change = if (leads[0] <= 0.0) == (leads[1] <= 0.0) { to } else { change };
            push(&mut nearest, a.part(from, change));
            push(&mut nearest, b.part(change, to));
        }
        let left = |strip: Strip| Some(strip.part(larger(strip.begin, to), strip.end)).filter(|left| left.begin < left.end);
        let others = 1 - sooner;
        heads[sooner] = left(one).or_else(|| rest[sooner].next());
        if from < to {
            heads[others] = left(other).or_else(|| rest[others].next());
        }
    }
    for (head, rest) in heads.into_iter().zip(rest) {
        head.into_iter().chain(rest).for_each(|strip| push(&mut nearest, strip));
    }
    nearest
}

/// Appends a strip, or what it goes on with.
fn push(list: &mut Vec<Strip>, strip: Strip) {
    if strip.begin >= strip.end {
        return;
    }
    match list.last_mut().filter(|last| last.part(strip.begin, strip.end) == strip && last.end == strip.begin) {
        Some(last) => last.end = strip.end,
        None => list.push(strip),
    }
}

/// Leaves of the strips and the windows of one half-edge, each in order along it, what is not farther than the other.
pub(super) fn settle(strips: &mut Vec<Strip>, beams: &mut Vec<Beam>) {
    let (all, windows) = (std::mem::take(strips), std::mem::take(beams));
    let pieces = |from: f64, to: f64, lost: &[(f64, f64)], keep: &mut dyn FnMut(f64, f64)| {
        let mut begin = from;
        for &(first, last) in lost {
            keep(begin, first);
            begin = larger(begin, last);
        }
        keep(begin, to);
    };
    let overlaps = |strip: &Strip, beam: &Beam| strip.begin < beam.end && beam.begin < strip.end;
    for strip in &all {
        let first = windows.partition_point(|beam| beam.end <= strip.begin);
        let beside = windows[first..].iter().take_while(|beam| overlaps(strip, beam));
        let lost: Vec<_> = beside.filter_map(|beam| Lead::new(strip, beam).of_beam()).collect();
        pieces(strip.begin, strip.end, &lost, &mut |begin, end| push(strips, strip.part(begin, end)));
    }
    for beam in &windows {
        let first = all.partition_point(|strip| strip.end <= beam.begin);
        let beside = all[first..].iter().take_while(|strip| overlaps(strip, beam));
        let lost: Vec<_> = beside.flat_map(|strip| Lead::new(strip, beam).of_strip()).flatten().collect();
        let least = if lost.is_empty() { 0.0 } else { GAP };
        pieces(beam.begin, beam.end, &lost, &mut |begin, end| {
            let part = beam.part(begin, end);
            if part.exceeds(least) {
                beams.push(part);
            }
        });
    }
}

/// A strip's distance less a window's, where both are: it rises to one maximum and falls from there.
struct Lead<'a> {
    strip: &'a Strip,
    beam: &'a Beam,
    begin: f64,
    end: f64,
    /// What is no more than rounding.
    rounding: f64,
}

impl<'a> Lead<'a> {
    fn new(strip: &'a Strip, beam: &'a Beam) -> Self {
        let (begin, end) = (larger(strip.begin, beam.begin), smaller(strip.end, beam.end));
        let rounding = 4.0 * f64::EPSILON * larger(beam.at(begin), beam.at(end)).abs();
        Self { strip, beam, begin, end, rounding }
    }

    fn at(&self, x: f64) -> f64 {
        self.strip.at(x) - self.beam.at(x)
    }

    /// Where the window is nearer, if anywhere.
    fn of_beam(&self) -> Option<(f64, f64)> {
        self.above(self.rounding)
    }

    /// Where the strip is nearer.
    fn of_strip(&self) -> [Option<(f64, f64)>; 2] {
        let before_and_after = |(from, to): (f64, f64)| [(self.begin, from), (to, self.end)];
        let lost = self.above(-self.rounding).map_or([(self.begin, self.end), (self.end, self.end)], before_and_after);
        lost.map(|(from, to)| (from < to).then_some((from, to)))
    }

    /// Where it is above a level.
    fn above(&self, level: f64) -> Option<(f64, f64)> {
        let lead = |x: f64| self.at(x) - level;
        let Self { strip, beam, begin, end, .. } = self;
        let ends = [(*begin, lead(*begin)), (*end, lead(*end))];
        let highest = beam.x + beam.depth * strip.along / strip.up;
        let highest = smaller(larger(highest, *begin), *end);
        let top = [(highest, lead(highest)), ends[0], ends[1]];
        let top = top.into_iter().find(|top| top.1 > 0.0)?;
        let bound = |end: (f64, f64)| if end.1 > 0.0 { end.0 } else { zero(lead, end, top, 0.5 * self.rounding) };
        Some((bound(ends[0]), bound(ends[1])))
    }
}
