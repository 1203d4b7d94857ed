use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DMat3, DVec3};

/// Nearest and farthest the eye may be from its target, in bounding radii.
pub(super) const DISTANCE_RANGE: (f64, f64) = (0.01, 40.0);
/// Farthest the target may be dragged from the centre, in bounding radii: the surface can always be found again.
pub(super) const TARGET_RANGE: f64 = 20.0;

/// Where the camera stands, free of the surface's scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Rotation about +y; radians. At 0 the camera looks along −z.
    pub yaw: f64,
    /// Height over the horizon; radians, −π/2 to π/2.
    pub pitch: f64,
    /// From the eye to the target; bounding radii.
    pub distance: f64,
    /// The target's offset from the surface's centre; bounding radii.
    pub target: DVec3,
}

impl View {
    /// From the six numbers that a link carries: yaw, pitch, distance, target.
    #[must_use]
    pub fn from_numbers([yaw, pitch, distance, x, y, z]: [f64; 6]) -> Self {
        Self { yaw, pitch, distance, target: DVec3::new(x, y, z) }
    }

    /// The six numbers of [`from_numbers`](Self::from_numbers).
    #[must_use]
    pub fn numbers(self) -> [f64; 6] {
        [self.yaw, self.pitch, self.distance, self.target.x, self.target.y, self.target.z]
    }

    pub(super) fn clamped(self) -> Self {
        Self {
            yaw: self.yaw.rem_euclid(TAU),
            pitch: self.pitch.clamp(-FRAC_PI_2, FRAC_PI_2),
            distance: self.distance.clamp(DISTANCE_RANGE.0, DISTANCE_RANGE.1),
            target: self.target.clamp_length_max(TARGET_RANGE),
        }
    }

    /// From so many times as far. It is not clamped, so that the way there and back ends where it began.
    pub(super) fn scaled(self, factor: f64) -> Self {
        Self { distance: self.distance * factor, ..self }
    }

    /// The camera's axes (right, up, back) as columns.
    pub(super) fn world_from_view(self) -> DMat3 {
        let (yaw_sin, yaw_cos) = self.yaw.sin_cos();
        let (pitch_sin, pitch_cos) = self.pitch.sin_cos();
        let right = DVec3::new(yaw_cos, 0.0, -yaw_sin);
        let back = DVec3::new(pitch_cos * yaw_sin, pitch_sin, pitch_cos * yaw_cos);
        DMat3::from_cols(right, back.cross(right), back)
    }

    /// Between two views with the same direction; distances in proportion, so that a zoom looks even.
    pub(super) fn between(from: Self, to: Self, fraction: f64) -> Self {
        let distance = from.distance * (to.distance / from.distance).powf(fraction);
        Self { distance, target: from.target.lerp(to.target, fraction), ..to }
    }
}
