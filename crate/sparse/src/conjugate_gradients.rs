//! Conjugate gradients with multigrid as preconditioner: little to prepare, little memory, tens of steps at every solve.
//!
//! Hestenes and Stiefel (1952); Notay, "Flexible conjugate gradients" (2000), because the preconditioner is not linear.
//! It stops at a residual relative to the right side, so all that is smaller than that share of the largest value is
//! noise: heat far from its sources is lost, which a factorisation keeps.

use crate::error::{Error, Result};
use crate::matrix::SymmetricMatrix;
use crate::multigrid::Multigrid;
use crate::simd::dot;

/// The residual at which it stops, as a share of the right side.
const TOLERANCE: f64 = 1e-12;

/// Steps that it takes at most: tens are enough on any mesh but one that it will not solve at all.
const MOST_STEPS: usize = 2000;

/// A symmetric positive definite matrix, to be solved by conjugate gradients.
#[derive(Debug)]
pub struct ConjugateGradients {
    multigrid: Multigrid,
}

impl ConjugateGradients {
    /// A matrix with its coarser grids.
    pub fn new(matrix: SymmetricMatrix) -> Self {
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
    pub fn solve(&self, right: &[f64]) -> Result<Vec<f64>> {
        self.solve_recording(right).map(|(solution, _)| solution)
    }

    /// The solution, and the residual as a share of the right side (both in the Euclidean norm) before the first step and
    /// after each. A right side of 0 takes no step and has the residual 0.
    ///
    /// # Errors
    /// [`Error::NotConverged`]; [`Error::Breakdown`].
    pub fn solve_recording(&self, right: &[f64]) -> Result<(Vec<f64>, Vec<f64>)> {
        let size = right.len();
        // Heat comes near the largest float, whose square would overflow.
        let scale = right.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        if scale == 0.0 {
            return Ok((vec![0.0; size], vec![0.0]));
        }
        let mut residual: Vec<f64> = right.iter().map(|value| value / scale).collect();
        let whole = dot(&residual, &residual).sqrt();
        let mut residuals = Vec::new();
        let mut scratch = self.multigrid.scratch();
        let mut solution = vec![0.0; size];
        let mut guess = vec![0.0; size];
        let mut direction = vec![0.0; size];
        let mut image = vec![0.0; size];
        // Of the last direction with its image; none at first.
        let mut curvature = f64::INFINITY;
        // In exact arithmetic as many steps as unknowns are enough; rounding may take a few times more.
        let most = (10 * size + 100).min(MOST_STEPS);
        for iterations in 0..most {
            let share = dot(&residual, &residual).sqrt() / whole;
            residuals.push(share);
            if share <= TOLERANCE {
                return Ok((solution.into_iter().map(|value| value * scale).collect(), residuals));
            }
            self.multigrid.precondition(&residual, &mut guess, &mut scratch);
            let share = dot(&guess, &image) / curvature;
            for (direction, guess) in direction.iter_mut().zip(&guess) {
                *direction = guess - share * *direction;
            }
            self.multigrid.multiply(&direction, &mut image);
            curvature = dot(&direction, &image);
            let step = dot(&guess, &residual) / curvature;
            if !step.is_finite() {
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
