//! Which meshes.

use std::fs;
use std::path::{Component, Path, PathBuf};

use anyhow::{Context, Result, ensure};
use heatwalk_files::meshes_in;
use heatwalk_model::io::text;

use crate::input::SHAPE;

/// A mesh and what it is called.
#[derive(Debug, PartialEq)]
pub struct Named {
    pub mesh: PathBuf,
    /// Its path without the extension, of steps downward alone.
    pub name: String,
}

/// Those of a folder, without what is in `output`, or of a list.
pub fn meshes(path: &Path, output: &Path) -> Result<Vec<Named>> {
    let cannot_read = || format!("cannot read {}", path.display());
    let meshes: Vec<Named> = if fs::metadata(path).with_context(cannot_read)?.is_dir() {
        let found = meshes_in(path, output).with_context(cannot_read)?;
        let below = |mesh: &PathBuf| name(mesh.strip_prefix(path).unwrap_or(mesh));
        found.into_iter().map(|mesh| Named { name: below(&mesh), mesh }).collect()
    } else {
        let bytes = fs::read(path).with_context(cannot_read)?;
        let text = String::from_utf8_lossy(text::decoded(&bytes).with_context(|| path.display().to_string())?);
        let lines =
            text::lines(&text).map(|(_, line)| line.trim()).filter(|line| !line.is_empty() && !line.starts_with('#'));
        lines.map(|line| Named { name: name(Path::new(line)), mesh: line.into() }).collect()
    };
    ensure!(
        !meshes.is_empty(),
        "{}: there is no mesh; give a folder with mesh files, or a text file with one a line",
        path.display()
    );
    Ok(meshes)
}

fn name(path: &Path) -> String {
    let path = path.to_str().and_then(|path| path.strip_prefix(SHAPE)).map_or(path, Path::new);
    let without = if path.extension().is_some_and(|extension| extension == "gz") {
        path.with_extension("")
    } else {
        path.to_owned()
    };
    let stem = without.with_extension("");
    let steps = stem.components().filter_map(|step| match step {
        Component::Normal(step) => Some(step.to_string_lossy()),
        _ => None,
    });
    steps.collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::name;

    #[test]
    fn names_are_paths_downward_without_extensions() {
        for (path, expected) in [
            ("a.off", "a"),
            ("x/a.b.off", "x/a.b"),
            ("../x/./a.vtk.gz", "x/a"),
            ("/scans/a.obj", "scans/a"),
            ("shape:torus", "torus"),
        ] {
            assert_eq!(name(Path::new(path)), expected);
        }
    }
}
