//! What holds of distance however it is found: along an edge it changes by the edge's length at most.
//!
//! In exact arithmetic windows alone see to that. Where triangles are so thin that rounding moves a ray from one side of a vertex to
//! the other, all windows may pass the vertex by; then it gets the distance of its neighbor plus the edge, and sends windows
//! itself, as if paths could bend there.

use super::geometry::{after, before};
use super::origin::Origin;
use super::wavefront::Wavefront;
use super::window::MARGIN;
use crate::room;
use heatwalk_surface::VertexId;

/// Share of an edge by which distances of its ends may differ by more than its length: some roundings.
const SLACK: f64 = 1e-13;

impl Wavefront {
    /// Gives each vertex that is reached, and nearer than `radius`, no more than the distance of its neighbors plus the edge
    /// between. Where windows have lost it, it sends some. Returns whether there are any.
    pub(super) fn relax(&mut self, radius: f64) -> bool {
        let mut lost = Vec::new();
        let mut place = 0;
        let mut changed = Vec::new();
        // Vertices that are reached here come at the end of the list.
        while let Some(vertex) = changed.pop().or_else(|| self.reached.get(place).copied().inspect(|_| place += 1)) {
            if self.values[vertex] < radius {
                self.relax_around(vertex, &mut changed, &mut lost);
            }
        }
        for &vertex in &lost {
            self.queue.rewind(self.values[VertexId(vertex)]);
            self.light_all_around(vertex);
        }
        !lost.is_empty()
    }

    /// Relaxes the edges of a vertex; `changed` are vertices that come nearer, `lost` those of them by more than rounding.
    fn relax_around(&mut self, vertex: VertexId, changed: &mut Vec<VertexId>, lost: &mut Vec<u32>) {
        let (geometry, surface) = (self.geometry.clone(), self.surface.clone());
        let value = self.values[vertex];
        for (face, k) in surface.corners_of_vertex(vertex) {
            let frame = geometry.frame(face.0);
            for (side, end) in [(k, after(k)), (before(k), before(k))] {
                let (length, end) = (frame[side].length, frame[end].vertex);
                let known = self.values[VertexId(end)];
                if known <= value + length * (1.0 + SLACK) {
                    continue;
                }
                let is_lost = known > value + length + (MARGIN * value.abs() + geometry.grain);
                self.offer(end, value + length, Origin::Straight { face: face.0, root: vertex.0 });
                self.is_refused |= !room::push(changed, VertexId(end));
                self.is_refused |= is_lost && !room::push(lost, end);
            }
        }
    }
}
