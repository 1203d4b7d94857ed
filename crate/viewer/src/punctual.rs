//! Lights of a file (KHR_lights_punctual), which take the place of the soft boxes.

use encase::ShaderType;
use glam::{Vec3, Vec4};

/// Lights that are drawn; the shader has as many.
pub const MOST_PUNCTUAL: usize = 8;

/// A light of a file; world space.
#[derive(Clone, Copy, Debug, Default, PartialEq, ShaderType)]
pub struct PunctualLight {
    /// Its position and 1, or the direction to one that is far away, of unit length, and 0.
    pub place: Vec4,
    /// The direction in which it shines, of unit length, and the offset of its cone, 1 for all directions.
    pub axis: Vec4,
    /// Linear red, green and blue that a matt white surface gives back straight below it at unit distance, and the slope of its
    /// cone by the cosine of the angle from the axis, 0 for all directions.
    pub color: Vec4,
}

/// What is left of sky, floor and soft boxes beside lights of a file: enough of the former to see the side that is turned away.
pub(crate) const AROUND: f32 = 0.15;

/// Those that are drawn, the rest dark.
pub(crate) fn drawn(lights: &[PunctualLight]) -> [PunctualLight; MOST_PUNCTUAL] {
    let mut drawn = [PunctualLight::default(); MOST_PUNCTUAL];
    drawn.iter_mut().zip(lights).for_each(|(drawn, light)| *drawn = *light);
    drawn
}

/// The same colors, in less light.
pub(crate) fn dimmed(colors: [Vec3; 3]) -> [Vec3; 3] {
    colors.map(|color| AROUND * color)
}
