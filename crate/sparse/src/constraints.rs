//! Linear systems with a few linear constraints, without factoring again: bordered (Schur complement) solves.

use std::sync::Arc;

use crate::columns::Column;
use crate::conjugate_gradients::Matrix;
use crate::error::Result;
use crate::factor::Factor;
use crate::vector::dot;

/// A weighted sum of unknowns, as `(unknown, weight)`.
pub type Functional = Vec<(u32, f64)>;

/// A pivot below this share of its diagonal entry means that a constraint follows from earlier ones. Rounding of the
/// sums before is some 1e-15.
const DEPENDENT: f64 = 1e-11;

/// A matrix that can be solved.
#[derive(Debug)]
pub enum System {
    /// By its Cholesky factor.
    Cholesky(Factor),
    /// By conjugate gradients.
    ConjugateGradients(Matrix),
}

/// What a constraint does to a system: `C⁻¹ e` for a factor, the solution `A⁻¹ e` otherwise.
#[derive(Debug)]
pub enum Response {
    /// Of a factor: `C⁻¹ e`.
    Forward(Column),
    /// Of an iterative solver.
    Solution {
        /// The constraint `e`.
        functional: Functional,
        /// `A⁻¹ e`.
        solution: Vec<f64>,
    },
}

impl Response {
    /// `e₁ᵀ A⁻¹ e₂`.
    pub fn against(&self, other: &Self) -> f64 {
        match (self, other) {
            (Self::Forward(a), Self::Forward(b)) => a.dot(b),
            (Self::Solution { functional, .. }, Self::Solution { solution, .. }) => evaluate(functional, solution),
            _ => unreachable!("responses of one system are of one kind"),
        }
    }

    /// Numbers kept.
    pub fn value_count(&self) -> usize {
        match self {
            Self::Forward(column) => column.len(),
            Self::Solution { solution, .. } => solution.len(),
        }
    }
}

/// The value of a functional at a vector.
pub fn evaluate(functional: &Functional, vector: &[f64]) -> f64 {
    functional.iter().map(|&(unknown, weight)| weight * vector[unknown as usize]).sum()
}

/// A functional as a vector.
fn dense(size: usize, functional: &Functional) -> Vec<f64> {
    let mut vector = vec![0.0; size];
    for &(unknown, weight) in functional {
        vector[unknown as usize] += weight;
    }
    vector
}

/// A solve that has begun: constraints can be evaluated and changed before it is finished.
pub struct Begun(Vec<f64>);

impl System {
    /// Stored entries of the factor; none for an iterative solver.
    pub fn nonzeros(&self) -> usize {
        match self {
            Self::Cholesky(factor) => factor.nonzeros(),
            Self::ConjugateGradients(_) => 0,
        }
    }

    /// The solution for one right side.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn solve(&self, right: &[f64]) -> Result<Vec<f64>> {
        match self {
            Self::Cholesky(factor) => Ok(factor.backward(factor.forward(right))),
            Self::ConjugateGradients(matrix) => matrix.solve(right),
        }
    }

    /// The solution for a right side that is zero but at a few rows.
    pub fn solve_sparse(&self, right: &Functional) -> Result<Vec<f64>> {
        match self {
            Self::Cholesky(factor) => Ok(factor.backward(factor.forward_sparse(right))),
            Self::ConjugateGradients(matrix) => matrix.solve(&dense(matrix.size(), right)),
        }
    }

    /// Responses to constraints.
    pub fn responses(&self, functionals: &[Functional]) -> Result<Vec<Arc<Response>>> {
        match self {
            Self::Cholesky(factor) => {
                let rights: Vec<&[(u32, f64)]> = functionals.iter().map(Vec::as_slice).collect();
                let columns = factor.columns(&rights);
                Ok(columns.into_iter().map(|column| Arc::new(Response::Forward(column))).collect())
            }
            Self::ConjugateGradients(matrix) => {
                let solve = |functional: &Functional| {
                    let solution = matrix.solve(&dense(matrix.size(), functional))?;
                    Ok(Arc::new(Response::Solution { functional: functional.clone(), solution }))
                };
                functionals.iter().map(solve).collect()
            }
        }
    }

    /// Begins a solve.
    ///
    /// # Errors
    /// [`Error::NotConverged`](crate::Error::NotConverged).
    pub fn begin(&self, right: &[f64]) -> Result<Begun> {
        match self {
            Self::Cholesky(factor) => Ok(Begun(factor.forward(right))),
            Self::ConjugateGradients(matrix) => matrix.solve(right).map(Begun),
        }
    }

    /// The solution of a solve that was begun.
    pub fn finish(&self, begun: Begun) -> Vec<f64> {
        match self {
            Self::Cholesky(factor) => factor.backward(begun.0),
            Self::ConjugateGradients(_) => begun.0,
        }
    }
}

impl Begun {
    /// `eᵀ x` of the solution `x` so far.
    pub fn evaluate(&self, response: &Response) -> f64 {
        match response {
            Response::Forward(column) => column.dot_dense(&self.0),
            Response::Solution { functional, .. } => evaluate(functional, &self.0),
        }
    }

    /// Adds `amount · e` to the right side.
    pub fn add(&mut self, amount: f64, response: &Response) {
        match response {
            Response::Forward(column) => column.add_to(amount, &mut self.0),
            Response::Solution { solution, .. } => {
                for (target, value) in self.0.iter_mut().zip(solution) {
                    *target += amount * value;
                }
            }
        }
    }
}

/// The Gram matrix `e_iᵀ A⁻¹ e_j` of constraints, factored.
pub struct Gram {
    /// Rows of the lower triangle, each up to its diagonal. The diagonal of a dependent constraint is 0.
    rows: Vec<Vec<f64>>,
}

impl Gram {
    /// `shift` is added to every entry.
    pub fn new(responses: &[Arc<Response>], shift: f64) -> Self {
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(responses.len());
        for (i, response) in responses.iter().enumerate() {
            let mut row: Vec<f64> = responses[..=i].iter().map(|other| response.against(other) + shift).collect();
            let whole = row[i];
            for j in 0..i {
                let known = dot(&row[..j], &rows[j][..j]);
                let pivot = rows[j][j];
                row[j] = if pivot > 0.0 { (row[j] - known) / pivot } else { 0.0 };
            }
            let rest = whole - dot(&row[..i], &row[..i]);
            row[i] = if rest > DEPENDENT * whole { rest.sqrt() } else { 0.0 };
            rows.push(row);
        }
        Self { rows }
    }

    /// Amounts `λ` with `S λ = wanted`; 0 for constraints that follow from earlier ones.
    pub fn solve(&self, wanted: &[f64]) -> Vec<f64> {
        let mut x = wanted.to_vec();
        for (i, row) in self.rows.iter().enumerate() {
            x[i] = if row[i] > 0.0 { (x[i] - dot(&row[..i], &x[..i])) / row[i] } else { 0.0 };
        }
        for (i, row) in self.rows.iter().enumerate().rev() {
            x[i] = if row[i] > 0.0 { x[i] / row[i] } else { 0.0 };
            let value = x[i];
            for (target, entry) in x[..i].iter_mut().zip(row) {
                *target -= entry * value;
            }
        }
        x
    }
}
