//! Conjugate gradients with multigrid as preconditioner: little to prepare, little memory, tens of steps at every solve.
//!
//! Hestenes and Stiefel (1952); Notay, "Flexible conjugate gradients" (2000), because the preconditioner is not linear.
//! It stops at a residual relative to the right side, so all that is smaller than that share of the largest value is
//! noise: heat far from its sources is lost, which a factorisation keeps.

use crate::error::{Error, Result};
use crate::matrix::SymmetricMatrix;
use crate::multigrid::Multigrid;
use crate::scalar::{Scalar, dot};

/// The residual at which it stops, as a share of the right side.
const TOLERANCE: f64 = 1e-12;

/// Steps that it takes at most: tens are enough on any mesh but one that it will not solve at all.
const MOST_STEPS: usize = 2000;

/// A positive definite matrix, symmetric or Hermitian, to be solved by conjugate gradients.
#[derive(Debug)]
pub struct ConjugateGradients<T: Scalar = f64> {
    multigrid: Multigrid<T>,
}

impl<T: Scalar> ConjugateGradients<T> {
    /// A matrix with its coarser grids.
    pub fn new(matrix: SymmetricMatrix<T>) -> Self {
        Self { multigrid: Multigrid::new(matrix) }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.multigrid.size()
    }

    /// The solution for one right side.
    ///
    /// # Errors
    /// [`Error::NotConverged`]; [`Error::Breakdown`].
    pub fn solve(&self, right: &[T]) -> Result<Vec<T>> {
        self.solve_recording(right).map(|(solution, _)| solution)
    }

    /// The solution, and the residual as a share of the right side (both in the Euclidean norm) before the first step and
    /// after each. A right side of 0 takes no step and has the residual 0.
    ///
    /// # Errors
    /// [`Error::NotConverged`]; [`Error::Breakdown`].
    pub fn solve_recording(&self, right: &[T]) -> Result<(Vec<T>, Vec<f64>)> {
        let size = right.len();
        // Heat comes near the largest float, whose square would overflow.
        let scale = right.iter().fold(0.0_f64, |largest, value| largest.max(value.magnitude()));
        if scale == 0.0 {
            return Ok((vec![T::ZERO; size], vec![0.0]));
        }
        let mut residual: Vec<T> = right.iter().map(|value| value.divide(scale)).collect();
        let whole = dot(&residual, &residual).real().sqrt();
        let mut residuals = Vec::new();
        let mut scratch = self.multigrid.scratch();
        let mut solution = vec![T::ZERO; size];
        let mut guess = vec![T::ZERO; size];
        let mut direction = vec![T::ZERO; size];
        let mut image = vec![T::ZERO; size];
        // Of the last direction with its image; none at first.
        let mut curvature = f64::INFINITY;
        // In exact arithmetic as many steps as unknowns are enough; rounding may take a few times more.
        let most = (10 * size + 100).min(MOST_STEPS);
        for iterations in 0..most {
            let share = dot(&residual, &residual).real().sqrt() / whole;
            residuals.push(share);
            if share <= TOLERANCE {
                return Ok((solution.into_iter().map(|value| value.scale(scale)).collect(), residuals));
            }
            self.multigrid.precondition(&residual, &mut guess, &mut scratch);
            let share = dot(&image, &guess).divide(curvature);
            for (direction, &guess) in direction.iter_mut().zip(&guess) {
                *direction = guess - share * *direction;
            }
            self.multigrid.multiply(&direction, &mut image);
            curvature = dot(&direction, &image).real();
            let step = dot(&guess, &residual).divide(curvature);
            if !step.magnitude().is_finite() {
                return Err(Error::Breakdown { iterations });
            }
            for row in 0..size {
                solution[row] += step * direction[row];
                residual[row] -= step * image[row];
            }
        }
        Err(Error::NotConverged { iterations: most })
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    #[test]
    fn a_matrix_without_a_finite_step_is_a_breakdown_and_not_a_solution() {
        let solve = |diagonal: f64, right: f64| {
            let matrix = SymmetricMatrix::from_entries(&[diagonal; 2], &[0; 3], &mut []);
            ConjugateGradients::new(matrix).solve(&[1.0, right])
        };
        assert!(solve(2.0, 1.0).is_ok());
        for (diagonal, right) in [(0.0, 1.0), (f64::NAN, 1.0), (2.0, f64::NAN)] {
            let told = solve(diagonal, right);
            assert!(matches!(told, Err(Error::Breakdown { iterations: 0 })), "{diagonal}, {right}: {told:?}");
        }
    }
}
