//! Algebraic multigrid as preconditioner: an approximate inverse in time and memory proportional to the unknowns.
//!
//! Notay, "An aggregation-based algebraic multigrid method" (2010): the K-cycle of section 3, with a Gauss-Seidel sweep
//! up and one down. What neighbours share is solved on a coarser grid, each of whose unknowns stands for some five of
//! the finer, and there in the same way, until no rows are coupled.

mod aggregation;
#[cfg(test)]
mod tests;

use crate::matrix::SymmetricMatrix;
use crate::pattern::NONE;
use crate::scalar::{Scalar, Turn, dot};
use aggregation::{Coarse, coarsen};

/// Least share of the second of two directions that is not along the first. Rounding of the sums before is some 1e-15.
const DEPENDENT: f64 = 1e-11;

/// A positive definite matrix, symmetric or Hermitian, with its coarser grids.
#[derive(Debug)]
pub(crate) struct Multigrid<T: Scalar> {
    /// The matrix itself first.
    grids: Vec<Grid<T>>,
}

#[derive(Debug)]
struct Grid<T: Scalar> {
    matrix: SymmetricMatrix<T>,
    /// Of the diagonal entries: each row waits for the one before, and a division would be most of that.
    inverse: Vec<f64>,
    /// Row of the next grid that each row is part of; [`NONE`] where it is in none, empty on the last grid.
    aggregates: Vec<u32>,
    /// From the value of that row to the value of each.
    turns: Vec<T::Turn>,
}

/// Memory for the cycle on one grid: vectors of its size, of which the finest grid needs the first only.
#[derive(Debug)]
pub(crate) struct Scratch<T> {
    rest: Vec<T>,
    right: Vec<T>,
    solution: Vec<T>,
    image: Vec<T>,
    second: Vec<T>,
}

impl<T: Scalar> Multigrid<T> {
    /// Makes the coarser grids, which have about a third of the matrix's entries together.
    pub(crate) fn new(matrix: SymmetricMatrix<T>) -> Self {
        let mut grids = vec![Grid::new(matrix)];
        loop {
            let last = grids.last_mut().expect("there is always one");
            let Coarse { aggregates, turns, matrix } = coarsen(&last.matrix);
            if matrix.size() == 0 {
                return Self { grids };
            }
            (last.aggregates, last.turns) = (aggregates, turns);
            grids.push(Grid::new(matrix));
        }
    }

    /// Number of rows.
    pub(crate) fn size(&self) -> usize {
        self.grids[0].matrix.size()
    }

    /// `result = A vector`.
    pub(crate) fn multiply(&self, vector: &[T], result: &mut [T]) {
        self.grids[0].multiply(vector, result);
    }

    /// Memory for [`Multigrid::precondition`].
    pub(crate) fn scratch(&self) -> Vec<Scratch<T>> {
        let of_grid = |(index, grid): (usize, &Grid<T>)| {
            let size = grid.matrix.size();
            let coarse = || vec![T::ZERO; if index > 0 { size } else { 0 }];
            Scratch {
                rest: vec![T::ZERO; size],
                right: coarse(),
                solution: coarse(),
                image: coarse(),
                second: coarse(),
            }
        };
        self.grids.iter().enumerate().map(of_grid).collect()
    }

    /// Writes an approximation of `A⁻¹ right` to `solution`. It is not linear in `right`.
    pub(crate) fn precondition(&self, right: &[T], solution: &mut [T], scratch: &mut [Scratch<T>]) {
        cycle(&self.grids, right, solution, scratch);
    }
}

/// Smooths, corrects by the next grid, smooths again.
fn cycle<T: Scalar>(grids: &[Grid<T>], right: &[T], solution: &mut [T], scratch: &mut [Scratch<T>]) {
    let [grid, coarser @ ..] = grids else { return };
    let [Scratch { rest, .. }, scratch @ ..] = scratch else { return };
    grid.smooth_up(right, solution, rest);
    if !coarser.is_empty() {
        scratch[0].right.fill(T::ZERO);
        for ((&aggregate, turn), &rest) in grid.aggregates.iter().zip(&grid.turns).zip(&*rest) {
            if aggregate != NONE {
                scratch[0].right[aggregate as usize] += turn.revert(rest);
            }
        }
        correct(coarser, scratch);
        for ((&aggregate, turn), value) in grid.aggregates.iter().zip(&grid.turns).zip(&mut *solution) {
            if aggregate != NONE {
                *value += turn.apply(scratch[0].solution[aggregate as usize]);
            }
        }
    }
    grid.smooth_down(right, solution, rest);
}

/// Solves roughly for the right side of the first of these grids, by two steps of conjugate gradients. Notay leaves the
/// second out where the first did well; then the preconditioner is another one from step to step, and on obtuse
/// triangles the steps outside become several times as many.
fn correct<T: Scalar>(grids: &[Grid<T>], scratch: &mut [Scratch<T>]) {
    visit(grids, scratch, |scratch| &mut scratch.solution);
    let Scratch { right, solution, image, .. } = &mut scratch[0];
    grids[0].multiply(solution, image);
    let energy = dot(solution, image).real();
    if energy <= 0.0 {
        return;
    }
    let mut step = dot(solution, right).divide(energy);
    for (right, &image) in right.iter_mut().zip(&*image) {
        *right -= step * image;
    }
    visit(grids, scratch, |scratch| &mut scratch.second);
    let Scratch { rest, right, solution, image, second } = &mut scratch[0];
    grids[0].multiply(second, rest);
    let (shared, whole) = (dot(second, image), dot(second, rest).real());
    let own = whole - shared.abs2() / energy;
    let mut second_step = T::ZERO;
    if own > DEPENDENT * whole {
        second_step = dot(second, right).divide(own);
        step -= shared.conj().divide(energy) * second_step;
    }
    for (value, &second) in solution.iter_mut().zip(&*second) {
        *value = step * *value + second_step * second;
    }
}

/// A cycle for the right side of the first of these grids, its solution written where `target` says.
fn visit<T: Scalar>(grids: &[Grid<T>], scratch: &mut [Scratch<T>], target: impl Fn(&mut Scratch<T>) -> &mut Vec<T>) {
    let right = std::mem::take(&mut scratch[0].right);
    let mut solution = std::mem::take(target(&mut scratch[0]));
    cycle(grids, &right, &mut solution, scratch);
    scratch[0].right = right;
    *target(&mut scratch[0]) = solution;
}

impl<T: Scalar> Grid<T> {
    fn new(matrix: SymmetricMatrix<T>) -> Self {
        let diagonal = (0..matrix.size()).map(|row| matrix[matrix.pattern().column(row).start].real());
        let inverse = diagonal.map(|value| 1.0 / value).collect();
        Self { matrix, inverse, aggregates: Vec::new(), turns: Vec::new() }
    }

    /// The entries of a column below its diagonal, as `(row, value)`.
    #[inline(always)]
    fn below(&self, column: usize) -> impl Iterator<Item = (usize, T)> {
        let std::ops::Range { start, end } = self.matrix.pattern().column(column);
        let rows = self.matrix.pattern().rows()[start + 1..end].iter();
        rows.zip(&self.matrix.values()[start + 1..end]).map(|(&row, &value)| (row as usize, value))
    }

    /// `result = A vector`.
    fn multiply(&self, vector: &[T], result: &mut [T]) {
        result.fill(T::ZERO);
        self.matrix.multiply_add(vector, result);
    }

    /// A Gauss-Seidel sweep from zero, in ascending order; leaves the residual in `rest`.
    fn smooth_up(&self, right: &[T], solution: &mut [T], rest: &mut [T]) {
        rest.copy_from_slice(right);
        for column in 0..right.len() {
            let value = rest[column].scale(self.inverse[column]);
            solution[column] = value;
            for (row, entry) in self.below(column) {
                rest[row] -= entry * value;
            }
        }
        // Each row was solved with zeros for the rows after it; what they became is its residual.
        for column in 0..right.len() {
            rest[column] = -self.below(column).map(|(row, entry)| entry.conj() * solution[row]).sum::<T>();
        }
    }

    /// A Gauss-Seidel sweep in descending order. `rest` is memory for it.
    fn smooth_down(&self, right: &[T], solution: &mut [T], rest: &mut [T]) {
        rest.copy_from_slice(right);
        for column in 0..right.len() {
            let value = solution[column];
            for (row, entry) in self.below(column) {
                rest[row] -= entry * value;
            }
        }
        for column in (0..right.len()).rev() {
            let later: T = self.below(column).map(|(row, entry)| entry.conj() * solution[row]).sum();
            solution[column] = (rest[column] - later).scale(self.inverse[column]);
        }
    }
}
