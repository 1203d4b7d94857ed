//! The contract between Rust and TypeScript: names, ranges, options and extensions of files that Rust defines, as a module of the page.
//!
//! It is read from the source, so that the page is built without compiling the solver for this machine too. A test compares
//! it with the solver's own values.

mod read;
mod typescript;

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};

use self::read::{Constant, Definitions, Value};

pub use self::read::doc;
pub use self::typescript::{camel, documented};

/// What defines most of the contract, in the order in which it is written.
const SOURCES: [&str; 3] =
    ["crate/solver/src/options.rs", "crate/sparse/src/progress.rs", "crate/bindings/src/failure.rs"];

/// Folders of readers, what the extensions of all their formats are called, and what these are.
const READERS: [(&str, &str, &str); 3] = [
    ("crate/model/src/io", "SURFACE_EXTENSIONS", "Extensions of files that may hold surfaces."),
    ("crate/volume/src/io", "TETRAHEDRON_EXTENSIONS", "Extensions of files that may hold tetrahedra."),
    ("crate/cloud/src", "POINT_EXTENSIONS", "Extensions of text whose lines are points."),
];

/// Enums that are the names of their variants to the page.
const ENUMS: [&str; 1] = ["Stage"];

/// Where the page finds it.
const MODULE: &str = "web/wasm/contract.ts";

/// Writes the page's module; leaves it alone where it is as it should be.
///
/// # Errors
/// Where a source cannot be read, or defines something in a way that is not understood.
pub fn write(workspace: &Path) -> Result<()> {
    let text = module(workspace)?;
    let path = workspace.join(MODULE);
    if fs::read_to_string(&path).is_ok_and(|written| written == text) {
        return Ok(());
    }
    fs::create_dir_all(path.parent().expect("it lies in a folder"))?;
    fs::write(&path, text).with_context(|| format!("{} cannot be written", path.display()))
}

fn module(workspace: &Path) -> Result<String> {
    let mut definitions = Definitions::default();
    for source in SOURCES {
        let text = fs::read_to_string(workspace.join(source)).with_context(|| format!("{source} cannot be read"))?;
        definitions.read(&text).with_context(|| format!("{source} is not understood"))?;
    }
    for (folder, name, doc) in READERS {
        let value = Value::Words(extensions_in(&workspace.join(folder))?);
        definitions.constants.push(Constant { of: None, name: name.to_owned(), doc: vec![doc.to_owned()], value });
    }
    typescript::module(&definitions, &SOURCES, &ENUMS)
}

/// Of the formats of a folder, each a file of it or a folder with a `mod.rs`; in order.
fn extensions_in(folder: &Path) -> Result<Vec<String>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| format!("{} cannot be read", folder.display()))? {
        let path = entry?.path();
        let source = if path.is_dir() { path.join("mod.rs") } else { path };
        if !source.is_file() {
            continue;
        }
        let text = fs::read_to_string(&source).with_context(|| format!("{} cannot be read", source.display()))?;
        found.extend(read::extensions(&text).with_context(|| format!("{} is not understood", source.display()))?);
    }
    ensure!(!found.is_empty(), "{} has no format", folder.display());
    found.sort();
    Ok(found)
}

#[cfg(test)]
mod tests;
