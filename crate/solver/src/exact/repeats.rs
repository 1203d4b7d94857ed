//! Windows that come to a half-edge where others have crossed before.
//!
//! Windows are forgotten when they have crossed a face. What comes around to it again is longer than by way of the half-edge's ends, and
//! is cut by that. Around triangles that are thin it is hardly longer, and where several of them share edges it comes around by many
//! ways, each of which branches again. So half-edges that are crossed often remember what has crossed, as all do in Mitchell, Mount &
//! Papadimitriou's search: what is no nearer than that ends there.

use std::collections::BTreeMap;

use super::envelope::Envelope;
use super::overlap::parts_before;
use super::window::{Beam, MARGIN};

/// Half-edges that are crossed more often remember. Ordinary ones are crossed a few times.
const OFTEN: u8 = 16;

/// At half-edges that are crossed more than 255 times windows have to be nearer by so many times as much as elsewhere: a hundred-millionth
/// of the distance.
const TIRED: f64 = 1e4;

/// What has crossed half-edges.
#[derive(Debug)]
pub(super) struct Repeats {
    /// `3 #F`, how often each half-edge has been crossed.
    times: Vec<u8>,
    /// The nearest windows that have crossed the half-edges that remember.
    crossed: BTreeMap<u32, Vec<Beam>>,
}

impl Repeats {
    pub fn new(halfedges: usize) -> Self {
        Self { times: vec![0; halfedges], crossed: BTreeMap::new() }
    }

    /// Whether a half-edge that is crossed once more remembers what has crossed.
    #[inline(always)]
    pub fn remembers(&mut self, halfedge: u32) -> bool {
        let times = &mut self.times[halfedge as usize];
        *times = times.saturating_add(1);
        *times > OFTEN
    }

    /// Leaves of the windows of a half-edge what is nearer than all that has crossed there, by more than rounding, and remembers it.
    #[cold]
    pub fn leave_nearer(&mut self, halfedge: u32, windows: &mut Vec<Beam>, envelope: &mut Envelope, grain: f64) {
        let crossed = self.crossed.entry(halfedge).or_default();
        let patience = if self.times[halfedge as usize] == u8::MAX { TIRED } else { 1.0 };
        let rounding = |window: &Beam| patience * (MARGIN * window.nearest().abs() + grain);
        *windows = windows.iter().flat_map(|window| parts_before(window, crossed, rounding(window))).collect();
        envelope.join(crossed, windows);
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.times.fill(0);
        self.crossed.clear();
    }
}
