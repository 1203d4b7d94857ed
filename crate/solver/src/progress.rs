//! How far the precomputation is, and whether it shall go on.

use std::ops::ControlFlow;

use crate::choice::choice;
use crate::error::{Error, Result};

/// A stage of the precomputation.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Stage {
    /// Building the triangulation and the matrices.
    #[default]
    Assembling,
    /// Choosing the elimination order.
    Ordering,
    /// Finding the pattern of the factors.
    Analysing,
    /// Factoring `L` and `M / t + L`, the latter for each boundary condition needed.
    Factoring,
}

choice!(Stage, "stage":
    Assembling = "Assembling",
    Ordering = "Ordering",
    Analysing = "Analysing",
    Factoring = "Factoring",
);

/// Called before each stage with the fraction done so far, 0 to 1. `Break` ends the work with [`Error::Cancelled`].
pub type Progress<'a> = &'a mut dyn FnMut(Stage, f64) -> ControlFlow<()>;

/// How far a [`DistanceSolver`](crate::DistanceSolver) is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// Before a stage of the precomputation of heat, with the fraction done so far, 0 to 1.
    Precompute(Stage, f64),
    /// Every value below this distance, in the file's unit, is final.
    Radius(f64),
    /// So many of several questions are answered.
    Answered(usize),
}

/// Called some milliseconds apart, or after each answer. `Break` ends the work with [`Error::Cancelled`].
pub type Steps<'a> = &'a mut dyn FnMut(Step) -> ControlFlow<()>;

pub(crate) fn report(progress: &mut dyn FnMut(Stage, f64) -> ControlFlow<()>, stage: Stage, done: f64) -> Result<()> {
    if progress(stage, done).is_break() { Err(Error::Cancelled) } else { Ok(()) }
}
