//! Linear systems with a few linear constraints, without factoring again: bordered (Schur complement) solves.

use std::fmt;
use std::sync::Arc;

use crate::conjugate_gradients::ConjugateGradients;
use crate::error::Result;
use crate::factor::Factor;
use crate::scalar::{Entry, Scalar};
use crate::schur::{Functional, Kind, SchurColumn, evaluate};

#[cfg(test)]
mod tests;

/// A positive definite matrix that can be solved, symmetric or, of complex numbers, Hermitian.
#[derive(Debug)]
pub enum System<T: Scalar = f64> {
    /// By its Cholesky factor.
    Cholesky(Box<dyn Substitute<T>>),
    /// By conjugate gradients.
    ConjugateGradients(ConjugateGradients<T>),
}

/// A Cholesky factor, whatever its entries are kept as. What no program makes is not in it.
pub trait Substitute<T: Scalar = f64>: Send + Sync {
    /// Number of rows.
    fn size(&self) -> usize;

    /// Number of nonzeros, zeros inside supernodes counted.
    fn nonzeros(&self) -> usize;

    /// The solution for a right side that is zero but at a few rows, given as `(row, value)`.
    fn solve_sparse(&self, right: &[(u32, T)]) -> Vec<T>;

    /// `C⁻¹ right`, in the elimination order.
    fn forward(&self, right: &[T]) -> Vec<T>;

    /// `C⁻ᴴ x` for a vector in the elimination order; the result is in the order of the matrix.
    fn backward(&self, x: Vec<T>) -> Vec<T>;

    /// The Schur columns of constraints.
    fn columns(&self, functionals: &[Functional<T>]) -> Vec<Arc<SchurColumn<T>>>;
}

/// Not its nonzeros, which are millions.
impl<T: Scalar> fmt::Debug for dyn Substitute<T> {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let mut factor = formatter.debug_struct("Factor");
        factor.field("size", &self.size()).field("nonzeros", &self.nonzeros()).finish_non_exhaustive()
    }
}

impl<T: Scalar, E: Entry<T>> Substitute<T> for Factor<T, E> {
    fn size(&self) -> usize {
        self.size()
    }

    fn nonzeros(&self) -> usize {
        self.nonzeros()
    }

    fn solve_sparse(&self, right: &[(u32, T)]) -> Vec<T> {
        self.solve_sparse(right)
    }

    fn forward(&self, right: &[T]) -> Vec<T> {
        self.forward(right)
    }

    fn backward(&self, x: Vec<T>) -> Vec<T> {
        self.backward(x)
    }

    fn columns(&self, functionals: &[Functional<T>]) -> Vec<Arc<SchurColumn<T>>> {
        let rights: Vec<&[(u32, T)]> = functionals.iter().map(Vec::as_slice).collect();
        let vectors = self.forward_sparse_all(&rights);
        vectors.into_iter().map(|vector| Arc::new(SchurColumn(Kind::Forward(vector)))).collect()
    }
}

/// A solve whose right side can still be changed by constraints.
#[derive(Debug)]
pub struct PartialSolve<'a, T: Scalar = f64> {
    system: &'a System<T>,
    /// `C⁻¹ right` in the elimination order of a factor, or the solution.
    vector: Vec<T>,
}

impl<T: Scalar> System<T> {
    /// By a Cholesky factor.
    pub fn cholesky<E: Entry<T>>(factor: Factor<T, E>) -> Self {
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
    pub fn solve(&self, right: &[T]) -> Result<Vec<T>> {
        match self {
            Self::Cholesky(factor) => Ok(factor.backward(factor.forward(right))),
            Self::ConjugateGradients(matrix) => matrix.solve(right),
        }
    }

    /// The solution for a right side that is zero but at a few rows, given as `(row, value)`.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn solve_sparse(&self, right: &Functional<T>) -> Result<Vec<T>> {
        match self {
            Self::Cholesky(factor) => Ok(factor.solve_sparse(right)),
            Self::ConjugateGradients(matrix) => matrix.solve(&dense(matrix.size(), right)),
        }
    }

    /// The Schur columns of constraints.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn schur_columns(&self, functionals: &[Functional<T>]) -> Result<Vec<Arc<SchurColumn<T>>>> {
        match self {
            Self::Cholesky(factor) => Ok(factor.columns(functionals)),
            Self::ConjugateGradients(matrix) => {
                let solve = |functional: &Functional<T>| {
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
    pub fn partial_solve(&self, right: &[T]) -> Result<PartialSolve<'_, T>> {
        let vector = match self {
            Self::Cholesky(factor) => factor.forward(right),
            Self::ConjugateGradients(matrix) => matrix.solve(right)?,
        };
        Ok(PartialSolve { system: self, vector })
    }
}

impl<T: Scalar> PartialSolve<'_, T> {
    /// `eᴴ x` of the solution `x` so far.
    pub fn evaluate(&self, column: &SchurColumn<T>) -> T {
        match &column.0 {
            Kind::Forward(vector) => vector.dot_dense(&self.vector),
            Kind::Solution { functional, .. } => evaluate(functional, &self.vector),
        }
    }

    /// Adds `multiplier · e` to the right side.
    pub fn add(&mut self, multiplier: T, column: &SchurColumn<T>) {
        match &column.0 {
            Kind::Forward(vector) => vector.add_to(multiplier, &mut self.vector),
            Kind::Solution { solution, .. } => {
                for (target, &value) in self.vector.iter_mut().zip(solution) {
                    *target += multiplier * value;
                }
            }
        }
    }

    /// The solution (`#rows`).
    pub fn finish(self) -> Vec<T> {
        match self.system {
            System::Cholesky(factor) => factor.backward(self.vector),
            System::ConjugateGradients(_) => self.vector,
        }
    }
}

/// A functional as a vector.
fn dense<T: Scalar>(size: usize, functional: &Functional<T>) -> Vec<T> {
    let mut vector = vec![T::ZERO; size];
    for &(unknown, weight) in functional {
        vector[unknown as usize] += weight;
    }
    vector
}
