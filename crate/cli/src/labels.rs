//! Files of labels on the command line: `FILE#NAME`, or the file alone.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use clap::ValueEnum;
use heatwalk_model::io::labels::Labels;
use heatwalk_model::io::read_labels;

/// Stands between a file and the name of one of its labels.
const NAME: char = '#';

/// Which distance two parcels have.
#[derive(Debug, Clone, Copy, Default, ValueEnum)]
pub enum Between {
    #[default]
    Mean,
    Minimum,
}

/// The vertices of the label that is named, as the file counts them; none where the file is not one of labels, by its name.
pub fn named_vertices(path: &Path) -> Result<Option<Vec<usize>>> {
    let Some(text) = path.to_str() else { return Ok(None) };
    let (file, name) = match text.rsplit_once(NAME) {
        Some((file, name)) if Labels::are_in(file) => (file, Some(name)),
        _ if Labels::are_in(text) => (text, None),
        _ => return Ok(None),
    };
    let labels = read(Path::new(file))?;
    let Some(name) = name else {
        bail!("{file} has labels; name one of them, as in {file}{NAME}{}: {}", labels.names[0], known(&labels));
    };
    let mut found = (0..labels.names.len()).filter(|&label| labels.names[label] == name).peekable();
    ensure!(found.peek().is_some(), "{file} has no label {name:?}; it has {}", known(&labels));
    let mut vertices: Vec<usize> = found.flat_map(|label| labels.vertices(label).collect::<Vec<_>>()).collect();
    ensure!(!vertices.is_empty(), "{file}: no vertex has the label {name:?}");
    vertices.sort_unstable();
    Ok(Some(vertices))
}

/// The labels of all vertices of a surface with so many.
pub fn of_surface(path: &Path, vertices: usize) -> Result<Labels> {
    let labels = read(path)?;
    require_vertices(path, labels.of_vertices.len(), vertices)?;
    Ok(labels)
}

fn read(path: &Path) -> Result<Labels> {
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    let labels = read_labels(&bytes).with_context(|| path.display().to_string())?;
    ensure!(!labels.names.is_empty(), "{}: the file names no label", path.display());
    Ok(labels)
}

fn require_vertices(path: &Path, labels: usize, vertices: usize) -> Result<()> {
    ensure!(
        labels == vertices,
        "{} labels {labels} vertices, and the surface has {vertices}; give labels of this surface",
        path.display()
    );
    Ok(())
}

fn known(labels: &Labels) -> String {
    labels.names.join(", ")
}
