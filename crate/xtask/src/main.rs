//! Build steps that need Rust: `cargo xtask wasm [--quick]`, `cargo xtask wasm-package`, `cargo xtask contract`,
//! `cargo xtask test-wasm [NAME]`, `cargo xtask clippy-wasm`; and a check, `cargo xtask cycles [FOLDER]`.

mod cycles;
mod modules;
mod toolchain;
mod wasm_tests;
mod workspace;

use std::path::Path;

use anyhow::{Result, bail};

use crate::toolchain::Toolchain;
use crate::workspace::workspace;

const USAGE: &str =
    "usage: cargo xtask wasm [--quick] | wasm-package | contract | test-wasm [NAME] | clippy-wasm | cycles [FOLDER]";

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["wasm"] => {
            heatwalk_contract::write(workspace())?;
            modules::publish_all(&Toolchain::find()?)
        }
        ["wasm", "--quick"] => {
            heatwalk_contract::write(workspace())?;
            modules::build_all_quickly(&Toolchain::find()?)
        }
        ["wasm-package"] => modules::publish(&modules::PACKAGE, &Toolchain::find()?),
        ["contract"] => heatwalk_contract::write(workspace()),
        ["test-wasm", names @ ..] => wasm_tests::run_all(&Toolchain::find()?, names),
        ["clippy-wasm"] => modules::clippy(&Toolchain::find()?),
        ["cycles"] => cycles::check(Path::new("crate")),
        ["cycles", folder] => cycles::check(Path::new(folder)),
        _ => bail!(USAGE),
    }
}
