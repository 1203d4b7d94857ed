//! The windows kept: of each half-edge one for each of its stretches.

use std::fmt::Debug;
use std::num::NonZeroUsize;

use crate::error::{Error, Result};
use crate::exact::{Beam, Window};
use crate::extremum::smaller;
use heatwalk_surface::parallel;

#[cfg(test)]
mod tests;

/// A window of a half-edge, kept for one of its stretches: half a cache line.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
struct Label {
    /// Distance of the source itself.
    offset: f64,
    /// Position of the source along the half-edge and behind it.
    x: f64,
    depth: f64,
    /// Distance of the stretch's middle by the window, in mean edges that cost as the half-edge's face does, bent at its end
    /// where it does not reach so far. Negative while the window has still to cross the face. Infinite where there is no window.
    value: f32,
    /// Where the interval begins and ends, in [`SHARES`] of the half-edge, rounded inward.
    begin: u16,
    end: u16,
}

const SHARES: f64 = u16::MAX as f64;

const NONE: Label = Label { offset: 0.0, x: 0.0, depth: 0.0, value: f32::INFINITY, begin: 0, end: 0 };

impl Label {
    /// `None` for a window that is narrower than a share.
    fn new(window: &Window, length: f64, value: f32) -> Option<Self> {
        let per_share = SHARES / length;
        let [begin, end] = [window.begin, window.end].map(|at| at * per_share);
        let whole = begin as u16;
        let (begin, end) = (whole.saturating_add(u16::from(f64::from(whole) < begin)), end as u16);
        (begin < end).then_some(Self { offset: window.offset, x: window.x, depth: window.depth, value, begin, end })
    }

    fn beam(&self, length: f64, source: u32) -> Beam {
        let share = length / SHARES;
        let [begin, end] = [self.begin, self.end].map(|shares| f64::from(shares) * share);
        Beam { begin, end, x: self.x, depth: self.depth, offset: self.offset, root: source }
    }
}

/// What a window must beat on a half-edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bar {
    pub length: f64,
    /// Distances of the half-edge's ends.
    pub ends: [f64; 2],
    /// The half-edge that runs against it, where there is just one, and the cost of that one's face over the cost of this
    /// one's.
    pub opposite: Option<(u32, f64)>,
}

impl Bar {
    /// Distance of the position `x` by the nearer end.
    fn by_ends(&self, x: f64) -> f64 {
        smaller(self.ends[0] + x, self.ends[1] + (self.length - x))
    }
}

/// How much sooner a window must come than the one that it replaces, in mean edges.
const MARGIN: f32 = 1e-6;

/// A number of stretches; one that is part of the type costs no loop.
pub(super) trait Count: Copy + Debug + Send + Sync + 'static {
    fn get(self) -> usize;
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Fixed<const N: usize>;

impl<const N: usize> Count for Fixed<N> {
    #[inline(always)]
    fn get(self) -> usize {
        N
    }
}

impl Count for usize {
    #[inline(always)]
    fn get(self) -> usize {
        self
    }
}

/// The labels of all half-edges.
#[derive(Debug)]
pub(super) struct Labels<C> {
    /// Stretches of a half-edge.
    stretches: C,
    /// Their inverse number.
    per_stretch: f64,
    /// Inverse of the mean edge.
    per_edge: f64,
    /// Half-edges.
    halfedges: usize,
    /// `3 #F × stretches`; empty before the first round.
    labels: Vec<Label>,
    /// Number of the source that each window comes from. Empty where there is just one source.
    sources: Vec<u32>,
}

impl<C: Count> Labels<C> {
    /// Makes room for them, with the help of so many threads.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn new(halfedges: usize, stretches: C, mean_edge: f64, threads: NonZeroUsize) -> Result<Self> {
        let (mut labels, count) = (Vec::new(), halfedges * stretches.get());
        labels.try_reserve_exact(count).map_err(|_| Error::OutOfMemory { stage: "keeping windows" })?;
        parallel::touch(&mut labels, threads);
        Ok(Self {
            stretches,
            per_stretch: 1.0 / stretches.get() as f64,
            per_edge: 1.0 / mean_edge,
            halfedges,
            labels,
            sources: Vec::new(),
        })
    }

    /// Forgets all windows, to keep those of so many sources.
    pub fn clear(&mut self, sources: usize) {
        self.labels.clear();
        self.labels.resize(self.halfedges * self.stretches(), NONE);
        self.sources.clear();
        if sources > 1 {
            self.sources.resize(self.labels.len(), 0);
        }
    }

    /// Distance of the middle of a half-edge's first stretch, in mean edges; infinite for no window.
    pub fn value_of(&self, halfedge: u32) -> f32 {
        self.value(halfedge as usize * self.stretches())
    }

    #[inline(always)]
    fn value(&self, index: usize) -> f32 {
        self.labels[index].value.abs()
    }

    /// The middle of a stretch.
    #[inline(always)]
    fn middle(&self, stretch: usize, length: f64) -> f64 {
        (stretch as f64 + 0.5) * length * self.per_stretch
    }

    /// Keeps a window for the stretches that it reaches sooner than all else. Returns its least distance, if there are any.
    #[inline(always)]
    pub fn offer(&mut self, halfedge: u32, beam: &Beam, bar: &Bar) -> Option<f64> {
        let first = halfedge as usize * self.stretches();
        let mut kept: Option<Window> = None;
        for stretch in 0..self.stretches() {
            let middle = self.middle(stretch, bar.length);
            let value = beam.bent_at(middle);
            let edges = (value * self.per_edge) as f32;
            let against = bar.opposite.map_or(f32::INFINITY, |(opposite, ratio)| {
                self.value((opposite as usize + 1) * self.stretches() - 1 - stretch) * ratio as f32
            });
            // One branch: which of these fails is as good as random.
            let is_sooner =
                (value < bar.by_ends(middle)) & (edges < self.value(first + stretch) - MARGIN) & (edges < against);
            if !is_sooner {
                continue;
            }
            let window = match kept {
                Some(ref window) => window,
                None => {
                    let mut window = Window::from(*beam);
                    if !(window.is_wide() && window.clip(bar.length, bar.ends)) {
                        return None;
                    }
                    kept.insert(window)
                }
            };
            self.labels[first + stretch] = Label::new(window, bar.length, -edges)?;
            if let Some(source) = self.sources.get_mut(first + stretch) {
                *source = beam.root;
            }
        }
        kept.map(|window| window.nearest())
    }

    /// The window kept for a stretch of a half-edge, where it waits to cross the face and is still of use. It no longer
    /// waits.
    #[inline(always)]
    pub fn take(&mut self, halfedge: u32, stretch: usize, bar: &Bar) -> Option<Beam> {
        let limit = (bar.by_ends(self.middle(stretch, bar.length)) * self.per_edge) as f32;
        let index = halfedge as usize * self.stretches() + stretch;
        let label = &mut self.labels[index];
        let waits = label.value.is_sign_negative();
        label.value = label.value.abs();
        // The ends may have become nearer since.
        let is_of_use = waits & (label.value < limit);
        is_of_use.then(|| label.beam(bar.length, self.sources.get(index).copied().unwrap_or(0)))
    }

    /// Stretches of a half-edge.
    #[inline(always)]
    pub fn stretches(&self) -> usize {
        self.stretches.get()
    }
}
