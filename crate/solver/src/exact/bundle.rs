//! Windows that cross faces together: what they see is computed when one of them is needed.
//!
//! A vertex divides at most a few of the windows that wait at a half-edge; all others only pass to its left or to its right. On a
//! smooth surface these are hundreds. So windows of a bundle stay as they were where it was gathered, and the faces that
//! it has crossed since are one motion of the plane (as Schreiber & Sharir, "An optimal-time algorithm for shortest
//! paths on a convex polytope in three dimensions", 2008, keep unfoldings in the nodes of their trees).

use std::ops::Range;
use std::sync::Arc;

use super::geometry::Side;
use super::window::{Beam, length};
use crate::extremum::{larger, smaller};

#[cfg(test)]
mod tests;

/// Rays may miss a vertex by this share of their length and still be asked whether they reach it: far above
/// [`GRAZE`](super::window::GRAZE) and rounding.
const CLOSE: f64 = 1e-5;

/// A turn of the plane, and a shift after it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motion {
    cos: f64,
    sin: f64,
    shift: [f64; 2],
}

impl Motion {
    const NONE: Self = Self { cos: 1.0, sin: 0.0, shift: [0.0; 2] };

    /// From a half-edge to the one across the edge at its begin. `sides` are those that it
    /// [sees](super::geometry::Frame::seen_from).
    pub fn to_left([base, ..]: [&Side; 3]) -> Self {
        Self { cos: base.cos, sin: -base.sin, shift: [0.0; 2] }
    }

    /// From a half-edge to the one across the edge at its end.
    pub fn to_right([base, right, _]: [&Side; 3]) -> Self {
        let shift = [right.length - base.length * right.cos, -base.length * right.sin];
        Self { cos: right.cos, sin: right.sin, shift }
    }

    fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.cos * x - self.sin * y + self.shift[0], self.sin * x + self.cos * y + self.shift[1]]
    }

    fn undo(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (x, y) = (x - self.shift[0], y - self.shift[1]);
        [self.cos * x + self.sin * y, self.cos * y - self.sin * x]
    }

    fn then(&self, next: &Self) -> Self {
        Self {
            cos: next.cos * self.cos - next.sin * self.sin,
            sin: next.sin * self.cos + next.cos * self.sin,
            shift: next.apply(self.shift),
        }
    }
}

/// Windows in order along the half-edge where they were gathered.
#[derive(Debug)]
struct Gathered {
    windows: Vec<Beam>,
    /// By how much a window may begin or end beyond one that comes after it, along the half-edge, and how much more its rays
    /// may lean, as a slope.
    disorder: [f64; 2],
    /// A direction, and the least distance of a window's source there: a bound of all distances.
    ahead: [f64; 2],
    base: f64,
}

impl Gathered {
    fn new(windows: Vec<Beam>) -> Self {
        let mut disorder = [0.0; 2];
        for end in [|window: &Beam| window.begin, |window: &Beam| window.end] {
            let mut most = [f64::NEG_INFINITY; 2];
            for window in &windows {
                let here = [end(window), (end(window) - window.x) / window.depth];
                for k in 0..2 {
                    most[k] = larger(most[k], here[k]);
                    disorder[k] = larger(disorder[k], most[k] - here[k]);
                }
            }
        }
        let middle = &windows[windows.len() / 2];
        let [x, y] = [0.5 * (middle.begin + middle.end) - middle.x, middle.depth];
        let length = length(x, y);
        let ahead = [x / length, y / length];
        let bases = windows.iter().map(|window| window.offset - window.x * ahead[0] + window.depth * ahead[1]);
        let base = bases.fold(f64::INFINITY, smaller);
        Self { windows, disorder, ahead, base }
    }
}

/// Some windows next to each other of those that were gathered at a half-edge, as another half-edge sees them. None of
/// them is cut by anything there, and what overlaps does not count.
#[derive(Debug, Clone)]
pub(super) struct Bundle {
    gathered: Arc<Gathered>,
    range: Range<u32>,
    /// From the half-edge where they were gathered to this one.
    motion: Motion,
    /// This half-edge's.
    length: f64,
}

impl Bundle {
    /// Of windows of a half-edge, at least one.
    pub fn new(windows: Vec<Beam>, length: f64) -> Self {
        let range = 0..windows.len() as u32;
        Self { gathered: Arc::new(Gathered::new(windows)), range, motion: Motion::NONE, length }
    }

    /// How many windows it has.
    pub fn len(&self) -> usize {
        self.range.len()
    }

    /// A window as this half-edge sees it.
    #[inline(never)]
    fn window(&self, number: u32) -> Beam {
        let window = &self.gathered.windows[number as usize];
        let [x, y] = self.motion.apply([window.x, -window.depth]);
        let meet = |at: f64| {
            let [along, up] = self.motion.apply([at, 0.0]);
            let place = along - (along - x) * up / (up - y);
            smaller(larger(place, 0.0), self.length)
        };
        Beam { begin: meet(window.begin), end: meet(window.end), x, depth: -y, ..*window }
    }

    /// The same windows across a face.
    pub fn across(mut self, motion: &Motion, length: f64) -> Self {
        self.motion = self.motion.then(motion);
        self.length = length;
        self
    }

    /// Those that pass a point on its left, those that may see it, and those that pass it on its right.
    pub fn split(self, point: [f64; 2]) -> [Self; 3] {
        let Range { start, end } = self.range;
        let [x, y] = self.motion.undo(point);
        let windows = &self.gathered.windows;
        let [shift, lean] = self.gathered.disorder;
        // How far to the right of the point the ray through the place `at` is at the point's height, and how far it must be for
        // those of all windows on its other side to be there too; both times the depth.
        let ray = |window: &Beam, at: f64| {
            let aside = (at - x) * window.depth + (at - window.x) * y;
            let close = CLOSE * (window.depth + y + (at - window.x).abs() + (at - x).abs());
            [aside, window.depth * (shift + lean * y + close)]
        };
        let is_passed = |number: u32| {
            let window = &windows[number as usize];
            let [aside, enough] = ray(window, window.end);
            aside < -enough
        };
        let is_ahead = |number: u32| {
            let window = &windows[number as usize];
            let [aside, enough] = ray(window, window.begin);
            aside > enough
        };
        let [left, right] = if y <= 0.0 {
            [start, end]
        } else if start < end && is_ahead(start) {
            [start, start]
        } else if start < end && is_passed(end - 1) {
            [end, end]
        } else {
            let left = after_last(start..end, is_passed);
            [left, (left..end).find(|&number| is_ahead(number)).unwrap_or(end)]
        };
        [start..left, left..right, right..end].map(|range| Self { range, ..self.clone() })
    }

    /// No window is nearer anywhere between these places of the half-edge.
    pub fn least(&self, ends: [f64; 2]) -> f64 {
        let Gathered { disorder: [shift, lean], ahead, base, .. } = *self.gathered;
        let bounds = ends.map(|end| {
            let [x, y] = self.motion.undo([end, 0.0]);
            base + x * ahead[0] + y * ahead[1] - shift - lean * y.abs()
        });
        smaller(bounds[0], bounds[1])
    }

    /// Bytes held, its share of what it has in common with others.
    pub fn bytes(&self) -> usize {
        size_of::<Beam>() * self.gathered.windows.capacity() / Arc::strong_count(&self.gathered)
    }
}

/// Takes windows out.
impl Iterator for Bundle {
    type Item = Beam;

    fn next(&mut self) -> Option<Beam> {
        self.range.next().map(|number| self.window(number))
    }
}

impl DoubleEndedIterator for Bundle {
    fn next_back(&mut self) -> Option<Beam> {
        self.range.next_back().map(|number| self.window(number))
    }
}

/// The number after one that holds, or the first one, which itself does not hold, or is the end.
fn after_last(range: Range<u32>, holds: impl Fn(u32) -> bool) -> u32 {
    let Range { mut start, mut end } = range;
    while start < end {
        let middle = start + (end - start) / 2;
        if holds(middle) {
            start = middle + 1;
        } else {
            end = middle;
        }
    }
    start
}
