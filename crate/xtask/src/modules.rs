//! The wasm modules of the page and what is run on them.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

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
    flags: &'static [&'static str],
    /// The target folder: one for packages that are compiled alike.
    folder: &'static str,
    /// The profile of Cargo.toml that it is compiled with.
    profile: &'static str,
    /// Whether the page can begin again with a fresh instance. A worker ends with its instance instead.
    is_restartable: bool,
}

/// The solver: float64 arithmetic that gains from SIMD.
pub const SOLVER: Module = Module {
    name: "solver",
    package: "heatwalk-worker",
    features: &[],
    file: "heatwalk_worker",
    flags: &["-Ctarget-feature=+simd128"],
    folder: "wasm-solver",
    profile: "worker",
    is_restartable: false,
};

/// The viewer on WebGPU: its arithmetic is the GPU's.
pub const VIEWER_WEBGPU: Module = Module {
    name: "viewer-webgpu",
    package: "heatwalk-viewer",
    features: &["webgpu"],
    file: "heatwalk_viewer_webgpu",
    flags: &[],
    folder: "wasm-viewer-webgpu",
    profile: "viewer",
    is_restartable: true,
};

/// The same on WebGL2, for browsers without WebGPU.
pub const VIEWER_WEBGL2: Module = Module {
    name: "viewer-webgl2",
    features: &["webgl2"],
    file: "heatwalk_viewer_webgl2",
    folder: "wasm-viewer-webgl2",
    ..VIEWER_WEBGPU
};

/// The decoder of Basis Universal images, which the worker loads where one occurs.
pub const BASIS: Module = Module {
    name: "basis",
    package: "heatwalk-basis",
    features: &[],
    file: "heatwalk_basis",
    flags: &[],
    folder: "wasm-basis",
    profile: "worker",
    is_restartable: true,
};

/// Tetrahedra, which the worker loads where an inside is wanted.
pub const INTERIOR: Module = Module {
    name: "interior",
    package: "heatwalk-interior",
    features: &[],
    file: "heatwalk_interior",
    flags: SOLVER.flags,
    folder: SOLVER.folder,
    profile: SOLVER.profile,
    is_restartable: false,
};

/// The readers of files, which the worker loads with the first of them.
pub const READER: Module =
    Module { name: "reader", package: "heatwalk-reader", file: "heatwalk_reader", is_restartable: true, ..INTERIOR };

/// Shapes, which the worker loads with the first of them.
pub const MAKER: Module = Module { name: "maker", package: "heatwalk-maker", file: "heatwalk_maker", ..READER };

/// Isolines and files of distances, which the worker loads where one is wanted.
pub const CURVES: Module = Module { name: "curves", package: "heatwalk-curves", file: "heatwalk_curves", ..INTERIOR };

/// The packages whose tests run on wasm32 too.
const TESTED: [&str; 6] =
    ["heatwalk-sparse", "heatwalk-surface", "heatwalk-shapes", "heatwalk", "heatwalk-volume", "heatwalk-scene"];

impl Module {
    fn target_folder(&self) -> PathBuf {
        workspace().join("target").join(self.folder)
    }

    /// Cargo's arguments for the package and its features.
    fn chosen(&self) -> Vec<&'static str> {
        let features = self.features.iter().flat_map(|feature| ["--features", feature]);
        ["--package", self.package, "--no-default-features"].into_iter().chain(features).collect()
    }

    /// `cargo COMMAND` with the module's flags and `more` of them.
    fn cargo(&self, toolchain: &Toolchain, command: &str, more: &[&str]) -> Command {
        let flags: Vec<String> = self.flags.iter().chain(more).map(ToString::to_string).chain(shortened()).collect();
        let mut cargo = toolchain.cargo(command);
        cargo.current_dir(workspace()).env("CARGO_TARGET_DIR", self.target_folder());
        cargo.env("CARGO_ENCODED_RUSTFLAGS", flags.join("\u{1f}"));
        cargo
    }
}

/// Builds all modules: two beside each other, since a module is linked as a whole, which takes long and one core.
pub fn build_all(toolchain: &Toolchain) -> Result<()> {
    let in_turn = |modules: &[&Module]| modules.iter().try_for_each(|module| build(module, toolchain));
    std::thread::scope(|scope| {
        let viewers = scope.spawn(|| in_turn(&[&VIEWER_WEBGL2, &VIEWER_WEBGPU]));
        let others = in_turn(&[&SOLVER, &READER, &MAKER, &INTERIOR, &CURVES, &BASIS]);
        viewers.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)).and(others)
    })
}

/// Compiles a module and writes its bindings to `web/wasm/NAME`.
pub fn build(module: &Module, toolchain: &Toolchain) -> Result<()> {
    eprintln!("Compiling the {} for wasm32.", module.name);
    run(module.cargo(toolchain, "build", &[]).args(["--profile", module.profile]).args(module.chosen()))?;
    let compiled = format!("{}.wasm", module.package.replace('-', "_"));
    let compiled = module.target_folder().join(TARGET).join(module.profile).join(compiled);
    let folder = workspace().join("web/wasm").join(module.name);
    let bound = folder.join(format!("{}_bg.wasm", module.file));
    if modified(&bound).is_some_and(|bound| modified(&compiled).is_some_and(|compiled| compiled < bound)) {
        return Ok(());
    }
    Bindgen::new()
        .input_path(&compiled)
        .web(true)?
        .typescript(true)
        .out_name(module.file)
        .reset_state_function(module.is_restartable)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(&folder)
        .with_context(|| format!("The bindings of {} could not be made", compiled.display()))
}

/// Runs the solver's tests on wasm32, under Node.
pub fn test_solver(toolchain: &Toolchain) -> Result<()> {
    eprintln!("Running the solver's tests on wasm32.");
    let runner = std::env::current_exe()?;
    let runner = runner.to_str().context("The path of the workspace is not Unicode")?;
    // Linking every test as a whole would take longer than all of them run.
    run(SOLVER
        .cargo(toolchain, "test", &[])
        .args(["--profile", "release", "--config", "profile.release.lto='off'"])
        .args(TESTED.iter().flat_map(|package| ["--package", package]))
        .arg("--tests")
        .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER", format!("{runner} test-runner")))
}

/// Lints the code of the modules as it is compiled for wasm32.
pub fn clippy(toolchain: &Toolchain) -> Result<()> {
    let (flags, last) = toolchain.deny_warnings();
    for module in [&SOLVER, &READER, &MAKER, &VIEWER_WEBGPU, &VIEWER_WEBGL2, &INTERIOR, &CURVES, &BASIS] {
        eprintln!("Linting the {} for wasm32.", module.name);
        let mut cargo = module.cargo(toolchain, "clippy", flags);
        run(cargo.args(["--profile", module.profile]).args(module.chosen()).args(last))?;
    }
    Ok(())
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

fn modified(path: &Path) -> Option<SystemTime> {
    path.metadata().and_then(|metadata| metadata.modified()).ok()
}

fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("{command:?} could not be started"))?;
    ensure!(status.success(), "The step above failed: {status}");
    Ok(())
}
