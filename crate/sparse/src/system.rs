//! Linear systems with a few linear constraints, without factoring again: bordered (Schur complement) solves.

use std::fmt;
use std::sync::Arc;

use crate::conjugate_gradients::ConjugateGradients;
use crate::error::Result;
use crate::factor::Factor;
use crate::scalar::Entry;
use crate::schur::{Functional, Kind, SchurColumn, evaluate};

#[cfg(test)]
mod tests;

/// A symmetric positive definite matrix that can be solved.
#[derive(Debug)]
pub enum System {
    /// By its Cholesky factor.
    Cholesky(Box<dyn Substitute>),
    /// By conjugate gradients.
    ConjugateGradients(ConjugateGradients),
}

/// A Cholesky factor, whatever its entries are kept as. What no program makes is not in it.
pub trait Substitute: Send + Sync {
    /// Number of rows.
    fn size(&self) -> usize;

    /// Number of nonzeros, zeros inside supernodes counted.
    fn nonzeros(&self) -> usize;

    /// The solution for a right side that is zero but at a few rows, given as `(row, value)`.
    fn solve_sparse(&self, right: &[(u32, f64)]) -> Vec<f64>;

    /// `C⁻¹ right`, in the elimination order.
    fn forward(&self, right: &[f64]) -> Vec<f64>;

    /// `C⁻ᴴ x` for a vector in the elimination order; the result is in the order of the matrix.
    fn backward(&self, x: Vec<f64>) -> Vec<f64>;

    /// The Schur columns of constraints.
    fn columns(&self, functionals: &[Functional]) -> Vec<Arc<SchurColumn>>;
}

/// Not its nonzeros, which are millions.
impl fmt::Debug for dyn Substitute {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let mut factor = formatter.debug_struct("Factor");
        factor.field("size", &self.size()).field("nonzeros", &self.nonzeros()).finish_non_exhaustive()
    }
}

impl<E: Entry<f64>> Substitute for Factor<f64, E> {
    fn size(&self) -> usize {
        self.size()
    }

    fn nonzeros(&self) -> usize {
        self.nonzeros()
    }

    fn solve_sparse(&self, right: &[(u32, f64)]) -> Vec<f64> {
        self.solve_sparse(right)
    }

    fn forward(&self, right: &[f64]) -> Vec<f64> {
        self.forward(right)
    }

    fn backward(&self, x: Vec<f64>) -> Vec<f64> {
        self.backward(x)
    }

    fn columns(&self, functionals: &[Functional]) -> Vec<Arc<SchurColumn>> {
        let rights: Vec<&[(u32, f64)]> = functionals.iter().map(Vec::as_slice).collect();
        let vectors = self.forward_sparse_all(&rights);
        vectors.into_iter().map(|vector| Arc::new(SchurColumn(Kind::Forward(vector)))).collect()
    }
}

/// A solve whose right side can still be changed by constraints.
#[derive(Debug)]
pub struct PartialSolve<'a> {
    system: &'a System,
    /// `C⁻¹ right` in the elimination order of a factor, or the solution.
    vector: Vec<f64>,
}

impl System {
    /// By a Cholesky factor.
    pub fn cholesky<E: Entry<f64>>(factor: Factor<f64, E>) -> Self {
        Self::Cholesky(Box::new(factor))
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        match self {
            Self::Cholesky(factor) => factor.size(),
            Self::ConjugateGradients(matrix) => matrix.size(),
        }
    }

    /// Nonzeros of the factor, zeros inside supernodes counted; 0 for an iterative solver.
    pub fn factor_nonzeros(&self) -> usize {
        match self {
            Self::Cholesky(factor) => factor.nonzeros(),
            Self::ConjugateGradients(_) => 0,
        }
    }

    /// The solution (`#rows`) for one right side (`#rows`).
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn solve(&self, right: &[f64]) -> Result<Vec<f64>> {
        match self {
            Self::Cholesky(factor) => Ok(factor.backward(factor.forward(right))),
            Self::ConjugateGradients(matrix) => matrix.solve(right),
        }
    }

    /// The solution for a right side that is zero but at a few rows, given as `(row, value)`.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn solve_sparse(&self, right: &Functional) -> Result<Vec<f64>> {
        match self {
            Self::Cholesky(factor) => Ok(factor.solve_sparse(right)),
            Self::ConjugateGradients(matrix) => matrix.solve(&dense(matrix.size(), right)),
        }
    }

    /// The Schur columns of constraints.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn schur_columns(&self, functionals: &[Functional]) -> Result<Vec<Arc<SchurColumn>>> {
        match self {
            Self::Cholesky(factor) => Ok(factor.columns(functionals)),
            Self::ConjugateGradients(matrix) => {
                let solve = |functional: &Functional| {
                    let solution = matrix.solve(&dense(matrix.size(), functional))?;
                    Ok(Arc::new(SchurColumn(Kind::Solution { functional: functional.clone(), solution })))
                };
                functionals.iter().map(solve).collect()
            }
        }
    }

    /// Begins a solve.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn partial_solve(&self, right: &[f64]) -> Result<PartialSolve<'_>> {
        let vector = match self {
            Self::Cholesky(factor) => factor.forward(right),
            Self::ConjugateGradients(matrix) => matrix.solve(right)?,
        };
        Ok(PartialSolve { system: self, vector })
    }
}

impl PartialSolve<'_> {
    /// `eᵀ x` of the solution `x` so far.
    pub fn evaluate(&self, column: &SchurColumn) -> f64 {
        match &column.0 {
            Kind::Forward(vector) => vector.dot_dense(&self.vector),
            Kind::Solution { functional, .. } => evaluate(functional, &self.vector),
        }
    }

    /// Adds `multiplier · e` to the right side.
    pub fn add(&mut self, multiplier: f64, column: &SchurColumn) {
        match &column.0 {
            Kind::Forward(vector) => vector.add_to(multiplier, &mut self.vector),
            Kind::Solution { solution, .. } => {
                for (target, value) in self.vector.iter_mut().zip(solution) {
                    *target += multiplier * value;
                }
            }
        }
    }

    /// The solution (`#rows`).
    pub fn finish(self) -> Vec<f64> {
        match self.system {
            System::Cholesky(factor) => factor.backward(self.vector),
            System::ConjugateGradients(_) => self.vector,
        }
    }
}

/// A functional as a vector.
fn dense(size: usize, functional: &Functional) -> Vec<f64> {
    let mut vector = vec![0.0; size];
    for &(unknown, weight) in functional {
        vector[unknown as usize] += weight;
    }
    vector
}
