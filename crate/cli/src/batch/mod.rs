//! `heatwalk batch`: one command on many meshes, a process each.

mod manifest;
mod meshes;
mod process;
mod task;

use std::fs;
use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Instant;

use anyhow::{Context, Error, Result, bail};
use serde_json::Value;

use self::manifest::Manifest;
use self::meshes::meshes;
use self::process::{Failure, Outcome};
use self::task::{Task, tasks};
use crate::answer::Answer;
use crate::args::{Batch, available};
use crate::progress::Ticker;
use crate::report::{Report, milliseconds};
use crate::sentence::DISK_FULL;

/// Runs a command on each mesh that it has not been run on before.
pub fn batch(arguments: &Batch) -> Result<Answer> {
    let start = Instant::now();
    task::check(&arguments.command)?;
    let cannot_write = || format!("cannot write {}", arguments.output.display());
    fs::create_dir_all(&arguments.output).with_context(cannot_write)?;
    let folder = fs::canonicalize(&arguments.output).with_context(cannot_write)?;
    let tasks = tasks(&meshes(&arguments.meshes, &folder)?, &arguments.command, &folder)?;
    let manifest = Manifest::open(&folder)?;
    let pending: Vec<usize> =
        (0..tasks.len()).filter(|&number| !manifest.is_done(&tasks[number], &tasks[number].question())).collect();
    let before = tasks.len() - pending.len();
    let jobs = arguments.jobs.unwrap_or_else(available).get().clamp(1, pending.len().max(1));
    let threads = NonZeroUsize::new(available().get() / jobs).unwrap_or(NonZeroUsize::MIN);
    let run = Run { folder: &folder, tasks: &tasks, pending: &pending, threads, next: AtomicUsize::new(0) };
    let ticker = Ticker::new("meshes", tasks.len(), before);
    let state = Mutex::new(State { manifest, ticker, before, done: 0, failures: Vec::new(), end: None });
    thread::scope(|scope| {
        for _ in 0..jobs {
            scope.spawn(|| run.work(&state));
        }
    });
    let State { manifest, mut ticker, done, mut failures, end, .. } =
        state.into_inner().unwrap_or_else(PoisonError::into_inner);
    ticker.end();
    if let Some(error) = end {
        let kept = "meshes are finished and kept; the same command goes on from there";
        return Err(error.context(format!("{} of {} {kept}", before + done, tasks.len())));
    }
    manifest.finish()?;
    if failures.is_empty() {
        task::tidy(&folder)?;
    }

    failures.sort_by_key(|(number, _)| *number);
    let mut report = Report::default();
    report.push("meshes", tasks.len());
    report.push("done", done);
    report.push("done_before", before);
    report.push("failed", failures.len());
    report.push("manifest", folder.join(manifest::NAME).display().to_string());
    report.push("seconds", milliseconds(start) / 1e3);
    let failures = failures.into_iter().map(|(_, sentence)| sentence).collect();
    Ok(Answer { text: report.render(arguments.json), failures, ..Answer::default() })
}

/// What all threads know.
struct Run<'a> {
    folder: &'a Path,
    tasks: &'a [Task],
    /// Those that are not done.
    pending: &'a [usize],
    /// Of each process.
    threads: NonZeroUsize,
    next: AtomicUsize,
}

/// What they come to.
struct State {
    manifest: Manifest,
    ticker: Ticker,
    /// Done by earlier runs.
    before: usize,
    done: usize,
    /// By the numbers of the tasks.
    failures: Vec<(usize, String)>,
    /// Why no further mesh can be done.
    end: Option<Error>,
}

impl Run<'_> {
    /// Takes one task after another.
    fn work(&self, state: &Mutex<State>) {
        let locked = || state.lock().unwrap_or_else(PoisonError::into_inner);
        while let Some(&number) = self.pending.get(self.next.fetch_add(1, Ordering::Relaxed)) {
            if locked().end.is_some() {
                return;
            }
            let task = &self.tasks[number];
            let question = task.question();
            let start = Instant::now();
            let outcome = self.outcome(task, &question);
            let seconds = start.elapsed().as_secs_f64();
            let mut state = locked();
            if let Err(error) = state.keep(number, (task, &question), outcome, seconds) {
                state.end.get_or_insert(error);
                return;
            }
            let finished = state.before + state.done + state.failures.len();
            // Whoever runs it has no way to end it but a signal.
            let _ = state.ticker.tell(finished, 0, 0.0);
        }
    }

    fn outcome(&self, task: &Task, question: &Value) -> Outcome {
        match &task.clash {
            Some(sentence) => Outcome::failed("file-exists", sentence.clone()),
            None => task.run(self.folder, question, self.threads),
        }
    }
}

impl State {
    /// Writes down what came of a task.
    ///
    /// # Errors
    /// Where nothing more can be written.
    fn keep(&mut self, number: usize, (task, question): (&Task, &Value), outcome: Outcome, seconds: f64) -> Result<()> {
        self.manifest.append(task, question, &outcome, seconds)?;
        match outcome.result {
            Ok(_) => self.done += 1,
            Err(Failure { code, sentence }) if code == DISK_FULL => bail!("{}: {sentence}", task.mesh.display()),
            Err(Failure { sentence, .. }) => {
                // A reader names the file itself.
                let mesh = task.mesh.display().to_string();
                let named = if sentence.contains(&mesh) { sentence } else { format!("{mesh}: {sentence}") };
                self.failures.push((number, named));
            }
        }
        Ok(())
    }
}
