//! From the view to matrices, rays and pixels.

use glam::dcamera::rh::proj::directx::{orthographic, perspective};
use glam::{DMat3, DMat4, DVec2, DVec3, Vec2, Vec3};

use super::{Camera, FIELD_OF_VIEW};
use heatwalk_bake::Ray;

/// The near plane is at least this share of the far one, so that depth keeps its resolution when the eye is inside.
const NEAREST_NEAR: f64 = 1e-3;
/// Pins and the walker stand out from the surface: the depth range covers this factor on the scene's radius.
const DEPTH_MARGIN: f64 = 1.3;
/// The floor with the scene's shadow reaches beyond that, away from the eye.
const FLOOR_MARGIN: f64 = 1.8;

/// Where lines of sight are parallel the eye stands for all of them: so many radii away, from where they differ by less than shading
/// shows.
const AWAY: f64 = 1000.0;

/// What one frame needs of the camera; world space.
#[derive(Clone, Copy, Debug)]
pub struct Eye {
    /// Projection and view; depth 0 at the near plane, 1 at the far one.
    pub clip_from_world: DMat4,
    /// Axes right, up, back as columns; orthonormal.
    pub world_from_view: DMat3,
    /// Where the eye is.
    pub position: DVec3,
    /// World size of a physical pixel at unit distance.
    pub pixel_slope: f64,
}

impl Camera {
    /// World size of a physical pixel at unit distance.
    pub(super) fn pixel_slope(&self) -> f64 {
        2.0 * (0.5 * FIELD_OF_VIEW).tan() / self.size.y
    }

    /// Matrices for the current view.
    #[must_use]
    pub fn eye(&self) -> Eye {
        let radius = f64::from(self.surface.radius);
        let world_from_view = self.view.world_from_view();
        let target = self.surface.center.as_dvec3() + radius * self.view.target;
        let distance = if self.is_orthographic { AWAY } else { self.view.distance };
        let position = target + radius * distance * world_from_view.z_axis;
        let scene_radius = f64::from(self.scene.radius);
        let depth = world_from_view.z_axis.dot(position - self.scene.center.as_dvec3());
        // With the scene behind the eye any positive range will do.
        let far = (depth + FLOOR_MARGIN * scene_radius).max(1e-3 * radius);
        let near = (depth - DEPTH_MARGIN * scene_radius).max(NEAREST_NEAR * far);
        let [right, down] = (2.0 * self.center_offset() / self.size).to_array();
        let shift = DMat4::from_translation(DVec3::new(right, -down, 0.0));
        let pixel_slope = self.pixel_slope() * self.view.distance / distance;
        let clip_from_view = if self.is_orthographic {
            let half = 0.5 * radius * distance * pixel_slope * self.size;
            shift * orthographic(-half.x, half.x, -half.y, half.y, near, far)
        } else {
            shift * perspective(FIELD_OF_VIEW, self.size.x / self.size.y, near, far)
        };
        let view_from_world = DMat4::from_mat3(world_from_view.transpose()) * DMat4::from_translation(-position);
        Eye { clip_from_world: clip_from_view * view_from_world, world_from_view, position, pixel_slope }
    }

    /// The ray through a physical pixel, (0, 0) being the upper left corner of the canvas.
    #[must_use]
    pub fn ray(&self, pixel: Vec2) -> Ray {
        let eye = self.eye();
        let offset = (pixel.as_dvec2() - 0.5 * self.size - self.center_offset()) * eye.pixel_slope;
        let across = eye.world_from_view * DVec3::new(offset.x, -offset.y, 0.0);
        let back = eye.world_from_view.z_axis;
        if !self.is_orthographic {
            return Ray { origin: eye.position.as_vec3(), direction: (across - back).normalize().as_vec3() };
        }
        // From in front of all there is, and no farther: single precision has no digits to lose.
        let radius = f64::from(self.surface.radius);
        let ahead = back.dot(eye.position - self.scene.center.as_dvec3()) - DEPTH_MARGIN * f64::from(self.scene.radius);
        let origin = eye.position + AWAY * radius * across - ahead * back;
        Ray { origin: origin.as_vec3(), direction: (-back).as_vec3() }
    }

    /// Physical pixel (x, y) and depth (0 near, 1 far) of a world point; None behind the eye.
    #[must_use]
    pub fn project(&self, point: Vec3) -> Option<Vec3> {
        let clip = self.eye().clip_from_world * point.as_dvec3().extend(1.0);
        if clip.w <= 0.0 {
            return None;
        }
        let device = clip.truncate() / clip.w;
        let pixel = 0.5 * self.size * DVec2::new(1.0 + device.x, 1.0 - device.y);
        Some(pixel.extend(device.z).as_vec3())
    }
}
