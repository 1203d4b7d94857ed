//! Mesh files on the disk: unpacked, with the files that they refer to, and places inside of their tetrahedra. What programs and packages share, and no page needs.

mod folder;
mod open;
mod place;

use std::path::Path;

use anyhow::{Context, Result};
use heatwalk_model::io::{self, Budget, Resources};
use heatwalk_model::{Error, Model};
use heatwalk_volume::io::{self as volume, Format, TetFile};

pub use folder::meshes_in;
pub use open::{MeshFile, open};
pub use place::{TetPlace, TetPlaceError};

/// Reads the surface of a file; of tetrahedra their boundary.
///
/// # Errors
/// With the path, what is wrong with the file.
pub fn read_surface(path: &Path) -> Result<Model> {
    open(path, |file| surface_of(&file, path, io::read_within))
}

/// The same, or points without faces: then the model has no triangles, and all its vertices are points.
///
/// # Errors
/// As [`read_surface`].
pub fn read_surface_or_points(path: &Path) -> Result<Model> {
    open(path, |file| surface_of(&file, path, heatwalk_cloud::read_within))
}

/// As [`read_surface_or_points`], of bytes that are not on the disk, in which nothing else is referred to. The extension of `name` tells the format
/// where the first bytes do not.
///
/// # Errors
/// With the name, what is wrong with the bytes.
pub fn surface_or_points_of_bytes(name: &str, bytes: &[u8]) -> Result<Model> {
    open::opened(Path::new(name), bytes, None, |file| surface_of(&file, Path::new(name), heatwalk_cloud::read_within))
}

/// The tetrahedra of a file; none where it is of a format of surfaces, or its cells are those of a surface.
///
/// # Errors
/// As [`read_surface`].
pub fn read_tetrahedra(path: &Path) -> Result<Option<TetFile>> {
    if !open::may_hold_tetrahedra(path) {
        return Ok(None);
    }
    open(path, |file| {
        if Format::of_name(file.name).is_none() {
            return Ok(None);
        }
        match volume::read_within(file.budget, file.name, file.bytes, file.resources) {
            Ok(file) => Ok(Some(file)),
            // It may be a surface; what is wrong with it otherwise is told by the reader of surfaces.
            Err(volume::Error::NoTetrahedra { .. }) => Ok(None),
            Err(error) => Err(error).with_context(|| path.display().to_string()),
        }
    })
}

/// The kind of failure of a reader, as its error names it.
#[must_use]
pub fn code(error: &anyhow::Error) -> Option<&'static str> {
    error.chain().find_map(|cause| {
        let model = || cause.downcast_ref::<Error>().map(Error::code);
        let surface = || cause.downcast_ref::<heatwalk_surface::Error>().map(heatwalk_surface::Error::code);
        cause.downcast_ref::<volume::Error>().map(volume::Error::code).or_else(model).or_else(surface)
    })
}

type Read = fn(&Budget, &str, &[u8], Resources<'_>) -> heatwalk_model::Result<Model>;

fn surface_of(file: &MeshFile, path: &Path, read: Read) -> Result<Model> {
    if Format::of_name(file.name).is_some() {
        let soup = volume::read_surface_within(file.budget, file.name, file.bytes, file.resources);
        return Ok(soup.with_context(|| path.display().to_string())?.into());
    }
    match read(file.budget, file.name, file.bytes, file.resources) {
        // It names the file itself.
        Err(error @ Error::UnknownFormat { .. }) => Err(error.into()),
        read => read.with_context(|| path.display().to_string()),
    }
}
