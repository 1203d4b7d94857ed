//! Solutions against Cholesky factors, steps that do not grow with the mesh, and aggregates of awkward matrices.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use glam::DVec3;

use super::aggregation::{Coarse, coarsen};
use super::*;
use crate::symbolic::Symbolic;
use crate::conjugate_gradients::Matrix;
use crate::constraints::System;
use crate::operator::Operator;
use crate::operator::laplacian::Laplacian;
use crate::shapes;
use crate::soup::Soup;
use crate::surface::Surface;

/// The grounded Poisson matrix of a soup, and its heat matrix for t = h² with the boundary held.
fn matrices(soup: &Soup, operator: Operator) -> (Arc<Pattern>, [Vec<f64>; 2]) {
    let surface = Surface::build(soup).expect("a surface");
    let laplacian = Laplacian::new(&surface, operator);
    let first_of = |component| surface.component_of_point.iter().position(|&other| other == component);
    let poisson = laplacian.combine(0.0, |point| first_of(surface.component_of_point[point]) == Some(point));
    let heat = laplacian.combine(surface.mean_edge.powi(-2), |point| surface.is_boundary_point[point]);
    (laplacian.pattern, [poisson, heat])
}

/// Values between −1 and 1 that repeat late.
fn right(size: usize) -> Vec<f64> {
    (0..size).map(|row| (row as f64 * 1.7).sin()).collect()
}

/// Solves by both solvers, asserts that they differ by at most this share of the largest value, and returns the steps.
fn steps_and_agreement(pattern: &Arc<Pattern>, values: &[f64], bound: f64) -> usize {
    let right = right(pattern.size());
    let (solution, steps) =
        Matrix::new(Arc::clone(pattern), values.to_vec()).solve_counting(&right).expect("converges");
    let permutation = Symbolic::order(pattern).expect("memory");
    let symbolic = Arc::new(Symbolic::analyse(permutation, pattern).expect("memory"));
    let [factor] = symbolic.factor([(values, "test")], &mut |_| Ok(())).expect("positive definite");
    let direct = System::Cholesky(factor).solve(&right).expect("a solution");
    let largest = direct.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let difference = solution.iter().zip(&direct).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(difference <= bound * largest, "{difference} of {largest} after {steps} steps");
    steps
}

/// Two pieces, one of them with a boundary; `shear` makes the triangles of the latter obtuse.
fn two_pieces(shear: f64) -> Soup {
    let (mut soup, sphere) = (shapes::grid(30, 20), shapes::icosphere(2));
    for position in &mut soup.positions {
        position.x += shear * position.z;
    }
    let first = soup.positions.len() as u32;
    let positions = soup.positions.iter().copied().chain(sphere.positions.iter().map(|at| *at + DVec3::splat(90.0)));
    let moved = sphere.triangles.iter().map(|triangle| triangle.map(|corner| corner + first));
    Soup::single("two", positions.collect(), soup.triangles.iter().copied().chain(moved).collect())
}

#[test]
fn solutions_are_those_of_factors() {
    for (shear, operator) in [(0.0, Operator::Plain), (3.0, Operator::Plain), (3.0, Operator::Delaunay)] {
        let (pattern, matrices) = matrices(&two_pieces(shear), operator);
        // Cotangents of right angles are rounding. The diagonal is positive anyway.
        let positive = matrices[0].iter().filter(|value| **value > 1e-9).count();
        assert_eq!(positive > pattern.size(), shear > 0.0 && operator == Operator::Plain);
        for values in &matrices {
            // A residual of 10⁻¹², by condition numbers of some 10⁴.
            steps_and_agreement(&pattern, values, 1e-8);
        }
    }
}

#[test]
fn steps_do_not_grow_with_the_mesh() {
    let steps = |subdivisions| {
        let (pattern, matrices) = matrices(&shapes::icosphere(subdivisions), Operator::Delaunay);
        matrices.map(|values| steps_and_agreement(&pattern, &values, 1e-8))
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
fn uneven_couplings_are_solved() {
    // A grid whose couplings jump between 10⁻² and 10² from edge to edge, worse than those of slivers.
    let side = 40;
    let mut seed = 1_u64;
    let mut weight = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        10.0_f64.powi((seed >> 33) as i32 % 5 - 2)
    };
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
    let (pattern, values) = Pattern::of_sides(&diagonal, &start, &mut sides);
    let pattern = Arc::new(pattern);
    let multigrid = Multigrid::new(Arc::clone(&pattern), values.clone());
    let is_halved = |grids: &[Grid]| 2 * grids[1].pattern.size() <= grids[0].pattern.size();
    assert!(multigrid.grids.windows(2).all(is_halved));
    // Condition numbers of some 10⁷.
    let steps = steps_and_agreement(&pattern, &values, 1e-5);
    // The bound of conjugate gradients without rounding, which the diagonal as preconditioner reaches.
    assert!(steps < side * side / 2, "{steps}");
}

#[test]
fn the_smallest_systems_are_solved() {
    let triangle = Soup::single("one", vec![DVec3::ZERO, DVec3::X, DVec3::Y], vec![[0, 1, 2]]);
    let (pattern, matrices) = matrices(&triangle, Operator::Delaunay);
    for values in &matrices {
        // Rounding.
        steps_and_agreement(&pattern, values, 1e-12);
    }
    let unit = Matrix::new(Arc::new(Pattern { column_start: vec![0, 1], rows: vec![0] }), vec![2.0]);
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
    let (pattern, values) = Pattern::of_sides(&diagonal, &start, &mut sides);
    let Coarse { aggregates, pattern, values } = coarsen(&pattern, &values);
    // The second pairing finds one row that nothing is coupled to, and leaves it to smoothing.
    assert_eq!((pattern.size(), values.len()), (0, 0));
    assert!(aggregates.iter().all(|&aggregate| aggregate == NONE));
}

#[test]
fn held_and_dominant_rows_are_in_no_aggregate() {
    // A chain 0–1–2–3, row 4 held, and a row 5 whose diagonal outweighs its coupling to 3.
    let mut sides = vec![(1, -1.0), (2, -1.0), (3, -1.0), (4, 0.0), (5, -1.0)];
    let (pattern, values) = Pattern::of_sides(&[1.5, 2.5, 2.5, 3.5, 1.0, 9.0], &[0, 1, 2, 3, 5, 5, 5], &mut sides);
    let Coarse { aggregates, pattern, values } = coarsen(&pattern, &values);
    assert_eq!(aggregates, [0, 0, 0, 0, NONE, NONE]);
    // 10 on the diagonals less six couplings.
    assert_eq!((pattern.size(), values), (1, vec![4.0]));
}

#[test]
fn positive_couplings_alone_make_no_aggregates() {
    // Left to pair with nothing, such rows would make the same grid for ever.
    let (pattern, values) = Pattern::of_sides(&[1.0, 1.0], &[0, 1, 1], &mut [(1, 0.5)]);
    let pattern = Arc::new(pattern);
    assert_eq!(Multigrid::new(Arc::clone(&pattern), values.clone()).grids.len(), 1);
    // Rounding.
    steps_and_agreement(&pattern, &values, 1e-12);
}
