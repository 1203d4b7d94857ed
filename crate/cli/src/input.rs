//! Mesh files and what they refer to.

use std::fs;
use std::path::{Component, Path};
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use heatwalk::{Soup, Surface, SurfacePoint, error, io};

use crate::args::Mesh;
use crate::report::milliseconds;

/// The chosen parts of a file.
pub struct Input {
    /// All of the file.
    pub file: Soup,
    /// The chosen parts; vertices on the command line count in it.
    pub soup: Soup,
    pub read_ms: f64,
}

impl Input {
    pub fn read(mesh: &Mesh) -> Result<Self> {
        let start = Instant::now();
        let path = &mesh.mesh;
        let bytes = read_file(path).with_context(|| format!("cannot read {}", path.display()))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let companion = |uri: &str| beside(Path::new(uri)).then(|| read_file(&folder.join(uri)).ok()).flatten();
        let file = io::read(&name, &bytes, &companion).with_context(|| path.display().to_string())?;
        let read_ms = milliseconds(start);
        let all: Vec<usize> = (0..file.parts.len()).collect();
        let soup = file.select(if mesh.parts.is_empty() { &all } else { &mesh.parts })?;
        Ok(Self { file, soup, read_ms })
    }

    /// Fails early, before the surface is built, for a vertex that does not exist.
    pub fn check_vertices(&self, vertices: &[usize]) -> Result<()> {
        let count = self.soup.positions.len();
        match vertices.iter().find(|&&vertex| vertex >= count) {
            None => Ok(()),
            Some(&vertex) => {
                let problem = format!("does not exist; there are {count}, counted from 0");
                Err(error::Error::BadVertex { vertex, problem }.into())
            }
        }
    }
}

/// The welded point of an input vertex.
pub fn point_of_vertex(surface: &Surface, vertex: usize) -> Result<SurfacePoint> {
    let point = surface.point_of_input.get(vertex).copied().flatten();
    let point = point.ok_or_else(|| error::Error::BadVertex {
        vertex,
        problem: "is used by no triangle; choose another".to_owned(),
    })?;
    Ok(SurfacePoint::Vertex(point))
}

/// Devices and pipes may never end, so only plain files are read.
fn read_file(path: &Path) -> Result<Vec<u8>> {
    ensure!(fs::metadata(path)?.is_file(), "it is not a file");
    Ok(fs::read(path)?)
}

/// A mesh may bring in files beside or below it, never from elsewhere on the disk.
fn beside(uri: &Path) -> bool {
    uri.components().all(|component| matches!(component, Component::Normal(_) | Component::CurDir))
}
