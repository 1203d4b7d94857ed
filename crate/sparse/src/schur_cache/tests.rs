//! Kept columns are those that would be computed anew, and are dropped when they are too many.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::*;
use crate::samples::{Mesh, both_systems, hermitian};
use faer::c64;

fn points(vertices: &[u32]) -> Vec<Functional> {
    vertices.iter().map(|&vertex| vec![(vertex, 0.75), (vertex + 1, 0.25)]).collect()
}

#[test]
fn complex_constraints_are_told_apart() {
    let [(system, _), _] = both_systems(&hermitian(20, 0.7));
    let mut cache = SchurCache::default();
    let mut column =
        |weight: c64| cache.columns(&system, &[vec![(30, weight)]], usize::MAX).expect("a factor").remove(0);
    let first = column(c64::new(0.6, 0.8));
    assert!(Arc::ptr_eq(&first, &column(c64::new(0.6, 0.8))));
    assert!(!Arc::ptr_eq(&first, &column(c64::new(0.6, -0.8))));
}

#[test]
fn kept_columns_are_those_computed_anew() {
    for (system, bound) in both_systems(&Mesh::grid(20, 20, 0.5, 1.0).heat()) {
        let mut cache = SchurCache::default();
        let first = cache.columns(&system, &points(&[30, 100]), usize::MAX).expect("converges");
        let wanted = points(&[100, 250, 30]);
        let columns = cache.columns(&system, &wanted, usize::MAX).expect("converges");
        assert!(Arc::ptr_eq(&first[0], &columns[2]) && Arc::ptr_eq(&first[1], &columns[0]));
        let anew = system.schur_columns(&wanted).expect("converges");
        for (kept, new) in columns.iter().zip(&anew) {
            assert!((kept.inner_product(&columns[1]) - new.inner_product(&anew[1])).abs() < bound);
        }
        // A different weight is a different constraint.
        let other = cache.columns(&system, &[vec![(30, 0.5), (31, 0.5)]], usize::MAX).expect("converges");
        assert!(!Arc::ptr_eq(&other[0], &first[0]));
    }
}

#[test]
fn columns_not_asked_for_are_dropped_when_there_are_too_many() {
    for (system, _) in both_systems(&Mesh::grid(20, 20, 0.5, 1.0).heat()) {
        let mut cache = SchurCache::default();
        let two = cache.columns(&system, &points(&[30, 100]), usize::MAX).expect("converges");
        let numbers = two.iter().map(|column| column.nonzeros()).sum();
        cache.columns(&system, &points(&[30]), numbers).expect("converges");
        assert_eq!(cache.columns.len(), 2, "as many as there may be");
        cache.columns(&system, &points(&[30]), numbers - 1).expect("converges");
        assert_eq!(cache.columns.len(), 1, "one too many");
        let again = cache.columns(&system, &points(&[30]), 0).expect("converges");
        assert!(Arc::ptr_eq(&again[0], &two[0]));
    }
}
