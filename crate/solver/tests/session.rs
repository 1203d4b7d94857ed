//! One solver in the course of its use: walls, costs, bridges and poses that change, paths, refinement and quick answers.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::truth::Random;
use crate::common::{nearest, soup, surface};
use glam::DVec3;
use heatwalk::exact::shortest_path;
use heatwalk::{
    Answer, BridgeRule, Bridges, Costs, DistanceOptions, DistanceSolver, Element, Error, FaceId, Method, PathKind,
    RelativeError, Solution, Source, Surface, VertexId, Walls, go_on,
};
use heatwalk_shapes as shapes;

/// What rounding may take from a length.
const ROUNDING: f64 = 1e-9;

fn ask(solver: &mut DistanceSolver, source: VertexId, options: &DistanceOptions) -> Answer {
    solver.distance(&[source], options, &mut go_on).expect("a distance")
}

fn torus() -> Arc<Surface> {
    Arc::new(surface(&shapes::torus(2.0, 0.7, 60, 30)))
}

/// Less than the automatic rule joins in a scene of this size.
const GAP: f64 = 0.01;

/// Two unit spheres that nearly touch.
fn pair() -> Arc<Surface> {
    let sphere = shapes::icosphere(3);
    let mut pair = soup(sphere.positions.clone(), sphere.triangles.clone());
    pair.add(sphere.positions.iter().map(|&position| position + DVec3::X * (2.0 + GAP)), &sphere.triangles);
    Arc::new(surface(&pair))
}

/// A belt around the torus but for a gate.
fn belt(surface: &Surface) -> Walls {
    let is_in_belt = |&face: &FaceId| {
        let middle = surface.corners(face).iter().sum::<DVec3>() / 3.0;
        middle.x.abs() < 0.2 && middle.z > 0.0 && middle.y < 0.5
    };
    Walls { faces: (0..surface.face_count() as u32).map(FaceId).filter(is_in_belt).collect(), edges: Vec::new() }
}

/// Dearer on one side.
fn costs(surface: &Surface) -> Costs {
    Costs::of_height(surface, DVec3::X, |share| 1.0 + f64::from(u8::from(share > 0.5))).expect("in range")
}

/// The same in another pose.
fn stretched(surface: &Surface) -> Arc<Surface> {
    Arc::new(surface.posed(surface.positions().iter().map(|&position| position * DVec3::new(1.0, 1.5, 1.0)).collect()))
}

#[test]
fn what_changed_and_changed_back_leaves_no_trace() {
    let whole = torus();
    let walls = belt(&whole);
    assert!(!walls.faces.is_empty());
    let mut used = DistanceSolver::new(Arc::clone(&whole));
    let source = nearest(&whole, DVec3::new(-2.7, 0.0, 0.0));
    for method in [Method::Propagation, Method::Heat] {
        let options = DistanceOptions::by(method);
        let plain = ask(&mut used, source, &options);

        used.set_costs(Some(costs(&whole)));
        let weighted = ask(&mut used, source, &options);
        let mut fresh = DistanceSolver::new(Arc::clone(&whole)).weighted(costs(&whole));
        assert_eq!(weighted.distance.values, ask(&mut fresh, source, &options).distance.values, "{method}");
        assert_ne!(weighted.distance.values, plain.distance.values);

        used.set_walls(&walls).expect("faces of the surface");
        used.set_costs(None);
        let walled = ask(&mut used, source, &options);
        let mut fresh = DistanceSolver::new(whole.walled(&walls).expect("faces"));
        assert_eq!(walled.distance.values, ask(&mut fresh, source, &options).distance.values, "{method}");

        let posed = stretched(used.parted());
        used.set_pose(&posed).expect("a pose");
        assert_eq!(used.surface().id(), posed.id());
        let mut fresh = DistanceSolver::new(Arc::clone(&posed));
        let stretched = ask(&mut used, source, &options);
        assert_eq!(stretched.distance.values, ask(&mut fresh, source, &options).distance.values, "{method}");

        used.set_walls(&Walls::default()).expect("none");
        assert_eq!(used.surface().id(), whole.id());
        assert_eq!(ask(&mut used, source, &options).distance.values, plain.distance.values, "{method}");
    }
    let foreign = torus();
    assert!(used.set_pose(&foreign).is_err() && used.join(&foreign, BridgeRule::Automatic, 0).is_err());
}

#[test]
fn components_are_joined_by_a_rule_or_by_links_across_walls_and_in_poses() {
    let whole = pair();
    let source = nearest(&whole, DVec3::new(-1.0, 0.0, 0.0));
    let far = nearest(&whole, DVec3::new(3.0, 0.0, 0.0));
    let mut solver = DistanceSolver::new(Arc::clone(&whole));
    let options = DistanceOptions::by(Method::Exact);
    let distance = |solver: &mut DistanceSolver| ask(solver, source, &options).distance.values[far];
    assert_eq!(distance(&mut solver), f64::INFINITY);

    solver.join(&whole, BridgeRule::Off, 0).expect("the surface");
    let alone = ask(&mut solver, source, &options);
    assert_eq!(solver.links_to_reach_more(&alone), 1);
    assert!(solver.joined().linked().is_empty());
    solver.join(&whole, BridgeRule::Off, 1).expect("the surface");
    assert_eq!((solver.joined().linked().len(), solver.joined().contact_count()), (1, 0));
    let linked = distance(&mut solver);

    solver.join(&whole, BridgeRule::Automatic, 0).expect("the surface");
    assert_eq!((solver.joined().bridges().group_count(), solver.joined().linked().len()), (1, 0));
    let joined = distance(&mut solver);
    let mut fresh = DistanceSolver::new(Arc::clone(&whole)).bridged(Bridges::find(&whole, BridgeRule::Automatic));
    assert_eq!(joined, distance(&mut fresh));
    assert!((linked - joined).abs() < 0.1 * joined, "{linked} {joined}");

    // Nothing leads through a wall around the contact.
    let is_near = |&face: &FaceId| whole.corners(face).iter().all(|corner| (corner.x - 1.0).abs() < 0.3);
    let faces = (0..whole.face_count() as u32).map(FaceId).filter(is_near).collect();
    solver.set_walls(&Walls { faces, edges: Vec::new() }).expect("faces of the surface");
    assert_eq!(distance(&mut solver), f64::INFINITY);
    solver.set_walls(&Walls::default()).expect("none");
    assert_eq!(distance(&mut solver), joined);

    // Found in the file's pose, measured in one where the parts are apart: the gap counts.
    let moved = whole.positions().iter().map(|&at| if at.x > 1.0 { at + DVec3::X } else { at }).collect();
    let posed = Arc::new(whole.posed(moved));
    solver.set_pose(&posed).expect("a pose");
    let apart = distance(&mut solver);
    assert!((apart - joined - 1.0).abs() < 0.1, "{apart} {joined}");
}

#[test]
fn paths_of_an_answer_are_the_shorter_the_more_is_asked_for() {
    let surface = torus();
    let mut solver = DistanceSolver::new(Arc::clone(&surface));
    let (from, to) = (VertexId(700), VertexId(3));
    let answer = ask(&mut solver, to, &DistanceOptions::by(Method::Heat));
    let [descent, straight, exact] = [PathKind::Descent, PathKind::Straightened, PathKind::Exact]
        .map(|kind| solver.path(&answer, from, kind).expect("a path").length());
    assert!(descent > straight && straight >= exact * (1.0 - ROUNDING), "{descent} {straight} {exact}");
    let exact_answer = ask(&mut solver, to, &DistanceOptions::by(Method::Exact));
    assert!((exact - exact_answer.distance.values[from]).abs() <= ROUNDING * exact);

    let [from_point, to_point] = [from, to].map(|vertex| surface.point(vertex).expect("a vertex"));
    let estimated = solver.path_between(from_point, to_point, &mut go_on).expect("a path").length();
    assert!(estimated >= exact * (1.0 - ROUNDING) && estimated < 1.02 * exact, "{estimated} {exact}");

    // Where costs differ, none is known to be exact.
    let costs = costs(&surface);
    solver.set_costs(Some(costs.clone()));
    let answer = ask(&mut solver, to, &DistanceOptions::default());
    let cost =
        |solver: &mut DistanceSolver, kind| costs.of_path(&surface, &solver.path(&answer, from, kind).expect("a path"));
    let refracted = cost(&mut solver, PathKind::Exact);
    assert_eq!(refracted, cost(&mut solver, PathKind::Straightened));
    assert!(refracted <= cost(&mut solver, PathKind::Descent) * (1.0 + ROUNDING));
}

#[test]
fn on_every_shape_paths_are_as_long_as_exact_distances() {
    let mut random = Random::new(11);
    for &name in shapes::names() {
        let surface = Arc::new(Surface::build(&shapes::by_name(name).expect("a shape").soup).expect("a surface"));
        let mut solver = DistanceSolver::new(Arc::clone(&surface));
        solver.join(&surface, BridgeRule::Automatic, 0).expect("its own surface");
        let source = VertexId::from_index(random.below(surface.vertex_count()));
        let answer = ask(&mut solver, source, &DistanceOptions::by(Method::Exact));
        let reached = |vertex: &VertexId| answer.distance.values[*vertex].is_finite();
        let vertices: Vec<VertexId> = surface.vertices().filter(reached).collect();
        for _ in 0..20 {
            let from = vertices[random.below(vertices.len())];
            let length = solver.path(&answer, from, PathKind::Straightened).expect("a path").length();
            let distance = answer.distance.values[from];
            assert!((length - distance).abs() <= 1e-9 * distance, "{name}, {from}: {length} for {distance}");
        }
    }
}

#[test]
fn a_search_of_a_path_goes_on_where_it_is_until_the_question_or_the_ground_is_another() {
    let surface = torus();
    let mut solver = DistanceSolver::new(Arc::clone(&surface));
    let [from, other] = [VertexId(900), VertexId(800)].map(|vertex| surface.point(vertex).expect("a vertex"));
    let sources = [Source::from(surface.point(VertexId(3)).expect("a vertex"))];
    let steps = |solver: &mut DistanceSolver, begun: &mut Option<_>, from| {
        let mut steps = 1;
        loop {
            match solver.search_path(begun, from, &sources, 1).expect("a path") {
                Some(path) => break (steps, path.length()),
                None => steps += 1,
            }
        }
    };
    let mut begun = None;
    let (whole, length) = steps(&mut solver, &mut begun, from);
    assert!(whole > 4 && begun.is_none());
    let at_once = shortest_path(solver.exact_geometry(), from, &sources).expect("a path");
    assert_eq!(length, at_once.length());

    for _ in 0..2 {
        assert!(solver.search_path(&mut begun, from, &sources, 1).expect("a step").is_none());
    }
    assert_eq!(steps(&mut solver, &mut begun, from), (whole - 2, length));
    assert!(solver.search_path(&mut begun, other, &sources, 1).expect("a step").is_none());
    assert_eq!(steps(&mut solver, &mut begun, from), (whole, length), "begins anew from another place");
    assert!(solver.search_path(&mut begun, from, &sources, 1).expect("a step").is_none());
    let everywhere = Costs::new(&surface, vec![2.0; surface.face_count()].into()).expect("in range");
    solver.set_costs(Some(everywhere));
    assert_eq!(steps(&mut solver, &mut begun, from).1, length, "a search of other ground is not gone on with");
}

#[test]
fn a_solution_becomes_exact_and_tells_how_far_off_it_was() {
    let surface = torus();
    let mut solver = DistanceSolver::new(Arc::clone(&surface));
    let everywhere = Costs::new(&surface, (0..surface.face_count()).map(|_| 7.3).collect()).expect("in range");
    let all = [None, Some(everywhere)]
        .into_iter()
        .flat_map(|cost| [Method::Heat, Method::Propagation].map(|by| (by, cost.clone())));
    for (method, cost) in all {
        solver.set_costs(cost);
        let exact = ask(&mut solver, VertexId(5), &DistanceOptions::by(Method::Exact));
        let first = ask(&mut solver, VertexId(5), &DistanceOptions::by(method));
        let mut solution = Solution::from(first.clone());
        assert!(solver.place_distances(&first).expect("no costs").is_none());
        let mut steps = 0;
        while !solution.answer().is_exact() {
            assert!(solution.instant().is_none() && solution.error().is_none() && solution.errors().is_none());
            let reached = solution.answer().distance.exact_below;
            solver.refine(&mut solution, 200).expect("room");
            // The first step begins at the sources.
            assert!(steps == 0 || solution.answer().distance.exact_below >= reached);
            steps += 1;
        }
        assert!(steps > 2, "{method}: {steps}");
        for (value, exact) in solution.answer().distance.values.iter().zip(&exact.distance.values) {
            assert!((value - exact).abs() <= ROUNDING * exact, "{method}: {value} {exact}");
        }
        assert_eq!(solution.instant(), Some(&first.distance.values));
        let [error, expected] = [
            solution.error().expect("all is exact"),
            RelativeError::between(&first.distance.values, &exact.distance.values),
        ];
        assert!((error.mean - expected.mean).abs() <= ROUNDING && (error.max - expected.max).abs() <= ROUNDING);
        let errors = solution.errors().expect("all is exact");
        assert_eq!(errors[VertexId(5)], 0.0);
        let largest = errors.iter().copied().fold(0.0, f64::max);
        assert!((error.max - largest).abs() <= ROUNDING, "{largest}");
        let places = solver.place_distances(solution.answer()).expect("no costs").expect("all is exact");
        assert_eq!(places.at(VertexId(5)), Ok(0.0));
    }
    solver.set_costs(Some(costs(&surface)));
    let mut weighted = Solution::from(ask(&mut solver, VertexId(5), &DistanceOptions::default()));
    assert_eq!(solver.refine(&mut weighted, 1), Err(Error::NotExact));
}

#[test]
fn quick_answers_are_near_the_others() {
    let surface = Arc::new(surface(&shapes::icosphere(5)));
    let mut solver = DistanceSolver::new(surface);
    let source = VertexId(11);
    let exact = ask(&mut solver, source, &DistanceOptions::by(Method::Exact));
    for method in [Method::Auto, Method::Propagation, Method::Heat] {
        let options = DistanceOptions::by(method);
        let quick = ask(&mut solver, source, &options.quick());
        assert_ne!(quick.method, Method::Exact);
        assert!(quick.windows < exact.windows / 4);
        let error = RelativeError::between(&quick.distance.values, &exact.distance.values);
        assert!(error.mean < 0.01, "{method}: {error:?}");
    }
    let few = DistanceOptions::by(Method::Heat).quick();
    assert_eq!(few.quick(), few);
}

#[test]
fn distances_are_given_by_vertices_of_the_input() {
    // The last vertex is in no triangle, and the first two are one.
    let positions = [DVec3::ZERO, DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE, DVec3::Z].to_vec();
    let mut solver = DistanceSolver::new(surface(&soup(positions, vec![[0, 2, 3], [1, 3, 4]])));
    let source = solver.surface().vertex_of_input(heatwalk::InputVertex(0)).expect("a corner");
    let answer = ask(&mut solver, source, &DistanceOptions::default());
    let values = solver.of_inputs(&answer);
    assert_eq!(values.len(), 6);
    for (value, expected) in values.iter().zip([0.0, 0.0, 1.0, 1.0, 3.0_f64.sqrt(), f64::INFINITY]) {
        assert!(*value == expected || (value - expected).abs() <= ROUNDING, "{values:?}");
    }
}
