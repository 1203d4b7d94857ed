#![doc = include_str!("../README.md")]

mod complex;
mod conjugate_gradients;
mod dissection;
mod error;
mod factor;
mod front;
mod matrix;
mod multifrontal;
mod multigrid;
mod ordering;
mod pattern;
mod progress;
mod real;
#[cfg(test)]
mod samples;
mod scalar;
mod schur;
mod schur_cache;
mod simd;
mod sparse_vector;
mod substitution;
mod symbolic;
mod system;

/// A complex number of two doubles.
pub use faer::c64;

pub use conjugate_gradients::ConjugateGradients;
pub use dissection::{Part, Separators};
pub use error::{Error, Result};
pub use factor::Factor;
pub use matrix::SymmetricMatrix;
pub use ordering::Permutation;
pub use pattern::Pattern;
pub use progress::{Progress, Stage, go_on, report};
pub use scalar::{Entry, Pair, Scalar, Turn};
pub use schur::{Functional, SchurColumn, SchurComplement, evaluate};
pub use schur_cache::SchurCache;
pub use symbolic::{FactorMemory, Symbolic};
pub use system::{PartialSolve, Substitute, System};
