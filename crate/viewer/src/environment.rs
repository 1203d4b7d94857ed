//! What lights the scene: an imagined room of a floor, a sky and a few soft boxes, given in closed form, so that a
//! mirror shows it sharp and a matt surface blurred without any texture.

use std::f32::consts::PI;

use encase::ShaderType;
use glam::Vec3;

use crate::color::linear_from_srgb;

/// Lights of every environment; the first is the key light, which casts the shadows.
pub(crate) const LIGHT_COUNT: usize = 4;

/// Surroundings to choose from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Surroundings {
    /// A photographer's room with large soft boxes.
    #[default]
    Studio,
    /// Open air under a blue sky.
    Sky,
    /// A dark room with coloured lamps.
    Night,
}

/// A rectangle that shines, far away.
struct SoftBox {
    /// Degrees to the right of the viewer who looks along the environment's front, 0 behind the viewer.
    azimuth: f32,
    /// Degrees above the horizon.
    elevation: f32,
    /// Half its width and half its height over its distance.
    half: [f32; 2],
    /// sRGB, 0..1.
    color: [f32; 3],
    /// Factor on the colour.
    strength: f32,
}

/// Colours of sky and floor (sRGB), and the lights.
struct Room {
    zenith: [f32; 3],
    horizon: [f32; 3],
    nadir: [f32; 3],
    lights: [SoftBox; LIGHT_COUNT],
}

const STUDIO: Room = Room {
    zenith: [0.56, 0.58, 0.62],
    horizon: [0.70, 0.71, 0.73],
    nadir: [0.40, 0.39, 0.385],
    lights: [
        SoftBox { azimuth: -42.0, elevation: 52.0, half: [0.55, 0.42], color: [1.0, 0.965, 0.91], strength: 4.6 },
        SoftBox { azimuth: 62.0, elevation: 22.0, half: [0.22, 0.85], color: [0.86, 0.93, 1.0], strength: 2.0 },
        SoftBox { azimuth: 168.0, elevation: 34.0, half: [0.95, 0.30], color: [0.95, 0.97, 1.0], strength: 3.0 },
        SoftBox { azimuth: -112.0, elevation: 12.0, half: [0.20, 0.70], color: [1.0, 0.93, 0.86], strength: 1.6 },
    ],
};

const SKY: Room = Room {
    zenith: [0.36, 0.53, 0.82],
    horizon: [0.85, 0.90, 0.96],
    nadir: [0.44, 0.42, 0.37],
    lights: [
        SoftBox { azimuth: -50.0, elevation: 48.0, half: [0.16, 0.16], color: [1.0, 0.95, 0.84], strength: 34.0 },
        SoftBox { azimuth: 95.0, elevation: 55.0, half: [0.9, 0.5], color: [0.80, 0.89, 1.0], strength: 0.9 },
        SoftBox { azimuth: 180.0, elevation: 18.0, half: [1.3, 0.25], color: [1.0, 0.97, 0.92], strength: 1.1 },
        SoftBox { azimuth: -120.0, elevation: 8.0, half: [0.8, 0.12], color: [0.95, 0.96, 1.0], strength: 0.5 },
    ],
};

const NIGHT: Room = Room {
    zenith: [0.13, 0.14, 0.22],
    horizon: [0.20, 0.20, 0.30],
    nadir: [0.09, 0.08, 0.12],
    lights: [
        SoftBox { azimuth: -48.0, elevation: 46.0, half: [0.40, 0.40], color: [0.78, 0.86, 1.0], strength: 2.4 },
        SoftBox { azimuth: 72.0, elevation: 14.0, half: [0.14, 1.1], color: [1.0, 0.28, 0.62], strength: 5.0 },
        SoftBox { azimuth: -105.0, elevation: 10.0, half: [0.14, 1.1], color: [0.15, 0.72, 1.0], strength: 5.0 },
        SoftBox { azimuth: 172.0, elevation: 40.0, half: [0.8, 0.2], color: [0.72, 0.66, 1.0], strength: 2.0 },
    ],
};

/// Surroundings, and how far they are turned.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Environment {
    pub(crate) surroundings: Surroundings,
    /// Yaw of the camera, radians, that the environment faces.
    pub(crate) yaw: f32,
}

impl Environment {
    fn room(self) -> &'static Room {
        match self.surroundings {
            Surroundings::Studio => &STUDIO,
            Surroundings::Sky => &SKY,
            Surroundings::Night => &NIGHT,
        }
    }

    /// Direction from the scene to a light, unit length, and along the light's width.
    fn axes(self, light: &SoftBox) -> [Vec3; 2] {
        let (sin, cos) = (self.yaw + light.azimuth.to_radians()).sin_cos();
        let (up, out) = light.elevation.to_radians().sin_cos();
        [Vec3::new(out * sin, up, out * cos), Vec3::new(cos, 0.0, -sin)]
    }

    /// Direction from the scene to the key light; unit length.
    pub(crate) fn key(self) -> Vec3 {
        self.axes(&self.room().lights[0])[0]
    }

    /// Light on the floor: the key light's share of all that falls there where nothing stands in its way.
    pub(crate) fn key_share(self) -> f32 {
        let room = self.room();
        let luminance = |color: Vec3| color.dot(Vec3::new(0.2126, 0.7152, 0.0722));
        let of_light = |light: &SoftBox| {
            let height = self.axes(light)[0].y.max(0.0);
            let radiance = light.strength * linear_from_srgb(Vec3::from(light.color));
            luminance(radiance) * height * solid_angle(light.half) / PI
        };
        let [horizon, zenith] = [room.horizon, room.zenith].map(|color| luminance(linear_from_srgb(Vec3::from(color))));
        let around = 0.5 * (horizon + zenith) + room.lights[1..].iter().map(of_light).sum::<f32>();
        let key = of_light(&room.lights[0]);
        key / (key + around)
    }

    /// Linear colours of the zenith, the horizon and the nadir.
    pub(crate) fn colors(self) -> [Vec3; 3] {
        let room = self.room();
        [room.zenith, room.horizon, room.nadir].map(|color| linear_from_srgb(Vec3::from(color)))
    }

    pub(crate) fn lights(self) -> [Light; LIGHT_COUNT] {
        self.room().lights.each_ref().map(|light| {
            let [towards, right] = self.axes(light);
            let [half_width, half_height] = light.half;
            let radiance = light.strength * linear_from_srgb(Vec3::from(light.color));
            Light { towards, half_width, right, half_height, radiance, share: solid_angle(light.half) / PI }
        })
    }
}

/// `Light` of shared.wgsl.
#[derive(Clone, Copy, Debug, ShaderType)]
pub(crate) struct Light {
    /// Direction to its middle, unit length.
    towards: Vec3,
    /// Over its distance, as the half height.
    half_width: f32,
    /// Direction along its width, unit length.
    right: Vec3,
    half_height: f32,
    /// Linear colour.
    radiance: Vec3,
    /// Solid angle over π.
    share: f32,
}

impl Light {
    /// The same light, dark.
    pub(crate) fn out(self) -> Self {
        Self { radiance: Vec3::ZERO, ..self }
    }
}

/// Of a rectangle straight ahead, from half its sides over its distance; steradians.
fn solid_angle([a, b]: [f32; 2]) -> f32 {
    4.0 * (a * b / ((1.0 + a * a) * (1.0 + b * b)).sqrt()).asin()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_axes_are_at_right_angles_and_turn_with_the_environment() {
        for surroundings in [Surroundings::Studio, Surroundings::Sky, Surroundings::Night] {
            let environment = Environment { surroundings, yaw: 0.3 };
            for light in &environment.room().lights {
                let [towards, right] = environment.axes(light);
                assert!(towards.is_normalized() && right.is_normalized() && towards.dot(right).abs() < 1e-6);
            }
            assert!(environment.key().y > 0.5, "shadows fall on the floor");
            let share = environment.key_share();
            assert!(share > 0.1 && share < 0.9, "they are seen, and never black: {share}");
        }
        let ahead = Environment { surroundings: Surroundings::Studio, yaw: 0.0 }.key();
        assert!(ahead.x < 0.0 && ahead.z > 0.0, "the key light stands behind the viewer, to the left");
    }

    #[test]
    fn a_rectangle_that_fills_half_the_view_has_half_the_sphere() {
        assert!((solid_angle([1e4, 1e4]) - 2.0 * PI).abs() < 1e-3);
        // Near the axis: area over squared distance.
        assert!((solid_angle([0.01, 0.02]) - 8e-4).abs() < 1e-6);
    }
}
