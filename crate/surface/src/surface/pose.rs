//! A surface in other poses: the same connectivity over other positions.

use glam::DVec3;
use heatwalk_base::sort;

use super::{Surface, SurfaceId};
use crate::element::{VertexData, VertexId};
use crate::error::{Error, Result};
use crate::triangle;

/// Share of its shape that a triangle keeps which a pose would leave without area: well above the rounding of coordinates,
/// well below what is seen.
const COLLAPSED: f64 = 1e-6;

impl Surface {
    /// The same connectivity in another place: `#V` positions. Reports and the mean edge stay. It is another surface, with
    /// an id of its own: no distance, path or point of this one holds there.
    pub fn with_positions(&self, positions: VertexData<DVec3>) -> Self {
        Self { id: SurfaceId::unique(), positions, ..self.clone() }
    }

    /// The same surface in another pose: [`Self::with_positions`], but where a triangle would have no area, its corners keep a
    /// little of their places here, since no distance can be measured on what has no shape.
    ///
    /// # Panics
    /// Where there is not one position a vertex.
    #[must_use]
    pub fn posed(&self, mut positions: VertexData<DVec3>) -> Self {
        assert_eq!(positions.len(), self.vertex_count(), "one position a vertex");
        let has_no_area = |&&[a, b, c]: &&[VertexId; 3]| {
            triangle::area_vector([a, b, c].map(|vertex| positions[vertex])) == DVec3::ZERO
        };
        let mut collapsed: Vec<VertexId> = self.faces.iter().filter(has_no_area).flatten().copied().collect();
        sort::sort(&mut collapsed);
        collapsed.dedup();
        let origin = self.positions[VertexId(0)];
        for vertex in collapsed {
            positions[vertex] += COLLAPSED * (self.positions[vertex] - origin);
        }
        self.with_positions(positions)
    }

    /// Whether the other one is the same surface, in this pose or in another.
    #[must_use]
    pub fn is_pose_of(&self, other: &Self) -> bool {
        self.connectivity == other.connectivity
    }

    /// Refuses a surface that is not this one in some pose.
    ///
    /// # Errors
    /// [`ForeignSurface`](crate::Error::ForeignSurface) with the name of the thing that was to be carried between them.
    pub fn require_pose_of(&self, other: &Self, thing: &'static str) -> Result<()> {
        if self.is_pose_of(other) { Ok(()) } else { Err(Error::ForeignSurface { thing }) }
    }
}
