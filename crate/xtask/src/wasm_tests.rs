//! Tests on wasm32.

use std::num::NonZero;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::thread;

use anyhow::{Context, Result, anyhow, ensure};
use serde_json::Value;

use crate::modules::{QUICK, QUICK_FOLDER, SOLVER, cargo, run};
use crate::toolchain::Toolchain;
use crate::workspace::workspace;

/// The packages whose tests run on wasm32 too.
const TESTED: [&str; 8] = [
    "heatwalk-base",
    "heatwalk-sparse",
    "heatwalk-surface",
    "heatwalk-model",
    "heatwalk-shapes",
    "heatwalk",
    "heatwalk-volume",
    "heatwalk-scene",
];

/// What the modules ask of the packages, so that all is compiled once for both.
const FEATURES: &str = "heatwalk-model/packed";

/// Programs of tests that take longest, by the folder of their crate; of the first, tests whose names have the word take as long
/// as all others, and run apart.
const LONGEST: [&str; 2] = ["crate/solver", "crate/volume"];
const APART_IN_LONGEST: &str = "truth::";

/// Runs the tests that depend on numbers, those of one name where it is given, on wasm32 under Node: each program in one
/// core, so that as many run beside each other as there are cores.
pub fn run_all(toolchain: &Toolchain, names: &[&str]) -> Result<()> {
    eprintln!("Running the solver's tests on wasm32.");
    let runs = test_runs(toolchain, names)?;
    let runner = test_runner()?;
    let (waiting, failed) = (Mutex::new(runs.iter()), Mutex::new(Vec::new()));
    let run_in_turn = || -> Result<()> {
        while let Some(run) = { waiting.lock().map_or(None, |mut waiting| waiting.next()) } {
            let output = Command::new(&runner).arg(&run.program).args(&run.chosen).current_dir(&run.folder).output()?;
            let said = [output.stdout, output.stderr].map(|said| String::from_utf8_lossy(&said).into_owned());
            eprintln!("{} {}\n{}", run.program.display(), run.chosen.join(" "), said.concat());
            if !output.status.success() {
                failed.lock().map_err(|_| anyhow!("Another program of tests could not be run"))?.push(&run.program);
            }
        }
        Ok(())
    };
    thread::scope(|scope| {
        let cores = thread::available_parallelism().map_or(1, NonZero::get);
        let runs: Vec<_> = (0..cores).map(|_| scope.spawn(run_in_turn)).collect();
        runs.into_iter().try_for_each(|run| run.join().unwrap_or_else(|panic| resume_unwind(panic)))
    })?;
    let failed = failed.into_inner().unwrap_or_default();
    ensure!(failed.is_empty(), "Tests failed in {failed:?}");
    Ok(())
}

/// Tests of a crate, compiled for wasm32.
struct TestRun {
    program: PathBuf,
    /// That of the crate.
    folder: PathBuf,
    /// Arguments that choose among the tests.
    chosen: Vec<String>,
}

/// Compiles the tests, and shares them out: those first that take longest.
fn test_runs(toolchain: &Toolchain, names: &[&str]) -> Result<Vec<TestRun>> {
    let mut build = cargo(toolchain, "test", QUICK_FOLDER, SOLVER.flags);
    build.args(["--profile", QUICK, "--tests", "--no-run", "--message-format", "json-render-diagnostics"]);
    build.args(TESTED.iter().flat_map(|package| ["--package", package])).args(["--features", FEATURES]);
    build.stderr(Stdio::inherit());
    let output = build.output().with_context(|| format!("{build:?} could not be started"))?;
    ensure!(output.status.success(), "The step above failed: {}", output.status);
    let mut runs = Vec::new();
    for line in String::from_utf8(output.stdout)?.lines() {
        let message: Value = serde_json::from_str(line)?;
        let (Some(manifest), Some(program)) = (message["manifest_path"].as_str(), message["executable"].as_str())
        else {
            continue;
        };
        let folder = Path::new(manifest).parent().context("A manifest lies in a folder")?;
        let choices = match names {
            [] if folder.ends_with(LONGEST[0]) => vec![vec![APART_IN_LONGEST], vec!["--skip", APART_IN_LONGEST]],
            names => vec![names.to_vec()],
        };
        runs.extend(choices.into_iter().map(|chosen| TestRun {
            program: program.into(),
            folder: folder.to_owned(),
            chosen: chosen.into_iter().map(ToOwned::to_owned).collect(),
        }));
    }
    let place = |run: &TestRun| LONGEST.iter().position(|folder| run.folder.ends_with(folder));
    runs.sort_by_key(|run| place(run).unwrap_or(LONGEST.len()));
    Ok(runs)
}

/// Compiles what runs tests under Node.
fn test_runner() -> Result<PathBuf> {
    run(Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into())).current_dir(workspace()).args([
        "build",
        "--package",
        "wasm-test-runner",
    ]))?;
    Ok(std::env::current_exe()?.with_file_name(format!("wasm-test-runner{}", std::env::consts::EXE_SUFFIX)))
}
