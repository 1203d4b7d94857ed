//! The camera, and what lies under a pixel.

use glam::{Vec2, Vec3};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use super::Viewer;
use super::results::Hit;
use crate::camera::{Camera, Insets, View};

#[wasm_bindgen]
impl Viewer {
    /// How far panels reach in from the edges, physical pixels: the view centres on what they leave free.
    pub fn set_insets(&mut self, left: f64, top: f64, right: f64, bottom: f64) {
        self.renderer.set_insets(Insets { left, top, right, bottom });
    }

    /// Distance from which surface and scenery fit into what the insets leave free; bounding radii.
    #[must_use]
    pub fn fitting_distance(&self) -> f64 {
        self.renderer.fitting_distance()
    }

    /// After the window or the insets have changed: what was drawn as large a share of what fits is again. `before`: what
    /// `fitting_distance` was.
    pub fn refit(&mut self, before: f64) {
        self.renderer.move_camera(|camera| camera.refit(before));
    }

    /// Whether lines of sight are parallel.
    pub fn set_orthographic(&mut self, is_orthographic: bool) {
        self.renderer.move_camera(|camera| camera.set_orthographic(is_orthographic));
    }

    /// Orbits the target; CSS pixels.
    pub fn orbit(&mut self, dx: f64, dy: f64) {
        self.renderer.move_camera(|camera| camera.orbit(dx, dy));
    }

    /// The pointer takes hold to orbit.
    pub fn begin_orbit(&mut self) {
        self.renderer.move_camera(Camera::begin_orbit);
    }

    /// The pointer lets go; the camera glides on or stops.
    pub fn end_orbit(&mut self, glides: bool) {
        self.renderer.move_camera(|camera| camera.end_orbit(glides));
    }

    /// Turns by itself, in radians a second; 0 stops.
    pub fn set_spin(&mut self, spin: f64) {
        self.renderer.move_camera(|camera| camera.set_spin(spin));
    }

    /// Pans: moves the target along the screen; CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.renderer.move_camera(|camera| camera.pan(dx, dy));
    }

    /// Zooms by a factor: above 1 is nearer.
    pub fn zoom(&mut self, factor: f64) {
        self.renderer.move_camera(|camera| camera.zoom(factor));
    }

    /// Fits surface and scenery into the window, smoothly if the camera `flies`, else at once.
    pub fn frame(&mut self, flies: bool) {
        self.renderer.move_camera(|camera| camera.frame(flies));
    }

    /// Moves the target to a world point, smoothly if the camera `flies`, else at once.
    pub fn focus(&mut self, x: f32, y: f32, z: f32, flies: bool) {
        self.renderer.move_camera(|camera| camera.focus(Vec3::new(x, y, z), flies));
    }

    /// Yaw and pitch in radians, distance and target offset in bounding radii.
    #[must_use]
    pub fn camera(&self) -> Vec<f64> {
        self.renderer.view().numbers().to_vec()
    }

    /// Sets what `camera` returns, at once.
    ///
    /// # Errors
    /// Throws when there are not six finite numbers.
    pub fn set_camera(&mut self, camera: &[f64]) -> Result<(), JsError> {
        let numbers = <[f64; 6]>::try_from(camera)
            .ok()
            .filter(|numbers| numbers.iter().all(|number| number.is_finite()))
            .ok_or_else(|| JsError::new("A camera is six finite numbers."))?;
        self.renderer.move_camera(|camera| camera.set_view(View::from_numbers(numbers)));
        Ok(())
    }

    /// The nearest place of the surface or the section under a physical pixel that scenery does not hide. What is cut away is
    /// not there.
    #[must_use]
    pub fn pick(&self, x: f32, y: f32) -> Option<Hit> {
        self.renderer.pick(Vec2::new(x, y)).map(Hit)
    }

    /// The pin whose ball is seen under a physical pixel, or within `slack` CSS pixels.
    #[must_use]
    pub fn pick_pin(&self, x: f32, y: f32, slack: f32) -> Option<usize> {
        self.renderer.pick_pin(Vec2::new(x, y), slack)
    }

    /// Physical pixel and depth of a world point; undefined behind the camera.
    #[must_use]
    pub fn project(&self, x: f32, y: f32, z: f32) -> Option<Vec<f32>> {
        self.renderer.project(Vec3::new(x, y, z)).map(|pixel| pixel.to_array().to_vec())
    }
}
