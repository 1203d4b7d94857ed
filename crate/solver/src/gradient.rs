//! Gradient fields of functions on the surface, per face and per point.
//!
//! Botsch, Kobbelt, Pauly, Alliez, Lévy, "Polygon Mesh Processing" (2010), section 3.3.3.

use glam::DVec3;

use crate::halfedge::FaceData;
use crate::heat::Distance;
use crate::surface::Surface;
use crate::triangle;

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

/// `#P × 3`, unit tangents at the points: the mean over the faces around each, by area, laid into the plane of its
/// normal; zero where they cancel.
pub fn point_tangents(surface: &Surface, fields: &FaceData<DVec3>) -> Vec<DVec3> {
    let tangent = |point| {
        let sum: DVec3 = surface.corners_of_point(point).map(|(face, _)| fields[face] * surface.face_area(face)).sum();
        let normal = surface.point_normal(point);
        triangle::unit(sum - normal * sum.dot(normal))
    };
    (0..surface.point_count() as u32).map(tangent).collect()
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

    /// `#P × 3`, unit tangents away from the sources.
    pub fn tangents(&self, surface: &Surface) -> Vec<DVec3> {
        point_tangents(surface, &self.gradients(surface))
    }
}
