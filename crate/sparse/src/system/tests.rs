//! What systems promise, whichever way they are solved.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::samples::{Mesh, both_systems, right_side};

#[test]
fn few_values_are_solved_as_a_whole_right_side() {
    for (system, bound) in both_systems(&Mesh::grid(20, 20, 0.5, 1.0).heat()) {
        let mut right = vec![0.0; system.size()];
        (right[40], right[200]) = (2.5, -1.0);
        let solution = system.solve_sparse(&vec![(40, 2.0), (200, -1.0), (40, 0.5)]).expect("converges");
        let whole = system.solve(&right).expect("converges");
        assert_eq!([solution.len(), whole.len()], [system.size(); 2]);
        assert!(whole[40] > 0.1, "{}", whole[40]);
        assert!(solution.iter().zip(&whole).all(|(a, b)| (a - b).abs() < bound));
    }
}

#[test]
fn a_finished_solve_without_constraints_is_the_solution() {
    for (system, bound) in both_systems(&Mesh::icosphere(2).poisson()) {
        let right = right_side(system.size());
        let partial = system.partial_solve(&right).expect("converges").finish();
        let whole = system.solve(&right).expect("converges");
        assert_eq!([partial.len(), whole.len()], [system.size(); 2]);
        assert!(partial.iter().zip(&whole).all(|(a, b)| (a - b).abs() < bound));
    }
}

#[test]
fn conjugate_gradients_have_no_factor() {
    let [(direct, _), (iterative, _)] = both_systems(&Mesh::icosphere(1).heat());
    // The lower triangle at least: 42 rows and 120 edges.
    assert!(direct.factor_nonzeros() >= 162, "{}", direct.factor_nonzeros());
    assert_eq!(iterative.factor_nonzeros(), 0);
}
