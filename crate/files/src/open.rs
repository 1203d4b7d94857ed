//! Mesh files as readers take them.

use std::fs;
use std::io::{Error, ErrorKind};
use std::path::{Component, Path};

use anyhow::{Context, Result};
use heatwalk_model::io::{self, Budget, Resources, Unpacked, has_extension, without_gz};
use heatwalk_volume::io::Format;

/// A mesh file.
pub struct MeshFile<'a> {
    /// Its name without that of its folder, and without `.gz`.
    pub name: &'a str,
    /// What it holds.
    pub bytes: &'a [u8],
    /// By the size of the file on the disk.
    pub budget: &'a Budget,
    /// What it refers to, beside or below it.
    pub resources: Resources<'a>,
}

/// Reads a file, which may be packed by gzip (`.gz`), or an archive with one mesh and what that refers to (`.zip`).
///
/// # Errors
/// Where the file cannot be read or unpacked, and those of `read`.
pub fn open<T>(path: &Path, read: impl FnOnce(MeshFile) -> Result<T>) -> Result<T> {
    let bytes = read_file(path).with_context(|| format!("cannot read {}", path.display()))?;
    opened(path, &bytes, path.parent(), read)
}

/// The same of the bytes of a file. `folder`: where that is from which it may bring in others.
pub fn opened<T>(
    path: &Path,
    bytes: &[u8],
    folder: Option<&Path>,
    read: impl FnOnce(MeshFile) -> Result<T>,
) -> Result<T> {
    let budget = &Budget::of_file(bytes.len());
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let file = Unpacked::of(budget, &name, bytes, is_mesh).with_context(|| path.display().to_string())?;
    let inside = |uri: &str| file.resource(uri);
    let beside = |uri: &str| {
        let file = folder.filter(|_| is_beside(Path::new(uri)))?.join(uri);
        read_file(&file).ok().and_then(|bytes| budget.admit(bytes).ok())
    };
    let resources: Resources = if file.is_of_archive() { &inside } else { &beside };
    read(MeshFile { name: file.name(), bytes: file.bytes(), budget, resources })
}

/// Whether the file may hold tetrahedra, by its name.
pub fn may_hold_tetrahedra(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    has_extension(&name, "zip") || Format::of_name(without_gz(&name)).is_some()
}

/// Whether a file is a mesh by its name, or may be one that is packed.
pub fn names_mesh(name: &str) -> bool {
    has_extension(name, "zip") || is_mesh(without_gz(name))
}

fn is_mesh(path: &str) -> bool {
    io::names_mesh(path) || Format::of_name(path).is_some()
}

/// Devices and pipes may never end, so only plain files are read.
fn read_file(path: &Path) -> Result<Vec<u8>> {
    if !fs::metadata(path)?.is_file() {
        return Err(Error::new(ErrorKind::InvalidInput, "it is not a file").into());
    }
    Ok(fs::read(path)?)
}

/// A mesh may bring in files beside or below it, never from elsewhere on the disk.
fn is_beside(uri: &Path) -> bool {
    uri.components().all(|component| matches!(component, Component::Normal(_) | Component::CurDir))
}
