//! Surfaces whose factors do not fit into memory.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::solver_with;
use heatwalk::{
    Boundary, Error, HeatSolver, LinearSolver, MemoryLimit, Parameters, Place, Result, Surface, TimeStep, VertexId,
    go_on,
};
use heatwalk_shapes as shapes;

const NUMBER: u64 = size_of::<f64>() as u64;

fn disc() -> Arc<Surface> {
    Arc::new(Surface::build(&shapes::terrain(48)).expect("a surface"))
}

fn limited(bytes: u64) -> Parameters {
    Parameters { memory: MemoryLimit::Bytes(bytes), ..Parameters::default() }
}

fn factor(surface: &Arc<Surface>, parameters: Parameters) -> Result<HeatSolver> {
    HeatSolver::new(Arc::clone(surface), parameters, &mut go_on)
}

fn needed(surface: &Arc<Surface>, parameters: Parameters) -> u64 {
    match factor(surface, parameters) {
        Err(Error::TooLarge { needed_bytes }) => needed_bytes,
        other => panic!("not refused: {:?}", other.map(|solver| solver.factor_nonzeros())),
    }
}

#[test]
fn factors_beyond_the_limit_are_refused_before_they_are_made() {
    let surface = disc();
    let needed = needed(&surface, limited(1));
    assert!(factor(&surface, limited(needed - 1)).is_err());
    let solver = factor(&surface, limited(needed)).expect("as much as is needed");
    let kept = NUMBER * solver.factor_nonzeros() as u64;
    assert!(kept < needed, "{kept} bytes kept of {needed}");
}

#[test]
fn each_matrix_needs_room_for_another_factor() {
    let surface = disc();
    // That of heat; that and the Poisson matrix; two of heat and the Poisson matrix.
    let [one, two, three] = [Boundary::Neumann, Boundary::Dirichlet, Boundary::Average]
        .map(|boundary| needed(&surface, Parameters { boundary, ..limited(1) }));
    let factor = NUMBER * factor(&surface, Parameters::default()).expect("factors").factor_nonzeros() as u64;
    assert_eq!([two - one, three - two], [factor; 2]);
}

#[test]
fn conjugate_gradients_answer_where_factors_do_not_fit() {
    let surface = disc();
    let factored = Parameters { time_step: TimeStep::Factor(16.0), ..Parameters::default() };
    let iterated = Parameters { solver: LinearSolver::ConjugateGradients, memory: MemoryLimit::Bytes(1), ..factored };
    let source = [Place::Vertex(VertexId(0))];
    let [iterated, factored] = [iterated, factored]
        .map(|parameters| factor(&surface, parameters).expect("a solver").distance(&source).expect("a source"));
    for (a, b) in iterated.values.iter().zip(&factored.values) {
        assert!((a - b).abs() < 1e-6 * factored.max(), "{a} by conjugate gradients, {b} by factors");
    }
}

#[test]
fn factors_that_are_kept_count() {
    let surface = disc();
    let mut solver = factor(&surface, limited(needed(&surface, limited(1)))).expect("as much as is needed");
    let change = Parameters { boundary: Boundary::Average, ..solver.parameters() };
    let refused = solver.set_parameters(change, &mut go_on);
    assert!(matches!(refused, Err(Error::TooLarge { .. })), "{refused:?}");
}

#[test]
fn spare_factors_go_where_memory_is_short() {
    let surface = disc();
    let three = needed(&surface, Parameters { boundary: Boundary::Average, ..limited(1) });
    let mut solver = factor(&surface, limited(three)).expect("a third of it to spare");
    for time in [4.0, 8.0, 16.0] {
        let change = Parameters { time_step: TimeStep::Factor(time), ..solver.parameters() };
        solver.set_parameters(change, &mut go_on).expect("room beside the factors in use");
    }
}

#[test]
fn a_solver_that_is_refused_new_factors_answers_with_the_old_ones() {
    let mut solver = solver_with(&shapes::terrain(48), Parameters::default());
    let before = solver.distance(&[Place::Vertex(VertexId(0))]).expect("a source");
    let change = Parameters { time_step: TimeStep::Factor(4.0), ..limited(1) };
    let refused = solver.set_parameters(change, &mut go_on);
    assert!(matches!(refused, Err(Error::TooLarge { .. })), "{refused:?}");
    assert_eq!(solver.parameters(), Parameters::default());
    let after = solver.distance(&[Place::Vertex(VertexId(0))]).expect("a source");
    assert_eq!(before.values, after.values);
}

#[test]
fn the_refusal_names_the_size_and_a_way_out() {
    let sentence = Error::TooLarge { needed_bytes: 5 << 30 }.to_string();
    for part in ["5.00 GiB", "conjugate gradients"] {
        assert!(sentence.contains(part), "{sentence}");
    }
}
