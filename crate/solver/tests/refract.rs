//! Paths where faces have costs.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::media::{jittered_square, least_cost, two_media};
use crate::common::truth::Random;
use crate::common::{nearest, surface};
use glam::DVec3;
use heatwalk::{
    BridgeRule, Costs, DistanceOptions, DistanceSolver, FaceId, Method, PathKind, Place, Surface, VertexId, descend,
    go_on, refract, straighten, tobler,
};
use heatwalk_shapes::{icosphere, robot, torus};

#[test]
fn paths_over_two_media_cost_what_snell_says() {
    for cost in [2.0, 10.0] {
        let square = Arc::new(surface(&jittered_square(40, 1)));
        let costs = two_media(&square, cost);
        for source in [DVec3::new(0.2, 0.5, 0.0), DVec3::new(0.55, 0.1, 0.0)] {
            let source = nearest(&square, source);
            let mut solver = DistanceSolver::new(Arc::clone(&square)).weighted(costs.clone());
            let distance =
                solver.distance(&[source], &DistanceOptions::default(), &mut go_on).expect("a source").distance;
            let mut random = Random::new(1);
            let (mut before, mut after, mut worst, count) = (0.0, 0.0, 0.0_f64, 200);
            for _ in 0..count {
                let from = VertexId(random.below(square.vertex_count()) as u32);
                if from == source {
                    continue;
                }
                let steepest = descend(&square, &distance, from).expect("connected");
                let path = refract(&square, &costs, &steepest).expect("a path of this surface");
                let [first, last] = [path.points[0].location, path.points[path.points.len() - 1].location];
                assert_eq!([first.vertex(&square), last.vertex(&square)], [Some(from), Some(source)]);
                for pair in path.points.windows(2) {
                    assert!(pair.iter().all(|point| point.location.faces(&square).contains(&pair[0].face)));
                }
                let expected = least_cost(square.position(source).truncate(), square.position(from).truncate(), cost);
                let excess = |path| costs.of_path(&square, path) / expected - 1.0;
                assert!(excess(&path) > -1e-9, "no path is cheaper than the least");
                before += excess(&steepest) / f64::from(count);
                after += excess(&path) / f64::from(count);
                worst = worst.max(excess(&path));
            }
            assert!(after < 1e-4 && worst < 5e-3, "1:{cost}: {before} before, {after} after, {worst} at most");
        }
    }
}

#[test]
fn with_one_cost_refracted_paths_are_straight() {
    let ring = surface(&torus(1.0, 0.4, 40, 20));
    let costs = Costs::new(&ring, (0..ring.face_count()).map(|_| 2.5).collect()).expect("in range");
    let mut solver = DistanceSolver::new(ring.clone());
    let distance = solver.distance(&[VertexId(3)], &DistanceOptions::default(), &mut go_on).expect("a source").distance;
    for from in (10..800).step_by(50).map(VertexId) {
        let steepest = descend(&ring, &distance, from).expect("connected");
        let [straight, refracted] = [straighten(&ring, &steepest), refract(&ring, &costs, &steepest)]
            .map(|path| path.expect("of this surface"));
        assert!(
            (refracted.length() / straight.length() - 1.0).abs() < 1e-6,
            "{} {}",
            refracted.length(),
            straight.length()
        );
        assert!((costs.of_path(&ring, &refracted) - 2.5 * refracted.length()).abs() < 1e-9);
    }
}

#[test]
fn random_costs_break_no_path() {
    let ring = surface(&torus(1.0, 0.4, 40, 20));
    let mut random = Random::new(5);
    let of_face = (0..ring.face_count()).map(|_| 10.0_f64.powf(random.between(-3.0, 3.0)));
    let costs = Costs::new(&ring, of_face.collect()).expect("in range");
    let mut solver = DistanceSolver::new(ring.clone()).weighted(costs.clone());
    let distance = solver.distance(&[VertexId(3)], &DistanceOptions::default(), &mut go_on).expect("a source").distance;
    assert!(distance.values.iter().all(|value| value.is_finite()));
    for from in (10..800).step_by(10).map(VertexId) {
        let steepest = descend(&ring, &distance, from).expect("connected");
        let path = refract(&ring, &costs, &steepest).expect("a path of this surface");
        let [before, after] = [&steepest, &path].map(|path| costs.of_path(&ring, path));
        assert!(after <= before && after > 0.5 * distance.values[from], "{before} {after} {}", distance.values[from]);
    }
    assert!(costs.of(FaceId(0)) > 0.0);
}

/// A sphere, split so often, with a cost of 1 to 10 on each face at random, and its solver.
fn ball_of_costs(splits: u32, seed: u64) -> (Arc<Surface>, DistanceSolver) {
    let ball = Arc::new(surface(&icosphere(splits)));
    let mut random = Random::new(seed);
    let of_face = (0..ball.face_count()).map(|_| random.between(1.0, 10.0));
    let costs = Costs::new(&ball, of_face.collect()).expect("in range");
    (Arc::clone(&ball), DistanceSolver::new(ball).weighted(costs))
}

#[test]
fn paths_cost_what_the_distance_says() {
    let (_, mut solver) = ball_of_costs(4, 3);
    let answer = solver.distance(&[VertexId(3)], &DistanceOptions::default(), &mut go_on).expect("a source");
    for from in (10..2560).step_by(25).map(VertexId) {
        let path = solver.path(&answer, from, PathKind::Straightened).expect("connected");
        let [cost, distance] = [solver.cost_of(&path), answer.distance.values[from]];
        assert!(cost < 1.02 * distance, "{cost} for {distance} from {from:?}");
    }
}

#[test]
fn the_distance_at_a_place_is_that_along_the_path_from_there() {
    let (ball, mut solver) = ball_of_costs(3, 4);
    let sources =
        [(VertexId(3), 0.5), (VertexId(400), 2.0)].map(|source| ball.source(source.0, source.1).expect("a source"));
    let ask = |solver: &mut DistanceSolver, method| {
        solver.distance(&sources, &DistanceOptions::by(method), &mut go_on).expect("a source")
    };
    let answer = ask(&mut solver, Method::Auto);
    let by_heat = ask(&mut solver, Method::Heat);
    let mut starts = [false; 2];
    for face in (0..1280).step_by(40).map(FaceId) {
        let place = Place::Face { face, weights: [0.2, 0.3, 0.5] };
        let path = solver.path(&answer, place, PathKind::Straightened).expect("connected");
        let end = path.points[path.points.len() - 1].location.vertex(&ball);
        let first = end == Some(VertexId(3));
        starts[usize::from(first)] = true;
        let along = solver.cost_of(&path) + if first { 0.5 } else { 2.0 };
        assert_eq!(solver.at(&answer, place).expect("on the surface"), along);
        let between = by_heat.distance.at(&ball, place).expect("on the surface");
        assert_eq!(solver.at(&by_heat, place).expect("on the surface"), between, "by heat");
    }
    assert_eq!(starts, [true; 2], "paths lead to either source");
    solver.set_costs(None);
    let exact = ask(&mut solver, Method::Exact);
    let place = Place::Face { face: FaceId(700), weights: [0.2, 0.3, 0.5] };
    let known = solver.place_distances(&exact).expect("no costs").expect("all is exact").at(place);
    assert_eq!(solver.at(&exact, place), known);
}

#[test]
fn over_contacts_every_path_arrives_and_costs_no_more_than_the_descent() {
    let parts = Arc::new(surface(&robot(0.05).soup));
    let costs = Costs::of_slope(&parts, DVec3::Y, tobler).expect("in range");
    let mut solver = DistanceSolver::new(Arc::clone(&parts)).weighted(costs);
    solver.join(&parts, BridgeRule::Automatic, 0).expect("the surface");
    for source in [0, parts.vertex_count() as u32 / 2].map(VertexId) {
        let answer = solver.distance(&[source], &DistanceOptions::default(), &mut go_on).expect("a source");
        let reached = parts.vertices().step_by(41).filter(|&vertex| answer.distance.values[vertex].is_finite());
        for from in reached.collect::<Vec<_>>() {
            let [straight, descent] = [PathKind::Straightened, PathKind::Descent].map(|kind| {
                let path = solver.path(&answer, from, kind).expect("it is reached");
                let end = path.points[path.points.len() - 1].location;
                assert_eq!(end.vertex(&parts), Some(source));
                solver.cost_of(&path)
            });
            assert!(straight <= descent * (1.0 + 1e-9), "{from:?}: {straight} {descent}");
        }
    }
}
