//! Gradient fields of functions on the surface, per face and per vertex.
//!
//! Botsch, Kobbelt, Pauly, Alliez, Lévy, "Polygon Mesh Processing" (2010), section 3.3.3.

use std::ops::Range;

use glam::DVec3;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceData, VertexData, triangle};

use crate::distance::Distance;
use crate::error::Result;

/// Squared lengths that neither under- nor overflow, however small a part of them is.
const PLAIN_SQUARES: Range<f64> = 1e-280..1e280;

/// `#F × 3`, gradient of the linear interpolation of `values` (`#V`) on each face; zero where it is not finite.
pub fn face_gradients(surface: &Surface, values: &VertexData<f64>) -> FaceData<DVec3> {
    let gradient = |face| {
        let corners = surface.faces()[face].map(|vertex| values[vertex]);
        triangle::gradient(surface.corners(face), corners)
    };
    surface.mesh().faces().map(gradient).collect()
}

/// `#F × 3`, unit vectors along the gradient of `values` (`#V`) on each face; zero where they are constant. Right for
/// values that fall by hundreds of orders of magnitude over the surface, as heat does.
pub fn face_directions(surface: &Surface, values: &VertexData<f64>) -> FaceData<DVec3> {
    let direction = |face| {
        let corners = surface.faces()[face].map(|vertex| values[vertex]);
        // Only ratios within the face matter.
        let scale = corners.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let scaled = corners.map(|value| if scale > 0.0 { value / scale } else { 0.0 });
        triangle::unit(triangle::gradient(surface.corners(face), scaled))
    };
    surface.mesh().faces().map(direction).collect()
}

/// `#V × 3`, unit vectors at the vertices along the mean, by area, of the gradients of `values` (`#V`) on the faces around;
/// zero where they cancel or are not finite.
pub fn vertex_directions(surface: &Surface, values: &VertexData<f64>) -> VertexData<DVec3> {
    let mut directions: VertexData<_> = vec![DVec3::ZERO; surface.vertex_count()].into();
    for face in surface.mesh().faces() {
        let vertices = surface.faces()[face];
        let corners = surface.corners(face);
        // The gradient times twice the area.
        let area = triangle::area_vector(corners);
        let [_, b, c] = triangle::edges(corners);
        let [from, to_b, to_c] = vertices.map(|vertex| values[vertex]);
        let along = b * (to_b - from) + c * (to_c - from);
        let length_squared = area.length_squared();
        let sum = area.cross(along) / length_squared.sqrt();
        if sum.is_finite() {
            for vertex in vertices {
                directions[vertex] += sum;
            }
        }
    }
    for direction in &mut directions {
        let squared = direction.length_squared();
        let is_plain = PLAIN_SQUARES.contains(&squared);
        *direction = if is_plain { squared.sqrt().recip() * *direction } else { triangle::unit(*direction) };
    }
    directions
}

/// `#V × 3`, unit tangents at the vertices: directions laid into the plane of each vertex's normal; zero where they cancel.
pub fn vertex_tangents(surface: &Surface, directions: &VertexData<DVec3>) -> VertexData<DVec3> {
    let tangent = |(vertex, direction): (_, &DVec3)| {
        let normal = surface.vertex_normal(vertex);
        triangle::unit(direction - normal * direction.dot(normal))
    };
    directions.enumerate().map(tangent).collect()
}

/// Each refuses another surface than the one of the distance: [`Error::Surface`](crate::Error::Surface) with
/// `ForeignSurface`.
impl Distance {
    /// `#F × 3`, gradient of the distance on each face, of length near 1, away from the sources; zero where the
    /// distance is infinite.
    pub fn gradients(&self, surface: &Surface) -> Result<FaceData<DVec3>> {
        surface.require_own(self.surface(), "distance")?;
        Ok(face_gradients(surface, &self.values))
    }

    /// `#F × 3`, unit vectors along the gradient of heat on each face, towards the sources. Also refuses a distance that heat
    /// has no part in: [`NoHeat`](crate::Error::NoHeat).
    pub fn heat_directions(&self, surface: &Surface) -> Result<FaceData<DVec3>> {
        surface.require_own(self.surface(), "distance")?;
        Ok(face_directions(surface, self.heat()?))
    }

    /// `#V × 3`, unit vectors away from the sources, not quite in the surface where it is curved.
    pub fn directions(&self, surface: &Surface) -> Result<VertexData<DVec3>> {
        surface.require_own(self.surface(), "distance")?;
        Ok(vertex_directions(surface, &self.values))
    }

    /// `#V × 3`, unit tangents away from the sources.
    pub fn tangents(&self, surface: &Surface) -> Result<VertexData<DVec3>> {
        surface.require_own(self.surface(), "distance")?;
        Ok(vertex_tangents(surface, &self.directions(surface)?))
    }
}
