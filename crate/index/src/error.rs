//! What can be wrong.

use thiserror::Error;

/// An index that cannot be made, read or asked.
#[derive(Debug, Error)]
pub enum Error {
    /// The input has no such vertex.
    #[error("vertex {vertex} does not exist; the index is of {count} vertices, counted from 0")]
    NoVertex {
        /// The vertex that was asked for.
        vertex: usize,
        /// How many there are.
        count: usize,
    },
    /// The bytes are of something else.
    #[error("this is no index of distances; make one with heatwalk index")]
    NotAnIndex,
    /// The bytes are of another version of the format.
    #[error("the index has version {found} of its format, and this program reads version {known}; make it again")]
    OtherVersion {
        /// The version that the file says.
        found: u32,
        /// The version that is read.
        known: u32,
    },
    /// The bytes are not those that were written.
    #[error("the index is damaged or cut short; make it again")]
    Damaged,
    /// The index is of another surface.
    #[error("the index was made of another mesh, or with other --part, --animation or --weld; make one of this mesh")]
    OtherSurface,
    /// A search failed.
    #[error(transparent)]
    Search(#[from] heatwalk::Error),
}

/// The result of an operation on indices.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// What kind of error it is, in words joined by hyphens.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::NoVertex { .. } => "vertex-out-of-range",
            Self::NotAnIndex => "unknown-format",
            Self::OtherVersion { .. } => "unsupported",
            Self::Damaged => "malformed",
            Self::OtherSurface => "other-surface",
            Self::Search(error) => error.code(),
        }
    }
}
