//! Windows that come to an edge of many faces.
//!
//! Each of them goes on into all other faces, so that as many faces as there are, each with a window for the edge, would take the square of
//! their number, however few of these windows are nearer than others somewhere on the edge. So edges that are crossed often remember what
//! has crossed, and gather what comes until the nearer half-edges are done: of that, the nearest goes first, and what is no nearer than what
//! has crossed ends there. It came to its own face that way at most as soon as by a straight line there.

use std::collections::BTreeMap;

use heatwalk_base::sort;
use heatwalk_surface::HalfedgeId;
use heatwalk_surface::edges::{EdgeNames, Edges};

use super::envelope::Envelope;
use super::geometry::{ExactGeometry, after};
use super::overlap::parts_before;
use super::window::Beam;
use crate::room;

/// Edges that are crossed more often remember and gather.
const OFTEN: usize = 16;

/// Windows that leave a face together by a half-edge.
#[derive(Debug)]
pub(super) struct Leaving {
    /// The least distance along them.
    pub nearest: f64,
    pub halfedge: u32,
    /// In order along the edge against the half-edge's direction.
    pub windows: Vec<Beam>,
}

/// What has crossed edges of three faces or more.
#[derive(Debug, Default)]
pub(super) struct Fans {
    names: EdgeNames,
    /// By the first half-edge of each.
    edges: BTreeMap<HalfedgeId, Fan>,
    gathered: Vec<Leaving>,
}

#[derive(Debug, Default)]
struct Fan {
    times: usize,
    /// The nearest windows that have crossed, as a half-edge sees them that runs from the vertex of the higher number, once there
    /// are many.
    crossed: Vec<Beam>,
}

impl Fans {
    /// Whether what leaves by a half-edge of an edge of three faces or more is to be gathered.
    pub fn gathers(&mut self, edges: &Edges, halfedge: u32) -> bool {
        let fan = self.edges.entry(self.names.first(edges, HalfedgeId(halfedge))).or_default();
        fan.times += 1;
        fan.times > OFTEN
    }

    /// Keeps windows until they are [taken](Self::take). Returns whether there was room.
    #[must_use]
    pub fn gather(&mut self, nearest: f64, halfedge: u32, windows: &mut Vec<Beam>) -> bool {
        room::push(&mut self.gathered, Leaving { nearest, halfedge, windows: std::mem::take(windows) })
    }

    /// Whether windows have been gathered.
    pub fn are_gathered(&self) -> bool {
        !self.gathered.is_empty()
    }

    /// Takes what has been gathered, the nearest first.
    pub fn take(&mut self) -> Vec<Leaving> {
        sort::sort_by(&mut self.gathered, |a, b| a.nearest.total_cmp(&b.nearest));
        std::mem::take(&mut self.gathered)
    }

    /// Leaves of windows what is nearer than all that has crossed their edge, by more than rounding, and remembers it.
    pub fn leave_nearer(&mut self, geometry: &ExactGeometry, leaving: &mut Leaving, envelope: &mut Envelope) {
        let Leaving { halfedge, windows, .. } = leaving;
        let (frame, k) = geometry.frame_of(*halfedge);
        let is_mirrored = frame[k].vertex > frame[after(k)].vertex;
        let mirror = |windows: &mut Vec<Beam>| {
            windows.reverse();
            windows.iter_mut().for_each(|window| *window = window.mirrored(frame[k].length));
        };
        if is_mirrored {
            mirror(windows);
        }
        let edge = self.names.first(geometry.surface().edges(), HalfedgeId(*halfedge));
        let crossed = &mut self.edges.entry(edge).or_default().crossed;
        let nearer = |window: &Beam| parts_before(window, crossed, geometry.grain);
        *windows = windows.iter().flat_map(nearer).collect();
        envelope.join(crossed, windows);
        if is_mirrored {
            mirror(windows);
        }
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.edges.clear();
        self.gathered.clear();
    }
}
