//! Gradient fields: of linear functions they are known, of a distance on the sphere nearly.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::truth::Random;
use crate::common::{distance_from, square, surface};
use glam::DVec3;
use heatwalk::gradient::{face_directions, face_gradients, vertex_directions, vertex_tangents};
use heatwalk::propagation::propagated_distance;
use heatwalk::{PropagationOptions, Surface, VertexData, VertexId, go_on};
use heatwalk_shapes::icosphere;

const SLOPE: DVec3 = DVec3::new(2.0, -3.0, 0.0);
/// Rounding of a few products.
const ROUNDING: f64 = 1e-12;

fn linear(surface: &Surface, scale: f64) -> VertexData<f64> {
    surface.vertices().map(|vertex| scale * SLOPE.dot(surface.position(vertex))).collect()
}

#[test]
fn a_linear_function_has_its_slope_everywhere() {
    let flat = surface(&square(6));
    let values = linear(&flat, 1.0);
    let gradients = face_gradients(&flat, &values);
    assert_eq!(gradients.len(), flat.faces().len());
    assert!(gradients.iter().all(|gradient| gradient.distance(SLOPE) < ROUNDING));
    let directions = vertex_directions(&flat, &values);
    assert_eq!(directions.len(), flat.vertex_count());
    assert!(directions.iter().all(|direction| direction.distance(SLOPE.normalize()) < ROUNDING));
}

#[test]
fn directions_are_right_however_small_the_values() {
    let flat = surface(&square(6));
    // Squares of the smallest ones are zero.
    for scale in [1.0, 1e-200, 1e-290] {
        let directions = face_directions(&flat, &linear(&flat, scale));
        assert_eq!(directions.len(), flat.faces().len());
        assert!(directions.iter().all(|direction| direction.distance(SLOPE.normalize()) < ROUNDING), "{scale}");
    }
}

#[test]
fn where_there_is_no_slope_there_is_no_direction() {
    let flat = surface(&square(6));
    for constant in [0.0, 1.0] {
        let values: VertexData<f64> = vec![constant; flat.vertex_count()].into();
        for directions in [face_gradients(&flat, &values), face_directions(&flat, &values)] {
            assert!(directions.iter().all(|direction| *direction == DVec3::ZERO));
        }
        assert!(vertex_directions(&flat, &values).iter().all(|direction| *direction == DVec3::ZERO));
    }
    let unreachable: VertexData<f64> = vec![f64::INFINITY; flat.vertex_count()].into();
    assert!(face_gradients(&flat, &unreachable).iter().all(|gradient| *gradient == DVec3::ZERO));
    assert!(vertex_directions(&flat, &unreachable).iter().all(|direction| *direction == DVec3::ZERO));
}

#[test]
fn a_distance_grows_away_from_its_source_and_heat_towards_it() {
    let (solver, distance) = distance_from(&icosphere(4), 0);
    let sphere = solver.surface();
    let source = sphere.position(VertexId(0));
    // Along the meridian, not near the poles, where directions turn within a face.
    let meridian = |at: DVec3| {
        let height = at.normalize().dot(source);
        (height.abs() < 0.9).then(|| (at * height - source).reject_from(at).normalize())
    };
    let tangents = distance.tangents(sphere).expect("its surface");
    assert_eq!(tangents, vertex_tangents(sphere, &distance.directions(sphere).expect("its surface")));
    let mut seen = 0;
    for (vertex, tangent) in tangents.enumerate() {
        if let Some(meridian) = meridian(sphere.position(vertex)) {
            assert!(tangent.dot(sphere.vertex_normal(vertex)).abs() < ROUNDING);
            // Two degrees: a quarter of an edge seen from its end.
            assert!(tangent.dot(meridian) > 2_f64.to_radians().cos(), "{}", tangent.dot(meridian));
            seen += 1;
        }
    }
    assert!(seen > 2000, "{seen}");
    let gradients = distance.gradients(sphere).expect("its surface");
    let heat = distance.heat_directions(sphere).expect("its surface");
    for ((face, gradient), towards) in gradients.enumerate().zip(heat.iter()) {
        let [a, b, c] = sphere.corners(face);
        if let Some(meridian) = meridian((a + b + c) / 3.0) {
            assert!((gradient.length() - 1.0).abs() < 0.1, "{}", gradient.length());
            assert!(gradient.dot(meridian) > 0.95, "{}", gradient.dot(meridian));
            assert!((towards.length() - 1.0).abs() < ROUNDING);
            assert!(towards.dot(meridian) < -0.95, "{}", towards.dot(meridian));
        }
    }
}

/// Mean angle, degrees, of the gradients of distances by so many windows against what is known: at the centers of faces and
/// at vertices, farther than an edge from the source.
fn mean_angles(surface: &Arc<Surface>, windows: &str, expected: impl Fn(DVec3, DVec3) -> DVec3) -> [f64; 2] {
    let options = PropagationOptions { windows: windows.parse().expect("a number"), ..PropagationOptions::default() };
    let source = VertexId((surface.vertex_count() / 2 + 17) as u32);
    let distance = propagated_distance(surface, &[source], options, &mut go_on);
    let distance = distance.expect("a valid source");
    let from = surface.position(source);
    let mean = |angles: Vec<f64>| angles.iter().sum::<f64>() / angles.len() as f64;
    let angle = |found: DVec3, at: DVec3, normal: DVec3| {
        let expected = expected(from, at).reject_from(normal);
        // At the antipode there is none.
        let is_known = at.distance(from) > surface.mean_edge() && expected != DVec3::ZERO;
        is_known.then(|| found.angle_between(expected).to_degrees())
    };
    let gradients = distance.gradients(surface).expect("its surface");
    let of_faces = gradients.enumerate().filter_map(|(face, &gradient)| {
        angle(gradient, surface.corners(face).iter().sum::<DVec3>() / 3.0, surface.face_normal(face))
    });
    let tangents = distance.tangents(surface).expect("its surface");
    let of_vertices = tangents
        .enumerate()
        .filter_map(|(vertex, &tangent)| angle(tangent, surface.position(vertex), surface.vertex_normal(vertex)));
    [mean(of_faces.collect()), mean(of_vertices.collect())]
}

/// Limits are half as much again as measured.
#[test]
fn directions_are_those_of_shortest_paths() {
    let mut plane = square(40);
    let mut random = Random::new(1);
    for position in &mut plane.positions {
        if position.x > 0.0 && position.x < 1.0 && position.y > 0.0 && position.y < 1.0 {
            let mut shift = || 0.008 * (random.share() - 0.5);
            *position += DVec3::new(shift(), shift(), 0.0);
        }
    }
    let plane = Arc::new(surface(&plane));
    let sphere = Arc::new(surface(&icosphere(5)));
    let cases =
        [("all", [0.43, 0.50], [0.28, 0.04]), ("2", [0.75, 0.62], [0.98, 0.45]), ("1", [1.15, 0.8], [1.8, 0.9])];
    for (windows, on_plane, on_sphere) in cases {
        let found = mean_angles(&plane, windows, |from, at| at - from);
        assert!(found[0] < on_plane[0] && found[1] < on_plane[1], "plane, {windows}: {found:?}");
        // Away from the source along the meridian.
        let found = mean_angles(&sphere, windows, |from, at| at * at.dot(from) - from * at.length_squared());
        assert!(found[0] < on_sphere[0] && found[1] < on_sphere[1], "sphere, {windows}: {found:?}");
    }
}
