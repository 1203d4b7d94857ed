//! The wasm modules of the page.

use std::fs;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use anyhow::{Context, Result, ensure};
use wasm_bindgen_cli_support::Bindgen;

use crate::toolchain::{TARGET, Toolchain};
use crate::workspace::workspace;

/// A wasm module of the page.
pub struct Module {
    name: &'static str,
    package: &'static str,
    features: &'static [&'static str],
    /// What the files of the module and its bindings are called.
    file: &'static str,
    /// Compiler flags.
    pub flags: &'static [&'static str],
    /// The target folder of the published module: one for packages that are compiled alike.
    folder: &'static str,
    /// The same of the module to develop with.
    quick_folder: &'static str,
    /// The profile of Cargo.toml that it is published with.
    profile: &'static str,
    /// Whether the page can begin again with a fresh instance. A worker ends with its instance instead.
    is_restartable: bool,
    /// Whether its bindings find it beside them. Otherwise they are given it.
    is_beside: bool,
}

/// The solver: float64 arithmetic that gains from SIMD.
pub const SOLVER: Module = Module {
    name: "solver",
    package: "heatwalk-worker",
    features: &[],
    file: "heatwalk_worker",
    flags: &["-Ctarget-feature=+simd128"],
    folder: "wasm-solver",
    quick_folder: QUICK_FOLDER,
    profile: "worker",
    is_restartable: false,
    is_beside: true,
};

/// The viewer on WebGPU: its arithmetic is the GPU's.
pub const VIEWER_WEBGPU: Module = Module {
    name: "viewer-webgpu",
    package: "heatwalk-viewer",
    features: &["webgpu"],
    file: "heatwalk_viewer_webgpu",
    flags: &[],
    folder: "wasm-viewer-webgpu",
    // Cargo keeps one module of a package in a folder, and would compile both viewers anew each time.
    quick_folder: "wasm-viewer-webgpu",
    profile: "viewer",
    is_restartable: true,
    is_beside: true,
};

/// The same on WebGL2, for browsers without WebGPU.
pub const VIEWER_WEBGL2: Module = Module {
    name: "viewer-webgl2",
    features: &["webgl2"],
    file: "heatwalk_viewer_webgl2",
    folder: "wasm-viewer-webgl2",
    quick_folder: QUICK_FOLDER,
    ..VIEWER_WEBGPU
};

/// The decoder of Basis Universal images, which the worker loads where one occurs.
pub const BASIS: Module = Module {
    name: "basis",
    package: "heatwalk-basis",
    features: &[],
    file: "heatwalk_basis",
    is_restartable: true,
    ..SOLVER
};

/// Tetrahedra, which the worker loads where an inside is wanted.
pub const INTERIOR: Module = Module {
    name: "interior",
    package: "heatwalk-interior",
    features: &[],
    file: "heatwalk_interior",
    flags: SOLVER.flags,
    folder: SOLVER.folder,
    quick_folder: SOLVER.quick_folder,
    profile: SOLVER.profile,
    is_restartable: false,
    is_beside: true,
};

/// The readers of files, which the worker loads with the first of them.
pub const READER: Module =
    Module { name: "reader", package: "heatwalk-reader", file: "heatwalk_reader", is_restartable: true, ..INTERIOR };

/// Shapes, which the worker loads with the first of them.
pub const MAKER: Module = Module { name: "maker", package: "heatwalk-maker", file: "heatwalk_maker", ..READER };

/// Curves on surfaces, and files, which the worker loads where one is wanted.
pub const WRITER: Module = Module { name: "writer", package: "heatwalk-writer", file: "heatwalk_writer", ..INTERIOR };

/// The solver of the npm package.
const NPM: Module = Module {
    name: "package",
    package: "heatwalk-npm",
    file: "heatwalk_npm",
    // Functions are copied into fewer places: the solver has 4 % fewer bytes, and its exact search takes 8 % longer.
    flags: &["-Ctarget-feature=+simd128", "-Cllvm-args=-inline-threshold=50"],
    folder: "wasm-package",
    profile: "npm",
    is_beside: false,
    ..INTERIOR
};

/// The modules of the npm package.
pub const PACKAGE: [&Module; 2] = [
    &NPM,
    &Module {
        name: "package-reader",
        package: READER.package,
        features: &["heatwalk-reader/unpack"],
        file: READER.file,
        is_restartable: true,
        ..NPM
    },
];

/// Modules that are compiled at once, so that what they share is compiled once; the one that the page begins with first.
const TOGETHER: [&Module; 5] = [&SOLVER, &READER, &MAKER, &WRITER, &BASIS];
/// It would be half as large again with what the others ask of the crates that all build on.
const APART: [&Module; 1] = [&INTERIOR];
/// The two are one package with different features.
const VIEWERS: [&[&Module]; 2] = [&[&VIEWER_WEBGL2], &[&VIEWER_WEBGPU]];

/// The profile of all that is not published: modules to develop and test with, tests, and lints.
pub const QUICK: &str = "quick";
/// The target folder of these but for one of the viewers, see [`Module::quick_folder`].
pub const QUICK_FOLDER: &str = "wasm-quick";

impl Module {
    /// Cargo's arguments for the package and its features.
    fn chosen(&self) -> Vec<&'static str> {
        let features = self.features.iter().flat_map(|feature| ["--features", feature]);
        ["--package", self.package].into_iter().chain(features).collect()
    }

    /// Where Cargo puts the module with this profile.
    fn compiled(&self, folder: &str, profile: &str) -> PathBuf {
        let file = format!("{}.wasm", self.package.replace('-', "_"));
        workspace().join("target").join(folder).join(TARGET).join(profile).join(file)
    }
}

/// `cargo COMMAND` that builds in a folder of `target` with compiler flags.
pub fn cargo(toolchain: &Toolchain, command: &str, folder: &str, flags: &[&str]) -> Command {
    let flags: Vec<String> = flags.iter().map(ToString::to_string).chain(shortened()).collect();
    let mut cargo = toolchain.cargo(command);
    cargo.current_dir(workspace()).env("CARGO_TARGET_DIR", workspace().join("target").join(folder));
    cargo.env("CARGO_ENCODED_RUSTFLAGS", flags.join("\u{1f}"));
    cargo
}

/// Builds all modules as they are published, the viewers beside the rest: a module is linked as a whole, which takes long and
/// one core.
pub fn publish_all(toolchain: &Toolchain) -> Result<()> {
    let in_turn = |groups: &[&[&Module]]| groups.iter().try_for_each(|group| publish(group, toolchain));
    thread::scope(|scope| {
        let viewers = scope.spawn(|| in_turn(&VIEWERS));
        let others = in_turn(&[&TOGETHER, &APART]);
        viewers.join().unwrap_or_else(|panic| resume_unwind(panic)).and(others)
    })
}

/// Compiles modules as they are published, and writes their bindings to `web/wasm/NAME`.
pub fn publish(modules: &[&Module], toolchain: &Toolchain) -> Result<()> {
    let Some(Module { folder, flags, profile, .. }) = modules.first() else { return Ok(()) };
    for_group(cargo(toolchain, "build", folder, flags), modules, profile, &[])?;
    modules.iter().try_for_each(|module| bind(module, &module.compiled(folder, profile)))
}

/// Builds all modules in less time, and larger: what they share is compiled once, and nothing is linked as a whole.
pub fn build_all_quickly(toolchain: &Toolchain) -> Result<()> {
    for modules in quick_groups() {
        let Some(Module { quick_folder, .. }) = modules.first() else { continue };
        for_group(cargo(toolchain, "build", quick_folder, SOLVER.flags), &modules, QUICK, &[])?;
        for module in modules {
            bind(module, &module.compiled(module.quick_folder, QUICK))?;
        }
    }
    Ok(())
}

/// Modules that are compiled at once where their size does not matter.
fn quick_groups() -> impl Iterator<Item = Vec<&'static Module>> {
    let together = TOGETHER.into_iter().chain(APART).collect();
    // That of the npm package has none of what the page asks of the same crates.
    [together, PACKAGE.to_vec()].into_iter().chain(VIEWERS.iter().map(|viewer| viewer.to_vec()))
}

fn for_group(mut command: Command, modules: &[&Module], profile: &str, last: &[&str]) -> Result<()> {
    let names: Vec<&str> = modules.iter().map(|module| module.name).collect();
    eprintln!("For wasm32: {}.", names.join(", "));
    let chosen = modules.iter().flat_map(|module| module.chosen());
    run(command.args(["--no-default-features", "--profile", profile]).args(chosen).args(last))
}

/// Writes the bindings of a compiled module, unless they are there.
fn bind(module: &Module, compiled: &Path) -> Result<()> {
    let folder = workspace().join("web/wasm").join(module.name);
    // Which file they are of, and of when.
    let stamp = format!("{}\n{:?}\n", compiled.display(), compiled.metadata()?.modified()?);
    let stamped = workspace().join("target/bound").join(module.name);
    if folder.is_dir() && fs::read_to_string(&stamped).is_ok_and(|before| before == stamp) {
        return Ok(());
    }
    Bindgen::new()
        .input_path(compiled)
        .web(true)?
        .typescript(true)
        .out_name(module.file)
        .reset_state_function(module.is_restartable)
        .omit_default_module_path(!module.is_beside)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(&folder)
        .with_context(|| format!("The bindings of {} could not be made", compiled.display()))?;
    fs::create_dir_all(stamped.parent().context("A file lies in a folder")?)?;
    Ok(fs::write(stamped, stamp)?)
}

/// Lints the code of the modules as it is compiled for wasm32.
pub fn clippy(toolchain: &Toolchain) -> Result<()> {
    let (flags, last) = toolchain.deny_warnings();
    let flags = [SOLVER.flags, flags].concat();
    quick_groups()
        .try_for_each(|modules| for_group(cargo(toolchain, "clippy", QUICK_FOLDER, &flags), &modules, QUICK, last))
}

/// Flags that take the folders of the registries off the file names in panic messages: two hundred of them, which name no
/// folder of the machine then.
fn shortened() -> Vec<String> {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| std::env::home_dir().map(|home| home.join(".cargo")));
    let registries = home.and_then(|home| home.join("registry/src").read_dir().ok());
    let mut flags: Vec<String> = registries
        .into_iter()
        .flatten()
        .flatten()
        .map(|registry| format!("--remap-path-prefix={}=", registry.path().display()))
        .collect();
    flags.sort();
    flags
}

pub fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("{command:?} could not be started"))?;
    ensure!(status.success(), "The step above failed: {status}");
    Ok(())
}
