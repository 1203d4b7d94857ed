//! `cargo xtask cycles`: fails where modules of a crate import each other in a cycle.
//!
//! On every level of the module tree, the children of a module and the module's own code are the nodes: `lib.rs` and
//! the top-level modules, `mod.rs` and the files beside it, and so on. An arrow goes from the module whose code names
//! an item to the module that defines it, followed through re-exports, and to modules that re-export it on the way
//! unless they are its parents. A module that declares and re-exports its children has no arrow to them by that; what
//! it uses of them itself, or they of it, are arrows like any other.
//!
//! What is read are names: imports and paths anywhere in the code under `src`, those in macro calls as tokens. A method
//! called on a value whose type is never named is no arrow. Code under `#[cfg(test)]` is left out, for tests may look
//! at everything, and so are other crates, where cargo itself refuses cycles.

mod arrows;
mod graph;
mod modules;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use self::arrows::arrows;
use self::graph::{Cycle, cycles};
use self::modules::Module;

/// Places that the report names for each arrow.
const SHOWN: usize = 4;

/// Reads the crates in `folder` and fails with the cycles that it finds.
pub fn check(folder: &Path) -> Result<()> {
    let roots = roots(folder)?;
    let mut count = 0;
    let mut found = Vec::new();
    for root in &roots {
        let modules = modules::read(root)?;
        count += modules.len();
        found.extend(cycles(&modules, &arrows(&modules)).iter().map(|cycle| described(cycle, &modules)));
    }
    found.iter().for_each(|cycle| eprintln!("{cycle}"));
    ensure!(found.is_empty(), "Modules use each other in cycles: {}", found.len());
    eprintln!("{count} modules of {} crates, no cycle.", roots.len());
    Ok(())
}

/// `lib.rs` and `main.rs` of every crate.
fn roots(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).with_context(|| format!("{} cannot be read", folder.display()))?;
    let mut roots = Vec::new();
    for entry in entries {
        let source = entry?.path().join("src");
        roots.extend(["lib.rs", "main.rs"].map(|name| source.join(name)).into_iter().filter(|root| root.is_file()));
    }
    ensure!(!roots.is_empty(), "{} holds no crates", folder.display());
    roots.sort();
    Ok(roots)
}

fn described(cycle: &Cycle, modules: &[Module]) -> String {
    let parent = &modules[cycle.parent];
    let name = |node: usize| {
        if node == cycle.parent { parent.file_name() } else { modules[node].name.clone() }
    };
    let nodes: Vec<String> = cycle.steps.iter().map(|step| name(step.from)).collect();
    let mut text = format!("{}: {} → {}\n", parent.folder().display(), nodes.join(" → "), nodes[0]);
    for step in &cycle.steps {
        text += &format!("    {} → {}:\n", name(step.from), name(step.to));
        for arrow in step.arrows.iter().take(SHOWN) {
            text += &format!("        {}:{} {}\n", modules[arrow.from].file.display(), arrow.line, arrow.path);
        }
        if step.arrows.len() > SHOWN {
            text += &format!("        and {} more\n", step.arrows.len() - SHOWN);
        }
    }
    text
}
