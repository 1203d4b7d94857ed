//! A command on one mesh.

use std::collections::HashMap;
use std::ffi::OsString;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::num::NonZeroUsize;
use std::path::{Component, Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use clap::Parser;
use clap::error::ErrorKind;
use serde_json::{Value, json};

use super::meshes::Named;
use super::process::{Outcome, run};
use crate::args::{Arguments, in_one_sentence};
use crate::checksum;

/// Where results and matrices wait until they are whole, below the folder of the output.
pub const WAITING: &str = ".batch";

/// Stands for the name of a mesh.
const NAME: &str = "{}";

/// What files of the output are called on the command line.
const OUTPUTS: [&str; 2] = ["--output", "--borders"];

pub struct Task {
    pub mesh: PathBuf,
    /// The command without the mesh, with its name in place of `{}`.
    words: Vec<String>,
    /// Which words name files that are written, and the files below the folder of the output.
    outputs: Vec<(usize, PathBuf)>,
    /// Why it cannot be done.
    pub clash: Option<String>,
}

/// Refuses a command that is wrong for all meshes.
///
/// # Errors
/// With what is wrong, in a sentence.
pub fn check(command: &[String]) -> Result<()> {
    let words = apart(command);
    for (_, value) in outputs(&words) {
        ensure!(
            value.contains(NAME),
            "all meshes would be written to {value}; put {NAME} where the name of the mesh goes"
        );
        let is_below =
            Path::new(&value).components().all(|step| matches!(step, Component::Normal(_) | Component::CurDir));
        ensure!(is_below, "{value} is not below the folder of the output; write it as a path from there");
    }
    match parsed(&words, Path::new("mesh.off")) {
        Ok(Arguments { command, .. }) if command.mesh().is_some() => Ok(()),
        Ok(_) => bail!("{} is not a command on one mesh", command[0]),
        Err(error) if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {
            bail!("for the help of a command: heatwalk {} --help", command[0])
        }
        Err(error) => bail!("{}", in_one_sentence(&error)),
    }
}

/// One for each mesh.
pub fn tasks(meshes: &[Named], command: &[String], folder: &Path) -> Result<Vec<Task>> {
    let command = apart(command);
    let mut writers: HashMap<PathBuf, &Path> = HashMap::new();
    let mut tasks = Vec::with_capacity(meshes.len());
    for Named { mesh, name } in meshes {
        let words: Vec<String> = command.iter().map(|word| word.replace(NAME, name)).collect();
        let outputs: Vec<(usize, PathBuf)> = outputs(&words).map(|(place, value)| (place, value.into())).collect();
        let mut clash = None;
        for (_, file) in &outputs {
            if let Some(other) = writers.insert(file.clone(), mesh) {
                clash = Some(format!(
                    "{} is written for {}; give one of them another name",
                    folder.join(file).display(),
                    other.display()
                ));
            }
        }
        tasks.push(Task { mesh: mesh.clone(), words, outputs, clash });
    }
    Ok(tasks)
}

/// With `--option=value` as two words.
fn apart(command: &[String]) -> Vec<String> {
    let split = |word: &String| match word.split_once('=') {
        Some((option, value)) if option.starts_with("--") => vec![option.to_owned(), value.to_owned()],
        _ => vec![word.clone()],
    };
    command.iter().flat_map(split).collect()
}

/// The values of the options that name files of the output, with their places.
fn outputs(words: &[String]) -> impl Iterator<Item = (usize, String)> {
    let is_output = |pair: &[String]| OUTPUTS.contains(&pair[0].as_str());
    words
        .windows(2)
        .enumerate()
        .filter(move |(_, pair)| is_output(pair))
        .map(|(place, pair)| (place + 1, pair[1].clone()))
}

fn with_mesh(words: &[String], mesh: &Path) -> Vec<OsString> {
    let mut all: Vec<OsString> = words.iter().map(OsString::from).collect();
    // A name that looks like an option is none.
    let looks = mesh.as_os_str().to_string_lossy().starts_with('-');
    all.insert(1, if looks { Path::new(".").join(mesh).into() } else { mesh.into() });
    all
}

fn parsed(words: &[String], mesh: &Path) -> Result<Arguments, clap::Error> {
    Arguments::try_parse_from([OsString::from("heatwalk")].into_iter().chain(with_mesh(words, mesh)))
}

impl Task {
    /// All that its files depend on: what is read with its checksums, the command, and the version of the program.
    pub fn question(&self) -> Value {
        let is_option = |word: &&String| !self.outputs.iter().any(|(place, _)| self.words[*place] == **word);
        let named = self.words[1..].iter().filter(is_option).map(PathBuf::from).filter(|path| path.is_file());
        let read = |path: PathBuf| {
            let (bytes, checksum) = checksum::of_file(&path).unzip();
            json!({ "file": path.display().to_string(), "bytes": bytes, "checksum": checksum.map(|sum| format!("{sum:08x}")) })
        };
        let read: Vec<Value> = [self.mesh.clone()].into_iter().chain(named).map(read).collect();
        json!({ "read": read, "command": self.words, "version": env!("CARGO_PKG_VERSION") })
    }

    /// The files that it writes, below the folder of the output.
    pub fn files(&self) -> impl Iterator<Item = &Path> {
        self.outputs.iter().map(|(_, file)| file.as_path())
    }

    /// Runs the command and puts its files into their places.
    pub fn run(&self, folder: &Path, question: &Value, threads: NonZeroUsize) -> Outcome {
        let waiting = folder.join(WAITING).join(key(question));
        match self.run_in(&waiting, folder, threads) {
            Ok(outcome) => outcome,
            Err(error) => Outcome::of_error(&error),
        }
    }

    fn run_in(&self, waiting: &Path, folder: &Path, threads: NonZeroUsize) -> Result<Outcome> {
        clean(waiting).with_context(|| format!("cannot write {}", waiting.display()))?;
        let mut words = self.words.clone();
        let mut moves = Vec::new();
        for (number, (place, file)) in self.outputs.iter().enumerate() {
            let extension =
                file.extension().map_or(String::new(), |extension| format!(".{}", extension.to_string_lossy()));
            let beside = waiting.join(format!("{number}{extension}"));
            words[*place] = beside.display().to_string();
            moves.push((beside, folder.join(file)));
        }
        for (option, value) in [("--json", None), ("--threads", Some(threads.to_string()))] {
            if !words.iter().any(|word| word == option) {
                words.push(option.to_owned());
                words.extend(value);
            }
        }
        let outcome = run(&with_mesh(&words, &self.mesh))?;
        if outcome.result.is_ok() {
            for (from, to) in &moves {
                place(from, to).with_context(|| format!("cannot write {}", to.display()))?;
            }
            fs::remove_dir_all(waiting).with_context(|| format!("cannot remove {}", waiting.display()))?;
        }
        Ok(outcome)
    }
}

/// A name for a question.
fn key(question: &Value) -> String {
    let mut hasher = DefaultHasher::new();
    question.to_string().hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}

/// Makes a folder, and removes what an end in the middle has left half written in it.
fn clean(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder)?;
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_name().to_string_lossy().starts_with('.') {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

/// Removes what waits for nothing any more: of a command that was another one.
///
/// # Errors
/// Where it cannot be removed.
pub fn tidy(folder: &Path) -> Result<()> {
    let waiting = folder.join(WAITING);
    let remove = || -> Result<()> {
        for entry in fs::read_dir(&waiting)? {
            let entry = entry?;
            if entry.file_type()?.is_dir() {
                fs::remove_dir_all(entry.path())?;
            }
        }
        Ok(())
    };
    remove().with_context(|| format!("cannot remove what is in {}", waiting.display()))
}

/// Puts a file that is whole into its place, when it is on the disk.
fn place(from: &Path, to: &Path) -> Result<()> {
    fs::File::open(from)?.sync_all()?;
    fs::create_dir_all(to.parent().unwrap_or(Path::new(".")))?;
    Ok(fs::rename(from, to)?)
}
