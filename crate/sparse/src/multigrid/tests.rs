//! Solutions against Cholesky factors, steps that do not grow with the mesh, and aggregates of awkward matrices.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use super::aggregation::{Coarse, coarsen};
use faer::c64;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use super::*;
use crate::conjugate_gradients::ConjugateGradients;
use crate::ordering::Permutation;
use crate::progress::go_on;
use crate::samples::{Mesh, right_side, unit_numbers};
use crate::symbolic::Symbolic;

/// Solves by both solvers, asserts that they differ by at most this share of the largest value, and returns the steps.
fn steps_and_agreement(matrix: &SymmetricMatrix, bound: f64) -> usize {
    let right = right_side(matrix.size());
    let (solution, residuals) = ConjugateGradients::new(matrix.clone()).solve_recording(&right).expect("converges");
    let steps = residuals.len() - 1;
    assert!(residuals[0] == 1.0 && residuals[steps] <= 1e-12 && residuals[..steps].iter().all(|&share| share > 1e-12));
    let negative: Vec<f64> = solution.iter().map(|value| -value).collect();
    let mut rest = right.clone();
    matrix.multiply_add(&negative, &mut rest);
    let norm = |vector: &[f64]| vector.iter().map(|value| value * value).sum::<f64>().sqrt();
    // What is updated step by step drifts from what is computed anew by rounding, which is that of the largest products.
    assert!(norm(&rest) <= 1e-9 * norm(&right), "{} of {}", norm(&rest), norm(&right));
    let permutation = Permutation::fill_reducing(matrix.pattern()).expect("memory");
    let symbolic = Arc::new(Symbolic::analyse(matrix.pattern(), permutation).expect("memory"));
    let [factor] = symbolic.factor([matrix], &mut go_on).expect("positive definite");
    let direct = factor.solve(&right);
    let largest = direct.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let difference = solution.iter().zip(&direct).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(difference <= bound * largest, "{difference} of {largest} after {steps} steps");
    steps
}

#[test]
fn solutions_are_those_of_factors() {
    // Even triangles, obtuse ones, and ones five times as long as high; beside them a sphere.
    for (shear, stretch) in [(0.0, 1.0), (3.0, 1.0), (0.0, 5.0)] {
        let mesh = Mesh::grid(30, 20, shear, stretch).beside(&Mesh::icosphere(2));
        let poisson = mesh.poisson();
        // Cotangents of right angles are rounding. The diagonal is positive anyway.
        let positive = poisson.values().iter().filter(|value| **value > 1e-9).count();
        assert_eq!(positive > poisson.size(), shear > 0.0);
        for matrix in [poisson, mesh.heat()] {
            // A residual of 10⁻¹², by condition numbers of some 10⁴.
            steps_and_agreement(&matrix, 1e-8);
        }
    }
}

#[test]
fn steps_do_not_grow_with_the_mesh() {
    let steps = |subdivisions| {
        let mesh = Mesh::icosphere(subdivisions);
        [mesh.poisson(), mesh.heat()].map(|matrix| steps_and_agreement(&matrix, 1e-8))
    };
    let [[poisson, heat], [finer_poisson, finer_heat]] = [3, 5].map(steps);
    // Sixteen times as many unknowns, a condition number sixteen times as large: without coarser grids four times as
    // many steps. The K-cycle's bound on them does not depend on the number of grids; a fifth is for its being near.
    assert!(5 * finer_poisson <= 6 * poisson, "{poisson} {finer_poisson}");
    assert!(5 * finer_heat <= 6 * heat, "{heat} {finer_heat}");
    // Half of what the diagonal as preconditioner takes on the small one.
    assert!(poisson < 42, "{poisson}");
}

#[test]
fn other_units_of_each_row_take_the_same_steps() {
    // A real matrix between values that are each turned by an angle of their own, as frames of a flat surface may be.
    let real = Mesh::icosphere(4).poisson();
    let turns = unit_numbers(real.size(), 2.3);
    let pattern = real.pattern();
    let entries = (0..real.size()).flat_map(|column| pattern.column(column).map(move |entry| (column, entry)));
    let turned = entries
        .map(|(column, entry)| (turns[pattern.rows()[entry] as usize] * turns[column].conj()).scale(real[entry]));
    let matrix = SymmetricMatrix::new(Arc::clone(pattern), turned.collect()).expect("values of the pattern");
    let right = right_side(real.size());
    let right_turned: Vec<c64> = turns.iter().zip(&right).map(|(turn, &value)| turn.scale(value)).collect();
    let (wanted, steps) = ConjugateGradients::new(real).solve_recording(&right).expect("converges");
    let (solution, residuals) = ConjugateGradients::new(matrix).solve_recording(&right_turned).expect("converges");
    assert_eq!(residuals.len(), steps.len());
    let largest = wanted.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    for ((value, turn), wanted) in solution.iter().zip(&turns).zip(&wanted) {
        // Residuals of 10⁻¹², by a condition number of some 10³.
        assert!((*value - turn.scale(*wanted)).magnitude() < 1e-9 * largest);
    }
}

#[test]
fn uneven_couplings_are_solved() {
    // A grid whose couplings jump between 10⁻² and 10² from edge to edge, worse than those of slivers.
    let side = 40;
    let mut random = SplitMix64::seed_from_u64(1);
    let mut weight = || 10.0_f64.powi(random.random_range(-2..=2));
    let mut diagonal = vec![0.0; side * side];
    let (mut start, mut sides) = (vec![0], Vec::new());
    for row in 0..side * side {
        let right = (row % side + 1 < side).then_some(row + 1);
        for other in right.into_iter().chain((row + side < side * side).then_some(row + side)) {
            let weight = weight();
            diagonal[row] += weight;
            diagonal[other] += weight;
            sides.push((other as u32, -weight));
        }
        start.push(sides.len() as u32);
    }
    diagonal[0] += 1.0;
    let matrix = SymmetricMatrix::from_entries(&diagonal, &start, &mut sides);
    let multigrid = Multigrid::new(matrix.clone());
    let is_halved = |grids: &[Grid<f64>]| 2 * grids[1].matrix.size() <= grids[0].matrix.size();
    assert!(multigrid.grids.windows(2).all(is_halved));
    // Condition numbers of some 10⁷.
    let steps = steps_and_agreement(&matrix, 1e-5);
    // The bound of conjugate gradients without rounding, which the diagonal as preconditioner reaches.
    assert!(steps < side * side / 2, "{steps}");
}

#[test]
fn the_smallest_systems_are_solved() {
    let square = Mesh::grid(1, 1, 0.0, 1.0);
    for matrix in [square.poisson(), square.heat()] {
        // Rounding.
        steps_and_agreement(&matrix, 1e-12);
    }
    let unit = ConjugateGradients::new(SymmetricMatrix::from_entries(&[2.0], &[0, 0], &mut []));
    assert_eq!(unit.solve(&[3.0]).expect("a solution"), [1.5]);
    assert_eq!(unit.solve(&[0.0]).expect("a solution"), [0.0]);
}

#[test]
fn rows_around_a_hub_are_one_aggregate() {
    let rows = 50;
    let mut sides: Vec<(u32, f64)> = (1..rows).map(|row| (row, -1.0)).collect();
    let mut diagonal = vec![1.0; rows as usize];
    diagonal[0] = f64::from(rows);
    let start: Vec<u32> = (0..=rows).map(|column| if column == 0 { 0 } else { rows - 1 }).collect();
    let Coarse { aggregates, matrix, .. } = coarsen(&SymmetricMatrix::from_entries(&diagonal, &start, &mut sides));
    // The second pairing finds one row that nothing is coupled to, and leaves it to smoothing.
    assert_eq!((matrix.size(), matrix.values().len()), (0, 0));
    assert!(aggregates.iter().all(|&aggregate| aggregate == NONE));
}

#[test]
fn constrained_and_dominant_rows_are_in_no_aggregate() {
    // A chain 0–1–2–3, row 4 constrained, and a row 5 whose diagonal outweighs its coupling to 3.
    let mut sides = vec![(1, -1.0), (2, -1.0), (3, -1.0), (4, 0.0), (5, -1.0)];
    let diagonal = [1.5, 2.5, 2.5, 3.5, 1.0, 9.0];
    let Coarse { aggregates, matrix, .. } =
        coarsen(&SymmetricMatrix::from_entries(&diagonal, &[0, 1, 2, 3, 5, 5, 5], &mut sides));
    assert_eq!(aggregates, [0, 0, 0, 0, NONE, NONE]);
    // 10 on the diagonals less six couplings.
    assert_eq!(matrix.values(), [4.0]);
}

#[test]
fn positive_couplings_alone_make_no_aggregates() {
    // Left to pair with nothing, such rows would make the same grid for ever.
    let matrix = SymmetricMatrix::from_entries(&[1.0, 1.0], &[0, 1, 1], &mut [(1, 0.5)]);
    assert_eq!(Multigrid::new(matrix.clone()).grids.len(), 1);
    // Rounding.
    steps_and_agreement(&matrix, 1e-12);
}
