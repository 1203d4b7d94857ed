//! The dials of the heat method.

use std::fmt;
use std::ops::ControlFlow;

use crate::error::{Error, Result};
use crate::operator::Operator;

/// What heat does at the boundary of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Boundary {
    /// None flows out: lines of equal distance meet the boundary at right angles.
    #[default]
    Neumann,
    /// It is held at 0, except at sources. Pieces that are all boundary fall back to Neumann.
    Dirichlet,
    /// The mean of both, nearest to the true distance where the time factor is large.
    Average,
}

/// How linear systems are solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LinearSolver {
    /// Sparse factorisation: once, then every source is quick and heat is right however far it has fallen.
    #[default]
    Cholesky,
    /// Conjugate gradients with multigrid: little to prepare, memory in proportion to the mesh, each source slow, and heat
    /// below 10⁻¹² of its maximum is noise.
    ConjugateGradients,
}

/// The diffusion time t = m h², h the mean edge length.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum TimeStep {
    /// m chosen by how even the edge lengths are; with conjugate gradients so large that all heat is above their noise.
    #[default]
    Automatic,
    /// This m; positive, no unit. Larger is smoother.
    Factor(f64),
}

/// How several sources are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MultiSource {
    /// Heat is 1 and distance is 0 (or its starting value) at every source, as if the matrices had been factored with
    /// these points held.
    #[default]
    Exact,
    /// Heat of the sources is added up and one constant subtracted, so that no source ends at exactly 0: what other
    /// programs do, for comparison.
    Superposed,
}

/// How far around the sources distances are exact polyhedral ones.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum NearField {
    /// As far as costs a fraction of a solve on large meshes, and a few solves, well below a millisecond each, on meshes of
    /// some thousand points.
    #[default]
    Automatic,
    /// So many mean edges, whatever it costs: 0 is the heat method alone, infinity is exact everywhere.
    Edges(f64),
}

/// Most memory that factors may take.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MemoryLimit {
    /// What there is.
    #[default]
    Automatic,
    /// So many bytes for the factors, made and kept, and for the work on them. The surface, its matrices and what
    /// solves keep are not counted.
    Bytes(u64),
}

/// The dials of the method.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Parameters {
    /// The triangles that carry the operators.
    pub operator: Operator,
    /// How linear systems are solved.
    pub solver: LinearSolver,
    /// How long heat flows.
    pub time_step: TimeStep,
    /// What heat does at the boundary.
    pub boundary: Boundary,
    /// How several sources are joined.
    pub sources: MultiSource,
    /// How far around the sources distances are exact.
    pub near_field: NearField,
    /// Most memory that factors may take.
    pub memory: MemoryLimit,
}

impl Parameters {
    /// # Errors
    /// [`Error::BadParameter`].
    pub(crate) fn check(&self) -> Result<()> {
        let bad = |name, value: f64, range| Err(Error::BadParameter { name, value: value.to_string(), range });
        match (self.time_step, self.near_field) {
            (TimeStep::Factor(factor), _) if !(factor.is_finite() && factor > 0.0) => {
                bad("the time factor", factor, "a positive number")
            }
            (_, NearField::Edges(edges)) if edges.is_nan() || edges < 0.0 => {
                bad("the radius of the near field", edges, "a number of mean edges, 0 or more")
            }
            _ => Ok(()),
        }
    }
}

/// A stage of the precomputation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Building the triangulation and the matrices.
    Assembling,
    /// Choosing the elimination order.
    Ordering,
    /// Finding the pattern of the factors.
    Analysing,
    /// Factoring `L` and `M / t + L`, the latter for each boundary condition needed.
    Factoring,
}

impl fmt::Display for Stage {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Assembling => "Assembling",
            Self::Ordering => "Ordering",
            Self::Analysing => "Analysing",
            Self::Factoring => "Factoring",
        })
    }
}

/// Called before each stage with the fraction done so far, 0 to 1. `Break` ends the work with [`Error::Cancelled`].
pub type Progress<'a> = &'a mut dyn FnMut(Stage, f64) -> ControlFlow<()>;

pub(crate) fn report(progress: &mut dyn FnMut(Stage, f64) -> ControlFlow<()>, stage: Stage, done: f64) -> Result<()> {
    if progress(stage, done).is_break() { Err(Error::Cancelled) } else { Ok(()) }
}
