//! Farthest samples against a search from each of them.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;
use heatwalk::exact::{ExactGeometry, exact_distance};
use heatwalk::{Element, Error, SampleCount, Soup, VertexId, farthest_samples, go_on};
use heatwalk_shapes as shapes;

use crate::common::surface;

/// Two spheres far apart.
fn two() -> Soup {
    let ball = shapes::icosphere(2);
    let count = ball.positions.len() as u32;
    let positions =
        ball.positions.iter().copied().chain(ball.positions.iter().map(|&place| 2.0 * place + 9.0 * DVec3::X));
    let triangles =
        ball.triangles.iter().copied().chain(ball.triangles.iter().map(|face| face.map(|corner| corner + count)));
    Soup::single("two", positions.collect(), triangles.collect())
}

#[test]
fn each_sample_is_farthest_from_those_before_it() {
    for (soup, first) in [(shapes::torus(1.0, 0.4, 24, 12), 5), (shapes::grid(9, 9), 40), (two(), 3)] {
        let surface = Arc::new(surface(&soup));
        let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
        let samples =
            farthest_samples(&geometry, VertexId(first), SampleCount::Exactly(25), &mut go_on).expect("samples");
        assert_eq!((samples.vertices.len(), samples.vertices[0]), (25, VertexId(first)));
        let mut least = vec![f64::INFINITY; surface.vertex_count()];
        for (number, &sample) in samples.vertices.iter().enumerate() {
            let farthest = least.iter().copied().fold(0.0, f64::max);
            assert!(least[sample.index()] >= farthest * (1.0 - 1e-12), "{number}");
            let alone = exact_distance(&surface, &[sample], &mut go_on).expect("a vertex");
            for vertex in surface.vertices() {
                let nearest = samples.nearest[vertex].expect("all components have one") as usize;
                if nearest == number {
                    assert!((samples.distances[vertex] - alone[vertex]).abs() < 1e-12);
                }
                least[vertex.index()] = least[vertex.index()].min(alone[vertex]);
            }
        }
        assert!(surface.vertices().all(|vertex| (samples.distances[vertex] - least[vertex.index()]).abs() < 1e-12));
        let farthest = least.iter().copied().fold(0.0, f64::max);
        assert!((samples.covering_radius() - farthest).abs() < 1e-12);
    }
}

#[test]
fn samples_of_a_radius_cover_all_and_are_no_nearer_to_each_other() {
    let surface = Arc::new(surface(&shapes::icosphere(3)));
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
    let samples = farthest_samples(&geometry, VertexId(0), SampleCount::Within(0.5), &mut go_on).expect("samples");
    assert!(samples.covering_radius() <= 0.5);
    for &sample in &samples.vertices {
        let alone = exact_distance(&surface, &[sample], &mut go_on).expect("a vertex");
        assert!(samples.vertices.iter().all(|&other| other == sample || alone[other] > 0.5));
    }
}

#[test]
fn there_are_no_more_samples_than_vertices() {
    let surface = Arc::new(surface(&shapes::icosphere(0)));
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
    let samples = farthest_samples(&geometry, VertexId(2), SampleCount::Exactly(100), &mut go_on).expect("samples");
    assert_eq!((samples.vertices.len(), samples.covering_radius()), (12, 0.0));
}

#[test]
fn what_cannot_be_sampled_is_told() {
    let surface = Arc::new(surface(&shapes::icosphere(1)));
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
    let refused = |first: u32, count| farthest_samples(&geometry, VertexId(first), count, &mut go_on).unwrap_err();
    assert!(matches!(refused(0, SampleCount::Exactly(0)), Error::BadParameter { name: "count", .. }));
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(refused(0, SampleCount::Within(radius)), Error::BadParameter { name: "radius", .. }));
    }
    assert!(matches!(refused(9999, SampleCount::Exactly(3)), Error::Surface(_)));
}

#[test]
fn sampling_can_be_cancelled() {
    let surface = Arc::new(surface(&shapes::icosphere(5)));
    let geometry = Arc::new(ExactGeometry::new(surface));
    let cancel = &mut |_, _| ControlFlow::Break(());
    let cancelled = farthest_samples(&geometry, VertexId(0), SampleCount::Exactly(3), cancel);
    assert!(matches!(cancelled, Err(Error::Cancelled)));
}
