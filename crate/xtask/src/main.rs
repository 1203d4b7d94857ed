//! Build steps that need Rust: `cargo xtask wasm [solver|reader|maker|viewer|interior|curves|basis]`, `cargo xtask contract`, `cargo xtask test-wasm`,
//! `cargo xtask clippy-wasm`; and a check, `cargo xtask cycles [FOLDER]`.

mod contract;
mod cycles;
mod modules;
mod toolchain;
mod workspace;

use std::path::Path;

use anyhow::{Result, bail};

use crate::modules::{BASIS, CURVES, INTERIOR, MAKER, READER, SOLVER, VIEWER_WEBGL2, VIEWER_WEBGPU};
use crate::toolchain::Toolchain;
use crate::workspace::workspace;

const USAGE: &str = "usage: cargo xtask wasm [solver|reader|maker|viewer|interior|curves|basis] | contract | test-wasm | clippy-wasm | cycles [FOLDER]";

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["wasm"] => {
            let toolchain = Toolchain::find()?;
            contract::write(workspace())?;
            modules::build_all(&toolchain)
        }
        ["wasm", "solver"] => {
            contract::write(workspace())?;
            modules::build(&SOLVER, &Toolchain::find()?)
        }
        ["wasm", "viewer"] => {
            let toolchain = Toolchain::find()?;
            modules::build(&VIEWER_WEBGPU, &toolchain)?;
            modules::build(&VIEWER_WEBGL2, &toolchain)
        }
        ["wasm", "reader"] => modules::build(&READER, &Toolchain::find()?),
        ["wasm", "maker"] => modules::build(&MAKER, &Toolchain::find()?),
        ["wasm", "curves"] => modules::build(&CURVES, &Toolchain::find()?),
        ["wasm", "interior"] => modules::build(&INTERIOR, &Toolchain::find()?),
        ["wasm", "basis"] => modules::build(&BASIS, &Toolchain::find()?),
        ["contract"] => contract::write(workspace()),
        ["test-wasm"] => modules::test_solver(&Toolchain::find()?),
        ["clippy-wasm"] => modules::clippy(&Toolchain::find()?),
        ["cycles"] => cycles::check(Path::new("crate")),
        ["cycles", folder] => cycles::check(Path::new(folder)),
        // Cargo calls this with the test's .wasm file as the first argument: see `modules::test_solver`.
        ["test-runner", ..] => {
            wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(std::env::args_os().skip(1))
        }
        _ => bail!(USAGE),
    }
}
