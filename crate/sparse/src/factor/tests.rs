//! Solutions put back into their matrices, of real and of complex numbers; what is refused.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::ops::ControlFlow;

use faer::c64;

use super::*;
use crate::ordering::Permutation;
use crate::pattern::Pattern;
use crate::progress::go_on;
use crate::samples::{Mesh, both_systems, hermitian, right_side, unit_numbers};
use crate::schur::{Functional, SchurComplement, evaluate};
use crate::system::System;

/// Share of the right side by which a solution may miss it: rounding, by the length of the sums and the growth in the
/// factor.
const RESIDUAL: f64 = 1e-12;

fn analysed(pattern: &Arc<Pattern>) -> Arc<Symbolic> {
    let permutation = Permutation::fill_reducing(pattern).expect("memory");
    Arc::new(Symbolic::analyse(pattern, permutation).expect("memory"))
}

fn assert_solves<T: Scalar>(matrix: &SymmetricMatrix<T>, solution: &[T], right: &[T]) {
    let mut rest: Vec<T> = right.iter().map(|&value| -value).collect();
    matrix.multiply_add(solution, &mut rest);
    let largest = solution.iter().fold(1.0_f64, |largest, value| largest.max(value.magnitude()));
    let missed = rest.iter().fold(0.0_f64, |most, value| most.max(value.magnitude()));
    assert!(missed <= RESIDUAL * largest, "{missed} at solutions up to {largest}");
}

#[test]
fn solutions_satisfy_their_matrices() {
    for mesh in [Mesh::grid(1, 1, 0.0, 1.0), Mesh::grid(40, 30, 3.0, 1.0), Mesh::icosphere(3)] {
        let mesh = mesh.beside(&Mesh::icosphere(0));
        let (poisson, heat) = (mesh.poisson(), mesh.heat());
        let symbolic = analysed(poisson.pattern());
        let factors = symbolic.factor([&poisson, &heat], &mut go_on).expect("positive definite");
        for (matrix, both) in [poisson, heat].iter().zip(factors) {
            let right = right_side(matrix.size());
            assert_solves(matrix, &both.solve(&right), &right);
            let [alone] = symbolic.factor([matrix], &mut go_on).expect("positive definite");
            assert_solves(matrix, &alone.solve(&right), &right);
            let few = [(3, 2.0), (0, -1.0), (3, 0.5)];
            let mut right = vec![0.0; matrix.size()];
            (right[3], right[0]) = (2.5, -1.0);
            assert_solves(matrix, &both.solve_sparse(&few), &right);
            assert_eq!(both.nonzeros(), symbolic.factor_nonzeros());
        }
    }
}

#[test]
fn a_rounded_factor_is_that_of_a_matrix_nearby() {
    let mesh = Mesh::grid(40, 30, 3.0, 1.0);
    let matrix = mesh.heat();
    let factor = || {
        let [factor] = analysed(matrix.pattern()).factor([&matrix], &mut go_on).expect("positive definite");
        factor
    };
    let rounded = System::cholesky(factor().rounded().expect("entries near 1"));
    let whole = System::cholesky(factor());
    assert_eq!(rounded.factor_nonzeros(), whole.factor_nonzeros());
    let right = right_side(matrix.size());
    let few: Functional = vec![(40, 2.0), (200, -1.0)];
    let solutions = |system: &System| {
        let columns = system.schur_columns(std::slice::from_ref(&few)).expect("a factor");
        let mut partial = system.partial_solve(&right).expect("a factor");
        partial.add(1.5, &columns[0]);
        [system.solve(&right), system.solve_sparse(&few), Ok(partial.finish())]
            .map(|solution| solution.expect("a factor"))
    };
    for (rounded, whole) in solutions(&rounded).iter().zip(solutions(&whole)) {
        let size = whole.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        let missed = rounded.iter().zip(&whole).map(|(a, b)| (a - b).abs()).fold(0.0_f64, f64::max);
        // Rounding by half of 2⁻²³, in a matrix whose condition number is some tens.
        assert!(missed > 0.0 && missed < 1e-5 * size, "{missed} of {size}");
    }
}

#[test]
fn a_factor_of_entries_that_single_precision_lacks_is_not_rounded() {
    let mesh = Mesh::grid(4, 4, 0.0, 1.0);
    for scale in [1e-90, 1e90] {
        let (pattern, values) = mesh.heat().into_parts();
        let values = values.into_iter().map(|value| scale * value).collect();
        let matrix = SymmetricMatrix::new(pattern, values).expect("values of the pattern");
        let [factor] = analysed(matrix.pattern()).factor([&matrix], &mut go_on).expect("positive definite");
        let kept = factor.rounded().expect_err("out of range");
        let right: Vec<f64> = right_side(matrix.size()).iter().map(|value| scale * value).collect();
        let solution = kept.solve(&right);
        let largest = solution.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        assert!(solution.iter().all(|value| value.is_finite()) && largest > 0.01, "{largest}");
    }
}

#[test]
fn constraints_are_met_by_changing_the_right_side_where_they_act() {
    let real = |unit: c64| unit.re;
    assert_meets_constraints(&Mesh::grid(20, 20, 0.5, 1.0).heat(), real);
    assert_meets_constraints(&hermitian(21, 0.7), |unit| unit);
}

/// With weights, values and a right side that are made of complex numbers of absolute value 1.
fn assert_meets_constraints<T: Scalar>(matrix: &SymmetricMatrix<T>, number: impl Fn(c64) -> T) {
    let numbers = |count, step| -> Vec<T> { unit_numbers(count, step).into_iter().map(&number).collect() };
    let weights = numbers(4, 0.5);
    let functionals: Vec<Functional<T>> =
        vec![vec![(30, weights[0])], vec![(100, weights[1]), (101, weights[2])], vec![(250, weights[3])]];
    let wanted = numbers(3, 1.1);
    for (system, bound) in both_systems(matrix) {
        let right = numbers(system.size(), 1.7);
        let columns = system.schur_columns(&functionals).expect("converges");
        let mut partial = system.partial_solve(&right).expect("converges");
        let missing: Vec<T> = wanted.iter().zip(&columns).map(|(&value, e)| value - partial.evaluate(e)).collect();
        let multipliers = SchurComplement::new(&columns, 0.0).solve(&missing);
        for (&multiplier, column) in multipliers.iter().zip(&columns) {
            partial.add(multiplier, column);
        }
        let solution = partial.finish();
        for (functional, value) in functionals.iter().zip(&wanted) {
            assert!((evaluate(functional, &solution) - *value).magnitude() < bound);
        }
        let mut changed = right;
        for (&(unknown, weight), &multiplier) in
            functionals.iter().zip(&multipliers).flat_map(|(e, m)| e.iter().map(move |term| (term, m)))
        {
            changed[unknown as usize] += multiplier * weight;
        }
        let direct = system.solve(&changed).expect("converges");
        assert_eq!([solution.len(), direct.len()], [matrix.size(); 2]);
        assert!(solution.iter().zip(&direct).all(|(&a, &b)| (a - b).magnitude() < bound));
    }
}

#[test]
fn any_order_becomes_one_that_can_be_factored() {
    let matrix = Mesh::grid(12, 9, 0.0, 1.0).poisson();
    let size = matrix.size() as u32;
    // Steps of a number without a common divisor visit every row.
    let order: Vec<u32> = (0..size).map(|place| place * 37 % size).collect();
    let permutation = Permutation::new(matrix.pattern(), order).expect("every row once");
    let symbolic = Arc::new(Symbolic::analyse(matrix.pattern(), permutation).expect("memory"));
    let [factor] = symbolic.factor([&matrix], &mut go_on).expect("positive definite");
    let right = right_side(matrix.size());
    assert_solves(&matrix, &factor.solve(&right), &right);
}

#[test]
fn rejects_what_does_not_fit() {
    let matrix = Mesh::grid(5, 5, 0.0, 1.0).poisson();
    let pattern = matrix.pattern();
    let other = Mesh::grid(6, 5, 0.0, 1.0).poisson();
    let code = |error: Error| error.code();
    let permutation = Permutation::fill_reducing(other.pattern()).expect("memory");
    assert_eq!(Symbolic::analyse(pattern, permutation).map_err(code).unwrap_err(), "permutation-mismatch");
    // The identity is a postorder of a path, but not of two pairs of rows that interleave.
    let path = Pattern::new(vec![0, 2, 4, 6, 7], vec![0, 1, 1, 2, 2, 3, 3]).expect("a pattern");
    let pairs = Arc::new(Pattern::new(vec![0, 2, 4, 5, 6], vec![0, 2, 1, 3, 2, 3]).expect("a pattern"));
    let permutation = Permutation::new(&path, vec![0, 1, 2, 3]).expect("an order");
    assert_eq!(Symbolic::analyse(&pairs, permutation).map_err(code).unwrap_err(), "permutation-mismatch");
    let path = Pattern::new(vec![0, 2, 4, 5], vec![0, 1, 1, 2, 2]).expect("a pattern");
    for (order, place) in [(vec![0, 1, 1], 2), (vec![0, 3, 1], 1), (vec![0, 1], 2), (vec![0, 1, 2, 0], 3)] {
        let error = Permutation::new(&path, order).unwrap_err();
        assert_eq!(error, Error::InvalidPermutation { place, size: 3 });
    }
    let symbolic = analysed(pattern);
    let error = symbolic.factor([&matrix, &other], &mut go_on).map(|_| ()).unwrap_err();
    assert_eq!(error, Error::PatternMismatch { matrix: 1 });
    let mut values = matrix.values().to_vec();
    values[pattern.column(7).start] = -1.0;
    let indefinite = SymmetricMatrix::new(Arc::clone(pattern), values).expect("values of the pattern");
    let error = symbolic.factor([&matrix, &indefinite], &mut go_on).map(|_| ()).unwrap_err();
    assert!(matches!(error, Error::NotPositiveDefinite { matrix: 1, .. }), "{error}");
    let large = Mesh::icosphere(4).poisson();
    let stop = &mut |_, _| ControlFlow::Break(());
    assert_eq!(analysed(large.pattern()).factor([&large], stop).map(|_| ()).unwrap_err(), Error::Cancelled);
    let error = SymmetricMatrix::new(Arc::clone(pattern), vec![1.0]).unwrap_err();
    assert_eq!(error, Error::ValueCount { values: 1, nonzeros: pattern.nonzeros() });
}

#[test]
fn rejects_invalid_patterns() {
    let code = |column_start: &[u32], rows: &[u32]| {
        Pattern::new(column_start.to_vec(), rows.to_vec()).map(|_| "valid").unwrap_or_else(|error| error.code())
    };
    assert_eq!(code(&[0, 2, 3], &[0, 1, 1]), "valid");
    for column_start in [&[][..], &[1, 2, 3], &[0, 2, 2], &[0, 3, 2], &[0, 2, 4]] {
        assert_ne!(code(column_start, &[0, 1, 1]), "valid", "{column_start:?}");
    }
    assert_eq!(code(&[0, 2, 3], &[0, 1, 0]), "missing-diagonal");
    assert_eq!(code(&[0, 2, 2], &[0, 1]), "missing-diagonal");
    assert_eq!(code(&[0, 2, 3], &[0, 2, 1]), "invalid-row");
    assert_eq!(code(&[0, 3, 4], &[0, 1, 1, 1]), "invalid-row");
}

#[test]
fn hermitian_matrices_are_solved() {
    let matrices = [hermitian(30, 0.7), hermitian(30, 1.9)];
    let symbolic = analysed(matrices[0].pattern());
    let has_transposed = |index| !symbolic.entries(index)[1].is_empty();
    assert!((0..symbolic.supernode_count()).any(has_transposed), "else the test shows nothing of conjugates");
    let both = symbolic.factor(matrices.each_ref(), &mut go_on).expect("positive definite");
    for (matrix, both) in matrices.iter().zip(both) {
        let [alone] = symbolic.factor([matrix], &mut go_on).expect("positive definite");
        let right = unit_numbers(matrix.size(), 1.7);
        for factor in [both, alone] {
            assert_solves(matrix, &factor.solve(&right), &right);
        }
    }
}
