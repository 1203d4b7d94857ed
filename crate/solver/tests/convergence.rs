//! Residuals of the two linear solvers.

use heatwalk::heat::Residuals;
use heatwalk::{Boundary, FactorOptions, Factorization, LinearSolver, Query, Soup, Surface, TimeStep, VertexId, go_on};
use heatwalk_shapes::{grid, icosphere};

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Where conjugate gradients stop.
const GOAL: f64 = 1e-12;

fn factored(soup: &Soup, options: FactorOptions) -> Factorization {
    let surface = Surface::build(soup).expect("a surface");
    Factorization::new(surface, options, &mut go_on).expect("factors")
}

fn assert_converges(residuals: &Residuals) {
    let (last, before) = residuals.iterated.split_last().expect("the residual before the first step");
    assert_eq!(residuals.iterated[0], 1.0, "nothing is solved before the first step");
    assert!(*last <= GOAL && before.iter().all(|&share| share > GOAL), "it stops as soon as it may");
    assert!(before.len() > 2, "some steps are needed");
    // Rounding of a backward stable solve, by condition numbers of some 10⁴.
    assert!(residuals.factored > 0.0 && residuals.factored < 1e-11, "{}", residuals.factored);
}

#[test]
fn both_systems_converge_whichever_solver_is_chosen() {
    let mut found = Vec::new();
    for solver in [LinearSolver::Cholesky, LinearSolver::ConjugateGradients] {
        // The time is the same for both solvers only where it is given.
        let options = FactorOptions { solver, time_step: TimeStep::Factor(1.0), ..FactorOptions::default() };
        let factorization = factored(&icosphere(4), options);
        let query = Query::new(factorization.surface(), &[VertexId(0), VertexId(100)]).expect("sources");
        let convergence = factorization.convergence(&query).expect("both solve");
        assert_converges(&convergence.heat);
        assert_converges(&convergence.poisson);
        found.push(convergence.heat);
    }
    assert_eq!(found[0], found[1], "the systems are those of the options, not of the solver");
}

#[test]
fn a_longer_time_takes_more_steps() {
    let steps = [1.0, 1000.0].map(|time| {
        let options = FactorOptions { time_step: TimeStep::Factor(time), ..FactorOptions::default() };
        let factorization = factored(&icosphere(4), options);
        let query = Query::new(factorization.surface(), &[VertexId(0)]).expect("a source");
        factorization.convergence(&query).expect("both solve").heat.iterated.len()
    });
    assert!(steps[0] < steps[1], "{steps:?}");
}

#[test]
fn a_source_on_a_cold_boundary_gives_no_heat() {
    let options = FactorOptions { boundary: Boundary::Dirichlet, ..FactorOptions::default() };
    let factorization = factored(&grid(20, 20), options);
    let surface = factorization.surface();
    let cold = surface.vertices().find(|&vertex| surface.boundary_vertices()[vertex]).expect("a boundary");
    let query = Query::new(surface, &[cold]).expect("a source");
    let convergence = factorization.convergence(&query).expect("both solve");
    assert_eq!((convergence.heat.iterated, convergence.heat.factored), (vec![0.0], 0.0));
}
