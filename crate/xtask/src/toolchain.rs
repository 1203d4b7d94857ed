//! The compiler and the standard library for wasm32-unknown-unknown, by the first way that this machine offers.

use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Result, bail};

/// The target of the wasm modules.
pub const TARGET: &str = "wasm32-unknown-unknown";

/// Debian's compiler, its source of the standard library, and what they need to build it.
const DEBIAN_PACKAGES: [&str; 4] = ["rustc-web", "rust-web-src", "rust-web-clippy", "rust-web-llvm"];
const DEBIAN_RUSTC: &str = "/usr/bin/rustc";
/// A link to the linker, whose package is called as the link's target.
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
    /// The first way that works, installing what is missing.
    pub fn find() -> Result<Self> {
        if target_is_installed() {
            return Ok(Self::Installed);
        }
        if debian_is_installed() {
            return Ok(Self::BuildStd);
        }
        eprintln!("The standard library for {TARGET} is missing; asking rustup for it.");
        if succeeds(Command::new("rustup").args(["target", "add", TARGET])) && target_is_installed() {
            return Ok(Self::Installed);
        }
        eprintln!("rustup could not provide it; installing Debian's compiler and source instead.");
        if install_debian_packages() && debian_is_installed() {
            return Ok(Self::BuildStd);
        }
        bail!(
            "There is no Rust standard library for {TARGET}. Run `rustup target add {TARGET}` or, on Debian, \
             `apt-get install {}`; then start again.",
            DEBIAN_PACKAGES.join(" ")
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

fn install_debian_packages() -> bool {
    let install =
        |packages: &[&str]| apt_get(&[&["install", "--yes", "--quiet", "--no-install-recommends"], packages].concat());
    apt_get(&["update", "--quiet"]) && install(&DEBIAN_PACKAGES) && {
        let linker = Path::new(DEBIAN_LINKER).read_link().unwrap_or_default();
        Path::new(DEBIAN_LINKER).is_file()
            || linker.file_name().and_then(|name| name.to_str()).is_some_and(|name| install(&[name]))
    }
}

fn apt_get(arguments: &[&str]) -> bool {
    let is_root = Command::new("id").arg("-u").output().is_ok_and(|output| output.stdout == b"0\n");
    let mut command = if is_root { Command::new("apt-get") } else { Command::new("sudo") };
    if !is_root {
        command.args(["--non-interactive", "apt-get"]);
    }
    succeeds(command.env("DEBIAN_FRONTEND", "noninteractive").args(arguments))
}

fn succeeds(command: &mut Command) -> bool {
    command.stdout(Stdio::null()).status().is_ok_and(|status| status.success())
}
