//! What can go wrong with a file of tetrahedra.

use strum::IntoStaticStr;
use thiserror::Error;

/// Result with this module's [`enum@Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every failure of reading. The message is one sentence that names what is at fault; [`Error::code`] is for programs.
#[derive(Debug, Clone, PartialEq, Error, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// The file breaks the rules of its format, needs what is not read here, or refers to a file that was not given.
    #[error(transparent)]
    File(#[from] heatwalk_model::Error),
    /// The file's extension and first bytes match no reader.
    #[error(
        "{name}: not a format of tetrahedral meshes known here; use Medit (.mesh, .meshb), Gmsh (.msh), VTK (.vtu, .vtk) or TetGen (.node with .ele)"
    )]
    UnknownFormat {
        /// File name as given.
        name: String,
    },
    /// The file was read, but nothing in it fills space.
    #[error("{name} holds no tetrahedra{}; {remedy}", if *.faces > 0 { format!(", but {faces} faces of a surface") } else { String::new() })]
    NoTetrahedra {
        /// File name as given.
        name: String,
        /// Cells that are triangles, quadrilaterals or polygons.
        faces: usize,
        /// What to do.
        remedy: &'static str,
    },
    /// A cell names a vertex that does not exist.
    #[error("{format}: {element} {index} refers to vertex {vertex}, which does not exist; repair the file")]
    NoSuchVertex {
        /// Format, for example `"Gmsh"`.
        format: &'static str,
        /// What names it: a `cell` that fills space, or a `face`.
        element: &'static str,
        /// Which one of these, counted from 0 in file order.
        index: usize,
        /// The vertex it names, as the file counts.
        vertex: u64,
    },
}

impl Error {
    /// Names the kind of failure, in kebab case. It stays the same between versions; messages may not.
    pub fn code(&self) -> &'static str {
        match self {
            Self::File(error) => error.code(),
            _ => self.into(),
        }
    }
}
