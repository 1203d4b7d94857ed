//! Places of surfaces that walls part.

use super::Place;
use crate::element::{Element, HalfedgeId};
use crate::surface::Surface;

impl Surface {
    /// Whether a place touches walls alone, so that no path leads there.
    pub fn is_in_wall(&self, place: Place) -> bool {
        // Walls share no vertex and no edge with what is open, so that any face tells.
        let face = match place {
            Place::Vertex(vertex) => self.corners_of_vertex(vertex).next().map(|(face, _)| face),
            Place::Edge { halfedge, .. } => Some(self.in_triangle(halfedge).triangle()),
            Place::Face { face, .. } => Some(face),
        };
        face.is_some_and(|face| self.is_wall(face))
    }

    /// A place of the surface before it was [parted](Self::walled), on this one: on an edge of walls, on the side of the
    /// triangle named; at a vertex there, on the vertex's first side.
    pub fn place_across_walls(&self, before: &Self, place: Place) -> Place {
        match place {
            Place::Edge { halfedge, fraction } if halfedge.index() >= 3 * before.face_count() => {
                Place::Edge { halfedge: before.mesh().twin(halfedge), fraction: 1.0 - fraction }
            }
            Place::Edge { halfedge, fraction } if self.is_wall(halfedge.triangle()) => {
                // The other side of the edge may be open.
                let is_open = |other: &HalfedgeId| !self.is_wall(other.triangle());
                let Some(other) = before.edges().around(halfedge).find(is_open) else { return place };
                let is_against = before.ends(other) != before.ends(halfedge);
                Place::Edge { halfedge: other, fraction: if is_against { 1.0 - fraction } else { fraction } }
            }
            _ => place,
        }
    }
}
