//! Crowds: they stay on the surface, go down at every step, by the step, and arrive.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common;

use std::sync::Arc;

use crate::common::truth::Random;
use crate::common::{any_triangles, band, book, distance_from, soup, square, stretched, surface, two_squares};
use glam::DVec3;
use heatwalk::exact::exact_distance;
use heatwalk::{Costs, Distance, Error, HeatSolver, Parameters, Place, Soup, Surface, VertexId, go_on};
use heatwalk_scene::{Crowd, DrawTransform, Walker};
use heatwalk_shapes as shapes;

const SEED: u64 = 7;

/// Everything a walker promises, whatever the surface.
fn check(surface: &Surface, distance: &Distance, crowd: &Crowd, count: usize) {
    assert_eq!(crowd.walkers().len(), count);
    for walker in crowd.walkers() {
        let Walker { face, weights, position, upright, heading, arc } = *walker;
        // Rounding of a few products a step.
        assert!(weights.iter().all(|weight| (0.0..=1.0 + 1e-12).contains(weight)), "{walker:?}");
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{walker:?}");
        let place = Place::Face { face, weights };
        let extent = surface.positions().iter().map(|position| position.length()).fold(0.0, f64::max);
        assert!(place.position(surface).distance(position) <= 1e-12 * extent);
        assert!(place.interpolate(surface, &distance.values).is_finite(), "no source there: {walker:?}");
        assert!((upright.length() - 1.0).abs() < 1e-12 && (heading.length() - 1.0).abs() < 1e-12, "{walker:?}");
        assert!(upright.dot(heading).abs() < 1e-12, "{walker:?}");
        assert!(arc.is_finite() && arc >= 0.0);
    }
    let poses = crowd.poses(&DrawTransform::IDENTITY);
    assert_eq!(poses.len(), 10 * count);
    assert!(poses.iter().all(|number| number.is_finite()));
}

fn value(surface: &Surface, distance: &Distance, walker: &Walker) -> f64 {
    Place::Face { face: walker.face, weights: walker.weights }.interpolate(surface, &distance.values)
}

/// How a step went.
enum Step {
    /// On, by so much arc, and so much nearer.
    On { arc: f64, nearer: f64 },
    /// It started again, from so far.
    Again { from: f64 },
}

/// One step, checked, and what became of each walker.
fn step(surface: &Surface, distance: &Distance, crowd: &mut Crowd, step: f64) -> Vec<Step> {
    let before = crowd.walkers().to_vec();
    crowd.follow(distance).expect("a source");
    crowd.advance(step).expect("a step");
    check(surface, distance, crowd, before.len());
    let went = |(old, new): (&Walker, &Walker)| {
        let from = value(surface, distance, old);
        if new.arc == 0.0 && step > 0.0 {
            return Step::Again { from };
        }
        // A chord is no longer than the way.
        assert!(new.position.distance(old.position) <= step * (1.0 + 1e-9), "{old:?} to {new:?}");
        Step::On { arc: new.arc - old.arc, nearer: from - value(surface, distance, new) }
    };
    before.iter().zip(crowd.walkers()).map(went).collect()
}

fn crowd_on(solver: &HeatSolver, distance: &Distance, count: usize) -> Crowd {
    let height = 2.0 * solver.surface().mean_edge();
    let mut crowd = Crowd::new(Arc::clone(solver.surface()), count, height, SEED).expect("a height");
    crowd.follow(distance).expect("a source");
    crowd.advance(0.0).expect("a step");
    check(solver.surface(), distance, &crowd, count);
    crowd
}

fn solver_of(soup: &Soup) -> HeatSolver {
    HeatSolver::new(surface(soup), Parameters::default(), &mut go_on).expect("factors")
}

/// The greatest slope of a face.
fn steepest(surface: &Surface, distance: &Distance) -> f64 {
    distance
        .gradients(surface)
        .expect("its surface")
        .as_slice()
        .iter()
        .map(|gradient| gradient.length())
        .fold(0.0, f64::max)
}

/// On smooth closed surfaces each walker goes exactly the step, gets nearer by about it, and arrives in time.
#[test]
fn each_step_shortens_the_distance_by_the_step() {
    for (soup, source) in [(shapes::icosphere(4), 17), (shapes::torus(1.0, 0.4, 60, 28), 5)] {
        let solver = solver_of(&soup);
        let surface = solver.surface();
        let distance = solver.distance(&[Place::Vertex(VertexId(source))]).expect("a source");
        let length = 0.5 * surface.mean_edge();
        let mut crowd = crowd_on(&solver, &distance, 500);
        let starts: Vec<f64> = crowd.walkers().iter().map(|walker| value(surface, &distance, walker)).collect();
        let mut steps_taken = vec![None; starts.len()];
        let steepest = steepest(surface, &distance);
        let (mut sum, mut steps, mut slow) = (0.0, 0, 0);
        for number in 1..=(1.2 * distance.max() / length) as usize {
            for (walker, step) in step(surface, &distance, &mut crowd, length).into_iter().enumerate() {
                match step {
                    Step::On { arc, nearer } => {
                        // Rounding of a sum of steps.
                        assert!((arc - length).abs() < 1e-9 * length, "{arc}");
                        // In a face the distance falls by its slope at most.
                        assert!(nearer <= steepest * length * (1.0 + 1e-9), "{nearer}");
                        sum += nearer;
                        steps += 1;
                        slow += usize::from(nearer < 0.8 * length);
                    }
                    Step::Again { from } => {
                        // Only the source ends a walk.
                        assert!(from <= steepest * length * (1.0 + 1e-9), "gave up at {from}");
                        steps_taken[walker].get_or_insert(number);
                    }
                }
            }
        }
        let mean = sum / f64::from(steps) / length;
        // The heat method's slopes are 1 but for some per cent; those along the cut loci of a torus are less.
        assert!((mean - 1.0).abs() < 0.03, "{mean}");
        assert!(slow * 20 < steps as usize, "{slow} of {steps} steps");
        for (start, taken) in starts.iter().zip(&steps_taken) {
            let taken = taken.expect("arrived") as f64;
            assert!(taken <= 1.1 * start / length + 4.0, "{taken} steps for {start}");
        }
    }
}

/// Down a plane of slope 1 in the direction of x: what a step does is known.
#[test]
fn slides_along_the_boundary() {
    let (solver, mut distance) = distance_from(&square(8), 0);
    let surface = solver.surface();
    for (value, position) in distance.values.iter_mut().zip(surface.positions()) {
        *value = position.x + 10.0 * position.y;
    }
    let mut crowd = crowd_on(&solver, &distance, 200);
    let length = 0.3 * surface.mean_edge();
    for _ in 0..40 {
        let before = crowd.walkers().to_vec();
        step(surface, &distance, &mut crowd, length);
        for (old, new) in before.iter().zip(crowd.walkers()).filter(|(_, new)| new.arc > 0.0) {
            let moved = new.position - old.position;
            if old.position.y == 0.0 && old.position.x > 0.25 {
                assert!((moved + DVec3::X * length).length() < 1e-12, "{moved}");
            } else if new.position.y > 0.0 && old.position.x > 0.25 {
                assert!((moved + DVec3::new(1.0, 10.0, 0.0).normalize() * length).length() < 1e-12, "{moved}");
            }
        }
    }
    assert!(crowd.walkers().iter().any(|walker| walker.position.y == 0.0));
}

/// A square with its middle cut out.
fn frame(n: u32) -> Soup {
    let mut soup = square(n);
    let middle = DVec3::new(0.5, 0.5, 0.0);
    let positions = soup.positions.clone();
    let is_kept = |triangle: &[u32; 3]| {
        let centre = triangle.iter().map(|&vertex| positions[vertex as usize]).sum::<DVec3>() / 3.0;
        (centre - middle).abs().max_element() > 0.26
    };
    soup.triangles.retain(is_kept);
    common::soup(soup.positions, soup.triangles)
}

/// Soups on which only the promises count, and that nobody stays out for ever.
#[test]
fn any_surface() {
    let squashed = stretched(square(12), 1e-4);
    let mut random = Random::new(3);
    let mut crumpled = square(10);
    for position in &mut crumpled.positions {
        *position += 0.1 * random.point();
        position.z *= 1e-6;
    }
    let maze = shapes::maze(4, 3).select(&[0]).expect("part 0 is the road");
    let mut soups = vec![frame(12), shapes::strip(1.0, 20.0, 4), maze, band(24, 1), book(3, 6), squashed, crumpled];
    soups.extend([5, 9, 20, 40].map(|points| any_triangles(points, &mut random)));
    for (index, soup) in soups.iter().enumerate() {
        let solver = solver_of(soup);
        let surface = solver.surface();
        let distance = solver.distance(&[Place::Vertex(VertexId(0))]).expect("a source");
        for edges in [0.1, 1.0, 30.0] {
            let length = edges * surface.mean_edge();
            let mut crowd = crowd_on(&solver, &distance, 60);
            let mut is_out = [true; 60];
            // The linear interpolation may fall as slowly as a face is badly shaped; a tenth of the slope 1 on average is
            // less than any of these has.
            for _ in 0..(10.0 * distance.max() / length) as usize + 10 {
                for (is_out, step) in is_out.iter_mut().zip(step(surface, &distance, &mut crowd, length)) {
                    match step {
                        Step::On { arc, nearer } => {
                            assert!(arc <= length * (1.0 + 1e-9), "{arc}");
                            // Straight to a source in sight, the interpolation may rise.
                            assert!(nearer > -length * (1.0 + 1e-9), "{nearer}");
                        }
                        Step::Again { .. } => *is_out = false,
                    }
                }
            }
            assert!(!is_out.contains(&true), "soup {index}, steps of {edges}");
        }
    }
}

#[test]
fn a_source_moves_under_way() {
    let (two, first) = two_squares(6);
    let solver = solver_of(&two);
    let surface = solver.surface();
    let distances =
        [0, first - 1, first].map(|point| solver.distance(&[Place::Vertex(VertexId(point))]).expect("a source"));
    let mut crowd = crowd_on(&solver, &distances[0], 100);
    let length = 0.5 * surface.mean_edge();
    for distance in &distances[..2] {
        // On the same component they go on from where they are; few have arrived.
        let steps = step(surface, distance, &mut crowd, length);
        assert!(steps.iter().filter(|step| matches!(step, Step::On { .. })).count() > 90);
    }
    // All are on the component that has lost its source.
    let steps = step(surface, &distances[2], &mut crowd, length);
    assert!(steps.iter().all(|step| matches!(step, Step::Again { .. })));
    assert!(crowd.walkers().iter().all(|walker| walker.position.z == 1.0));
}

#[test]
fn starts_are_spread_by_area() {
    // Two strips of quads, one twice as wide: twice as many walkers.
    let positions = [(0.0, 0.0), (1.0, 0.0), (3.0, 0.0)];
    let positions: Vec<DVec3> = [0.0, 1.0].iter().flat_map(|&y| positions.map(|(x, z)| DVec3::new(x, y, z))).collect();
    let soup = soup(positions, vec![[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]]);
    let solver = solver_of(&soup);
    let distance = solver.distance(&[Place::Vertex(VertexId(0))]).expect("a source");
    let crowd = crowd_on(&solver, &distance, 9000);
    let wide = crowd.walkers().iter().filter(|walker| walker.position.x > 1.0).count();
    // Five standard deviations of √(9000 · 2/9).
    assert!(wide.abs_diff(6000) < 5 * 45, "{wide}");
}

#[test]
fn the_same_seed_walks_the_same_way() {
    let solver = solver_of(&shapes::icosphere(2));
    let distance = solver.distance(&[Place::Vertex(VertexId(3))]).expect("a source");
    let walk = |seed| {
        let mut crowd = Crowd::new(Arc::clone(solver.surface()), 50, 0.1, seed).expect("a height");
        crowd.follow(&distance).expect("a source");
        for _ in 0..60 {
            crowd.advance(0.1).expect("a step");
        }
        crowd.poses(&DrawTransform::IDENTITY)
    };
    assert_eq!(walk(1), walk(1));
    assert_ne!(walk(1), walk(2));
}

#[test]
fn a_change_of_number_keeps_those_who_stay() {
    let solver = solver_of(&shapes::icosphere(3));
    let distance = solver.distance(&[Place::Vertex(VertexId(3))]).expect("a source");
    let mut crowd = crowd_on(&solver, &distance, 50);
    let before = crowd.walkers().to_vec();
    crowd.set_count(20);
    assert_eq!(crowd.walkers(), &before[..20]);
    crowd.set_count(70);
    crowd.advance(0.0).expect("a step");
    assert_eq!(crowd.walkers().len(), 70);
    for (old, new) in before[..20].iter().zip(crowd.walkers()) {
        // The heading is laid at right angles to the normal anew.
        assert!((old.face, old.weights, old.arc) == (new.face, new.weights, new.arc));
    }
    crowd.set_count(0);
    crowd.advance(0.1).expect("a step");
    assert!(crowd.poses(&DrawTransform::IDENTITY).is_empty());
}

#[test]
fn headings_turn_over_a_height() {
    // Downhill is −x, then, at once, +x.
    let (solver, mut distance) = distance_from(&square(8), 0);
    let surface = Arc::clone(solver.surface());
    for (value, position) in distance.values.iter_mut().zip(surface.positions()) {
        *value = position.x;
    }
    let (height, step) = (0.02, 0.002);
    let mut crowd = Crowd::new(surface, 100, height, SEED).expect("a height");
    crowd.follow(&distance).expect("a source");
    crowd.advance(0.0).expect("a step");
    let is_inside = |walker: &Walker| (0.4..0.6).contains(&walker.position.x);
    let chosen: Vec<usize> = (0..100).filter(|&index| is_inside(&crowd.walkers()[index])).collect();
    assert!(!chosen.is_empty());
    for value in &mut distance.values {
        *value = 1.0 - *value;
    }
    crowd.follow(&distance).expect("a source");
    let mut before: Vec<DVec3> = chosen.iter().map(|&index| crowd.walkers()[index].heading).collect();
    for _ in 0..40 {
        crowd.advance(step).expect("a step");
        for (&index, before) in chosen.iter().zip(&mut before) {
            let heading = crowd.walkers()[index].heading;
            // A share of 1 − exp(−step / height) of the way, which is √2 at most; its arc is little longer.
            assert!(heading.distance(*before) < 1.5 * step / height, "{before} to {heading}");
            assert!(heading.x >= before.x, "it turns one way");
            *before = heading;
        }
    }
    // Of four heights π/2 go into the quarter turn to the side; 2 arctan(e^-2.4), 0.18 radians, is left after the rest.
    assert!(before.iter().all(|heading| heading.x > 0.98), "{before:?}");
}

#[test]
fn arrives_at_a_source_inside_a_face() {
    let solver = solver_of(&shapes::icosphere(1));
    let surface = solver.surface();
    let face = heatwalk::FaceId(11);
    let distance = solver.distance(&[Place::Face { face, weights: [0.2, 0.3, 0.5] }]).expect("a source");
    let mut crowd = crowd_on(&solver, &distance, 300);
    let length = 0.01 * surface.mean_edge();
    let source = distance.sources[0].position(surface);
    let mut arrivals = 0;
    for _ in 0..400 {
        let before = crowd.walkers().to_vec();
        let steps = step(surface, &distance, &mut crowd, length);
        for (old, _) in before.iter().zip(&steps).filter(|(_, step)| matches!(step, Step::Again { .. })) {
            assert!(old.position.distance(source) <= length * (1.0 + 1e-9), "{}", old.position);
            arrivals += 1;
        }
    }
    assert!(arrivals > 300, "{arrivals}");
}

#[test]
fn goes_on_over_a_constant_distance() {
    // Nothing falls anywhere: all start again at every step, but for those who see the source.
    let (solver, mut distance) = distance_from(&square(8), 0);
    distance.values.as_mut_slice().fill(1.0);
    let mut crowd = crowd_on(&solver, &distance, 50);
    for _ in 0..10 {
        step(solver.surface(), &distance, &mut crowd, 0.01);
    }
}

#[test]
fn exact_distances_are_walked_to_the_end() {
    // A refined field: every value exact.
    let solver = solver_of(&shapes::torus(1.0, 0.4, 40, 20));
    let surface = solver.surface();
    let source = Place::Vertex(VertexId(9));
    let mut distance = solver.distance(&[source]).expect("a source");
    distance.values = exact_distance(surface, &[(source, 0.0)], &mut go_on).expect("a source");
    let mut crowd = crowd_on(&solver, &distance, 300);
    let mut is_out = [true; 300];
    for _ in 0..(1.3 * distance.max() / surface.mean_edge()) as usize {
        for (is_out, step) in is_out.iter_mut().zip(step(surface, &distance, &mut crowd, surface.mean_edge())) {
            *is_out &= matches!(step, Step::On { .. });
        }
    }
    assert!(!is_out.contains(&true));
}

#[test]
fn rejects_invalid_arguments() {
    let (solver, mut distance) = distance_from(&square(4), 0);
    let surface = solver.surface();
    for height in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let crowd = Crowd::new(Arc::clone(surface), 1, height, SEED);
        assert!(matches!(crowd, Err(Error::BadParameter { name: "the height of walkers", .. })));
    }
    let mut crowd = crowd_on(&solver, &distance, 1);
    for step in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(crowd.advance(step), Err(Error::BadParameter { name: "step", .. })));
    }
    distance.sources.clear();
    assert_eq!(crowd.follow(&distance), Err(Error::NoSource));
}

#[test]
fn walkers_are_as_many_times_slower_as_it_costs() {
    let (solver, distance) = distance_from(&shapes::grid(20, 20), 0);
    let square = solver.surface();
    let arcs = |cost: Option<f64>| {
        let mut crowd = Crowd::new(Arc::clone(square), 50, 0.05, SEED).expect("a height");
        let costs =
            cost.map(|cost| Costs::new(square, (0..square.face_count()).map(|_| cost).collect()).expect("in range"));
        crowd.set_costs(costs.as_ref());
        crowd.follow(&distance).expect("a source");
        crowd.advance(0.0).expect("a step");
        crowd.advance(0.01).expect("a step");
        crowd.walkers().iter().map(|walker| walker.arc).collect::<Vec<f64>>()
    };
    let [plain, mud, road] = [arcs(None), arcs(Some(4.0)), arcs(Some(0.5))];
    for ((plain, mud), road) in plain.iter().zip(mud).zip(road) {
        // Who arrives on the way starts again.
        let is_like = |arc: f64, expected: f64| arc == 0.0 || (arc - expected).abs() < 1e-12;
        assert!(is_like(*plain, 0.01) && is_like(mud, 0.0025) && is_like(road, 0.02), "{plain} {mud} {road}");
    }
}
