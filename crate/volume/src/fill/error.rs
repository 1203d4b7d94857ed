//! Why a surface cannot be filled.

use strum::IntoStaticStr;
use thiserror::Error;

/// Result with this module's [`enum@Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every failure of filling. The message is one sentence that names what is at fault; [`Error::code`] is for programs.
#[derive(Debug, Clone, PartialEq, Error, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// There is no inside, or it cannot be told from the outside.
    #[error(
        "the surface does not enclose a volume: it has {}; close it, or choose parts that are closed",
        if *.holes == 1 {
            format!("a hole of {edges} edges around vertex {vertex}")
        } else {
            format!("{holes} holes, the largest one of {edges} edges around vertex {vertex}")
        }
    )]
    #[strum(serialize = "open-surface")]
    Open {
        /// Boundary loops.
        holes: usize,
        /// Edges of the longest of them.
        edges: usize,
        /// A vertex of the input on that one.
        vertex: u32,
    },
    /// The triangles cannot be oriented, so that they have no inside.
    #[error(
        "inside and outside of the surface cannot be told: its triangles disagree about them; repair the mesh, or choose other parts"
    )]
    NotOriented,
    /// All that is enclosed is thinner than the cells.
    #[error(
        "nothing of the inside is as thick as a cell; choose a finer resolution than {cells:.1} cells along the longest side"
    )]
    TooCoarse {
        /// Cells along the longest side.
        cells: f64,
    },
    /// A resolution that is no number of cells or tetrahedra, or beyond what memory can hold.
    #[error("{name} is {value}; it must be {range}")]
    BadParameter {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: String,
        /// The range allowed.
        range: &'static str,
    },
    /// The lattice does not fit into memory.
    #[error("out of memory while {stage}; choose a coarser resolution")]
    OutOfMemory {
        /// What was being done.
        stage: &'static str,
    },
    /// The work was stopped by the caller's progress callback.
    #[error("cancelled")]
    Cancelled,
}

impl Error {
    /// Names the kind of failure, in kebab case. It stays the same between versions; messages may not.
    pub fn code(&self) -> &'static str {
        self.into()
    }
}
