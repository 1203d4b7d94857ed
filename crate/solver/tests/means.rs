//! Means of places and of cells.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use glam::{DQuat, DVec3, dvec3};
use heatwalk::exact::{ExactGeometry, exact_distance};
use heatwalk::{Error, FaceId, Place, Surface, VertexId, go_on, mean, relaxed};
use heatwalk_shapes as shapes;

use crate::common::searches::geometry;
use crate::common::truth::Random;
use crate::common::{nearest, square, surface, two_squares};

fn laid_out(soup: &heatwalk::Soup) -> (Arc<Surface>, Arc<ExactGeometry>) {
    let surface = Arc::new(surface(soup));
    (Arc::clone(&surface), geometry(&surface))
}

#[test]
fn in_the_plane_it_is_the_weighted_mean() {
    let (surface, geometry) = laid_out(&square(7));
    let mut random = Random::new(2);
    for count in [1, 2, 3, 8] {
        let places: Vec<(Place, f64)> = (0..count)
            .map(|_| {
                let face = FaceId(random.below(surface.face_count()) as u32);
                let [a, b] = [random.share(), random.share()];
                (Place::Face { face, weights: [a * b, a * (1.0 - b), 1.0 - a] }, random.between(0.1, 3.0))
            })
            .collect();
        let whole: f64 = places.iter().map(|place| place.1).sum();
        let center: DVec3 = places.iter().map(|(place, weight)| place.position(&surface) * (weight / whole)).sum();
        let variance: f64 = places
            .iter()
            .map(|(place, weight)| weight / whole * place.position(&surface).distance_squared(center))
            .sum();
        let found = mean(&geometry, &places, &mut go_on).expect("a mean");
        let position = found.place.position(&surface);
        assert!(position.distance(center) < 1e-9, "{position} for {center}");
        assert!((found.variance - variance).abs() < 1e-12);
    }
}

#[test]
fn on_a_sphere_places_around_an_axis_have_theirs_on_it() {
    let (surface, geometry) = laid_out(&shapes::icosphere(4));
    let axis = dvec3(0.36, 0.48, 0.8);
    let out = DQuat::from_axis_angle(axis.any_orthonormal_vector(), 0.7) * axis;
    let places: Vec<(VertexId, f64)> =
        (0..5).map(|k| (nearest(&surface, DQuat::from_axis_angle(axis, 1.2566 * f64::from(k)) * out), 1.0)).collect();
    let found = mean(&geometry, &places, &mut go_on).expect("a mean");
    let angle = found.place.position(&surface).angle_between(axis);
    assert!(angle < 0.05, "{angle} from the axis; vertices are as far from where they were meant");
    assert!((found.variance.sqrt() - 0.7).abs() < 0.05);
}

#[test]
fn relaxed_samples_cover_a_torus_better_and_stay_where_they_are_in_the_middle() {
    let (surface, geometry) = laid_out(&shapes::torus(1.0, 0.4, 32, 16));
    let crowded: Vec<VertexId> = (0..9).map(|k| VertexId(3 * k)).collect();
    let spread = relaxed(&geometry, &crowded, 40, &mut go_on).expect("samples");
    let radius = |distances: heatwalk::VertexData<f64>| distances.iter().copied().fold(0.0, f64::max);
    let [before, after] = [
        radius(exact_distance(&surface, &crowded, &mut go_on).expect("distances")),
        radius(exact_distance(&surface, &spread, &mut go_on).expect("distances")),
    ];
    assert!(after < 0.5 * before, "{after} after {before}");
    let (flat, of_flat) = laid_out(&square(8));
    let middle = nearest(&flat, dvec3(0.5, 0.5, 0.0));
    let one = relaxed(&of_flat, &[middle], 5, &mut go_on).expect("a sample");
    assert!(one[0].place().position(&flat).distance(dvec3(0.5, 0.5, 0.0)) < 1e-9);
}

#[test]
fn what_has_no_mean_is_refused() {
    let (surface, geometry) = laid_out(&two_squares(3).0);
    let none: [(VertexId, f64); 0] = [];
    assert!(matches!(mean(&geometry, &none, &mut go_on), Err(Error::NoSource)));
    let none: [VertexId; 0] = [];
    assert!(matches!(relaxed(&geometry, &none, 3, &mut go_on), Err(Error::NoSource)));
    let weight = mean(&geometry, &[(VertexId(0), -1.0)], &mut go_on).expect_err("a weight").to_string();
    assert!(weight.contains("the weight is -1; it must be positive"), "{weight}");
    let last = VertexId(surface.vertex_count() as u32 - 1);
    let apart = mean(&geometry, &[(VertexId(0), 1.0), (last, 1.0)], &mut go_on);
    assert!(matches!(apart, Err(Error::Unreachable)));
}
