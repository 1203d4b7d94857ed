use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DMat3, DVec3, Vec2, Vec3};

use super::motion::{FLIGHT_SECONDS, GLIDE_SECONDS};
use super::view::{DISTANCE_RANGE, TARGET_RANGE};
use super::{Camera, Insets, View};
use heatwalk_bake::BoundingSphere;

/// Pixels; single precision on coordinates up to two thousand.
const PIXEL_TOLERANCE: f32 = 2e-3;

fn camera() -> Camera {
    let mut camera = Camera::new();
    let surface = BoundingSphere { center: Vec3::new(5.0, -2.0, 1.0), radius: 3.0, lowest: -5.0, side: 6.0 };
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

    camera.frame(true);
    camera.advance(FLIGHT_SECONDS);
    for (from_center, room) in [(Vec3::X, 500.0), (Vec3::Y, 400.0)] {
        let axes = camera.eye().world_from_view;
        let rim = center + (axes * from_center.as_dvec3()).as_vec3() * 3.0;
        let reach = (camera.project(rim).unwrap() - pixel).truncate().length();
        assert!(reach < room, "the bounding sphere fits: {reach} of {room}");
    }
}

#[test]
fn orthographic_lengths_are_the_same_at_any_depth_and_rays_meet_what_is_projected() {
    let mut camera = camera();
    camera.set_insets(Insets { left: 0.0, top: 0.0, right: 600.0, bottom: 100.0 });
    let center = Vec3::new(5.0, -2.0, 1.0);
    let axes = camera.eye().world_from_view.as_mat3();
    let across = |camera: &Camera, depth: f32| {
        let middle = center + depth * axes.z_axis;
        let [start, end] = [middle, middle + axes.x_axis].map(|point| camera.project(point).unwrap());
        (end - start).truncate().length()
    };
    let in_perspective = across(&camera, 0.0);
    assert!(across(&camera, 2.0) > 1.1 * in_perspective);
    camera.set_orthographic(true);
    for depth in [-2.0, 0.0, 2.0] {
        assert!((across(&camera, depth) / in_perspective - 1.0).abs() < 1e-5, "as at the target in perspective");
    }
    // Sizes in pixels that shaders find by the distance from the eye.
    let eye = camera.eye();
    let pixel = eye.pixel_slope * (eye.position - center.as_dvec3()).dot(eye.world_from_view.z_axis);
    assert!((pixel * f64::from(in_perspective) - 1.0).abs() < 1e-3);
    for point in [center, center + 2.0 * axes.y_axis - axes.z_axis, center + axes.x_axis + 2.5 * axes.z_axis] {
        let seen = camera.project(point).unwrap();
        assert!(seen.z > 0.0 && seen.z < 1.0);
        let ray = camera.ray(seen.truncate());
        let to_point = point - ray.origin;
        assert!(to_point.dot(ray.direction) > 0.0);
        assert!(to_point.cross(ray.direction).length() < 1e-4, "{to_point} {}", ray.direction);
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
        camera.frame(true);
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
fn another_shape_of_the_window_shows_the_same_share_of_the_model() {
    let mut camera = camera();
    camera.frame(true);
    settle(&mut camera);
    camera.zoom(1.5);
    let share = camera.view().distance / camera.fitting_distance();
    let yaw = camera.view().yaw;
    camera.focus(Vec3::new(6.0, -2.0, 1.0), true);
    let before = camera.fitting_distance();
    camera.set_size(450, 900, 2.0);
    assert!(camera.fitting_distance() > 1.3 * before, "a portrait is narrower");
    camera.refit(before);
    assert!((camera.view().distance / camera.fitting_distance() - share).abs() < 1e-12);
    assert!(camera.is_moving(), "a move under way goes on");
    settle(&mut camera);
    assert!((camera.view().distance / camera.fitting_distance() - share).abs() < 1e-12, "and ends as near");
    assert_eq!(camera.view().yaw, yaw);
}

#[test]
fn focus_moves_the_target_and_keeps_the_distance() {
    let mut camera = camera();
    let (distance, point) = (camera.view().distance, Vec3::new(7.0, -2.0, 1.0));
    camera.focus(point, true);
    assert!(camera.is_moving());
    settle(&mut camera);
    let pixel = camera.project(point).expect("in front");
    assert!((pixel.truncate() - Vec2::new(800.0, 450.0)).length() < PIXEL_TOLERANCE);
    assert!((camera.view().distance - distance).abs() < 1e-12);
    let reached = camera.view();
    camera.frame(true);
    settle(&mut camera);
    camera.focus(point, true);
    camera.focus(point, false);
    assert!(!camera.is_moving(), "at once, where nothing is to fly");
    assert!(camera.view().target.distance(reached.target) < 1e-12);
}

#[test]
fn the_camera_glides_on_when_a_moving_pointer_lets_go_and_comes_to_rest() {
    let turned = |pause: usize, glides: bool| {
        let mut camera = camera();
        camera.begin_orbit();
        for _ in 0..10 {
            camera.orbit(12.0, 0.0);
            camera.advance(0.016);
        }
        for _ in 0..pause {
            camera.advance(0.016);
        }
        let before = camera.view().yaw;
        camera.end_orbit(glides);
        settle(&mut camera);
        before - camera.view().yaw
    };
    // Twelve pixels in 16 ms over a window 450 CSS pixels high, for the time of the glide.
    let expected = TAU * 12.0 / 450.0 / 0.016 * GLIDE_SECONDS;
    assert!((turned(0, true) / expected - 1.0).abs() < 0.05, "{} of {expected}", turned(0, true));
    assert_eq!(turned(0, false), 0.0);
    assert!(turned(20, true).abs() < 1e-3, "a pointer that has come to rest lets go of a camera at rest");
}

#[test]
fn the_turntable_turns_evenly_and_a_frame_does_not_stop_it() {
    let mut camera = camera();
    let yaw = camera.view().yaw;
    camera.set_spin(0.5);
    camera.frame(true);
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
    let scaled = BoundingSphere { center: 10.0 * Vec3::new(5.0, -2.0, 1.0), radius: 30.0, lowest: -50.0, side: 60.0 };
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
