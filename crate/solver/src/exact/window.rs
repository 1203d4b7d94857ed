//! Windows: the part of an edge that sees one (pseudo-)source along straight lines, unfolded into the plane.

use crate::extremum::{either, larger, smaller};

/// A window reaches vertices that its rays miss by at most this share of their distance from it. Rounding stays below: that of
/// positions unfolded through thousands of faces, and that of a ray which has passed a vertex at a hundred-millionth of the edges
/// there. A path bent at the window's end to reach such a vertex is longer by no more than the square of this share.
pub(super) const GRAZE: f64 = 1e-6;

/// Windows seen under a smaller angle, radians, are dropped: what they see, their neighbours reach within [`GRAZE`].
pub(super) const THIN: f64 = 1e-13;

/// An angle sum counts as a turn within this, radians.
pub(super) const TURN: f64 = 1e-11;

/// Windows of one half-edge may overlap by what is seen under a smaller angle, radians. Most windows end at a ray that the
/// next one begins with, at the border of a shadow, which is taken wider by a tenth of this: who is nearer there
/// is up to rounding, and nothing is lost where both are kept.
pub(super) const SLIVER: f64 = 1e-8;

/// Nothing is dropped unless it is longer by this share than what replaces it: rounding of lengths stays below, so
/// a shortest path is never lost to a tie with itself.
pub(super) const MARGIN: f64 = 1e-12;

/// Two windows with sources nearer to each other than this share of their distance see the same source: rounding of
/// positions unfolded past a vertex. A vertex with so little curvature that its shadow is not seen.
const SAME: f64 = 1e-13;

/// A window without the distances of its ends: see [`Window`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Beam {
    pub begin: f64,
    pub end: f64,
    pub x: f64,
    pub depth: f64,
    pub offset: f64,
    pub root: u32,
}

impl Beam {
    /// Distance of the position `x` of the half-edge by this window.
    pub fn at(&self, x: f64) -> f64 {
        self.offset + length(x - self.x, self.depth)
    }

    /// Distance of the position `x` of the half-edge by this window, bent at its end where that is before.
    pub fn bent_at(&self, x: f64) -> f64 {
        let at = smaller(larger(x, self.begin), self.end);
        self.at(at) + (x - at).abs()
    }

    /// Where the straight line to a place beyond the half-edge crosses that, and the distance of the place, where rays miss it by no more
    /// than `grain`.
    #[inline]
    pub fn sees(&self, [x, y]: [f64; 2], grain: f64) -> Option<(f64, f64)> {
        let height = self.depth + y;
        let crosses = self.x + (x - self.x) * self.depth / height;
        let at = crosses.max(self.begin).min(self.end);
        let is_missed = (crosses - at).abs() * height > length(x - self.x, height) * (GRAZE * height + grain);
        (!is_missed).then_some((at, self.at(at) + length(x - at, y)))
    }

    /// [Cuts off](Window::clip) what is too far. Returns whether anything is left.
    pub fn clip(&mut self, length: f64, values: [f64; 2]) -> bool {
        let mut window = Window::from(*self);
        let is_left = window.clip(length, values);
        *self = window.beam();
        is_left
    }

    /// The same window on a half-edge in the opposite direction.
    pub fn mirrored(self, length: f64) -> Self {
        Self { begin: length - self.end, end: length - self.begin, x: length - self.x, ..self }
    }

    /// The same window for a part of its interval.
    pub fn part(&self, begin: f64, end: f64) -> Self {
        Self { begin, end, ..*self }
    }

    /// The same window for so much more of a half-edge of this length: from a source on the half-edge itself, rays in all directions
    /// pass one place, where rounding may have cut it.
    #[cold]
    pub fn wider(&self, by: f64, length: f64) -> Self {
        self.part(larger(self.begin - by, 0.0), smaller(self.end + by, length))
    }

    /// Whether the root has the distance that the window starts from, or one that is less by rounding: the window may have won a
    /// tie against the next one of the same root, which is lost then.
    #[inline(always)]
    pub fn is_current(&self, at_root: f64, grain: f64) -> bool {
        self.offset <= at_root + (MARGIN * at_root.abs() + grain)
    }

    /// Whether the interval is worth following. Also false where something is not a number.
    #[inline(always)]
    pub fn is_wide(&self) -> bool {
        self.exceeds(THIN)
    }

    /// Whether the interval is seen from the source under more than a small angle, in radians.
    #[inline(always)]
    pub fn exceeds(&self, angle: f64) -> bool {
        let aside = larger(larger(self.begin - self.x, self.x - self.end), 0.0);
        (self.end - self.begin) * self.depth >= angle * (aside * aside + self.depth * self.depth)
    }

    /// The least distance in the interval.
    #[inline(always)]
    pub fn nearest(&self) -> f64 {
        let aside = larger(larger(self.begin - self.x, self.x - self.end), 0.0);
        self.offset + length(aside, self.depth)
    }

    /// Whether another window that does not begin before this one begins well before its end: by what is seen under a larger angle.
    #[inline(always)]
    pub fn overlaps(&self, other: &Self, sliver: f64) -> bool {
        self.part(other.begin, self.end).exceeds(sliver)
    }

    /// Whether another window begins where this one ends and has the same source, at the same distance: that of a vertex
    /// may have fallen between the two.
    #[inline(always)]
    pub fn continues_into(&self, other: &Self) -> bool {
        let close = SAME * (self.depth + (self.end - self.x).abs());
        // No branches: one alone is often true, all together hardly ever.
        ((self.end - other.begin).abs() <= close)
            & (self.root == other.root)
            & (self.offset == other.offset)
            & ((self.x - other.x).abs() <= close)
            & ((self.depth - other.depth).abs() <= close)
    }
}

impl From<Beam> for Window {
    fn from(Beam { begin, end, x, depth, offset, root }: Beam) -> Self {
        Self::new(begin, end, [x, depth], offset, root)
    }
}

/// An interval of a half-edge, and the (pseudo-)source that lights it from behind.
///
/// The half-edge lies on the x axis from the origin, its face above, the source at `(x, −depth)`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Window {
    /// Where the interval begins and ends, along the half-edge.
    pub begin: f64,
    pub end: f64,
    /// Position of the source along the half-edge and behind it.
    pub x: f64,
    pub depth: f64,
    /// Distance of the source itself.
    pub offset: f64,
    /// Distance where the interval begins and ends.
    pub at_begin: f64,
    pub at_end: f64,
    /// A vertex, or `#V` + the number of a source.
    pub root: u32,
}

impl Window {
    /// A window and the distances of its ends. `[x, depth]` is the source's place, `offset` its distance.
    pub fn new(begin: f64, end: f64, [x, depth]: [f64; 2], offset: f64, root: u32) -> Self {
        let at = |at: f64| offset + length(at - x, depth);
        Self { begin, end, x, depth, offset, at_begin: at(begin), at_end: at(end), root }
    }

    /// Without the distances of its ends.
    pub fn beam(&self) -> Beam {
        let Self { begin, end, x, depth, offset, root, .. } = *self;
        Beam { begin, end, x, depth, offset, root }
    }

    /// Distance of the position `x` of the half-edge by this window.
    pub fn at(&self, x: f64) -> f64 {
        self.offset + length(x - self.x, self.depth)
    }

    /// The same window for a part of its interval.
    pub fn part(&self, begin: f64, end: f64) -> Self {
        let at_begin = if begin == self.begin { self.at_begin } else { self.at(begin) };
        let at_end = if end == self.end { self.at_end } else { self.at(end) };
        Self { begin, end, at_begin, at_end, ..*self }
    }

    /// The least distance in the interval.
    pub fn nearest(&self) -> f64 {
        let is_below = (self.begin < self.x) & (self.x < self.end);
        either(is_below, self.offset + self.depth, smaller(self.at_begin, self.at_end))
    }

    /// Whether the interval is worth following. Also false where something is not a number.
    pub fn is_wide(&self) -> bool {
        self.beam().is_wide()
    }

    /// Cuts off what is farther than by way of the half-edge's ends (Xin & Wang 2009, theorem 3.2, for every ray instead
    /// of the whole window); `values` are distances there. Returns whether anything is left.
    pub fn clip(&mut self, length: f64, limit: [f64; 2]) -> bool {
        // At slope one, the way by an end grows at least as fast as this window's distance.
        let is_cut = [self.at_begin > limit[0] + self.begin, self.at_end > limit[1] + (length - self.end)];
        if is_cut == [false; 2] {
            return true;
        }
        if is_cut[0] {
            if self.at_end > limit[0] + self.end {
                return false;
            }
            let begin = tie(self.x, self.depth, limit[0] - self.offset);
            *self = self.part(smaller(larger(begin, self.begin), self.end), self.end);
        }
        if is_cut[1] {
            if self.at_begin > limit[1] + (length - self.begin) {
                return false;
            }
            let end = length - tie(length - self.x, self.depth, limit[1] - self.offset);
            *self = self.part(self.begin, larger(smaller(end, self.end), self.begin));
        }
        self.is_wide()
    }
}

/// The least distance along some windows, if there are any.
pub(super) fn nearest(windows: &[Beam]) -> Option<f64> {
    windows.iter().map(Beam::nearest).reduce(smaller)
}

/// [Clips](Window::clip) a list of windows. Where they touch, distance changes no faster than place from one to the next,
/// so that only the outermost can be too far.
pub(super) fn clip(windows: &mut Vec<Beam>, length: f64, values: [f64; 2]) {
    let is_left = |window: &mut Beam| window.clip(length, values);
    let lost = windows.iter_mut().position(is_left).unwrap_or(windows.len());
    if lost > 0 {
        windows.drain(..lost);
    }
    while windows.pop_if(|window| !is_left(window)).is_some() {}
}

/// Euclidean length. The numbers are of the mesh's size, so that squares are safe.
pub(crate) fn length(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

/// Where on the x axis the distance from `(x, −depth)` equals the distance from the origin plus `limit`.
fn tie(x: f64, depth: f64, limit: f64) -> f64 {
    let tie = 0.5 * (x * x + depth * depth - limit * limit) / (x + limit);
    if tie.is_finite() { tie } else { f64::NEG_INFINITY }
}
