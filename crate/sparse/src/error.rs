//! What can go wrong, with the row at fault.

use thiserror::Error;

/// Result with this crate's [`enum@Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every failure of the crate.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A matrix could not be factored.
    #[error("matrix {matrix} is not positive definite at row {row}")]
    NotPositiveDefinite {
        /// Which of the matrices factored together, counted from 0.
        matrix: usize,
        /// Row of the failing pivot, in the order of the matrix.
        row: usize,
    },
    /// Conjugate gradients did not reach their tolerance.
    #[error("conjugate gradients did not converge in {iterations} steps")]
    NotConverged {
        /// Steps done.
        iterations: usize,
    },
    /// Something does not fit into memory.
    #[error("out of memory while {stage}")]
    OutOfMemory {
        /// What was being done.
        stage: &'static str,
    },
    /// The work was stopped by the caller's progress callback.
    #[error("cancelled")]
    Cancelled,
}
