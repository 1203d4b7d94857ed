//! What lines are followed back to: places, and sides of segments, which they meet somewhere.

use heatwalk_surface::{FaceId, Place};

use super::roots::Root;
use super::wavefront::Wavefront;

/// What a root is to a line that is followed back to it.
#[derive(Debug, Clone, Copy)]
pub(super) enum Goal {
    /// A [settled](super::ExactGeometry::settled) place.
    Place(Place),
    /// The side of a segment.
    Side(u32),
}

impl Wavefront {
    /// That of a root.
    pub(super) fn goal(&self, root: u32) -> Goal {
        match self.root(root) {
            Root::Side(side) => Goal::Side(side),
            _ => Goal::Place(self.geometry.settled(self.place_of_root(root))),
        }
    }

    /// The weights of a goal in the face of a half-edge, if it lies there; of a segment, where it is nearest to a place that is laid out by
    /// the half-edge.
    #[inline(always)]
    pub(super) fn weights_of_goal(&self, goal: Goal, halfedge: u32, place: [f64; 2]) -> Option<[f64; 3]> {
        match goal {
            Goal::Place(place) => self.geometry.weights_at(place, halfedge / 3),
            Goal::Side(side) => self.foot(side, halfedge, place),
        }
    }

    #[cold]
    fn foot(&self, side: u32, halfedge: u32, place: [f64; 2]) -> Option<[f64; 3]> {
        let (frame, k) = self.geometry.frame_of(halfedge);
        let lines = self.lines.as_ref().filter(|lines| lines.face(side) == halfedge / 3)?;
        Some(lines.foot(frame, k, side, place))
    }

    /// Where a root is; of a segment, somewhere on it.
    pub(super) fn place_of_root(&self, root: u32) -> Place {
        match self.root(root) {
            Root::Vertex(vertex) => Place::Vertex(vertex),
            Root::Source(number) => self.sources[number].place(),
            Root::End(end) => self.ends.locations[end as usize],
            Root::Side(side) => {
                let face = self.lines.as_ref().map_or(0, |lines| lines.face(side));
                Place::Face { face: FaceId(face), weights: self.foot(side, 3 * face, [0.0; 2]).unwrap_or_default() }
            }
        }
    }

    /// Where a root is nearest to a place of a face that it lies on.
    pub(super) fn foot_of_root(&self, root: u32, face: u32, from: Place) -> Place {
        let foot = || {
            let Root::Side(side) = self.root(root) else { return None };
            let from = self.geometry.weights_at(self.geometry.settled(from), face)?;
            self.foot(side, 3 * face, self.geometry.frame(face).place(0, from))
        };
        foot().map_or_else(|| self.place_of_root(root), |weights| Place::Face { face: FaceId(face), weights })
    }
}
