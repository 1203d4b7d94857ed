//! Cameras of a file as views of the page.

use glam::DVec3;
use heatwalk_bake::BoundingSphere;
use heatwalk_bindings::Message;
use heatwalk_model::{Camera, Projection};
use heatwalk_scene::DrawTransform;

/// Vertical field of view of the page's camera; radians.
const FIELD_OF_VIEW: f64 = 0.6;
/// What is looked at is at least so many bounding radii away: a camera inside a room looks at something.
const NEAREST: f64 = 0.2;

/// A camera of the file.
#[derive(Message)]
pub struct CameraView {
    /// Its name in the file, or a made one.
    pub name: String,
    /// Six numbers, as the camera of a scene has them.
    pub view: Vec<f64>,
}

impl CameraView {
    /// Looks where the camera does, upright, from where the page's field of view covers as much at the distance of the
    /// surface, which has these bounds as it is drawn.
    pub(crate) fn new(camera: &Camera, transform: &DrawTransform, surface: BoundingSphere) -> Self {
        let (center, radius) = (surface.center.as_dvec3(), f64::from(surface.radius));
        let eye = transform.place(camera.position).as_dvec3();
        let forward = transform.direction(camera.forward);
        let distance = (center - eye).dot(forward).max(NEAREST * radius);
        let DVec3 { x, y, z } = (eye + distance * forward - center) / radius;
        // Half the height of what is seen at the distance of the surface.
        let half = match camera.projection {
            Projection::Perspective { field_of_view } => distance * (0.5 * field_of_view).tan(),
            Projection::Orthographic { height } => 0.5 * height * transform.scale,
        };
        let away = half / (0.5 * FIELD_OF_VIEW).tan();
        let (yaw, pitch) = ((-forward.x).atan2(-forward.z), (-forward.y).clamp(-1.0, 1.0).asin());
        Self { name: camera.name.clone(), view: vec![yaw, pitch, away / radius, x, y, z] }
    }
}
