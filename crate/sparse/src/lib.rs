//! Sparse symmetric positive definite systems, native and on wasm32.
//!
//! The way of the data: [`Pattern`] → [`Symbolic`] (elimination order and pattern of the factors, once for all matrices of
//! one pattern) → [`Factor`] → [`System`], which solves whole right sides, sparse ones, and right sides under linear
//! constraints without factoring again. Where factors do not fit, [`Matrix`] solves by conjugate gradients with multigrid.

mod cholesky;
mod columns;
mod conjugate_gradients;
mod constraints;
mod dissection;
mod error;
mod factor;
mod front;
mod multifrontal;
mod multigrid;
mod ordering;
mod pattern;
mod responses;
mod substitution;
mod vector;

pub use cholesky::Symbolic;
pub use conjugate_gradients::Matrix;
pub use constraints::{Begun, Functional, Gram, Response, System, evaluate};
pub use error::{Error, Result};
pub use factor::Factor;
pub use ordering::Permutation;
pub use pattern::Pattern;
pub use responses::Responses;
