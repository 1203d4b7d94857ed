//! What holds of distance however it is found: along an edge it changes by the edge's length at most.
//!
//! In exact arithmetic windows alone see to that. Where triangles are so thin that rounding moves a ray from one side of a vertex to
//! the other, all windows may pass the vertex by; then it gets the distance of its neighbor plus the edge, and sends windows
//! itself, as if paths could bend there.

use std::sync::Arc;

use heatwalk_surface::{FaceId, VertexId};

use super::geometry::{Frame, after, before};
use super::origin::Origin;
use super::wavefront::Wavefront;
use super::window::MARGIN;
use crate::room;

/// Share of an edge by which distances of its ends may differ by more than its length: some roundings.
const SLACK: f64 = 1e-13;

/// Vertices that have come nearer.
#[derive(Default)]
struct Nearer {
    /// Whose neighbors are to be looked at.
    open: Vec<VertexId>,
    /// Those that windows have lost.
    lost: Vec<VertexId>,
}

impl Wavefront {
    /// Gives vertices nearer than `radius` no more than the distance of a neighbor plus the edge between. Where windows
    /// have lost one, it sends some. Returns whether there are any.
    pub(super) fn relax(&mut self, radius: f64) -> bool {
        let (geometry, surface) = (Arc::clone(&self.geometry), Arc::clone(&self.surface));
        let mut nearer = Nearer::default();
        if radius == f64::INFINITY {
            surface.faces().ids().for_each(|face| self.relax_face(geometry.frame(face.0), face, radius, &mut nearer));
        } else {
            for place in 0..self.reached.len() {
                for (face, _) in surface.corners_of_vertex(self.reached[place]) {
                    self.relax_face(geometry.frame(face.0), face, radius, &mut nearer);
                }
            }
        }
        while let Some(vertex) = nearer.open.pop() {
            for (face, k) in surface.corners_of_vertex(vertex) {
                let frame = geometry.frame(face.0);
                for (side, end) in [(k, after(k)), (before(k), before(k))] {
                    let edge = (vertex, VertexId(frame[end].vertex));
                    self.relax_edge(edge, (face, frame[side].length), radius, &mut nearer);
                }
            }
        }
        for &vertex in &nearer.lost {
            self.queue.rewind(self.values[vertex]);
            self.light_all_around(vertex.0);
        }
        !nearer.lost.is_empty()
    }

    #[inline(always)]
    fn relax_face(&mut self, frame: &Frame, face: FaceId, radius: f64, nearer: &mut Nearer) {
        let ends = frame.vertices().map(VertexId);
        let values = ends.map(|vertex| self.values[vertex]);
        for k in 0..3 {
            if (values[k] - values[after(k)]).abs() > frame[k].length * (1.0 + SLACK) {
                let (from, to) = if values[k] < values[after(k)] { (k, after(k)) } else { (after(k), k) };
                self.relax_edge((ends[from], ends[to]), (face, frame[k].length), radius, nearer);
            }
        }
    }

    /// Gives the end of an edge, of this length in a face, no more than the distance of its start plus that, where that is below
    /// `radius`.
    fn relax_edge(
        &mut self,
        (from, to): (VertexId, VertexId),
        (face, length): (FaceId, f64),
        radius: f64,
        nearer: &mut Nearer,
    ) {
        let (value, known) = (self.values[from] + length, self.values[to]);
        if value < radius && known > value + SLACK * length {
            let is_lost = known > value + (MARGIN * value.abs() + self.geometry.grain);
            self.offer(to.0, value, Origin::Straight { face: face.0, root: from.0 });
            let geometry = Arc::clone(&self.geometry);
            let frame = geometry.frame(face.0);
            let weights = frame.vertices().map(|corner| f64::from(u8::from(corner == from.0)));
            self.see_straight(frame, face.0, weights, (self.values[from], from.0));
            self.is_refused |= !room::push(&mut nearer.open, to);
            self.is_refused |= is_lost && !room::push(&mut nearer.lost, to);
        }
    }
}
