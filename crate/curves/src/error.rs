//! What can be wrong with a field or with what is asked of it.

use thiserror::Error;

/// Isolines that are traced at once, at most: at a hundred thousand, the curves of a small mesh fill a gigabyte.
pub const MOST_LEVELS: usize = 10_000;

/// Angle defects of all inner vertices of a piece that is unrolled, in radians, without their signs, at most. Where two sides of
/// a cut would meet, the plane shape is off by no more than this times the piece's extent: 1 %.
pub const MAX_DEFECT: f64 = 0.01;

/// A piece that has no plane shape.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "strip {strip} cannot be unrolled: it is curved, with an angle defect of {largest:.4} rad at vertex {vertex} and of {total:.4} rad \
     in all, where {MAX_DEFECT} is allowed; {}",
    if self.is_by_one_vertex() {
        "no spacing changes that, since one vertex has more than that, and only strips without such vertices are flat"
    } else {
        "choose a smaller spacing"
    }
)]
pub struct NotDevelopable {
    /// Which strip it is a piece of.
    pub strip: usize,
    /// The largest angle defect, without its sign, in radians.
    pub largest: f64,
    /// Where that is: a vertex of the strips.
    pub vertex: u32,
    /// The sum of all of them, without signs.
    pub total: f64,
}

impl NotDevelopable {
    /// Whether one vertex alone is curved too much: then the strip that holds it is not flat however narrow it is.
    pub fn is_by_one_vertex(&self) -> bool {
        self.largest > MAX_DEFECT
    }
}

/// What is wrong, in a sentence that names it.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Error {
    /// A surface and its values do not belong together.
    #[error("{vertices} vertices need as many distances, not {distances}")]
    CountMismatch {
        /// Positions given.
        vertices: usize,
        /// Distances given.
        distances: usize,
    },
    /// A triangle names a vertex that is not there.
    #[error("triangle {triangle} uses vertex {vertex}, and there are {vertices}, counted from 0")]
    IndexOutOfRange {
        /// Counted from 0.
        triangle: usize,
        /// Counted from 0.
        vertex: usize,
        /// How many there are.
        vertices: usize,
    },
    /// A position that is no place, or a distance that is no number.
    #[error("vertex {vertex} has a {what} that is not a number")]
    NotANumber {
        /// Counted from 0.
        vertex: usize,
        /// `position` or `distance`.
        what: &'static str,
    },
    /// No value to draw an isoline at.
    #[error("no isoline: {reason}")]
    NoLevel {
        /// What to change.
        reason: String,
    },
    /// More values than are traced at once.
    #[error("these are {levels:.0} isolines, and {MOST_LEVELS} are drawn at most; choose a larger spacing")]
    TooManyLevels {
        /// How many were asked for.
        levels: f64,
    },
    /// More vertices than indices can number.
    #[error("the strips have more vertices than 32 bits can number; choose fewer isolines")]
    TooManyVertices,
    /// A strip that the plane cannot take.
    #[error(transparent)]
    NotDevelopable(#[from] NotDevelopable),
}

/// What a fallible call returns.
pub type Result<T> = std::result::Result<T, Error>;
