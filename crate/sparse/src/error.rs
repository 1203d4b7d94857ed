//! What can go wrong, with the row, column or matrix at fault.

use strum::IntoStaticStr;
use thiserror::Error;

/// Result with this crate's [`enum@Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every failure of the crate. Rows, columns and matrices are counted from 0.
#[derive(Debug, Clone, PartialEq, Eq, Error, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// Where the columns of a pattern begin does not fit the rows given.
    #[error(
        "the columns of a pattern must begin at 0, in ascending order, and end with the last of its {nonzeros} entries; column {column} does not"
    )]
    InvalidColumnStart {
        /// The column at fault; the number of columns where the end is wrong.
        column: usize,
        /// Number of row indices given.
        nonzeros: usize,
    },
    /// A column of a pattern does not begin with its diagonal entry.
    #[error("column {column} does not begin with its diagonal entry")]
    MissingDiagonal {
        /// The column.
        column: usize,
    },
    /// The rows of a column do not ascend, or leave the matrix.
    #[error("row {row} of column {column} is not between the row before it and the last of {size} rows")]
    InvalidRow {
        /// The column.
        column: usize,
        /// The row.
        row: usize,
        /// Number of rows of the matrix.
        size: usize,
    },
    /// A matrix has not one value for each entry of its pattern.
    #[error("{values} values for a pattern of {nonzeros} entries")]
    ValueCount {
        /// Number of values.
        values: usize,
        /// Stored entries of the pattern.
        nonzeros: usize,
    },
    /// An order does not have every row exactly once.
    #[error("an order of {size} rows must have each once; place {place} does not")]
    InvalidPermutation {
        /// Place in the order of the row that is missing, repeated or too large.
        place: usize,
        /// Number of rows.
        size: usize,
    },
    /// A permutation belongs to another pattern.
    #[error("the permutation of {found} rows does not order a pattern of {expected} rows, or is no postorder of it")]
    PermutationMismatch {
        /// Rows of the pattern.
        expected: usize,
        /// Rows of the permutation.
        found: usize,
    },
    /// A matrix has another pattern than the one analysed.
    #[error("matrix {matrix} has another pattern than the one analysed")]
    PatternMismatch {
        /// Which of the matrices factored together.
        matrix: usize,
    },
    /// A matrix could not be factored.
    #[error("matrix {matrix} is not positive definite at row {row}")]
    NotPositiveDefinite {
        /// Which of the matrices factored together.
        matrix: usize,
        /// Row of the failing pivot, in the order of the matrix.
        row: usize,
    },
    /// Conjugate gradients did not reach their tolerance.
    #[error("conjugate gradients did not converge in {iterations} iterations")]
    NotConverged {
        /// Iterations done.
        iterations: usize,
    },
    /// A step of conjugate gradients has no finite length: in rounding, the matrix is not positive definite.
    #[error("conjugate gradients broke down after {iterations} iterations")]
    Breakdown {
        /// Iterations done.
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

impl Error {
    /// A name of the kind of error that stays the same from version to version.
    pub fn code(&self) -> &'static str {
        self.into()
    }
}
