//! Which field the heat method takes, and what suits each.

use heatwalk::{Boundary, FactorOptions, LinearSolver, TimeStep};

/// What stands for the gradient of distance where that is not known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Field {
    /// −∇u / |∇u|.
    Unit,
    /// That of the [`Logarithm`](super::logarithm::Logarithm) of heat.
    Logarithm,
}

impl Field {
    /// Heat that is 0 at the boundary has no logarithm there, and conjugate gradients leave noise in that of little heat.
    pub(super) fn of(options: FactorOptions, is_monotone: bool) -> Self {
        match (options.time_step, options.solver, options.boundary) {
            (TimeStep::Automatic, LinearSolver::Cholesky, Boundary::Neumann) if is_monotone => Self::Logarithm,
            _ => Self::Unit,
        }
    }

    /// m in t = m h² where it is chosen and edges are even, by errors measured on cubes, balls and tubes.
    pub(super) fn time_factor(self) -> f64 {
        match self {
            Self::Unit => 0.5,
            Self::Logarithm => 0.6,
        }
    }

    /// Work of the march in the exact region for each vertex.
    pub(super) fn work(self) -> f64 {
        match self {
            Self::Unit => 5.5,
            Self::Logarithm => 2.5,
        }
    }
}
