mod eye;
mod motion;
#[cfg(test)]
mod tests;
mod view;

use std::f64::consts::TAU;

use glam::{DVec2, Vec3};

use self::motion::{Flight, Orbit};
use heatwalk_bake::BoundingSphere;

pub use self::eye::Eye;
pub use self::view::View;

/// Vertical field of view; long enough that shapes are not distorted at the edges of a full window.
const FIELD_OF_VIEW: f64 = 0.6;
/// Room around a framed surface, as a factor on its bounding sphere.
const FRAME_MARGIN: f64 = 1.04;
/// How far what floats over the canvas reaches in from its edges; physical pixels. The view centres on what it leaves free.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Insets {
    /// From the left edge.
    pub left: f64,
    /// From the upper edge.
    pub top: f64,
    /// From the right edge.
    pub right: f64,
    /// From the lower edge.
    pub bottom: f64,
}

/// A turntable camera: yaw about the vertical, pitch, and a target to look at.
#[derive(Clone, Debug)]
pub struct Camera {
    view: View,
    flight: Option<Flight>,
    orbit: Orbit,
    /// Of the turntable; radians a second.
    spin: f64,
    surface: BoundingSphere,
    scene: BoundingSphere,
    /// Physical pixels.
    size: DVec2,
    /// Physical pixels a CSS pixel.
    pixel_ratio: f64,
    insets: Insets,
    is_orthographic: bool,
}

impl Camera {
    /// A camera that frames the unit sphere from slightly above and to the side.
    #[must_use]
    pub fn new() -> Self {
        let view = View {
            yaw: 0.5,
            pitch: 0.3,
            distance: FRAME_MARGIN / (0.5 * FIELD_OF_VIEW).sin(),
            target: glam::DVec3::ZERO,
        };
        Self {
            view,
            flight: None,
            orbit: Orbit::default(),
            spin: 0.0,
            surface: BoundingSphere::UNIT,
            scene: BoundingSphere::UNIT,
            size: DVec2::ONE,
            pixel_ratio: 1.0,
            insets: Insets::default(),
            is_orthographic: false,
        }
    }

    /// Whether lines of sight are parallel; what is at the target is as large as in perspective.
    pub fn set_orthographic(&mut self, is_orthographic: bool) {
        self.is_orthographic = is_orthographic;
    }

    /// What the view is relative to, and what must lie between the near and the far plane.
    pub fn set_bounds(&mut self, surface: BoundingSphere, scene: BoundingSphere) {
        self.surface = surface;
        self.scene = scene;
    }

    /// Canvas size in physical pixels, and how many of them make a CSS pixel.
    pub fn set_size(&mut self, width: u32, height: u32, pixel_ratio: f32) {
        self.size = DVec2::new(f64::from(width.max(1)), f64::from(height.max(1)));
        self.pixel_ratio = f64::from(pixel_ratio);
    }

    /// The same view in a picture so many times as large, without insets.
    #[must_use]
    pub fn scaled(&self, scale: f32) -> Self {
        let scale = f64::from(scale);
        let (size, pixel_ratio) = ((scale * self.size).round(), scale * self.pixel_ratio);
        Self { size, pixel_ratio, insets: Insets::default(), ..self.clone() }
    }

    /// Centres the view on what the insets leave free.
    pub fn set_insets(&mut self, insets: Insets) {
        self.insets = insets;
    }

    /// Size of the canvas that the insets leave free, at least a third of it each way; physical pixels.
    fn free_size(&self) -> DVec2 {
        let covered = DVec2::new(self.insets.left + self.insets.right, self.insets.top + self.insets.bottom);
        (self.size - covered).max(self.size / 3.0)
    }

    /// From the middle of the canvas to the middle of what is free, x right, y down; physical pixels.
    fn center_offset(&self) -> DVec2 {
        0.5 * DVec2::new(self.insets.left - self.insets.right, self.insets.top - self.insets.bottom)
    }

    /// The column of pixels that is so far right of the middle of what is free, a share of the width; within the canvas.
    pub(crate) fn column(&self, offset: f32) -> u32 {
        let column = (0.5 + f64::from(offset)) * self.size.x + self.center_offset().x;
        column.round().clamp(0.0, self.size.x) as u32
    }

    /// Physical pixels across and down.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        let [width, height] = self.size.max(DVec2::ONE).to_array();
        (width as u32, height as u32)
    }

    /// Physical pixels a CSS pixel.
    #[must_use]
    pub fn pixel_ratio(&self) -> f32 {
        self.pixel_ratio as f32
    }

    /// The current view.
    #[must_use]
    pub fn view(&self) -> View {
        self.view
    }

    /// Jumps to a view; out-of-range values are clamped.
    pub fn set_view(&mut self, view: View) {
        self.flight = None;
        self.orbit.rest();
        self.view = view.clamped();
    }

    /// Orbits the target by a drag in CSS pixels; a drag over the window's height is a full turn.
    pub fn orbit(&mut self, dx: f64, dy: f64) {
        let turn = TAU * self.pixel_ratio / self.size.y * DVec2::new(-dx, dy);
        self.flight = None;
        self.turn(turn);
        self.orbit.follow(turn);
    }

    fn turn(&mut self, turn: DVec2) {
        self.view = View { yaw: self.view.yaw + turn.x, pitch: self.view.pitch + turn.y, ..self.view }.clamped();
    }

    /// The pointer takes hold to orbit.
    pub fn begin_orbit(&mut self) {
        self.orbit.begin();
    }

    /// The pointer lets go; the camera glides on as fast as it was, or not at all.
    pub fn end_orbit(&mut self, glides: bool) {
        self.orbit.end(glides);
    }

    /// Turns by itself, in radians a second, until that is 0 again.
    pub fn set_spin(&mut self, spin: f64) {
        self.spin = spin;
    }

    /// Moves the target so that what is at its depth follows a drag in CSS pixels.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        let reach = self.view.distance * self.pixel_slope() * self.pixel_ratio;
        let axes = self.view.world_from_view();
        let shift = reach * (axes.y_axis * dy - axes.x_axis * dx);
        self.set_view(View { target: self.view.target + shift, ..self.view });
    }

    /// Divides the distance to the target; above 1 is nearer.
    pub fn zoom(&mut self, factor: f64) {
        self.set_view(View { distance: self.view.distance / factor, ..self.view });
    }

    /// Where the fitting distance was another one: what filled a share of the free window fills as large a share now.
    pub fn refit(&mut self, before: f64) {
        let factor = self.fitting_distance() / before;
        self.view = self.view.scaled(factor);
        self.flight = self.flight.map(|flight| flight.scaled(factor));
    }

    /// Distance from which the scene fits into what the insets leave free; bounding radii of the surface.
    #[must_use]
    pub fn fitting_distance(&self) -> f64 {
        let free = self.free_size() / self.size.y * (0.5 * FIELD_OF_VIEW).tan();
        let (half_horizontal, half_vertical) = (free.x.atan(), free.y.atan());
        let radius = f64::from(self.scene.radius / self.surface.radius);
        FRAME_MARGIN * radius / half_vertical.min(half_horizontal).sin()
    }

    /// Fits the scene into what the insets leave free, by a smooth move if it `flies`, else at once; the direction stays.
    pub fn frame(&mut self, flies: bool) {
        let distance = self.fitting_distance();
        let target = (self.scene.center - self.surface.center).as_dvec3() / f64::from(self.surface.radius);
        self.move_to(View { distance, target, ..self.view }, flies);
    }

    /// Moves the target to a world point, smoothly if it `flies`, else at once; direction and distance stay.
    pub fn focus(&mut self, point: Vec3, flies: bool) {
        let target = (point - self.surface.center).as_dvec3() / f64::from(self.surface.radius);
        self.move_to(View { target, ..self.view }, flies);
    }

    fn move_to(&mut self, to: View, flies: bool) {
        self.orbit = Orbit::default();
        if flies {
            self.flight = Some(Flight::new(self.view, to.clamped()));
        } else {
            self.set_view(to);
        }
    }

    /// True while the camera moves by itself, or the pointer's speed is being taken.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.flight.is_some() || self.orbit.is_moving() || self.spin != 0.0
    }

    /// Takes what moves by itself further.
    pub fn advance(&mut self, seconds: f64) {
        let seconds = seconds.max(0.0);
        if self.spin != 0.0 && !self.orbit.is_held() {
            self.turn(DVec2::new(self.spin * seconds, 0.0));
        }
        let glide = self.orbit.advance(seconds);
        if glide != DVec2::ZERO {
            self.turn(glide);
        }
        let Some(flight) = &mut self.flight else { return };
        let (view, is_last) = flight.advance(seconds);
        self.view = if self.spin == 0.0 { view } else { View { yaw: self.view.yaw, ..view } };
        if is_last {
            self.flight = None;
        }
    }
}

impl Default for Camera {
    fn default() -> Self {
        Self::new()
    }
}
