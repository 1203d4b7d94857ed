//! What is seen through a convex polygon.

use glam::DVec3;

/// A place is seen where it is outside of a plane of the cone by no more than this share of its distance: lines through vertices,
/// along edges and along the boundary are inside, whatever rounding makes of them.
const GRAZING: f64 = 1e-9;

/// Nothing is seen through a polygon of less than this angle across, in radians: its sides would be rounding.
const THIN: f64 = 1e-12;

/// All that is seen from a place through a convex polygon.
#[derive(Debug, Clone)]
pub(super) struct Cone {
    apex: DVec3,
    /// Unit vectors into the cone, at right angles to its sides.
    sides: Vec<DVec3>,
}

impl Cone {
    /// Through a triangle; none where that is seen edge on.
    pub(super) fn new(apex: DVec3, triangle: [DVec3; 3]) -> Option<Self> {
        Self::through(apex, &triangle.map(|corner| corner - apex))
    }

    fn through(apex: DVec3, corners: &[DVec3]) -> Option<Self> {
        // As directions, whose products do not underflow whatever the size of the mesh.
        let corners: Vec<DVec3> = corners.iter().map(|corner| corner.normalize_or_zero()).collect();
        let inside: DVec3 = corners.iter().sum();
        let next = corners.iter().cycle().skip(1);
        let mut sides = Vec::with_capacity(corners.len());
        for (corner, next) in corners.iter().zip(next) {
            let normal = corner.cross(*next);
            // Where two corners are one but for rounding, there is no side between them.
            if normal.length() <= THIN {
                continue;
            }
            let normal = normal.normalize();
            let depth = normal.dot(inside);
            if depth.abs() <= THIN * inside.length() {
                return None;
            }
            sides.push(depth.signum() * normal);
        }
        (sides.len() >= 3).then_some(Self { apex, sides })
    }

    /// Whether a place is seen.
    pub(super) fn sees(&self, place: DVec3) -> bool {
        let to = place - self.apex;
        let beyond = -GRAZING * to.length();
        self.sides.iter().all(|side| side.dot(to) >= beyond)
    }

    /// What is seen through another triangle, too; none where nothing is.
    pub(super) fn narrowed(&self, triangle: [DVec3; 3]) -> Option<Self> {
        let mut corners: Vec<DVec3> = triangle.map(|corner| corner - self.apex).to_vec();
        // By Sutherland and Hodgman (1974).
        for side in &self.sides {
            let mut cut = Vec::with_capacity(corners.len() + 1);
            for (index, &corner) in corners.iter().enumerate() {
                let next = corners[(index + 1) % corners.len()];
                let [here, there] = [side.dot(corner), side.dot(next)];
                if here >= 0.0 {
                    cut.push(corner);
                }
                if (here < 0.0) != (there < 0.0) {
                    cut.push(corner.lerp(next, here / (here - there)));
                }
            }
            corners = cut;
        }
        Self::through(self.apex, &corners)
    }
}
