//! The contract between Rust and TypeScript: names, ranges and options that Rust defines, as a module of the page.
//!
//! It is read from the source, so that the page is built without compiling the solver for this machine too. A test compares
//! it with the solver's own values.

mod read;
mod typescript;

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use self::read::Definitions;

pub use self::read::doc;
pub use self::typescript::{camel, documented};

/// What defines the contract, in the order in which it is written.
const SOURCES: [&str; 3] =
    ["crate/solver/src/options.rs", "crate/sparse/src/progress.rs", "crate/bindings/src/failure.rs"];

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
    typescript::module(&definitions, &SOURCES, &ENUMS)
}

#[cfg(test)]
mod tests;
