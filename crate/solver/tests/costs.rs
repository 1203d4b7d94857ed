//! Distances where faces have costs.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::media::{jittered_square, least_cost, two_media};
use crate::common::{nearest, surface};
use glam::{DVec2, DVec3};
use heatwalk::{
    Costs, DistanceOptions, DistanceSolver, Error, FaceData, FaceId, Method, Surface, VertexData, VertexId, Windows,
    go_on, tobler,
};
use heatwalk_shapes::{grid, icosphere, torus};

fn distances(
    surface: &Arc<Surface>,
    costs: &Costs,
    source: (VertexId, f64),
    options: &DistanceOptions,
) -> VertexData<f64> {
    let mut solver = DistanceSolver::new(Arc::clone(surface)).weighted(costs.clone());
    solver.distance(&[source], options, &mut go_on).expect("a source").distance.values
}

fn flat(surface: &Surface, vertex: VertexId) -> DVec2 {
    surface.position(vertex).truncate()
}

/// Mean and largest error on a plane of two media, the largest beyond ten edges from the source.
fn errors((edges, seed): (u32, u64), cost: f64, method: Method) -> (f64, f64) {
    let square = Arc::new(surface(&jittered_square(edges, seed)));
    let source = nearest(&square, DVec3::new(0.2, 0.5, 0.0));
    let found = distances(&square, &two_media(&square, cost), (source, 0.0), &DistanceOptions::by(method));
    let from = flat(&square, source);
    let of_vertex = |vertex: VertexId| {
        let to = flat(&square, vertex);
        ((to - from).length(), (found[vertex] / least_cost(from, to, cost) - 1.0).abs())
    };
    let others: Vec<(f64, f64)> = square.vertices().filter(|&vertex| vertex != source).map(of_vertex).collect();
    let far = others.iter().filter(|(away, _)| *away > 10.0 / f64::from(edges));
    let mean = others.iter().map(|(_, error)| error).sum::<f64>() / others.len() as f64;
    (mean, far.map(|&(_, error)| error).fold(0.0, f64::max))
}

#[test]
fn a_plane_of_two_media_follows_snell() {
    for cost in [2.0, 10.0] {
        for seed in 1..=5 {
            let (mean, far) = errors((100, seed), cost, Method::Auto);
            assert!(mean < 0.0002 && far < 0.01, "1:{cost}, {seed}: mean {mean}, beyond ten edges {far}");
            let (coarse, _) = errors((25, seed), cost, Method::Auto);
            assert!(mean < coarse, "1:{cost}, {seed}: {coarse} of 25 edges, {mean} of 100");
        }
    }
}

#[test]
fn paths_creep_along_cheaper_ground_and_leave_it_at_the_critical_angle() {
    let square = Arc::new(surface(&jittered_square(60, 3)));
    let cost = 5.0;
    let source = nearest(&square, DVec3::new(0.56, 0.1, 0.0));
    let found = distances(&square, &two_media(&square, cost), (source, 0.0), &DistanceOptions::default());
    let from = flat(&square, source);
    let mut creeping = 0;
    for vertex in square.vertices().filter(|&vertex| vertex != source) {
        let to = flat(&square, vertex);
        let expected = least_cost(from, to, cost);
        creeping += usize::from(to.x > 0.5 && expected < 0.9 * cost * (to - from).length());
        let error = (found[vertex] / expected - 1.0).abs();
        assert!(error < 0.02, "{from} to {to}: {error}");
    }
    assert!(creeping > 500, "{creeping} of the dearer side are reached along the cheaper one");
}

#[test]
fn heat_follows_snell_too() {
    // The bounds of the heat method with one cost everywhere, by the report's own sources of error, grow with the ratio.
    for (cost, bound) in [(2.0, 0.012), (10.0, 0.03)] {
        let (mean, _) = errors((100, 5), cost, Method::Heat);
        assert!(mean < bound, "1:{cost}: {mean}");
    }
}

#[test]
fn a_sphere_of_two_media_agrees_with_a_finer_one() {
    let of = |subdivisions: u32| {
        let sphere = Arc::new(surface(&icosphere(subdivisions)));
        let of_face =
            |face| if sphere.corners(FaceId(face)).iter().map(|at| at.y).sum::<f64>() < 0.0 { 1.0 } else { 3.0 };
        let costs = Costs::new(&sphere, (0..sphere.face_count() as u32).map(of_face).collect()).expect("in range");
        let source = nearest(&sphere, DVec3::new(0.3, -0.9, 0.1));
        let values = distances(&sphere, &costs, (source, 0.0), &DistanceOptions::default());
        (sphere, source, values)
    };
    let ((coarse, source, found), (fine, finer_source, expected)) = (of(5), of(6));
    assert!((coarse.position(source) - fine.position(finer_source)).length() < 0.05, "sources near each other");
    let offset = (coarse.position(source) - fine.position(finer_source)).length();
    let mut sum = 0.0;
    let mut count = 0;
    for vertex in coarse.vertices().filter(|&vertex| vertex.0 % 20 == 0 && found[vertex] > 1.0) {
        let there = expected[nearest(&fine, coarse.position(vertex))];
        sum += ((found[vertex] - there).abs() - offset).max(0.0) / there;
        count += 1;
    }
    let mean = sum / f64::from(count);
    assert!(mean < 0.006, "{mean}");
}

#[test]
fn one_cost_everywhere_makes_every_distance_as_many_times_as_large() {
    let bumpy = Arc::new(surface(&torus(1.0, 0.4, 60, 30)));
    for method in [Method::Auto, Method::Exact, Method::Propagation, Method::Heat] {
        let options = DistanceOptions::by(method);
        let of = |cost: f64| {
            let everywhere: FaceData<f64> = (0..bumpy.face_count()).map(|_| cost).collect();
            let costs = Costs::new(&bumpy, everywhere).expect("in range");
            distances(&bumpy, &costs, (VertexId(5), 0.25 * cost), &options)
        };
        let one = of(1.0);
        for cost in [0.001, 7.3, 1000.0] {
            for (value, one) in of(cost).iter().zip(&one) {
                assert!((value - cost * one).abs() <= 1e-9 * cost * one, "{method}, {cost}: {value} {one}");
            }
        }
    }
}

#[test]
fn exact_distances_with_several_costs_are_refused() {
    let square = surface(&grid(4, 4));
    let costs = (0..square.face_count()).map(|face| 1.0 + f64::from(u8::from(face > 7))).collect();
    let mut solver = DistanceSolver::new(square.clone()).weighted(Costs::new(&square, costs).expect("in range"));
    for options in [
        DistanceOptions::by(Method::Exact),
        DistanceOptions { windows: Windows::All, ..DistanceOptions::by(Method::Propagation) },
    ] {
        let answer = solver.distance(&[VertexId(0)], &options, &mut go_on);
        assert_eq!(answer, Err(Error::NotExact));
    }
    let answer = solver.distance(&[VertexId(0)], &DistanceOptions::default(), &mut go_on);
    assert_eq!(answer.expect("an answer").distance.exact_below, 0.0);
}

#[test]
fn costs_out_of_range_are_refused_with_their_face() {
    let square = surface(&grid(4, 4));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1001.0] {
        let costs = (0..square.face_count()).map(|face| if face == 3 { bad } else { 1.0 }).collect();
        let error = Costs::new(&square, costs).expect_err("out of range");
        assert!(error.to_string().contains("face 3"), "{error}");
    }
}

#[test]
fn slopes_cost_what_tobler_says() {
    // 0.5 (exp(3.5·0.15) + exp(3.5·0.05)) / exp(3.5·0.05), by hand.
    assert!((tobler(0.1) - 0.5 * (0.35_f64.exp() + 1.0)).abs() < 1e-12);
    assert_eq!(tobler(0.0), 1.0);
    let level = surface(&grid(4, 4));
    let costs = Costs::of_slope(&level, DVec3::Y, tobler).expect("in range");
    assert_eq!(costs.constant(), Some(1.0), "a level grid in the plane of x and z");
    let steep = Costs::of_slope(&level, DVec3::new(0.0, 1.0, 1.0), tobler).expect("in range");
    assert!((steep.of(FaceId(0)) - tobler(1.0)).abs() < 1e-9, "{}", steep.of(FaceId(0)));
    let wall = Costs::of_slope(&level, DVec3::X, tobler).expect("upright faces have the largest cost");
    assert_eq!(wall.constant(), Some(1000.0));
}
