//! What was done: an object a line for each mesh.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use serde_json::{Map, Value, json};

use super::process::{Failure, Outcome};
use super::task::{Task, WAITING};
use crate::destination::replace;

pub const NAME: &str = "manifest.jsonl";

/// Entries of a list that is kept of a result which is in files, too.
const FEW: usize = 16;

/// The last line of each mesh counts. A line counts where it is whole: what an end in the middle has left is cut off.
pub struct Manifest {
    folder: PathBuf,
    file: File,
    lines: BTreeMap<String, Value>,
    /// Held as long as this is written.
    _lock: File,
}

impl Manifest {
    /// Goes on with that of a folder, or begins one.
    ///
    /// # Errors
    /// Where another run writes it, and where it cannot be written.
    pub fn open(folder: &Path) -> Result<Self> {
        let open = |path: &Path| {
            let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
            file.with_context(|| format!("cannot write {}", path.display()))
        };
        let waiting = folder.join(WAITING);
        fs::create_dir_all(&waiting).with_context(|| format!("cannot write {}", waiting.display()))?;
        let lock = open(&waiting.join("lock"))?;
        match lock.try_lock() {
            Err(TryLockError::WouldBlock) => bail!("{} is being written by another run; wait for it", folder.display()),
            // A file system without locks has to do without.
            Ok(()) | Err(TryLockError::Error(_)) => {}
        }
        let path = folder.join(NAME);
        let mut file = open(&path)?;
        let bytes = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        let whole = bytes.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
        let parsed = bytes[..whole].split(|&byte| byte == b'\n').filter_map(|line| serde_json::from_slice(line).ok());
        let mesh = |line: Value| Some((line["mesh"].as_str()?.to_owned(), line));
        let lines = parsed.filter_map(mesh).collect();
        let cut = file.set_len(whole as u64).and_then(|()| file.seek(SeekFrom::End(0)));
        cut.with_context(|| format!("cannot write {}", path.display()))?;
        Ok(Self { folder: folder.to_owned(), file, lines, _lock: lock })
    }

    /// Whether a task was done with the same question, and its files are there as they were written.
    pub fn is_done(&self, task: &Task, question: &Value) -> bool {
        let Some(line) = self.lines.get(&mesh(task)) else { return false };
        let is_there = |file: &Value| {
            let path = file["file"].as_str().map(|file| self.folder.join(file));
            let bytes = path.and_then(|path| fs::metadata(path).ok()).map(|metadata| metadata.len());
            bytes.is_some() && bytes == file["bytes"].as_u64()
        };
        line["question"] == *question
            && line["result"].is_object()
            && line["files"].as_array().is_some_and(|files| files.iter().all(is_there))
    }

    /// Adds a line, which is on the disk when this returns.
    pub fn append(&mut self, task: &Task, question: &Value, outcome: &Outcome, seconds: f64) -> Result<()> {
        let mut line =
            json!({ "mesh": mesh(task), "question": question, "warnings": outcome.warnings, "seconds": seconds });
        match &outcome.result {
            Ok(result) => {
                let files: Vec<Value> = task.files().map(|file| self.described(file)).collect();
                line["result"] = if files.is_empty() { result.clone() } else { without_lists(result) }.into();
                line["files"] = files.into();
            }
            Err(Failure { code, sentence }) => line["error"] = json!({ "code": code, "sentence": sentence }),
        }
        let path = self.folder.join(NAME);
        let written = self.file.write_all(format!("{line}\n").as_bytes()).and_then(|()| self.file.sync_data());
        written.with_context(|| format!("cannot write {}", path.display()))?;
        self.lines.insert(mesh(task), line);
        Ok(())
    }

    fn described(&self, file: &Path) -> Value {
        let bytes = fs::metadata(self.folder.join(file)).map(|metadata| metadata.len()).ok();
        json!({ "file": file.display().to_string(), "bytes": bytes })
    }

    /// Writes it anew, with one line a mesh, in the order of their names.
    pub fn finish(self) -> Result<()> {
        let path = self.folder.join(NAME);
        let text: String = self.lines.values().map(|line| format!("{line}\n")).collect();
        replace(&path, text.as_bytes()).with_context(|| format!("cannot write {}", path.display()))
    }
}

fn mesh(task: &Task) -> String {
    task.mesh.display().to_string()
}

fn without_lists(result: &Map<String, Value>) -> Map<String, Value> {
    let is_short = |value: &Value| value.as_array().is_none_or(|list| list.len() <= FEW);
    result.iter().filter(|(_, value)| is_short(value)).map(|(name, value)| (name.clone(), value.clone())).collect()
}
