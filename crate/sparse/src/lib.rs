//! Sparse symmetric positive definite systems, native and on wasm32.
//!
//! The way of the data: [`Pattern`] and [`SymmetricMatrix`] → [`Permutation`] (elimination order) → [`Symbolic`] (pattern
//! of the factors, once for all matrices of one pattern) → [`Factor`] → [`System`], which solves whole right sides, sparse
//! ones, and right sides under linear constraints without factoring again. Where factors do not fit,
//! [`ConjugateGradients`] solves with multigrid as preconditioner.

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

pub use conjugate_gradients::ConjugateGradients;
pub use error::{Error, Result};
pub use factor::Factor;
pub use matrix::SymmetricMatrix;
pub use ordering::Permutation;
pub use pattern::Pattern;
pub use scalar::{Pair, Scalar};
pub use schur::{Functional, SchurColumn, SchurComplement, evaluate};
pub use schur_cache::SchurCache;
pub use symbolic::{FactorMemory, Symbolic};
pub use system::{PartialSolve, System};
