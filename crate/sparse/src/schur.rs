//! Schur complements of a few linear constraints.
//!
//! Benzi, Golub, Liesen, "Numerical solution of saddle point problems" (2005), section 5, on their use.

use std::sync::Arc;

use crate::scalar::{Scalar, dot};
use crate::sparse_vector::SparseVector;

/// A vector `e` that is zero but at a few unknowns, as `(unknown, weight)`, for the weighted sum of unknowns `eᴴ x`.
pub type Functional<T = f64> = Vec<(u32, T)>;

/// A pivot below this share of its diagonal entry means that a constraint follows from earlier ones. Rounding of the
/// sums before is some 1e-15.
const DEPENDENT: f64 = 1e-11;

/// What a constraint `e` does to a system `A`, ready to be combined with other constraints of that system.
#[derive(Debug)]
pub struct SchurColumn<T = f64>(pub(crate) Kind<T>);

#[derive(Debug)]
pub(crate) enum Kind<T> {
    /// Of a factor: `C⁻¹ e`.
    Forward(SparseVector<T>),
    /// Of an iterative solver: `A⁻¹ e`.
    Solution { functional: Functional<T>, solution: Vec<T> },
}

impl<T: Scalar> SchurColumn<T> {
    /// `e₁ᴴ A⁻¹ e₂`.
    ///
    /// # Panics
    /// Where one column is of a factor and the other of conjugate gradients.
    pub fn inner_product(&self, other: &Self) -> T {
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
pub fn evaluate<T: Scalar>(functional: &Functional<T>, vector: &[T]) -> T {
    functional.iter().map(|&(unknown, weight)| weight.conj() * vector[unknown as usize]).sum()
}

/// The Schur complement `S`, of entries `e_iᴴ A⁻¹ e_j`, of some constraints, factored as `C Cᴴ`.
#[derive(Debug, Clone)]
pub struct SchurComplement<T = f64> {
    /// Conjugates of the rows of `C`, each up to its diagonal. The diagonal of a dependent constraint is 0.
    rows: Vec<Vec<T>>,
}

impl<T: Scalar> SchurComplement<T> {
    /// The Schur complement of constraints of one system. `shift` is added to every entry.
    pub fn new(columns: &[Arc<SchurColumn<T>>], shift: f64) -> Self {
        let mut rows: Vec<Vec<T>> = Vec::with_capacity(columns.len());
        for (i, column) in columns.iter().enumerate() {
            let entry = |other: &Arc<SchurColumn<T>>| column.inner_product(other).conj() + T::from_real(shift);
            let mut row: Vec<T> = columns[..=i].iter().map(entry).collect();
            let whole = row[i].real();
            for j in 0..i {
                let known = dot(&rows[j][..j], &row[..j]);
                let pivot = rows[j][j].real();
                row[j] = if pivot > 0.0 { (row[j] - known).divide(pivot) } else { T::ZERO };
            }
            let rest = whole - dot(&row[..i], &row[..i]).real();
            row[i] = T::from_real(if rest > DEPENDENT * whole { rest.sqrt() } else { 0.0 });
            rows.push(row);
        }
        Self { rows }
    }

    /// Multipliers `λ` (one for each constraint) with `S λ = values`; 0 for constraints that follow from earlier ones.
    ///
    /// # Panics
    /// Where there is not one value for each constraint.
    pub fn solve(&self, values: &[T]) -> Vec<T> {
        assert_eq!(values.len(), self.rows.len(), "one value for each constraint");
        let over = |value: T, pivot: T| if pivot.real() > 0.0 { value.divide(pivot.real()) } else { T::ZERO };
        let mut x = values.to_vec();
        for (i, row) in self.rows.iter().enumerate() {
            x[i] = over(x[i] - dot(&row[..i], &x[..i]), row[i]);
        }
        for (i, row) in self.rows.iter().enumerate().rev() {
            x[i] = over(x[i], row[i]);
            let value = x[i];
            for (target, &entry) in x[..i].iter_mut().zip(row) {
                *target -= entry * value;
            }
        }
        x
    }
}
