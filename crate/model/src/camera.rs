//! Cameras of files.

use glam::DVec3;

/// A camera of a file, as it stands while nothing moves.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Camera {
    /// Name in the file, or a made one.
    pub name: String,
    /// Where it is, in the file's unit.
    pub position: DVec3,
    /// Unit vector to what it looks at.
    pub forward: DVec3,
    /// How much of it is seen.
    pub projection: Projection,
}

/// How a camera projects.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum Projection {
    /// To a point.
    Perspective {
        /// Vertical, in radians, between 0 and π.
        field_of_view: f64,
    },
    /// Along its line of sight.
    Orthographic {
        /// Of what is seen, in the file's unit; positive.
        height: f64,
    },
}
