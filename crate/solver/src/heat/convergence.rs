//! How the two linear solvers of the report come to the solutions of the heat method.

use std::sync::Arc;

use heatwalk_sparse::{ConjugateGradients, Permutation, Symbolic, SymmetricMatrix, go_on};
use heatwalk_surface::Source;

use crate::error::{Error, Result};
use crate::heat::factorization::Factorization;
use crate::heat::flow::HEAT_MATRIX;
use crate::heat::poisson::{POISSON_MATRIX, Poisson};
use crate::heat::query::Query;
use crate::operator::Discretization;

/// Residuals `‖b − A x‖₂ / ‖b‖₂` of one linear system.
#[derive(Debug, Clone, PartialEq)]
pub struct Residuals {
    /// By conjugate gradients: before the first step, where it is 1, and after each. The last is at most 10⁻¹².
    pub iterated: Vec<f64>,
    /// By Cholesky factors, whose one solve has no steps.
    pub factored: f64,
}

/// Residuals of the two systems of the heat method, by both linear solvers.
#[derive(Debug, Clone, PartialEq)]
pub struct Convergence {
    /// `(M / t + L) u = δ` with the first boundary condition that the options need; the supplies of several sources are
    /// summed.
    pub heat: Residuals,
    /// `L φ = div X`, with one vertex of each component constrained to 0.
    pub poisson: Residuals,
}

impl Factorization {
    /// Solves both systems of a query anew by both linear solvers, whichever the options have. Costs about as much as
    /// factoring both matrices.
    ///
    /// # Errors
    /// As [`Factorization::distance`], and [`Error::NotPositiveDefinite`] on degenerate triangles.
    pub fn convergence(&self, query: &Query) -> Result<Convergence> {
        let flow = self.method.needed_flows().next().expect("some heat system is always there");
        let mut supply = vec![0.0; self.operators().laplacian().size()];
        for source in query.checked(self.surface())? {
            let free = |&(vertex, _): &(_, f64)| !flow.condition().is_cold(vertex);
            for (vertex, weight) in supports(self, &source).filter(free) {
                supply[vertex as usize] += weight;
            }
        }
        let divergence = self.method.poisson()?.grounded_right(&self.divergence(query)?);
        let heat = flow.step().matrix(flow.systems().operators().laplacian());
        let poisson = Poisson::matrix(flow.systems());
        let pattern = heat.pattern();
        let symbolic = Arc::new(Symbolic::analyse(pattern, Permutation::fill_reducing(pattern)?)?);
        let residuals = |matrix: &SymmetricMatrix, name, right: &[f64]| -> Result<Residuals> {
            let [factor] =
                symbolic.factor([matrix], &mut go_on).map_err(|error| Error::of_matrices(&error, &[name]))?;
            let factored = residual(matrix, &factor.solve(right), right);
            let (_, iterated) = ConjugateGradients::new(matrix.clone()).solve_recording(right)?;
            Ok(Residuals { iterated, factored })
        };
        Ok(Convergence {
            heat: residuals(&heat, HEAT_MATRIX, &supply)?,
            poisson: residuals(&poisson, POISSON_MATRIX, &divergence)?,
        })
    }
}

/// Vertices and weights of a source.
fn supports(factorization: &Factorization, source: &Source) -> impl Iterator<Item = (u32, f64)> {
    source.place().support(factorization.surface()).map(|(vertex, weight)| (vertex.0, weight))
}

/// `‖right − A solution‖₂ / ‖right‖₂`; 0 where the right side is 0.
fn residual(matrix: &SymmetricMatrix, solution: &[f64], right: &[f64]) -> f64 {
    let negative: Vec<f64> = solution.iter().map(|value| -value).collect();
    let mut rest = right.to_vec();
    matrix.multiply_add(&negative, &mut rest);
    let norm = |vector: &[f64]| vector.iter().map(|value| value * value).sum::<f64>().sqrt();
    let whole = norm(right);
    if whole > 0.0 { norm(&rest) / whole } else { 0.0 }
}
