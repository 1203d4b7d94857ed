use std::f64::consts::{FRAC_PI_2, TAU};

use glam::dcamera::rh::proj::directx::perspective;
use glam::{DMat3, DMat4, DVec2, DVec3, Vec2, Vec3};

use crate::bounds::Bounds;
use crate::pick::Ray;

/// Vertical field of view; long enough that shapes are not distorted at the edges of a full window.
const FIELD_OF_VIEW: f64 = 0.6;
/// Room around a framed surface, as a factor on its bounding sphere.
const FRAME_MARGIN: f64 = 1.04;
/// Nearest and farthest the eye may be from its target, in bounding radii.
const DISTANCE_RANGE: (f64, f64) = (0.01, 40.0);
/// Farthest the target may be dragged from the centre, in bounding radii: the surface can always be found again.
const TARGET_RANGE: f64 = 20.0;
/// The near plane is at least this share of the far one, so that depth keeps its resolution when the eye is inside.
const NEAREST_NEAR: f64 = 1e-3;
/// Pins and the walker stand out from the surface: the depth range covers this factor on the scene's radius.
const DEPTH_MARGIN: f64 = 1.3;
/// The floor with the scene's shadow reaches beyond that, away from the eye.
const FLOOR_MARGIN: f64 = 1.8;
/// After a hand lets go, the camera glides on and loses speed by a factor e in this time; seconds.
const GLIDE_SECONDS: f64 = 0.18;
/// Time over which a hand's speed is taken; seconds.
const HAND_SECONDS: f64 = 0.04;
/// A slower glide is none; radians a second.
const LEAST_GLIDE: f64 = 0.02;
/// Length of a smooth move; seconds.
const FLIGHT_SECONDS: f64 = 0.3;

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

/// Where the camera stands, free of the surface's scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Turn about +y; radians. At 0 the camera looks along −z.
    pub yaw: f64,
    /// Height over the horizon; radians, −π/2 to π/2.
    pub pitch: f64,
    /// From the eye to the target; bounding radii.
    pub distance: f64,
    /// The target's offset from the surface's centre; bounding radii.
    pub target: DVec3,
}

impl View {
    fn clamped(self) -> Self {
        Self {
            yaw: self.yaw.rem_euclid(TAU),
            pitch: self.pitch.clamp(-FRAC_PI_2, FRAC_PI_2),
            distance: self.distance.clamp(DISTANCE_RANGE.0, DISTANCE_RANGE.1),
            target: self.target.clamp_length_max(TARGET_RANGE),
        }
    }

    /// The camera's axes (right, up, back) as columns.
    fn world_from_view(self) -> DMat3 {
        let (yaw_sin, yaw_cos) = self.yaw.sin_cos();
        let (pitch_sin, pitch_cos) = self.pitch.sin_cos();
        let right = DVec3::new(yaw_cos, 0.0, -yaw_sin);
        let back = DVec3::new(pitch_cos * yaw_sin, pitch_sin, pitch_cos * yaw_cos);
        DMat3::from_cols(right, back.cross(right), back)
    }

    /// Between two views with the same direction; distances in proportion, so that a zoom looks even.
    fn between(from: Self, to: Self, fraction: f64) -> Self {
        let distance = from.distance * (to.distance / from.distance).powf(fraction);
        Self { distance, target: from.target.lerp(to.target, fraction), ..to }
    }
}

/// A smooth move under way.
#[derive(Clone, Copy, Debug)]
struct Flight {
    from: View,
    to: View,
    seconds: f64,
}

/// Turning by hand: yaw and pitch, radians.
#[derive(Clone, Copy, Debug, Default)]
struct Turning {
    /// True while a hand holds on.
    is_held: bool,
    /// Turned since the last frame.
    turned: DVec2,
    /// A second.
    speed: DVec2,
}

/// A turntable camera: yaw about the vertical, pitch, and a target to look at.
#[derive(Clone, Debug)]
pub struct Camera {
    view: View,
    flight: Option<Flight>,
    turning: Turning,
    /// Of the turntable; radians a second.
    spin: f64,
    surface: Bounds,
    scene: Bounds,
    /// Physical pixels.
    size: DVec2,
    /// Physical pixels a CSS pixel.
    pixel_ratio: f64,
    insets: Insets,
}

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
    /// A camera that frames the unit sphere from slightly above and to the side.
    #[must_use]
    pub fn new() -> Self {
        let view =
            View { yaw: 0.5, pitch: 0.3, distance: FRAME_MARGIN / (0.5 * FIELD_OF_VIEW).sin(), target: DVec3::ZERO };
        Self {
            view,
            flight: None,
            turning: Turning::default(),
            spin: 0.0,
            surface: Bounds::UNIT,
            scene: Bounds::UNIT,
            size: DVec2::ONE,
            pixel_ratio: 1.0,
            insets: Insets::default(),
        }
    }

    /// What the view is relative to, and what must lie between the near and the far plane.
    pub fn set_bounds(&mut self, surface: Bounds, scene: Bounds) {
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
        self.turning.speed = DVec2::ZERO;
        self.view = view.clamped();
    }

    /// Turns around the target by a drag in CSS pixels; a drag over the window's height is a full turn.
    pub fn orbit(&mut self, dx: f64, dy: f64) {
        let turn = TAU * self.pixel_ratio / self.size.y * DVec2::new(-dx, dy);
        self.flight = None;
        self.turn(turn);
        if self.turning.is_held {
            self.turning.turned += turn;
        }
    }

    fn turn(&mut self, turn: DVec2) {
        self.view = View { yaw: self.view.yaw + turn.x, pitch: self.view.pitch + turn.y, ..self.view }.clamped();
    }

    /// A hand takes hold to turn.
    pub fn hold(&mut self) {
        self.turning = Turning { is_held: true, ..Turning::default() };
    }

    /// The hand lets go; the camera glides on as fast as the hand was, or not at all.
    pub fn let_go(&mut self, glides: bool) {
        let speed = if glides && self.turning.is_held { self.turning.speed } else { DVec2::ZERO };
        self.turning = Turning { speed, ..Turning::default() };
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

    /// Starts a smooth move that fits the scene into what the insets leave free; the direction stays.
    pub fn frame(&mut self) {
        let free = self.free_size() / self.size.y * (0.5 * FIELD_OF_VIEW).tan();
        let (half_horizontal, half_vertical) = (free.x.atan(), free.y.atan());
        let radius = f64::from(self.scene.radius / self.surface.radius);
        let distance = FRAME_MARGIN * radius / half_vertical.min(half_horizontal).sin();
        let target = (self.scene.center - self.surface.center).as_dvec3() / f64::from(self.surface.radius);
        self.fly_to(View { distance, target, ..self.view });
    }

    /// Starts a smooth move of the target to a world point; direction and distance stay.
    pub fn focus(&mut self, point: Vec3) {
        let target = (point - self.surface.center).as_dvec3() / f64::from(self.surface.radius);
        self.fly_to(View { target, ..self.view });
    }

    fn fly_to(&mut self, to: View) {
        self.turning = Turning::default();
        self.flight = Some(Flight { from: self.view, to: to.clamped(), seconds: 0.0 });
    }

    /// True while the camera moves by itself, or a hand's speed is being taken.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        let Turning { turned, speed, .. } = self.turning;
        self.flight.is_some() || turned != DVec2::ZERO || speed.length() > LEAST_GLIDE || self.spin != 0.0
    }

    /// Takes what moves by itself further.
    pub fn advance(&mut self, seconds: f64) {
        let seconds = seconds.max(0.0);
        if self.spin != 0.0 && !self.turning.is_held {
            self.turn(DVec2::new(self.spin * seconds, 0.0));
        }
        self.advance_turning(seconds);
        let Some(flight) = &mut self.flight else { return };
        flight.seconds += seconds;
        let time = (flight.seconds / FLIGHT_SECONDS).min(1.0);
        let view = View::between(flight.from, flight.to, time * time * (3.0 - 2.0 * time));
        self.view = if self.spin == 0.0 { view } else { View { yaw: self.view.yaw, ..view } };
        if time >= 1.0 {
            self.flight = None;
        }
    }

    fn advance_turning(&mut self, seconds: f64) {
        let Turning { is_held, turned, speed } = self.turning;
        if is_held && seconds > 0.0 {
            let share = 1.0 - (-seconds / HAND_SECONDS).exp();
            self.turning = Turning { is_held, turned: DVec2::ZERO, speed: speed.lerp(turned / seconds, share) };
        } else if !is_held && speed.length() > LEAST_GLIDE {
            let kept = (-seconds / GLIDE_SECONDS).exp();
            self.turn(GLIDE_SECONDS * (1.0 - kept) * speed);
            self.turning.speed = kept * speed;
        }
    }

    /// World size of a physical pixel at unit distance.
    fn pixel_slope(&self) -> f64 {
        2.0 * (0.5 * FIELD_OF_VIEW).tan() / self.size.y
    }

    /// Matrices for the current view.
    #[must_use]
    pub fn eye(&self) -> Eye {
        let radius = f64::from(self.surface.radius);
        let world_from_view = self.view.world_from_view();
        let target = self.surface.center.as_dvec3() + radius * self.view.target;
        let position = target + radius * self.view.distance * world_from_view.z_axis;
        let scene_radius = f64::from(self.scene.radius);
        let depth = world_from_view.z_axis.dot(position - self.scene.center.as_dvec3());
        // With the scene behind the eye any positive range will do.
        let far = (depth + FLOOR_MARGIN * scene_radius).max(1e-3 * radius);
        let near = (depth - DEPTH_MARGIN * scene_radius).max(NEAREST_NEAR * far);
        let [right, down] = (2.0 * self.center_offset() / self.size).to_array();
        let shift = DMat4::from_translation(DVec3::new(right, -down, 0.0));
        let clip_from_view = shift * perspective(FIELD_OF_VIEW, self.size.x / self.size.y, near, far);
        let view_from_world = DMat4::from_mat3(world_from_view.transpose()) * DMat4::from_translation(-position);
        Eye {
            clip_from_world: clip_from_view * view_from_world,
            world_from_view,
            position,
            pixel_slope: self.pixel_slope(),
        }
    }

    /// The ray through a physical pixel, (0, 0) being the upper left corner of the canvas.
    #[must_use]
    pub fn ray(&self, pixel: Vec2) -> Ray {
        let eye = self.eye();
        let offset = (pixel.as_dvec2() - 0.5 * self.size - self.center_offset()) * eye.pixel_slope;
        let direction = eye.world_from_view * DVec3::new(offset.x, -offset.y, -1.0);
        Ray { origin: eye.position.as_vec3(), direction: direction.normalize().as_vec3() }
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

impl Default for Camera {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pixels; single precision on coordinates up to two thousand.
    const PIXEL_TOLERANCE: f32 = 2e-3;

    fn camera() -> Camera {
        let mut camera = Camera::new();
        let surface = Bounds { center: Vec3::new(5.0, -2.0, 1.0), radius: 3.0, lowest: -5.0, side: 6.0 };
        camera.set_bounds(surface, surface);
        camera.set_size(1600, 900, 2.0);
        camera
    }

    #[test]
    fn insets_move_the_centre_and_shrink_the_frame() {
        let mut camera = camera();
        let center = Vec3::new(5.0, -2.0, 1.0);
        camera.set_insets(Insets { left: 0.0, top: 0.0, right: 600.0, bottom: 100.0 });
        let pixel = camera.project(center).unwrap();
        assert!((pixel.truncate() - Vec2::new(500.0, 400.0)).length() < PIXEL_TOLERANCE, "{pixel}");
        let ray = camera.ray(Vec2::new(500.0, 400.0));
        assert!((center - ray.origin).normalize().dot(ray.direction) > 0.999_999);

        camera.frame();
        camera.advance(FLIGHT_SECONDS);
        for (from_center, room) in [(Vec3::X, 500.0), (Vec3::Y, 400.0)] {
            let axes = camera.eye().world_from_view;
            let rim = center + (axes * from_center.as_dvec3()).as_vec3() * 3.0;
            let reach = (camera.project(rim).unwrap() - pixel).truncate().length();
            assert!(reach < room, "the bounding sphere fits: {reach} of {room}");
        }
    }

    fn settle(camera: &mut Camera) {
        while camera.is_moving() {
            camera.advance(0.016);
        }
    }

    #[test]
    fn axes_are_orthonormal_and_right_handed_even_at_the_poles() {
        for pitch in [-FRAC_PI_2, -0.4, 0.0, 1.2, FRAC_PI_2] {
            let axes = View { yaw: 2.1, pitch, distance: 3.0, target: DVec3::ZERO }.world_from_view();
            assert!((axes.transpose() * axes).abs_diff_eq(DMat3::IDENTITY, 1e-12));
            assert!((axes.determinant() - 1.0).abs() < 1e-12);
            assert!(axes.y_axis.y >= 0.0, "up stays up");
        }
    }

    #[test]
    fn the_target_is_in_the_middle_of_the_canvas() {
        let camera = camera();
        let pixel = camera.project(Vec3::new(5.0, -2.0, 1.0)).expect("in front");
        assert!((pixel.truncate() - Vec2::new(800.0, 450.0)).length() < PIXEL_TOLERANCE);
        assert!(pixel.z > 0.0 && pixel.z < 1.0);
    }

    #[test]
    fn rays_go_through_the_points_they_project_to() {
        let mut camera = camera();
        camera.orbit(130.0, -70.0);
        camera.zoom(1.7);
        for point in [Vec3::new(6.0, -1.0, 2.0), Vec3::new(4.2, -3.0, 0.0), Vec3::new(5.0, 0.0, 1.0)] {
            let pixel = camera.project(point).expect("in front");
            let ray = camera.ray(pixel.truncate());
            let gap = (point - ray.origin).reject_from_normalized(ray.direction).length();
            assert!(gap < 1e-4, "{gap}");
        }
    }

    #[test]
    fn points_behind_the_eye_have_no_pixel() {
        let camera = camera();
        let ray = camera.ray(Vec2::new(800.0, 450.0));
        assert_eq!(camera.project(ray.origin - ray.direction), None);
    }

    #[test]
    fn panning_carries_the_target_along_with_the_pointer() {
        let mut camera = camera();
        let target = Vec3::new(5.0, -2.0, 1.0);
        camera.pan(30.0, -20.0);
        let pixel = camera.project(target).expect("in front");
        // 30 and −20 CSS pixels at two physical pixels each.
        assert!((pixel.truncate() - Vec2::new(860.0, 410.0)).length() < PIXEL_TOLERANCE);
    }

    #[test]
    fn framing_fits_the_sphere_in_landscape_and_in_portrait() {
        for (width, height) in [(1600, 900), (500, 1200)] {
            let mut camera = camera();
            camera.set_size(width, height, 1.0);
            camera.zoom(5.0);
            camera.pan(200.0, 100.0);
            let yaw = camera.view().yaw;
            camera.frame();
            settle(&mut camera);
            assert_eq!(camera.view().yaw, yaw);
            let eye = camera.eye();
            let half = 0.5 * width.min(height) as f32;
            // The silhouette of a sphere is seen under asin(radius / distance).
            let sight = (3.0 / eye.position.distance(DVec3::new(5.0, -2.0, 1.0))).asin().tan() / eye.pixel_slope;
            assert!(sight as f32 <= half && sight as f32 > 0.9 * half, "{sight} of {half}");
        }
    }

    #[test]
    fn focus_moves_the_target_and_keeps_the_distance() {
        let mut camera = camera();
        let (distance, point) = (camera.view().distance, Vec3::new(7.0, -2.0, 1.0));
        camera.focus(point);
        assert!(camera.is_moving());
        settle(&mut camera);
        let pixel = camera.project(point).expect("in front");
        assert!((pixel.truncate() - Vec2::new(800.0, 450.0)).length() < PIXEL_TOLERANCE);
        assert!((camera.view().distance - distance).abs() < 1e-12);
    }

    #[test]
    fn the_camera_glides_on_when_a_moving_hand_lets_go_and_comes_to_rest() {
        let turned = |pause: usize, glides: bool| {
            let mut camera = camera();
            camera.hold();
            for _ in 0..10 {
                camera.orbit(12.0, 0.0);
                camera.advance(0.016);
            }
            for _ in 0..pause {
                camera.advance(0.016);
            }
            let before = camera.view().yaw;
            camera.let_go(glides);
            settle(&mut camera);
            before - camera.view().yaw
        };
        // Twelve pixels in 16 ms over a window 450 CSS pixels high, for the time of the glide.
        let expected = TAU * 12.0 / 450.0 / 0.016 * GLIDE_SECONDS;
        assert!((turned(0, true) / expected - 1.0).abs() < 0.05, "{} of {expected}", turned(0, true));
        assert_eq!(turned(0, false), 0.0);
        assert!(turned(20, true).abs() < 1e-3, "a hand that has come to rest lets go of a camera at rest");
    }

    #[test]
    fn the_turntable_turns_evenly_and_a_frame_does_not_stop_it() {
        let mut camera = camera();
        let yaw = camera.view().yaw;
        camera.set_spin(0.5);
        camera.frame();
        for _ in 0..100 {
            camera.advance(0.01);
        }
        assert!((camera.view().yaw - yaw - 0.5).abs() < 1e-9);
        camera.set_spin(0.0);
        assert!(!camera.is_moving());
    }

    #[test]
    fn a_view_survives_a_change_of_scale() {
        let mut camera = camera();
        let point = Vec3::new(6.0, -1.0, 2.0);
        let before = camera.project(point).expect("in front");
        let scaled = Bounds { center: 10.0 * Vec3::new(5.0, -2.0, 1.0), radius: 30.0, lowest: -50.0, side: 60.0 };
        camera.set_bounds(scaled, scaled);
        let after = camera.project(10.0 * point).expect("in front");
        assert!((after - before).length() < PIXEL_TOLERANCE);
    }

    #[test]
    fn views_are_clamped() {
        let mut camera = camera();
        camera.set_view(View { yaw: -1.0, pitch: 9.0, distance: 0.0, target: DVec3::splat(1e9) });
        let view = camera.view();
        assert_eq!(view.pitch, FRAC_PI_2);
        assert_eq!(view.distance, DISTANCE_RANGE.0);
        assert!((view.yaw - (TAU - 1.0)).abs() < 1e-12 && view.target.length() <= TARGET_RANGE + 1e-9);
    }
}
