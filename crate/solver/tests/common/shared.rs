//! Meshes for comparisons that lie beside the repository, not in it.

use std::path::{Path, PathBuf};

use heatwalk::{Soup, io};

/// Their folder; says so where it is absent.
pub fn shared_meshes(name: &str) -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/meshes").join(name);
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("skipped: {} is absent", folder.display());
    None
}

/// One-dimensional float64 array: ten bytes of magic, version and header length, a header, then the values.
pub fn read_npy(path: &Path) -> Vec<f64> {
    let bytes = std::fs::read(path).expect("a shared file");
    let header = u16::from_le_bytes([bytes[8], bytes[9]]) as usize;
    let values = bytes[10 + header..].chunks_exact(8);
    values.map(|chunk| f64::from_le_bytes(chunk.try_into().expect("eight bytes"))).collect()
}

/// A mesh of one file.
pub fn read_mesh(path: &Path) -> Soup {
    let bytes = std::fs::read(path).expect("a shared mesh");
    io::read(&path.file_name().expect("a file").to_string_lossy(), &bytes, &|_| None).expect("a readable mesh")
}
