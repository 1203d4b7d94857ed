//! Half-lines, and where they meet triangles.

use glam::Vec3;

/// A half-line in world space.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Unit length.
    pub direction: Vec3,
}

impl Ray {
    /// The place so far along it; world units.
    #[must_use]
    pub fn at(&self, depth: f32) -> Vec3 {
        self.origin + depth * self.direction
    }

    /// Whether it meets a box, given by its least and greatest corner.
    #[must_use]
    pub fn meets_box(&self, corners: [Vec3; 2]) -> bool {
        entry(corners, self.origin, self.direction.recip()).is_finite()
    }
}

/// How far along a ray a box begins, given by its least and greatest corner; 0 from inside, infinite where the ray misses it.
/// `inverse`: of its direction.
pub(crate) fn entry([low, high]: [Vec3; 2], origin: Vec3, inverse: Vec3) -> f32 {
    let (mut enters, mut leaves) = (0.0_f32, f32::INFINITY);
    for axis in 0..3 {
        let [a, b] = [low, high].map(|side| side[axis] - origin[axis]);
        if inverse[axis].is_finite() {
            enters = enters.max((a * inverse[axis]).min(b * inverse[axis]));
            leaves = leaves.min((a * inverse[axis]).max(b * inverse[axis]));
        } else if a > 0.0 || b < 0.0 {
            return f32::INFINITY;
        }
    }
    if enters <= leaves { enters } else { f32::INFINITY }
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index of the triangle.
    pub triangle: u32,
    /// Barycentric weights of the triangle's three corners; they sum to one.
    pub weights: Vec3,
    /// Distance along the ray; world units.
    pub depth: f32,
}
