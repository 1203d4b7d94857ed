//! Files of tetrahedra from and to bytes. Nothing here touches a file system: a second file comes from the caller.
//!
//! ```
//! use heatwalk_volume::io;
//!
//! let text = "MeshVersionFormatted 2 Dimension 3 \
//!     Vertices 4 0 0 0 0  1 0 0 0  0 1 0 0  0 0 1 0 \
//!     Tetrahedra 1 1 2 3 4 0 End";
//! let file = io::read("corner.mesh", text.as_bytes(), &|_| None)?;
//! assert_eq!(file.soup.tetrahedra, [[0, 1, 2, 3]]);
//! # Ok::<(), io::Error>(())
//! ```

mod cells;
mod error;
mod gmsh;
mod input;
mod medit;
mod tetgen;
mod vtk;
pub mod write;

pub use cells::CellCounts;
pub use error::{Error, Result};

use heatwalk::Soup;
use heatwalk::surface::Error as SurfaceError;
use heatwalk_model::Error as FileError;
use heatwalk_model::io::{Budget, Resources, expect_mesh, text};

use self::cells::NamedMesh;
use crate::soup::TetSoup;

/// Formats of tetrahedral meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// `.mesh`, `.meshb`.
    Medit,
    /// `.msh`.
    Gmsh,
    /// `.vtk`, `.vtu`; such a file may also hold a surface.
    Vtk,
    /// `.node` with `.ele`.
    TetGen,
}

/// What extensions of files stand for.
const EXTENSIONS: [(&str, Format); 7] = [
    ("ele", Format::TetGen),
    ("mesh", Format::Medit),
    ("meshb", Format::Medit),
    ("msh", Format::Gmsh),
    ("node", Format::TetGen),
    ("vtk", Format::Vtk),
    ("vtu", Format::Vtk),
];

impl Format {
    /// The format of a file: by its first bytes where they tell, else by the extension of its name.
    pub fn of(name: &str, bytes: &[u8]) -> Option<Self> {
        let bytes = text::decoded(bytes).unwrap_or_default();
        if gmsh::has_header(bytes) {
            Some(Self::Gmsh)
        } else if medit::has_header(bytes) {
            Some(Self::Medit)
        } else if heatwalk_model::io::vtk::has_header(bytes) {
            Some(Self::Vtk)
        } else {
            Self::of_name(name)
        }
    }

    /// The format that an extension stands for.
    pub fn of_name(name: &str) -> Option<Self> {
        let (_, extension) = stem_and_extension(name);
        EXTENSIONS.into_iter().find(|(known, _)| extension.eq_ignore_ascii_case(known)).map(|(_, format)| format)
    }
}

/// What a file holds.
#[derive(Debug, Clone, PartialEq)]
pub struct TetFile {
    /// Its tetrahedra, those that other cells were split into among them, in file order, over all its vertices.
    pub soup: TetSoup,
    /// What the cells were in the file.
    pub cells: CellCounts,
}

/// Reads tetrahedra. The first bytes tell the format where they can, the extension of `name` otherwise. Of the two files of TetGen
/// either may be given; `resources` is asked for the other one.
///
/// # Errors
/// [`Error::UnknownFormat`]; [`Error::File`] where the file is damaged, needs what is not read here, or the second file is
/// missing; [`Error::NoSuchVertex`]; [`Error::NoTetrahedra`] where nothing in the file fills space.
pub fn read(name: &str, bytes: &[u8], resources: Resources) -> Result<TetFile> {
    with_budget(bytes, resources, |budget, resources| read_within(budget, name, bytes, resources))
}

/// As [`read`], with what is left of a budget. What `resources` gives is for the caller to count.
///
/// # Errors
/// As [`read`].
pub fn read_within(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<TetFile> {
    finished(budget, tetrahedra(budget, name, bytes, resources))
}

fn tetrahedra(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<TetFile> {
    let (soup, cells) = match contents(budget, name, bytes, resources)? {
        Contents::Named(mesh) => mesh.tetrahedra()?,
        Contents::Vtk(bytes) => vtk::read(budget, bytes)?,
    };
    if cells.volumes() == 0 {
        let remedy = if cells.faces > 0 { "read it as a surface" } else { "save the cells with their vertices" };
        return Err(Error::NoTetrahedra { name: name.to_owned(), faces: cells.faces, remedy });
    }
    Ok(TetFile { soup, cells })
}

/// Reads the triangles and quadrilaterals of a file as a surface.
///
/// # Errors
/// As [`read`], and [`Error::File`] with [`Empty`](SurfaceError::Empty) where there is no face.
pub fn read_surface(name: &str, bytes: &[u8], resources: Resources) -> Result<Soup> {
    with_budget(bytes, resources, |budget, resources| read_surface_within(budget, name, bytes, resources))
}

/// As [`read_surface`], with what is left of a budget. What `resources` gives is for the caller to count.
///
/// # Errors
/// As [`read_surface`].
pub fn read_surface_within(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Soup> {
    finished(budget, surface(budget, name, bytes, resources))
}

fn surface(budget: &Budget, name: &str, bytes: &[u8], resources: Resources) -> Result<Soup> {
    let soup = match contents(budget, name, bytes, resources)? {
        Contents::Named(mesh) => mesh.surface(stem_and_extension(name).0)?,
        Contents::Vtk(bytes) => return Ok(heatwalk_model::io::read_within(budget, name, bytes, resources)?.soup),
    };
    if soup.triangles.is_empty() {
        let reason = format!("{name} holds neither tetrahedra nor faces; save the cells with their vertices");
        return Err(FileError::from(SurfaceError::Empty { reason }).into());
    }
    Ok(soup)
}

/// Reads by a budget of the file's own, which what `resources` gives is counted against.
fn with_budget<T>(bytes: &[u8], resources: Resources, read: impl FnOnce(&Budget, Resources) -> Result<T>) -> Result<T> {
    let budget = Budget::of_file(bytes.len());
    read(&budget, &|uri| budget.admit(resources(uri)?).ok())
}

/// What was read, unless the budget had no room for all of it: a second file that it has no room for is as if it were missing.
fn finished<T>(budget: &Budget, read: Result<T>) -> Result<T> {
    budget.finish()?;
    read
}

/// A file before it is known whether tetrahedra or a surface is wanted.
enum Contents<'a> {
    Named(NamedMesh<'a>),
    /// Its text, not read yet: cells of VTK count vertices from 0 without gaps.
    Vtk(&'a [u8]),
}

fn contents<'a>(budget: &'a Budget, name: &str, bytes: &'a [u8], resources: Resources) -> Result<Contents<'a>> {
    let bytes = decoded(name, bytes)?;
    let format = Format::of(name, bytes).ok_or_else(|| Error::UnknownFormat { name: name.to_owned() })?;
    let mesh = match format {
        Format::Vtk => return Ok(Contents::Vtk(bytes)),
        Format::Medit => medit::read(budget, bytes)?,
        Format::Gmsh => gmsh::read(budget, bytes)?,
        Format::TetGen => {
            let (stem, extension) = stem_and_extension(name);
            let has_nodes = extension.eq_ignore_ascii_case("node");
            let uri = format!("{stem}.{}", if has_nodes { "ele" } else { "node" });
            let other = resources(&uri).ok_or_else(|| FileError::MissingResource { uri: uri.clone() })?;
            let other = decoded(&uri, &other)?;
            let (nodes, elements) = if has_nodes { (bytes, other) } else { (other, bytes) };
            tetgen::read(budget, nodes, elements)?
        }
    };
    Ok(Contents::Named(mesh))
}

/// What a file holds as text, where that may be a mesh.
fn decoded<'a>(name: &str, bytes: &'a [u8]) -> Result<&'a [u8]> {
    let bytes = text::decoded(bytes)?;
    expect_mesh(name, bytes)?;
    Ok(bytes)
}

fn stem_and_extension(name: &str) -> (&str, &str) {
    let file_name = name.rsplit(['/', '\\']).next().unwrap_or(name);
    file_name.rsplit_once('.').unwrap_or((file_name, ""))
}
