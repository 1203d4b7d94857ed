//! The meshes of a folder.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::open::names_mesh;

/// The mesh files of a folder and of those within it, by their names and in the order of these; packed ones, too. Without hidden files, without
/// text files of points, and without the folder `except`.
///
/// # Errors
/// A folder that cannot be read.
pub fn meshes_in(folder: &Path, except: &Path) -> io::Result<Vec<PathBuf>> {
    let mut meshes = Vec::new();
    let mut entries = fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let path = entry.path();
        let name = entry.file_name().to_string_lossy().into_owned();
        if name.starts_with('.') {
            continue;
        }
        // Links are followed to files, not to folders, which may be around the link.
        if entry.file_type()?.is_dir() {
            if fs::canonicalize(&path)? != except {
                meshes.extend(meshes_in(&path, except)?);
            }
        } else if names_mesh(&name) && path.is_file() && !is_second(&path) {
            meshes.push(path);
        }
    }
    Ok(meshes)
}

/// Of a pair of files of TetGen, which is one mesh.
fn is_second(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "ele") && path.with_extension("node").is_file()
}
