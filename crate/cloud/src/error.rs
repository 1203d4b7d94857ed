//! What can go wrong, and what to do.

use thiserror::Error;

/// Result with this crate's [`enum@Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Why there is no surface of a cloud.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Error {
    /// Less than a triangle.
    #[error(
        "a cloud has to have three points at least that are different and finite, and of the {points} here so many are: {different}"
    )]
    TooFew {
        /// Points given.
        points: usize,
        /// Different finite ones among them.
        different: usize,
    },
    /// No two directions to spread in.
    #[error("all {points} points lie on lines, so no triangles can be made between them; give points of a surface")]
    Line {
        /// Points given.
        points: usize,
    },
    /// They do not fit into memory.
    #[error("there is not enough memory to join {points} points; give fewer")]
    OutOfMemory {
        /// Points given.
        points: usize,
    },
}

impl Error {
    /// Names the kind of failure, in kebab case. It stays the same between versions; messages may not.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooFew { .. } => "too-few-points",
            Self::Line { .. } => "points-on-lines",
            Self::OutOfMemory { .. } => "too-many-points",
        }
    }
}
