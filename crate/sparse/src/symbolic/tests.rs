//! What is told of a factorisation before it is made.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::collections::BTreeMap;

use super::*;
use crate::matrix::SymmetricMatrix;
use crate::progress::go_on;
use crate::samples::{Mesh, assemble};
use crate::system::System;

fn analysed(matrix: &SymmetricMatrix) -> Arc<Symbolic> {
    let permutation = Permutation::fill_reducing(matrix.pattern()).expect("memory");
    Arc::new(Symbolic::analyse(matrix.pattern(), permutation).expect("memory"))
}

/// A matrix without zeros: one supernode.
fn full(size: u32) -> SymmetricMatrix {
    let entry = |column: u32, row: u32| if row == column { f64::from(size) } else { -0.5 };
    let places = (0..size).flat_map(|column| (column..size).map(move |row| [column, row]));
    assemble(size as usize, &places.map(|[c, r]| ([c, r], entry(c, r))).collect::<BTreeMap<_, _>>())
}

#[test]
fn a_full_matrix_is_one_supernode() {
    let symbolic = analysed(&full(5));
    assert_eq!(symbolic.supernode_count(), 1);
    assert_eq!(symbolic.factor_nonzeros(), 25);
    assert_eq!(symbolic.factor_work(), 125.0);
    // Every constraint goes through all of it.
    let expected = |count: f64| count * (SPARSE_PENALTY * 25.0 + 0.5 * count * 5.0 + count * count / 6.0);
    for count in [1, 4] {
        assert_eq!(symbolic.constraint_work(count), expected(count as f64));
    }
    // Nothing waits; the supernode itself is all there is.
    assert_eq!(symbolic.memory::<f64>(2), FactorMemory { factor: 25 * 8, factorization: 2 * 25 * 8 });
}

#[test]
fn the_work_of_constraints_counts_the_rows_that_they_reach() {
    let matrix = Mesh::grid(3, 3, 0.5, 1.0).heat();
    let symbolic = analysed(&matrix);
    assert!(matrix.size() <= CONSTRAINT_SAMPLES, "every row is a sample");
    let [factor] = symbolic.factor([&matrix], &mut go_on).expect("positive definite");
    let functionals: Vec<_> = (0..matrix.size() as u32).map(|row| vec![(row, 1.0)]).collect();
    let columns = System::cholesky(factor).schur_columns(&functionals).expect("memory");
    let reached: usize = columns.iter().map(|column| column.nonzeros()).sum();
    // The part of the work that is quadratic in their number.
    let rows = symbolic.constraint_work(2) - 2.0 * symbolic.constraint_work(1) - 1.0;
    assert!((rows - reached as f64 / matrix.size() as f64).abs() < 1e-9, "{rows}");
}

#[test]
fn what_waits_is_counted_for_each_matrix() {
    let symbolic = analysed(&Mesh::icosphere(3).poisson());
    let widest = (0..symbolic.supernode_count()).map(|index| symbolic.supernode(index).values.len()).max().unwrap();
    let [one, two] = [1, 2].map(|matrices| symbolic.memory::<f64>(matrices));
    assert_eq!(one.factor, 8 * symbolic.factor_nonzeros() as u64);
    assert_eq!(two.factor, one.factor);
    assert_eq!(two.factorization, 2 * one.factorization);
    assert_eq!(one.factorization, 8 * (symbolic.stack_length() + widest) as u64);
    // Two halves meet at a separator: what one has left over waits while the other is eliminated.
    assert!(symbolic.stack_length() > widest / 4, "{} {widest}", symbolic.stack_length());
}
