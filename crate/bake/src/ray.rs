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
