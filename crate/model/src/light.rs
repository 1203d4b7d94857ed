//! Lights of files.

use glam::{DVec3, Vec3};

/// A light of a file, as it stands while nothing moves.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Light {
    /// Where its light goes.
    pub kind: LightKind,
    /// Where it is, in the file's unit.
    pub position: DVec3,
    /// Unit vector to where it shines.
    pub forward: DVec3,
    /// Linear red, green and blue times its strength: in lux for one that is far away, else in candela.
    pub color: Vec3,
}

/// Where the light of a light goes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum LightKind {
    /// It comes from far away.
    Directional,
    /// In all directions.
    Point,
    /// Into a cone.
    Spot {
        /// Angle from its axis up to which it is whole; radians.
        inner: f64,
        /// Angle from which on there is none; radians, up to π/2.
        outer: f64,
    },
}
