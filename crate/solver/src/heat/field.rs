//! What stands for the gradient of distance where that is not known.

use crate::heat::constraint::Constraint;
use crate::options::{Boundary, FactorOptions, LinearSolver, TimeStep};

/// A field made of heat.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Field {
    /// −∇u / |∇u|. Its Poisson equation gives distance.
    Unit,
    /// That of the logarithm of heat. Distance follows it from vertex to vertex.
    Logarithm,
}

impl Field {
    /// Heat that is 0 at the boundary has no logarithm there, and conjugate gradients leave noise in that of little heat.
    pub(super) fn of(options: FactorOptions, has_logarithm: bool) -> Self {
        match (options.time_step, options.solver, options.boundary) {
            (TimeStep::Automatic, LinearSolver::Cholesky, Boundary::Neumann) if has_logarithm => Self::Logarithm,
            _ => Self::Unit,
        }
    }
}

/// Right side of the Poisson equation.
#[derive(Debug)]
pub struct RightSide {
    /// `#V`, integrated divergence of the field that should be the gradient of distance, signed so that `L φ` equals it.
    pub divergence: Vec<f64>,
    /// On the rim of each patch of the exact region the mean of the exact distances: [`ExactRegion::rims`](super::ExactRegion::rims).
    pub rims: Vec<Constraint>,
}
