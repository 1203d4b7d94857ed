//! The windows kept: of each half-edge one for each of its stretches.

use std::num::NonZeroUsize;

use heatwalk_base::lanes::Lanes;
use heatwalk_base::parallel;

use crate::error::Result;
use crate::exact::{Beam, Exits, Window};
use crate::extremum::smaller;
use crate::room::REFUSED;

#[cfg(test)]
mod tests;

/// What is known of one stretch of a half-edge.
#[derive(Debug, Clone, Copy)]
struct Label {
    /// Least distance of the stretch's middle by a window that has come here, in mean edges that cost as the half-edge's face
    /// does, bent at its end where it does not reach so far; less where windows are hurried. Infinite where none has.
    value: f32,
    /// Where that window is among those that wait; [`NOT_WAITING`] where it has crossed the face.
    place: u32,
}

const NOT_WAITING: u32 = u32::MAX;

const UNREACHED: Label = Label { value: f32::INFINITY, place: NOT_WAITING };

/// What a window must beat on a half-edge.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bar {
    pub length: f64,
    /// Distances of the half-edge's ends.
    pub ends: [f64; 2],
}

impl Bar {
    /// Distance of the position `x` by the nearer end.
    fn by_ends(&self, x: f64) -> f64 {
        smaller(self.ends[0] + x, self.ends[1] + (self.length - x))
    }
}

/// What windows must beat on two half-edges.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bars {
    pub length: Lanes,
    /// Distances where the half-edges begin, and where they end.
    pub ends: [Lanes; 2],
}

impl Bars {
    /// That of one of them.
    pub fn bar(&self, k: usize) -> Bar {
        let at = |lanes: Lanes| lanes.to_array()[k];
        Bar { length: at(self.length), ends: self.ends.map(at) }
    }

    /// [`Bar::by_ends`] of both.
    #[inline(always)]
    fn by_ends(&self, x: Lanes) -> Lanes {
        (self.ends[1] + (self.length - x)).smaller(self.ends[0] + x)
    }
}

/// How much sooner a window must come than the one that it replaces, in mean edges.
const MARGIN: f32 = 1e-6;

/// What that grows to where windows are hurried: of a stretch that has been reached so often, this share of its distance times the square
/// of their number. On edges around one vertex each of many windows may come a little sooner than the one before.
const HURRY: f32 = 1e-6;

/// A number of stretches; one that is part of the type costs no loop.
pub(super) trait Count: Copy + Send + Sync + 'static {
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
    /// As many, how often each was replaced since windows are hurried; empty before.
    times: Vec<u8>,
    /// The windows that wait, in no order. They are few, so that this memory is always at hand.
    waiting: Vec<Beam>,
    /// Places in it that are free.
    free: Vec<u32>,
    /// Whether there was no memory for a window, which is lost.
    is_refused: bool,
}

impl<C: Count> Labels<C> {
    /// Makes room for them, with the help of so many threads.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn new(halfedges: usize, stretches: C, mean_edge: f64, threads: NonZeroUsize) -> Result<Self> {
        let (mut labels, count) = (Vec::new(), halfedges * stretches.get());
        labels.try_reserve_exact(count).map_err(|_| REFUSED)?;
        parallel::touch(&mut labels, threads);
        Ok(Self {
            stretches,
            per_stretch: 1.0 / stretches.get() as f64,
            per_edge: 1.0 / mean_edge,
            halfedges,
            labels,
            times: Vec::new(),
            waiting: Vec::new(),
            free: Vec::new(),
            is_refused: false,
        })
    }

    /// Forgets all windows.
    pub fn clear(&mut self) {
        self.labels.clear();
        self.labels.resize(self.halfedges * self.stretches(), UNREACHED);
        self.times.clear();
        self.waiting.clear();
        self.free.clear();
        self.is_refused = false;
    }

    /// From now on windows have to come the sooner, the more often those of a stretch were replaced: so each stretch is reached by a
    /// few, however many there are.
    #[cold]
    pub fn hurry(&mut self) {
        if self.times.try_reserve_exact(self.labels.len()).is_ok() {
            self.times.resize(self.labels.len(), 0);
        } else {
            self.is_refused = true;
        }
    }

    /// What windows have to come sooner than, where one has come to a stretch at this distance.
    #[inline(always)]
    fn value_to_beat(&mut self, label: usize, value: f32) -> f32 {
        match self.times.get_mut(label) {
            None => value,
            Some(times) => {
                *times = times.saturating_add(1);
                value * (1.0 - HURRY * f32::from(*times).powi(2))
            }
        }
    }

    /// Whether there was no memory for a window, which is lost.
    pub fn is_refused(&self) -> bool {
        self.is_refused
    }

    /// Distance of the middle of a half-edge's first stretch, in mean edges; infinite for no window.
    pub fn value_of(&self, halfedge: u32) -> f32 {
        self.labels[halfedge as usize * self.stretches()].value
    }

    /// The middle of a stretch.
    #[inline(always)]
    fn middle(&self, stretch: usize, length: f64) -> f64 {
        (stretch as f64 + 0.5) * length * self.per_stretch
    }

    /// Whether the windows that leave a face reach some stretch of these half-edges sooner than all else.
    #[inline(always)]
    pub fn are_sooner(&self, halfedges: [u32; 2], exits: &Exits, bars: &Bars) -> [bool; 2] {
        let mut are_sooner = [false; 2];
        for stretch in 0..self.stretches() {
            let middle = Lanes::both(stretch as f64 + 0.5) * bars.length * Lanes::both(self.per_stretch);
            let value = exits.bent_at(middle);
            let are_nearer = value.is_below(bars.by_ends(middle)).to_array();
            let value = value.to_array();
            for k in 0..2 {
                are_sooner[k] |= are_nearer[k] & self.is_sooner_than_known(halfedges[k], stretch, value[k]);
            }
        }
        are_sooner
    }

    /// Whether the distance `value` of the middle of a stretch is less than by the windows that have come there.
    #[inline(always)]
    fn is_sooner_than_known(&self, halfedge: u32, stretch: usize, value: f64) -> bool {
        let known = self.labels[halfedge as usize * self.stretches() + stretch].value;
        ((value * self.per_edge) as f32) < known - MARGIN
    }

    /// Whether it is less than any other that is known.
    #[inline(always)]
    fn is_sooner_at(&self, halfedge: u32, stretch: usize, value: f64, bar: &Bar) -> bool {
        // One branch, if any: which of these fails is as good as random.
        (value < bar.by_ends(self.middle(stretch, bar.length))) & self.is_sooner_than_known(halfedge, stretch, value)
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
            if !self.is_sooner_at(halfedge, stretch, value, bar) {
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
            let beam = window.beam();
            let beaten = self.value_to_beat(first + stretch, edges);
            let label = &mut self.labels[first + stretch];
            label.value = beaten;
            if let Some(replaced) = self.waiting.get_mut(label.place as usize) {
                *replaced = beam;
            } else if let Some(place) = self.free.pop() {
                label.place = place;
                self.waiting[place as usize] = beam;
            } else if self.waiting.len() < self.waiting.capacity() {
                label.place = self.waiting.len() as u32;
                self.waiting.push(beam);
            } else {
                self.grow(first + stretch, beam);
            }
        }
        kept.map(|window| window.nearest())
    }

    /// Makes room for more windows, and for the places of all that become free; keeps one for a label.
    #[cold]
    fn grow(&mut self, label: usize, beam: Beam) {
        if self.waiting.try_reserve(1).is_ok() && self.free.try_reserve(self.waiting.capacity()).is_ok() {
            self.labels[label].place = self.waiting.len() as u32;
            self.waiting.push(beam);
        } else {
            self.is_refused = true;
        }
    }

    /// The window kept for a stretch of a half-edge, where it waits to cross the face and is still of use. It no longer
    /// waits.
    #[inline(always)]
    pub fn take(&mut self, halfedge: u32, stretch: usize, bar: &Bar) -> Option<Beam> {
        let limit = (bar.by_ends(self.middle(stretch, bar.length)) * self.per_edge) as f32;
        let index = halfedge as usize * self.stretches() + stretch;
        let Label { value, place } = self.labels[index];
        let beam = *self.waiting.get(place as usize)?;
        self.labels[index].place = NOT_WAITING;
        self.free.push(place);
        // The ends may have become nearer since.
        (value < limit).then_some(beam)
    }

    /// Stretches of a half-edge.
    #[inline(always)]
    pub fn stretches(&self) -> usize {
        self.stretches.get()
    }
}
