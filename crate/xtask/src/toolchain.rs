//! The compiler and the standard library for wasm32-unknown-unknown, by the first way that this machine offers.

use std::path::Path;
use std::process::Command;

use anyhow::{Result, bail};

/// The target of the wasm modules.
pub const TARGET: &str = "wasm32-unknown-unknown";

/// Debian's compiler, which comes with the source of the standard library.
const DEBIAN_RUSTC: &str = "/usr/bin/rustc";
const DEBIAN_LINKER: &str = "/usr/bin/rust-lld";
const DEBIAN_CLIPPY: &str = "/usr/bin/clippy-driver";

/// How the standard library for wasm32 comes about.
pub enum Toolchain {
    /// It is installed for the active compiler: an ordinary build.
    Installed,
    /// Debian's compiler builds it from Debian's source, with the code that it compiles.
    BuildStd,
}

impl Toolchain {
    /// The first way that works.
    pub fn find() -> Result<Self> {
        if target_is_installed() {
            return Ok(Self::Installed);
        }
        if debian_is_installed() {
            return Ok(Self::BuildStd);
        }
        bail!(
            "There is no Rust standard library for {TARGET}. Run `rustup target add {TARGET}`; where there is no rustup, \
             `npm run check` installs Debian's."
        )
    }

    /// `cargo COMMAND` for wasm32 with this toolchain; `clippy` runs the linter of the same compiler.
    pub fn cargo(&self, command: &str) -> Command {
        let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        match self {
            Self::Installed => cargo.arg(command),
            Self::BuildStd => {
                cargo.env("RUSTC", DEBIAN_RUSTC).env("RUSTC_BOOTSTRAP", "1");
                if command == "clippy" {
                    cargo.env("RUSTC_WORKSPACE_WRAPPER", DEBIAN_CLIPPY).arg("check");
                } else {
                    cargo.arg(command);
                }
                cargo.arg("-Zbuild-std=std,panic_abort")
            }
        };
        cargo.args(["--target", TARGET]);
        cargo
    }

    /// What makes an error of each warning of `clippy`: compiler flags, and its last arguments. Arguments where it takes
    /// them: with other flags than a build it runs build scripts anew, and the next build compiles again what needs them.
    pub fn deny_warnings(&self) -> (&'static [&'static str], &'static [&'static str]) {
        match self {
            Self::Installed => (&[], &["--", "-Dwarnings"]),
            Self::BuildStd => (&["-Dwarnings"], &[]),
        }
    }
}

fn target_is_installed() -> bool {
    let output = Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).output();
    output.is_ok_and(|output| Path::new(String::from_utf8_lossy(&output.stdout).trim()).is_dir())
}

fn debian_is_installed() -> bool {
    let source = |version: &str| format!("/usr/src/rustc-{version}/library/std/Cargo.toml");
    let version = Command::new(DEBIAN_RUSTC).arg("--version").output();
    version.is_ok_and(|output| {
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        text.split_whitespace().nth(1).is_some_and(|version| Path::new(&source(version)).is_file())
    }) && [DEBIAN_CLIPPY, DEBIAN_LINKER].iter().all(|program| Path::new(program).is_file())
}
