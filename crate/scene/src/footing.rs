//! How figures stand on a surface.

use glam::DVec3;
use heatwalk::surface::triangle;
use heatwalk::{Surface, VertexData};

use crate::flow::{Place, combined};

/// `#V`, position and normal of each vertex, the latter of unit length or zero where faces cancel. Figures come to
/// vertices in no order, and find both in one place of memory.
#[derive(Debug, Clone)]
pub(crate) struct Footing(VertexData<[DVec3; 2]>);

impl Footing {
    pub fn new(surface: &Surface) -> Self {
        Self(surface.vertices().map(|vertex| [surface.position(vertex), surface.vertex_normal(vertex)]).collect())
    }

    /// Position and upright at a place: the normal is interpolated between those of the vertices, or the face's where these point below it.
    pub fn stand(&self, surface: &Surface, Place { face, weights }: Place) -> (DVec3, DVec3) {
        let footing = surface.faces()[face].map(|vertex| self.0[vertex]);
        let corners = footing.map(|[position, _]| position);
        let mean = combined(footing.map(|[_, normal]| normal), weights);
        let is_above = mean.dot(triangle::area_vector(corners)) > 0.0;
        let upright = if is_above { mean.normalize() } else { surface.face_normal(face) };
        (combined(corners, weights), upright)
    }
}

/// The heading after a share of the turn to a direction, both laid at right angles to `upright`.
pub(crate) fn turned(heading: DVec3, direction: DVec3, upright: DVec3, share: f64) -> DVec3 {
    let laid = |vector: DVec3| vector - upright * upright.dot(vector);
    let (heading, direction) = (laid(heading), laid(direction).normalize_or_zero());
    // The mean with a direction behind would hardly turn, or vanish: first to the side.
    let goal = if heading.dot(direction) < 0.0 {
        let left = upright.cross(heading);
        if left.dot(direction) < 0.0 { -left } else { left }
    } else if direction == DVec3::ZERO {
        heading
    } else {
        direction
    };
    // Laid again, for a vector along the normal leaves nothing but rounding.
    laid(heading + (goal - heading) * share).try_normalize().unwrap_or_else(|| upright.any_orthonormal_vector())
}
