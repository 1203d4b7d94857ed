//! One solver by any method: what it tells, what it keeps, the same answers however it is asked.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::common::{square, surface};
use heatwalk::exact::exact_distance;
use heatwalk::{
    Answer, Boundary, DistanceOptions, DistanceSolver, Error, ExactRadius, HeatSolver, Method, Parameters,
    PropagationOptions, RelativeError, Stage, Surface, VertexId, Windows, go_on, propagation,
};
use heatwalk_shapes as shapes;

const METHODS: [Method; 4] = [Method::Auto, Method::Propagation, Method::Heat, Method::Exact];

fn torus() -> Arc<Surface> {
    Arc::new(surface(&shapes::torus(2.0, 0.7, 90, 40)))
}

fn ask(solver: &mut DistanceSolver, source: u32, options: &DistanceOptions) -> Answer {
    solver.distance(&[VertexId(source)], options, &mut go_on).expect("a distance")
}

#[test]
fn each_method_gives_what_it_gives_by_itself() {
    let surface = torus();
    let sources = [VertexId(3), VertexId(500)];
    let mut solver = DistanceSolver::new(Arc::clone(&surface));
    let mut by = |method| solver.distance(&sources, &DistanceOptions::by(method), &mut go_on).expect("a distance");

    let exact = by(Method::Exact);
    let alone = exact_distance(&surface, &sources, &mut go_on).expect("a distance");
    assert_eq!(exact.distance.values, alone);
    assert_eq!((exact.method, exact.distance.exact_below), (Method::Exact, f64::INFINITY));
    assert!(exact.windows > surface.face_count());

    let few = by(Method::Propagation);
    let options = PropagationOptions::default();
    let alone = propagation::propagated_distance(&surface, &sources, options, &mut go_on);
    assert_eq!(few.distance, alone.expect("a distance"));
    assert_eq!(few.method, Method::Propagation);
    assert!(few.distance.exact_below > 0.0 && few.distance.exact_below < few.distance.max());
    assert!(few.windows > 0 && few.windows < exact.windows, "{} {}", few.windows, exact.windows);

    let heat = by(Method::Heat);
    let alone = HeatSolver::new(Arc::clone(&surface), Parameters::default(), &mut go_on)
        .and_then(|solver| solver.distance(&sources));
    assert_eq!(heat.distance, alone.expect("a distance"));
    assert_eq!((heat.method, heat.windows), (Method::Heat, 0));

    // So small a surface is exact at no cost.
    let auto = by(Method::Auto);
    assert_eq!(auto, exact);
    assert_eq!(DistanceOptions::default(), DistanceOptions::by(Method::Auto));
}

#[test]
fn questions_do_not_leave_traces() {
    let mut used = DistanceSolver::new(torus());
    let more = Windows::AtMost(4.try_into().expect("not 0"));
    let cold =
        Parameters { boundary: Boundary::Average, exact_radius: ExactRadius::Edges(0.0), ..Parameters::default() };
    let mut asked: Vec<DistanceOptions> = METHODS.map(DistanceOptions::by).to_vec();
    asked.push(DistanceOptions { windows: more, ..DistanceOptions::by(Method::Propagation) });
    asked.push(DistanceOptions { max_distance: 1.5, ..DistanceOptions::by(Method::Propagation) });
    asked.push(DistanceOptions { heat: cold, ..DistanceOptions::by(Method::Heat) });
    for source in [7, 1234, 7] {
        for options in asked.iter().chain(asked.iter().rev()) {
            let mut fresh = DistanceSolver::new(Arc::clone(used.surface()));
            assert_eq!(ask(&mut used, source, options), ask(&mut fresh, source, options), "{options:?}");
        }
    }
}

#[test]
fn only_what_a_method_needs_is_made_and_once() {
    let mut solver = DistanceSolver::new(torus());
    for method in [Method::Auto, Method::Propagation, Method::Exact] {
        ask(&mut solver, 0, &DistanceOptions::by(method));
    }
    assert!(solver.heat().is_none());
    let geometry = Arc::clone(solver.exact_geometry());
    ask(&mut solver, 1, &DistanceOptions::default());
    assert!(Arc::ptr_eq(&geometry, solver.exact_geometry()));

    let heat = DistanceOptions::by(Method::Heat);
    let stages = |solver: &mut DistanceSolver, options: &DistanceOptions| {
        let mut stages = Vec::new();
        let mut note = |stage, _| {
            stages.push(stage);
            ControlFlow::Continue(())
        };
        solver.prepare(options, &mut note).expect("factors");
        stages
    };
    assert!(stages(&mut solver, &heat).contains(&Stage::Ordering));
    assert!(solver.heat().is_some_and(|heat| heat.factor_nonzeros() > 0));
    assert_eq!(stages(&mut solver, &heat), []);
    let other_query = Parameters { exact_radius: ExactRadius::Edges(2.0), ..Parameters::default() };
    assert_eq!(stages(&mut solver, &DistanceOptions { heat: other_query, ..heat }), []);

    let mut warm = DistanceSolver::new(Arc::clone(solver.surface()));
    warm.prepare(&heat, &mut go_on).expect("factors");
    let shared = Arc::clone(warm.heat().expect("just factored").exact_geometry());
    assert!(Arc::ptr_eq(&shared, warm.exact_geometry()), "triangles are unfolded once");
}

#[test]
fn what_is_farther_than_asked_for_stays_at_infinity() {
    let surface = torus();
    let mut solver = DistanceSolver::new(Arc::clone(&surface));
    for method in [Method::Auto, Method::Propagation, Method::Exact] {
        let whole = ask(&mut solver, 9, &DistanceOptions::by(method));
        let some_value = whole.distance.values[VertexId(1700)];
        for max_distance in [0.5, some_value, 100.0] {
            let near = ask(&mut solver, 9, &DistanceOptions { max_distance, ..DistanceOptions::by(method) });
            for (&near, &whole) in near.distance.values.iter().zip(&whole.distance.values) {
                assert_eq!(near, if whole <= max_distance { whole } else { f64::INFINITY });
            }
            assert!(near.windows < whole.windows || max_distance > whole.distance.max());
        }
    }
    for (method, max_distance) in
        [(Method::Heat, 1.0), (Method::Auto, 0.0), (Method::Exact, -1.0), (Method::Propagation, f64::NAN)]
    {
        let options = DistanceOptions { max_distance, ..DistanceOptions::by(method) };
        let refused = solver.distance(&[VertexId(0)], &options, &mut go_on);
        assert!(matches!(refused, Err(Error::BadParameter { name: "the maximum distance", .. })), "{refused:?}");
    }
}

#[test]
fn the_caller_is_told_how_far_it_is_and_can_stop() {
    let mut solver = DistanceSolver::new(surface(&shapes::icosphere(6)));
    for method in METHODS {
        let options = DistanceOptions::by(method);
        let mut stages = Vec::new();
        let mut stop = |stage, _| {
            stages.push(stage);
            if stages.len() == 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let stopped = solver.distance(&[VertexId(0)], &options, &mut stop).map(|answer| answer.windows);
        assert_eq!(stopped, Err(Error::Cancelled), "{method}");
        match (method, stages.as_slice()) {
            (Method::Heat, stages) => assert_eq!(stages, [Stage::Assembling, Stage::Ordering]),
            (_, &[Stage::Searching { radius: first }, Stage::Searching { radius: second }]) => {
                assert!(0.0 < first && first <= second);
            }
            (_, stages) => panic!("{method}: {stages:?}"),
        }
        // It answers afterwards.
        let exact = ask(&mut solver, 0, &DistanceOptions::by(Method::Exact));
        let error = RelativeError::between(&ask(&mut solver, 0, &options).distance.values, &exact.distance.values);
        assert!(error.mean < 0.01, "{method}: {error:?}");
    }
}

#[test]
fn refuses_what_is_not_on_the_surface_and_goes_on() {
    let mut solver = DistanceSolver::new(surface(&square(4)));
    for method in METHODS {
        let options = DistanceOptions::by(method);
        let before = ask(&mut solver, 1, &options);
        assert_eq!(solver.distance::<VertexId>(&[], &options, &mut go_on), Err(Error::NoSource));
        assert!(solver.distance(&[VertexId(1000)], &options, &mut go_on).is_err());
        assert_eq!(ask(&mut solver, 1, &options), before);
    }
    let bad = Parameters { exact_radius: ExactRadius::Edges(-1.0), ..Parameters::default() };
    let bad = DistanceOptions { heat: bad, ..DistanceOptions::by(Method::Heat) };
    assert!(solver.distance(&[VertexId(0)], &bad, &mut go_on).is_err());
    ask(&mut solver, 0, &DistanceOptions::by(Method::Heat));
}

fn threads(count: usize) -> NonZeroUsize {
    NonZeroUsize::new(count).expect("a thread")
}

#[test]
fn sources_by_themselves_are_in_their_order() {
    let surface = torus();
    let sources: Vec<VertexId> = (0..7).map(|source| VertexId(300 * source)).collect();
    // wasm32 has no threads.
    let most = if cfg!(target_arch = "wasm32") { 1 } else { 12 };
    for method in METHODS {
        let options = DistanceOptions::by(method);
        let mut solver = DistanceSolver::new(Arc::clone(&surface));
        let alone: Vec<Answer> = sources.iter().map(|&source| ask(&mut solver, source.0, &options)).collect();
        for count in [1, 3, 12].into_iter().filter(|&count| count <= most) {
            let each = solver.distances_from_each(&sources, &options, threads(count), &mut go_on);
            assert_eq!(each.as_ref(), Ok(&alone), "{method}, {count} threads");
        }
    }
}

#[test]
fn several_questions_can_be_stopped() {
    let mut solver = DistanceSolver::new(torus());
    let sources = [VertexId(0); 5];
    let options = DistanceOptions::by(Method::Propagation);
    let mut shares = Vec::new();
    let mut stop = |stage, done| {
        assert_eq!(stage, Stage::Answering);
        shares.push(done);
        if done >= 0.6 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let stopped = solver.distances_from_each(&sources, &options, threads(1), &mut stop);
    assert_eq!(stopped, Err(Error::Cancelled));
    shares.dedup();
    shares.retain(|&share| share > 0.0);
    assert_eq!(shares, [0.2, 0.4, 0.6]);
    let none = solver.distances_from_each::<VertexId>(&[], &options, threads(1), &mut go_on);
    assert_eq!(none, Err(Error::NoSource));
    let missing = [VertexId(0), VertexId(1_000_000)];
    assert!(solver.distances_from_each(&missing, &options, threads(1), &mut go_on).is_err());
}

#[test]
fn several_questions_can_be_stopped_while_one_is_worked_on() {
    let mut solver = DistanceSolver::new(torus());
    let sources = [VertexId(0), VertexId(1)];
    let mut told = Vec::new();
    let mut stop = |_, done| {
        told.push(done);
        ControlFlow::Break(())
    };
    let options = DistanceOptions::by(Method::Exact);
    let stopped = solver.distances_from_each(&sources, &options, threads(1), &mut stop);
    assert_eq!((stopped, told), (Err(Error::Cancelled), vec![0.0]), "before the first is answered");
}
