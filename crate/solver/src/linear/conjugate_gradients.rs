//! Conjugate gradients with the diagonal as preconditioner: nothing to prepare, much to do at every solve.
//!
//! Hestenes and Stiefel (1952). It stops at a residual relative to the right side, so all that is smaller than that
//! share of the largest value is noise: heat far from its sources is lost, which a factorisation keeps.

use std::sync::Arc;

use crate::error::{Error, Result};
use crate::linear::Pattern;
use crate::linear::dot;

/// The residual at which it stops, as a share of the right side.
const TOLERANCE: f64 = 1e-12;

/// A symmetric positive definite matrix, to be solved iteratively.
#[derive(Debug)]
pub(crate) struct Matrix {
    pattern: Arc<Pattern>,
    values: Vec<f64>,
}

impl Matrix {
    pub(crate) fn new(pattern: Arc<Pattern>, values: Vec<f64>) -> Self {
        Self { pattern, values }
    }

    /// Number of rows.
    pub(crate) fn size(&self) -> usize {
        self.pattern.size()
    }

    /// The solution for one right side.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub(crate) fn solve(&self, right: &[f64]) -> Result<Vec<f64>> {
        let size = right.len();
        // Heat comes near the largest float, whose square would overflow.
        let scale = right.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        if scale == 0.0 {
            return Ok(vec![0.0; size]);
        }
        let inverse: Vec<f64> = (0..size).map(|row| 1.0 / self.values[self.pattern.column(row).start]).collect();
        let mut residual: Vec<f64> = right.iter().map(|value| value / scale).collect();
        let goal = TOLERANCE * TOLERANCE * dot(&residual, &residual);
        let mut solution = vec![0.0; size];
        let mut direction: Vec<f64> = residual.iter().zip(&inverse).map(|(value, inverse)| value * inverse).collect();
        let mut energy = dot(&residual, &direction);
        let mut image = vec![0.0; size];
        // In exact arithmetic as many steps as unknowns are enough; rounding may take a few times more.
        let most = 10 * size + 100;
        for _ in 0..most {
            if dot(&residual, &residual) <= goal {
                return Ok(solution.into_iter().map(|value| value * scale).collect());
            }
            image.fill(0.0);
            self.pattern.multiply_add(&self.values, &direction, &mut image);
            let step = energy / dot(&direction, &image);
            if !step.is_finite() {
                break;
            }
            for row in 0..size {
                solution[row] += step * direction[row];
                residual[row] -= step * image[row];
            }
            let next = (0..size).map(|row| residual[row] * inverse[row] * residual[row]).sum::<f64>();
            let share = next / energy;
            energy = next;
            for row in 0..size {
                direction[row] = residual[row] * inverse[row] + share * direction[row];
            }
        }
        Err(Error::NotConverged { iterations: most })
    }
}
