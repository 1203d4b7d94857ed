//! How far long work is, and whether it shall go on. The crates above tell it the same way.

use std::fmt;
use std::ops::ControlFlow;

use crate::error::{Error, Result};

/// A stage of long work.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stage {
    /// Building the triangulation and the matrices.
    Assembling,
    /// Choosing the elimination order.
    Ordering,
    /// Finding the pattern of the factors.
    Analysing,
    /// Factoring matrices.
    Factoring,
    /// Searching outward from sources.
    Searching {
        /// Every distance below this one, in the file's unit, is final.
        radius: f64,
    },
    /// Answering several questions.
    Answering,
    /// Filling a solid with tetrahedra.
    Filling,
}

impl fmt::Display for Stage {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Assembling => "Assembling",
            Self::Ordering => "Ordering",
            Self::Analysing => "Analysing",
            Self::Factoring => "Factoring",
            Self::Searching { .. } => "Searching",
            Self::Answering => "Answering",
            Self::Filling => "Filling",
        })
    }
}

/// Called before each stage, and some milliseconds apart in it, with the share of the work done so far, 0 to 1; that of a
/// search is the share of the largest distance asked for. `Break` ends the work with an error that says so.
pub type Progress<'a> = &'a mut dyn FnMut(Stage, f64) -> ControlFlow<()>;

/// Progress that nobody asks about: as `&mut go_on`.
pub fn go_on(_: Stage, _: f64) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Tells progress.
///
/// # Errors
/// [`Error::Cancelled`] where it does not go on.
pub fn report(progress: Progress<'_>, stage: Stage, done: f64) -> Result<()> {
    if progress(stage, done).is_break() { Err(Error::Cancelled) } else { Ok(()) }
}
