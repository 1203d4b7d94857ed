//! The windows kept: of each half-edge one for each of its stretches.

use crate::error::{Error, Result};
use crate::exact::{Beam, Window};
use crate::extremum::smaller;

#[cfg(test)]
mod tests;

/// A window of a half-edge, kept for one of its stretches.
#[derive(Debug, Clone, Copy)]
struct Label {
    /// Distance of the stretch's middle by the window, bent at its end where it does not reach so far.
    value: f64,
    /// Distance of the source itself.
    offset: f64,
    /// Position of the source along the half-edge and behind it.
    x: f64,
    depth: f64,
    /// Where the interval begins and ends, as shares of the half-edge, rounded inward.
    begin: f32,
    end: f32,
    /// Number of the source that it comes from.
    source: u32,
    /// Of which round it is. One of another round is none.
    round: u16,
    /// Whether it has still to cross the face.
    waits: bool,
}

/// No label, in any round.
const NONE: Label =
    Label { value: 0.0, offset: 0.0, x: 0.0, depth: 0.0, begin: 0.0, end: 0.0, source: 0, round: 0, waits: false };

impl Label {
    fn new(window: &Window, length: f64, value: f64, round: u16) -> Self {
        let per_length = 1.0 / length;
        Self {
            value,
            offset: window.offset,
            x: window.x,
            depth: window.depth,
            begin: rounded_up(window.begin * per_length),
            end: rounded_down(window.end * per_length),
            source: window.root,
            round,
            waits: true,
        }
    }

    fn beam(&self, length: f64) -> Beam {
        let [begin, end] = [self.begin, self.end].map(|share| f64::from(share) * length);
        Beam { begin, end, x: self.x, depth: self.depth, offset: self.offset, root: self.source }
    }

    fn has_same_source(&self, other: &Self) -> bool {
        self.x == other.x && self.depth == other.depth && self.offset == other.offset
    }
}

fn rounded_up(share: f64) -> f32 {
    let rounded = share as f32;
    if f64::from(rounded) < share { rounded.next_up() } else { rounded }
}

fn rounded_down(share: f64) -> f32 {
    let rounded = share as f32;
    if f64::from(rounded) > share { rounded.next_down() } else { rounded }
}

/// What a window must beat on a half-edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bar {
    pub length: f64,
    /// Distances of the half-edge's ends.
    pub ends: [f64; 2],
    /// The half-edge that runs against it, where there is just one.
    pub opposite: Option<u32>,
}

impl Bar {
    /// Distance of the position `x` by the nearer end.
    fn by_ends(&self, x: f64) -> f64 {
        smaller(self.ends[0] + x, self.ends[1] + (self.length - x))
    }
}

/// The labels of all half-edges.
#[derive(Debug)]
pub(super) struct Labels {
    /// Stretches of a half-edge.
    stretches: usize,
    /// Their inverse number.
    per_stretch: f64,
    /// How much sooner a window must come than the one that it replaces.
    margin: f64,
    round: u16,
    /// `3 #F × stretches`.
    labels: Vec<Label>,
}

impl Labels {
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(halfedges: usize, stretches: usize, margin: f64) -> Result<Self> {
        let (mut labels, count) = (Vec::new(), halfedges * stretches);
        labels.try_reserve_exact(count).map_err(|_| Error::OutOfMemory { stage: "keeping windows" })?;
        labels.resize(count, NONE);
        Ok(Self { stretches, per_stretch: 1.0 / stretches as f64, margin, round: 1, labels })
    }

    /// Forgets all windows.
    pub fn clear(&mut self) {
        self.round = self.round.checked_add(1).unwrap_or_else(|| {
            self.labels.fill(NONE);
            1
        });
    }

    /// Distance of the middle of a half-edge's first stretch; infinite for no window.
    pub fn value_of(&self, halfedge: u32) -> f64 {
        self.value(halfedge as usize * self.stretches)
    }

    fn value(&self, index: usize) -> f64 {
        let label = &self.labels[index];
        if label.round == self.round { label.value } else { f64::INFINITY }
    }

    /// The middle of a stretch.
    fn middle(&self, stretch: usize, length: f64) -> f64 {
        (stretch as f64 + 0.5) * length * self.per_stretch
    }

    /// Keeps a window for the stretches that it reaches sooner than all else. Returns its least distance, if there are any.
    pub fn offer(&mut self, halfedge: u32, beam: &Beam, bar: &Bar) -> Option<f64> {
        let first = halfedge as usize * self.stretches;
        let mut kept: Option<Window> = None;
        for stretch in 0..self.stretches {
            let middle = self.middle(stretch, bar.length);
            let value = beam.bent_at(middle);
            if !(value < bar.by_ends(middle) && value < self.value(first + stretch) - self.margin) {
                continue;
            }
            if let Some(opposite) = bar.opposite {
                let against = (opposite as usize + 1) * self.stretches - 1 - stretch;
                if value >= self.value(against) {
                    continue;
                }
            }
            let window = match kept {
                Some(ref window) => window,
                None => {
                    let mut window = Window::from(*beam);
                    if !window.clip(bar.length, bar.ends) {
                        return None;
                    }
                    kept.insert(window)
                }
            };
            self.labels[first + stretch] = Label::new(window, bar.length, value, self.round);
        }
        kept.map(|window| window.nearest())
    }

    /// Gives the windows of a half-edge that wait to cross its face to `cross`. They no longer wait.
    pub fn take(&mut self, halfedge: u32, bar: &Bar, mut cross: impl FnMut(Beam)) {
        let first = halfedge as usize * self.stretches;
        let mut last: Option<Label> = None;
        for stretch in 0..self.stretches {
            let middle = self.middle(stretch, bar.length);
            let label = &mut self.labels[first + stretch];
            let waits = std::mem::take(&mut label.waits) && label.round == self.round;
            // The ends may have become nearer since.
            if !waits || label.value >= bar.by_ends(middle) {
                continue;
            }
            // One that is kept for several stretches crosses once.
            if last.is_none_or(|last| !last.has_same_source(label)) {
                cross(label.beam(bar.length));
            }
            last = Some(*label);
        }
    }
}
