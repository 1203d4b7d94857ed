//! One of the agents.

use glam::{DMat3, DQuat, DVec3};
use heatwalk::FaceId;

/// Someone on the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agent {
    /// A face that it stands on.
    pub face: FaceId,
    /// Where in that face: barycentric weights, non-negative, of sum 1.
    pub weights: [f64; 3],
    /// The same place, in the file's unit.
    pub position: DVec3,
    /// In the file's unit a second, along the surface.
    pub velocity: DVec3,
    /// Unit normal there.
    pub upright: DVec3,
    /// Unit vector at right angles to `upright`, in which it looks.
    pub heading: DVec3,
    /// In the file's unit.
    pub radius: f64,
    /// In the file's unit a second, where a unit of length costs 1.
    pub speed: f64,
    /// How far the nearest source is; infinite where there is none.
    pub left: f64,
    /// Whether it touches a source, or one that has arrived and is nearer to it.
    pub has_arrived: bool,
}

impl Agent {
    /// The turn that takes x to its right, y upward and z backward, as models of glTF stand.
    #[must_use]
    pub fn orientation(&self) -> DQuat {
        let back = -self.heading;
        DQuat::from_mat3(&DMat3::from_cols(self.upright.cross(back), self.upright, back))
    }
}
