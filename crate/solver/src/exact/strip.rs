//! Strips: what a straight segment of a curve lights by parallel rays, at a right angle to it. Distance along an edge is linear there
//! (Bommes & Kobbelt, "Accurate computation of geodesic distance fields for polygonal curves on triangle meshes", 2007).

use heatwalk_base::sort;

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
            let mut nearest = Vec::new();
            merge([&first, &second], &mut nearest);
            nearest
        }
    }
}

/// The same of two lists that are so. What `nearest` holds before is of no meaning, but its memory.
pub(super) fn merge(lists: [&[Strip]; 2], nearest: &mut Vec<Strip>) {
    nearest.clear();
    let mut rest = lists.map(|list| list.iter().copied());
    let mut heads = rest.each_mut().map(Iterator::next);
    while let [Some(one), Some(other)] = heads {
        let sooner = usize::from(other.begin < one.begin);
        let [one, other] = if sooner == 0 { [one, other] } else { [other, one] };
        let (from, to) = (smaller(other.begin, one.end), smaller(one.end, other.end));
        push(nearest, one.part(one.begin, from));
        if from < to {
            let leads = [from, to].map(|x| one.at(x) - other.at(x));
            let change = from + (to - from) * larger(0.0, smaller(leads[0] / (leads[0] - leads[1]), 1.0));
            let (a, b) = if leads[0] <= 0.0 { (one, other) } else { (other, one) };
            let change = if (leads[0] <= 0.0) == (leads[1] <= 0.0) { to } else { change };
            push(nearest, a.part(from, change));
            push(nearest, b.part(change, to));
        }
        let left =
            |strip: Strip| Some(strip.part(larger(strip.begin, to), strip.end)).filter(|left| left.begin < left.end);
        let others = 1 - sooner;
        heads[sooner] = left(one).or_else(|| rest[sooner].next());
        if from < to {
            heads[others] = left(other).or_else(|| rest[others].next());
        }
    }
    for (head, rest) in heads.into_iter().zip(rest) {
        head.into_iter().chain(rest).for_each(|strip| push(nearest, strip));
    }
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

/// What of strips and windows of one half-edge is farther than the others; kept for its memory.
#[derive(Debug, Default)]
pub(super) struct Lost {
    /// Intervals, each with the number of the strip.
    of_strips: Vec<(usize, f64, f64)>,
    /// The same of windows.
    of_beams: Vec<(usize, f64, f64)>,
    strips: Vec<Strip>,
    beams: Vec<Beam>,
}

impl Lost {
    /// Leaves of the strips and the windows of one half-edge, each in order along it, what is not farther than the other.
    pub fn settle(&mut self, strips: &mut Vec<Strip>, beams: &mut Vec<Beam>) {
        self.of_strips.clear();
        self.of_beams.clear();
        let mut first = 0;
        for (number, strip) in strips.iter().enumerate() {
            first += beams[first..].iter().take_while(|beam| beam.end <= strip.begin).count();
            for (beside, beam) in beams.iter().enumerate().skip(first).take_while(|(_, beam)| beam.begin < strip.end) {
                if beam.end > strip.begin {
                    let lead = Lead::new(strip, beam);
                    self.of_strips.extend(lead.above(lead.rounding).map(|(from, to)| (number, from, to)));
                    let [start, end] = [lead.begin.0, lead.end.0];
                    let (from, to) = lead.above(-lead.rounding).unwrap_or((end, end));
                    let parts = [(beside, start, from), (beside, to, end)];
                    self.of_beams.extend(parts.into_iter().filter(|part| part.1 < part.2));
                }
            }
        }
        if !self.of_strips.is_empty() {
            self.strips.clear();
            for_each_left(
                strips.iter().map(|strip| (strip.begin, strip.end)),
                &self.of_strips,
                |number, begin, end, _| {
                    push(&mut self.strips, strips[number].part(begin, end));
                },
            );
            std::mem::swap(strips, &mut self.strips);
        }
        if !self.of_beams.is_empty() {
            // Windows may overlap by slivers.
            sort::sort_by_key(&mut self.of_beams, |lost| lost.0);
            self.beams.clear();
            for_each_left(
                beams.iter().map(|beam| (beam.begin, beam.end)),
                &self.of_beams,
                |number, begin, end, is_whole| {
                    let part = beams[number].part(begin, end);
                    if is_whole || part.exceeds(GAP) {
                        self.beams.push(part);
                    }
                },
            );
            std::mem::swap(beams, &mut self.beams);
        }
    }
}

/// Tells what is left of intervals without others, which are in order by their numbers and along these, and whether it is a whole one.
fn for_each_left(
    intervals: impl Iterator<Item = (f64, f64)>,
    lost: &[(usize, f64, f64)],
    mut tell: impl FnMut(usize, f64, f64, bool),
) {
    let mut lost = lost.iter().peekable();
    for (number, (begin, end)) in intervals.enumerate() {
        let mut from = begin;
        let mut is_whole = true;
        while let Some(&(_, first, last)) = lost.next_if(|lost| lost.0 == number) {
            is_whole = false;
            if first > from {
                tell(number, from, first, is_whole);
            }
            from = larger(from, last);
        }
        if end > from {
            tell(number, from, end, is_whole);
        }
    }
}

/// A strip's distance less a window's, where both are: it rises to one maximum and falls from there.
struct Lead<'a> {
    strip: &'a Strip,
    beam: &'a Beam,
    /// Where both begin and end, with the lead there.
    begin: (f64, f64),
    end: (f64, f64),
    /// What is no more than rounding.
    rounding: f64,
}

impl<'a> Lead<'a> {
    fn new(strip: &'a Strip, beam: &'a Beam) -> Self {
        let places = [larger(strip.begin, beam.begin), smaller(strip.end, beam.end)];
        let distances = places.map(|place| beam.at(place));
        let [begin, end] = [0, 1].map(|k| (places[k], strip.at(places[k]) - distances[k]));
        let rounding = 4.0 * f64::EPSILON * larger(distances[0], distances[1]).abs();
        Self { strip, beam, begin, end, rounding }
    }

    /// Where it is above a level.
    fn above(&self, level: f64) -> Option<(f64, f64)> {
        let Self { strip, beam, begin, end, .. } = self;
        let lead = |x: f64| strip.at(x) - beam.at(x) - level;
        let ends = [(begin.0, begin.1 - level), (end.0, end.1 - level)];
        if ends[0].1 > 0.0 && ends[1].1 > 0.0 {
            return Some((begin.0, end.0));
        }
        let inside = || {
            let highest = beam.x + beam.depth * strip.along / strip.up;
            (highest > begin.0 && highest < end.0).then(|| (highest, lead(highest)))
        };
        let top = ends.into_iter().chain(inside()).find(|top| top.1 > 0.0)?;
        let [first, last] = self.meetings(level);
        let bound = |end: (f64, f64), meeting: f64| match lead(meeting).abs() <= self.rounding {
            _ if end.1 > 0.0 => end.0,
            true => smaller(larger(meeting, begin.0), self.end.0),
            false => zero(lead, end, top, 0.5 * self.rounding),
        };
        Some((bound(ends[0], first), bound(ends[1], last)))
    }

    /// Where it is at a level, if anywhere: the zeros of a quadratic polynomial.
    fn meetings(&self, level: f64) -> [f64; 2] {
        let Self { strip, beam, begin, .. } = self;
        // From where both begin.
        let (x, ahead) = (beam.x - begin.0, strip.at(begin.0) - beam.offset - level);
        let half = x + strip.along * ahead;
        let constant = x * x + beam.depth * beam.depth - ahead * ahead;
        let square = strip.up * strip.up;
        let root = half + larger(half * half - square * constant, 0.0).sqrt().copysign(half);
        let [one, other] = [root / square, constant / root];
        [begin.0 + smaller(one, other), begin.0 + larger(one, other)]
    }
}
