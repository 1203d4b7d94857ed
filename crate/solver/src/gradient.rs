//! Gradient fields of functions on the surface, per face and per point.
//!
//! Botsch, Kobbelt, Pauly, Alliez, Lévy, "Polygon Mesh Processing" (2010), section 3.3.3.

use glam::DVec3;

use crate::heat::Distance;
use heatwalk_surface::halfedge::FaceData;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::triangle;

/// `#F × 3`, gradient of the linear interpolation of `values` (`#P`) on each face; zero where it is not finite.
pub fn face_gradients(surface: &Surface, values: &[f64]) -> FaceData<DVec3> {
    let gradient = |face| {
        let corners = surface.faces[face].map(|point| values[point as usize]);
        triangle::gradient(surface.corners(face), corners)
    };
    surface.mesh.faces().map(gradient).collect::<Vec<_>>().into()
}

/// `#F × 3`, unit vectors along the gradient of `values` (`#P`) on each face; zero where they are constant. Right for
/// values that fall by hundreds of orders of magnitude over the surface, as heat does.
pub fn face_directions(surface: &Surface, values: &[f64]) -> FaceData<DVec3> {
    let direction = |face| {
        let corners = surface.faces[face].map(|point| values[point as usize]);
        // Only ratios within the face matter.
        let scale = corners.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let scaled = corners.map(|value| if scale > 0.0 { value / scale } else { 0.0 });
        triangle::unit(triangle::gradient(surface.corners(face), scaled))
    };
    surface.mesh.faces().map(direction).collect::<Vec<_>>().into()
}

/// `#P × 3`, unit vectors at the points along the mean, by area, of the gradients of `values` (`#P`) on the faces around;
/// zero where they cancel or are not finite.
pub fn point_directions(surface: &Surface, values: &[f64]) -> Vec<DVec3> {
    let mut directions = vec![DVec3::ZERO; surface.point_count()];
    for face in surface.mesh.faces() {
        let points = surface.faces[face];
        let corners = surface.corners(face);
        // The gradient times twice the area.
        let area = triangle::area_vector(corners);
        let [_, b, c] = triangle::edges(corners);
        let [from, to_b, to_c] = points.map(|point| values[point as usize]);
        let along = b * (to_b - from) + c * (to_c - from);
        let length_squared = area.length_squared();
        let sum = area.cross(along) / length_squared.sqrt();
        if sum.is_finite() {
            for point in points {
                directions[point as usize] += sum;
            }
        }
    }
    for direction in &mut directions {
        *direction = triangle::unit(*direction);
    }
    directions
}

/// `#P × 3`, unit tangents at the points: directions laid into the plane of each point's normal; zero where they cancel.
pub fn point_tangents(surface: &Surface, directions: &[DVec3]) -> Vec<DVec3> {
    let tangent = |(point, direction): (u32, &DVec3)| {
        let normal = surface.point_normal(point);
        triangle::unit(direction - normal * direction.dot(normal))
    };
    (0..).zip(directions).map(tangent).collect()
}

impl Distance {
    /// `#F × 3`, gradient of the distance on each face, of length near 1, away from the sources; zero where the
    /// distance is infinite.
    pub fn gradients(&self, surface: &Surface) -> FaceData<DVec3> {
        face_gradients(surface, &self.values)
    }

    /// `#F × 3`, unit vectors along the gradient of heat on each face, towards the sources.
    pub fn heat_directions(&self, surface: &Surface) -> FaceData<DVec3> {
        face_directions(surface, &self.heat)
    }

    /// `#P × 3`, unit vectors away from the sources, not quite in the surface where it is curved.
    pub fn directions(&self, surface: &Surface) -> Vec<DVec3> {
        point_directions(surface, &self.values)
    }

    /// `#P × 3`, unit tangents away from the sources.
    pub fn tangents(&self, surface: &Surface) -> Vec<DVec3> {
        point_tangents(surface, &self.directions(surface))
    }
}
