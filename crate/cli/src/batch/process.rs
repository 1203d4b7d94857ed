//! The process of a mesh.

use std::env;
use std::ffi::OsString;
use std::process::{Command, ExitStatus, Stdio};

use anyhow::{Context, Error, Result};
use serde_json::{Map, Value};

use crate::sentence::{code_of, sentence};

/// What warnings begin with on standard error.
const WARNING: &str = "heatwalk: warning: ";

/// What came of a mesh.
pub struct Outcome {
    pub result: Result<Map<String, Value>, Failure>,
    pub warnings: Vec<String>,
}

/// An error as it is told.
pub struct Failure {
    pub code: String,
    pub sentence: String,
}

impl Outcome {
    pub fn failed(code: &str, sentence: String) -> Self {
        Self { result: Err(Failure { code: code.to_owned(), sentence }), warnings: Vec::new() }
    }

    pub fn of_error(error: &Error) -> Self {
        Self::failed(code_of(error), sentence(error))
    }
}

/// Runs a command in a process of its own, which ends where this one does.
pub fn run(words: &[OsString]) -> Result<Outcome> {
    let program = env::current_exe().context("cannot find the program itself")?;
    let mut command = Command::new(program);
    command.arg("--job").args(words).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut process = command.spawn().context("cannot start a process")?;
    // It ends when this is closed, by this process or with it.
    let open = process.stdin.take();
    let output = process.wait_with_output().context("cannot read what a process has to say")?;
    drop(open);
    let stderr = String::from_utf8_lossy(&output.stderr);
    let warnings = stderr.lines().filter_map(|line| line.strip_prefix(WARNING)).map(str::to_owned).collect();
    let told: Option<Map<String, Value>> = serde_json::from_slice(&output.stdout).ok();
    let error = |told: &Map<String, Value>| {
        let text = |name: &str| told.get("error")?.get(name)?.as_str().map(str::to_owned);
        Some(Failure { code: text("code")?, sentence: text("sentence")? })
    };
    let result = match told {
        Some(told) if output.status.success() => Ok(told),
        told => Err(told.as_ref().and_then(error).unwrap_or_else(|| ended(output.status, &stderr))),
    };
    Ok(Outcome { result, warnings })
}

/// What is known of a process that did not come to its end.
fn ended(status: ExitStatus, stderr: &str) -> Failure {
    let last = stderr.lines().last().map_or(String::new(), |line| format!(": {line}"));
    let sentence = format!("its process ended early, {status}{last}; perhaps memory is short, then use fewer --jobs");
    Failure { code: "ended".to_owned(), sentence }
}
