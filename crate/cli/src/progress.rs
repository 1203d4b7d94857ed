//! Progress on standard error.

use std::io::{self, IsTerminal, Write};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use crate::complaint::complain;

/// Between two lines of a terminal, each in place of the one before; elsewhere lines stay, and are fewer.
const ON_TERMINAL: Duration = Duration::from_millis(500);
const ELSEWHERE: Duration = Duration::from_secs(10);

/// Tells now and then how many of something are done, and how long the others may take.
pub struct Ticker {
    what: &'static str,
    all: usize,
    /// Finished by an earlier run.
    before: usize,
    start: Instant,
    told: Instant,
    is_terminal: bool,
    has_line: bool,
}

impl Ticker {
    /// `what`: what there are so many of; `before` of them were finished by an earlier run.
    pub fn new(what: &'static str, all: usize, before: usize) -> Self {
        if before > 0 {
            complain(&format!("{before} of {all} {what} were finished before; going on with the others"));
        }
        let start = Instant::now();
        Self { what, all, before, start, told: start, is_terminal: io::stderr().is_terminal(), has_line: false }
    }

    /// `share` of `some` after the `first` ones.
    pub fn tell(&mut self, first: usize, some: usize, share: f64) -> ControlFlow<()> {
        let between = if self.is_terminal { ON_TERMINAL } else { ELSEWHERE };
        let done = first as f64 + some as f64 * share;
        if self.told.elapsed() < between || done <= self.before as f64 {
            return ControlFlow::Continue(());
        }
        self.told = Instant::now();
        let seconds = self.start.elapsed().as_secs_f64();
        let left = seconds * (self.all as f64 - done) / (done - self.before as f64);
        let line = format!("{} of {} {} in {seconds:.0} s, about {left:.0} s left", done as usize, self.all, self.what);
        if self.is_terminal {
            self.has_line = true;
            // It is no more than progress.
            let _ = write!(io::stderr(), "\r{line:<70}");
        } else {
            complain(&line);
        }
        ControlFlow::Continue(())
    }

    /// Clears the line on a terminal.
    pub fn end(&mut self) {
        if self.has_line {
            let _ = write!(io::stderr(), "\r{:<70}\r", "");
        }
    }
}
