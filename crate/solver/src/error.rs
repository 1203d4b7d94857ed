//! What can go wrong, with the element at fault and a remedy.

use strum::IntoStaticStr;
use thiserror::Error;

use crate::choice::UnknownChoice;

/// Result with this crate's [`enum@Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every failure of the crate. The message is one sentence for a person: what is wrong, where, what to do.
#[derive(Debug, Clone, PartialEq, Error, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A file that cannot be read, triangles that make no surface, or a place that is not on it.
    #[error(transparent)]
    Surface(#[from] heatwalk_surface::Error),
    /// A distance was asked for without a source.
    #[error("no source: give at least one")]
    NoSource,
    /// A parameter is outside its range.
    #[error("{name} is {value}; it must be {range}")]
    BadParameter {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: String,
        /// The range allowed.
        range: &'static str,
    },
    /// A side of an intrinsic triangle is glued to one that does not fit.
    #[error(
        "side {side} is not glued to another one that is glued back, runs between the same vertices the other way and is as long"
    )]
    BadGlue {
        /// The side, `3 f + k` for side `k` of face `f`.
        side: usize,
    },
    /// A vertex has no tangent plane.
    #[error(
        "the triangles at vertex {vertex} are not one fan in a sheet of its own, so it has no tangent plane; take a vertex for each fan"
    )]
    NoTangentPlane {
        /// The vertex.
        vertex: usize,
    },
    /// A name that is none of the choices.
    #[error(transparent)]
    UnknownChoice(#[from] UnknownChoice),
    /// A matrix could not be factored.
    #[error(
        "the {matrix} matrix is not positive definite at vertex {vertex}: the triangles around it are degenerate; choose the Delaunay operator or repair the mesh there"
    )]
    NotPositiveDefinite {
        /// Which matrix: heat or Poisson.
        matrix: &'static str,
        /// Welded vertex of the failing pivot.
        vertex: usize,
    },
    /// Conjugate gradients did not reach their tolerance.
    #[error("conjugate gradients did not converge in {iterations} steps; choose the Cholesky solver")]
    NotConverged {
        /// Steps done.
        iterations: usize,
    },
    /// A step of conjugate gradients has no finite length.
    #[error(
        "conjugate gradients broke down after {iterations} steps: rounding on thin triangles leaves no positive definite matrix; choose the Cholesky solver"
    )]
    Breakdown {
        /// Steps done.
        iterations: usize,
    },
    /// Arguments of linear algebra that do not fit together.
    #[error(transparent)]
    Algebra(heatwalk_sparse::Error),
    /// The factors do not fit into memory, or not into the [`MemoryLimit`](crate::MemoryLimit) given.
    #[error(
        "factoring takes {} of memory, more than there is; choose conjugate gradients, which need no factors",
        memory_size(*.needed_bytes)
    )]
    TooLarge {
        /// Most bytes that are in use at once while the matrices are factored or solved.
        needed_bytes: u64,
    },
    /// A mesh does not fit into memory, which is found out before it is built.
    #[error(
        "a mesh of {triangles} triangles takes {} of memory, more than the {} there are",
        memory_size(*.needed_bytes),
        memory_size(*.available_bytes)
    )]
    MeshTooLarge {
        /// Of the file.
        triangles: usize,
        /// Most bytes that would be in use at once.
        needed_bytes: u64,
        /// Bytes there are.
        available_bytes: u64,
    },
    /// A mesh fits into memory, but not with so many windows.
    #[error(
        "{windows} windows of each half-edge of {triangles} triangles take {} of memory, more than the {} there are; keep one window, which fits",
        memory_size(*.needed_bytes),
        memory_size(*.available_bytes)
    )]
    TooManyWindows {
        /// Of the file.
        triangles: usize,
        /// Windows asked for.
        windows: u16,
        /// Most bytes that would be in use at once.
        needed_bytes: u64,
        /// Bytes there are.
        available_bytes: u64,
    },
    /// Something else does not fit into memory.
    #[error("out of memory while {stage}")]
    OutOfMemory {
        /// What was being done.
        stage: &'static str,
    },
    /// Exact distances or paths were asked for where faces have different costs.
    #[error(
        "exact distances and paths are not known where faces have different costs; ask for auto, propagation with a number of windows, or heat"
    )]
    NotExact,
    /// Heat was asked of a distance that was found by other means.
    #[error("this distance was not found by heat; ask for the heat method")]
    NoHeat,
    /// Start and source lie on parts that are not connected.
    #[error("no source can be reached from there: the parts are not connected")]
    Unreachable,
    /// A closed curve can be deformed into a point, or all that are asked for.
    #[error(
        "the loop shrinks to a point, because it goes around no handle and no hole; give places on the way around one, or three and more that hold it"
    )]
    Contractible,
    /// The work was stopped by the caller's progress callback.
    #[error("cancelled")]
    Cancelled,
}

impl From<heatwalk_sparse::Error> for Error {
    fn from(error: heatwalk_sparse::Error) -> Self {
        Self::of_matrices(&error, &[])
    }
}

impl Error {
    /// Names the kind of failure, in kebab case. It stays the same between versions; messages may not.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Surface(error) => error.code(),
            Self::Algebra(error) => error.code(),
            _ => self.into(),
        }
    }

    /// Of linear algebra on matrices of these names.
    pub(crate) fn of_matrices(error: &heatwalk_sparse::Error, names: &[&'static str]) -> Self {
        use heatwalk_sparse::Error as Sparse;
        match *error {
            Sparse::Cancelled => Self::Cancelled,
            Sparse::NotPositiveDefinite { matrix, row } => {
                Self::NotPositiveDefinite { matrix: names.get(matrix).copied().unwrap_or("system"), vertex: row }
            }
            Sparse::NotConverged { iterations } => Self::NotConverged { iterations },
            Sparse::OutOfMemory { stage } => Self::OutOfMemory { stage },
            Sparse::Breakdown { iterations } => Self::Breakdown { iterations },
            ref other => Self::Algebra(other.clone()),
        }
    }
}

/// In the unit that suits.
fn memory_size(bytes: u64) -> String {
    let mebibytes = bytes as f64 / f64::from(1 << 20);
    if mebibytes < 1000.0 { format!("{mebibytes:.1} MiB") } else { format!("{:.2} GiB", mebibytes / 1024.0) }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    #[test]
    fn failures_of_conjugate_gradients_are_told_as_such_and_not_as_cancelled() {
        let told = |error: heatwalk_sparse::Error| {
            let error = Error::from(error);
            (error.code(), error.to_string().contains("after 7 steps"), error.to_string().contains("in 7 steps"))
        };
        assert_eq!(told(heatwalk_sparse::Error::Breakdown { iterations: 7 }), ("breakdown", true, false));
        assert_eq!(told(heatwalk_sparse::Error::NotConverged { iterations: 7 }), ("not-converged", false, true));
        assert_eq!(told(heatwalk_sparse::Error::Cancelled).0, "cancelled");
    }
}
