//! Schur complements of a few linear constraints.
//!
//! Benzi, Golub, Liesen, "Numerical solution of saddle point problems" (2005), section 5, on their use.

use std::sync::Arc;

use crate::simd::dot;
use crate::sparse_vector::SparseVector;

/// A weighted sum of unknowns, as `(unknown, weight)`.
pub type Functional = Vec<(u32, f64)>;

/// A pivot below this share of its diagonal entry means that a constraint follows from earlier ones. Rounding of the
/// sums before is some 1e-15.
const DEPENDENT: f64 = 1e-11;

/// What a constraint `e` does to a system `A`, ready to be combined with other constraints of that system.
#[derive(Debug)]
pub struct SchurColumn(pub(crate) Kind);

#[derive(Debug)]
pub(crate) enum Kind {
    /// Of a factor: `C⁻¹ e`.
    Forward(SparseVector),
    /// Of an iterative solver: `A⁻¹ e`.
    Solution { functional: Functional, solution: Vec<f64> },
}

impl SchurColumn {
    /// `e₁ᵀ A⁻¹ e₂`.
    ///
    /// # Panics
    /// Where one column is of a factor and the other of conjugate gradients.
    pub fn inner_product(&self, other: &Self) -> f64 {
        match (&self.0, &other.0) {
            (Kind::Forward(a), Kind::Forward(b)) => a.dot(b),
            (Kind::Solution { functional, .. }, Kind::Solution { solution, .. }) => evaluate(functional, solution),
            _ => panic!("Schur columns of one system are combined"),
        }
    }

    /// Numbers stored.
    pub fn nonzeros(&self) -> usize {
        match &self.0 {
            Kind::Forward(vector) => vector.len(),
            Kind::Solution { solution, .. } => solution.len(),
        }
    }
}

/// The value of a functional at a vector.
pub fn evaluate(functional: &Functional, vector: &[f64]) -> f64 {
    functional.iter().map(|&(unknown, weight)| weight * vector[unknown as usize]).sum()
}

/// The Schur complement `S`, of entries `e_iᵀ A⁻¹ e_j`, of some constraints, factored.
#[derive(Debug, Clone)]
pub struct SchurComplement {
    /// Rows of the lower triangle of the factor, each up to its diagonal. The diagonal of a dependent constraint is 0.
    rows: Vec<Vec<f64>>,
}

impl SchurComplement {
    /// The Schur complement of constraints of one system. `shift` is added to every entry.
    pub fn new(columns: &[Arc<SchurColumn>], shift: f64) -> Self {
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(columns.len());
        for (i, column) in columns.iter().enumerate() {
            let mut row: Vec<f64> = columns[..=i].iter().map(|other| column.inner_product(other) + shift).collect();
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

    /// Multipliers `λ` (one for each constraint) with `S λ = values`; 0 for constraints that follow from earlier ones.
    ///
    /// # Panics
    /// Where there is not one value for each constraint.
    pub fn solve(&self, values: &[f64]) -> Vec<f64> {
        assert_eq!(values.len(), self.rows.len(), "one value for each constraint");
        let mut x = values.to_vec();
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
