//! Two windows that overlap: each keeps what it reaches sooner.

use super::window::Beam;
use crate::extremum::{either, larger, smaller};

#[cfg(test)]
mod tests;

/// Two overlapping windows of one half-edge, and the first's distance less the second's where their overlap begins and
/// ends. A tie is the second's.
pub(super) struct Overlap<'a> {
    pub first: &'a Beam,
    pub second: &'a Beam,
    pub begin: (f64, f64),
    pub end: (f64, f64),
    /// The larger of the second's distances there.
    farther: f64,
}

/// Intervals of two windows in order, each with whether it is the first's. At most: one alone, three turns, one alone.
pub(super) struct Shares {
    shares: [(bool, f64, f64); 5],
    count: usize,
}

impl Shares {
    fn push(&mut self, is_first: bool, begin: f64, end: f64) {
        if self.count > 0 && self.shares[self.count - 1].0 == is_first {
            self.shares[self.count - 1].2 = end;
        } else if end > begin {
            self.shares[self.count] = (is_first, begin, end);
            self.count += 1;
        }
    }

    /// The intervals.
    pub fn as_slice(&self) -> &[(bool, f64, f64)] {
        &self.shares[..self.count]
    }
}

impl<'a> Overlap<'a> {
    pub fn new(first: &'a Beam, second: &'a Beam) -> Self {
        let ends = [larger(first.begin, second.begin), smaller(first.end, second.end)];
        let [of_first, of_second] = [first, second].map(|window| ends.map(|place| window.at(place)));
        let [begin, end] = [0, 1].map(|k| (ends[k], of_first[k] - of_second[k]));
        Self { first, second, begin, end, farther: larger(of_second[0], of_second[1]) }
    }

    /// The lead there.
    fn lead(&self, place: f64) -> f64 {
        self.first.at(place) - self.second.at(place)
    }

    /// Where one leads where the other does at begin and end, or may do so, since they are equal there but for rounding; and the
    /// lead there.
    ///
    /// The difference of two distances along a line has one extremum at most, in line with both sources, so that
    /// the lead changes twice at most.
    pub fn turn(&self) -> Option<(f64, f64)> {
        let (first, second) = (self.first, self.second);
        let (across, apart) = (first.x * second.depth - second.x * first.depth, second.depth - first.depth);
        let [from_begin, from_end] = [self.begin.0, self.end.0].map(|place| across - place * apart);
        if (from_begin < 0.0) == (from_end < 0.0) {
            return None;
        }
        let in_line = across / apart;
        let lead = self.lead(in_line);
        let is_tie = smaller(self.begin.1.abs(), self.end.1.abs()) <= self.rounding();
        (is_tie || (lead < 0.0) != (self.begin.1 < 0.0)).then_some((in_line, lead))
    }

    /// What rounding makes of a lead.
    fn rounding(&self) -> f64 {
        4.0 * f64::EPSILON * self.farther
    }

    /// Who keeps what.
    pub fn shares(&self) -> Shares {
        let (first, second, begin, end) = (self.first, self.second, self.begin, self.end);
        let mut shares = Shares { shares: [(false, 0.0, 0.0); 5], count: 0 };
        if first.begin < begin.0 {
            shares.push(true, first.begin, begin.0);
        } else if second.begin < begin.0 {
            shares.push(false, second.begin, begin.0);
        }
        let mut from = begin;
        for to in self.turn().into_iter().chain([end]) {
            let change = if (from.1 < 0.0) == (to.1 < 0.0) { to.0 } else { self.zero(from, to) };
            shares.push(from.1 < 0.0, from.0, change);
            shares.push(to.1 < 0.0, change, to.0);
            from = to;
        }
        if first.end > end.0 {
            shares.push(true, end.0, first.end);
        } else if second.end > end.0 {
            shares.push(false, end.0, second.end);
        }
        shares
    }

    /// Where the lead is zero, between two positions where its signs differ. Positions come with the lead there.
    fn zero(&self, begin: (f64, f64), end: (f64, f64)) -> f64 {
        Self { begin, end, ..*self }.change()
    }

    /// Where the lead changes, from begin to end, where its signs differ there; of no meaning where they do not.
    #[inline(always)]
    pub fn change(&self) -> f64 {
        let (low, high) = (self.begin, self.end);
        let (first, second) = (self.first, self.second);
        // Rounding of a lead, and a share of the leads around that moves the zero by as much of the overlap: a
        // sliver in which the slower ray is kept meets the faster one within as little.
        let enough = larger(self.rounding(), 1e-11 * (high.1 - low.1).abs());
        // The zeros r₁ = r₂ + δ lie on a conic: (p x + q)² = 4 δ² r₂², with x from `low`; with p x + q of δ's sign.
        let (a, b) = (first.x - low.0, second.x - low.0);
        let delta = second.offset - first.offset;
        let p = 2.0 * (b - a);
        let q = (a - b) * (a + b) + (first.depth - second.depth) * (first.depth + second.depth) - delta * delta;
        let four = 4.0 * delta * delta;
        let square = p * p - four;
        let half = p * q + four * b;
        let under = (q + p * b) * (q + p * b) + second.depth * second.depth * square;
        let root = -(half + (2.0 * delta.abs() * larger(under, 0.0).sqrt()).copysign(half));
        let constant = q * q - four * (b * b + second.depth * second.depth);
        let width = high.0 - low.0;
        let [x, other] = [root / square, constant / root];
        let is_inside = (x >= 0.0) & (x <= width) & ((p * x + q) * delta >= 0.0);
        let meeting = low.0 + smaller(larger(either(is_inside, x, other), 0.0), width);
        let is_enough = (self.lead(meeting).abs() <= enough) | ((low.1 < 0.0) == (high.1 < 0.0));
        if is_enough { meeting } else { zero(|place| self.lead(place), low, high, enough) }
    }
}

/// Where a function is zero, between two places where its signs differ, each with its value there, by the Illinois variant of the secant
/// method, until the value is small enough.
#[cold]
pub(super) fn zero(at: impl Fn(f64) -> f64, mut low: (f64, f64), mut high: (f64, f64), enough: f64) -> f64 {
    for _ in 0..60 {
        let x = (low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1)).max(low.0.min(high.0)).min(low.0.max(high.0));
        let value = at(x);
        if value.abs() <= enough {
            return x;
        }
        if (value < 0.0) == (high.1 < 0.0) {
            low.1 *= 0.5;
        } else {
            low = high;
        }
        high = (x, value);
    }
    high.0
}

/// The parts of a window that are nearer than all others of its half-edge, by more than this distance. The others lie in order, and
/// overlap by no more than slivers.
pub(super) fn parts_before(window: &Beam, others: &[Beam], by: f64) -> Vec<Beam> {
    let (mut done, mut parts) = (Vec::new(), vec![*window]);
    let first = others.partition_point(|other| other.end <= window.begin);
    for other in others[first..].iter().take_while(|other| other.begin < window.end) {
        let cut = |part: Beam| {
            if part.begin >= other.end || other.begin >= part.end {
                return vec![part];
            }
            let later = Beam { offset: part.offset + by, ..part };
            let shares = Overlap::new(&later, other).shares();
            let own = shares.as_slice().iter().filter(|share| share.0);
            own.map(|&(_, begin, end)| part.part(begin, end)).filter(Beam::is_wide).collect()
        };
        let open = parts.iter().position(|part| other.begin < part.end).unwrap_or(parts.len());
        done.extend(parts.drain(..open));
        parts = parts.into_iter().flat_map(cut).collect();
    }
    done.extend(parts);
    done
}
