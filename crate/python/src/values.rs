//! Values of vertices as files.

use std::fs;
use std::path::PathBuf;

use anyhow::Context;
use heatwalk_model::io::write::overlay::Overlay;
use pyo3::prelude::*;

use crate::arrays::Given;
use crate::errors::{Failure, Result};
use crate::interrupt::run;
use crate::mesh::Mesh;

#[pymethods]
impl Mesh {
    /// Write values of vertices for programs that show brains, in 32 bits: a GIFTI file (`.shape.gii`, `.func.gii`) or one of FreeSurfer
    /// (`.mgh`, `.curv`), by how `path` ends.
    ///
    /// `values`: (n,) floats, or (k, n) of several columns, which `.curv` has not.
    ///
    /// Raises OSError where the file cannot be written, HeatwalkError for another ending or shape.
    fn write_values(&self, py: Python<'_>, path: PathBuf, values: &Bound<'_, PyAny>) -> PyResult<()> {
        let values = Given::new("values", values)?;
        let (vertices, faces) = (self.soup().positions.len(), self.soup().triangles.len());
        let values =
            if values.dimensions() == 1 { values.row(Some(vertices))? } else { values.rows(vertices)? }.floats()?;
        run(py, None, move |_| {
            let overlay = overlay(&path)?;
            let rows: Vec<(String, &[f64])> = values
                .chunks_exact(vertices.max(1))
                .enumerate()
                .map(|(number, row)| (number.to_string(), row))
                .collect();
            let most = if overlay.has_columns() { usize::MAX } else { 1 };
            if !(1..=most).contains(&rows.len()) {
                let sentence = format!("{}: there are {} columns of values; give one", path.display(), rows.len());
                return Err(Failure::new("bad-shape", sentence));
            }
            let named: Vec<(&str, &[f64])> = rows.iter().map(|(name, row)| (name.as_str(), *row)).collect();
            let written = fs::write(&path, overlay.bytes(&named, faces));
            Ok(written.with_context(|| format!("cannot write {}", path.display()))?)
        })
    }
}

/// By the end of a name.
fn overlay(path: &std::path::Path) -> Result<Overlay> {
    let name = path.to_string_lossy().to_ascii_lowercase();
    let found = Overlay::ALL.into_iter().find(|overlay| name.ends_with(&format!(".{}", overlay.ending())));
    found.ok_or_else(|| {
        let known = Overlay::ALL.map(|overlay| format!(".{}", overlay.ending())).join(", ");
        Failure::new("unknown-format", format!("{}: values are written as {known}", path.display()))
    })
}
