//! Progress on standard error.

use std::io::{self, IsTerminal, Write};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use crate::complaint::complain;

/// Between two lines of a terminal, each in place of the one before; elsewhere lines stay, and are fewer.
const ON_TERMINAL: Duration = Duration::from_millis(500);
const ELSEWHERE: Duration = Duration::from_secs(10);

/// Tells now and then how many rows there are, and how long the others may take.
pub struct Ticker {
    rows: usize,
    /// Finished by an earlier run.
    before: usize,
    start: Instant,
    told: Instant,
    is_terminal: bool,
    has_line: bool,
}

impl Ticker {
    pub fn new(rows: usize, before: usize) -> Self {
        if before > 0 {
            complain(&format!("{before} of {rows} rows were finished before; going on with the others"));
        }
        let start = Instant::now();
        Self { rows, before, start, told: start, is_terminal: io::stderr().is_terminal(), has_line: false }
    }

    /// `share` of `some` rows after the `first` ones.
    pub fn tell(&mut self, first: usize, some: usize, share: f64) -> ControlFlow<()> {
        let between = if self.is_terminal { ON_TERMINAL } else { ELSEWHERE };
        let done = first as f64 + some as f64 * share;
        if self.told.elapsed() < between || done <= self.before as f64 {
            return ControlFlow::Continue(());
        }
        self.told = Instant::now();
        let seconds = self.start.elapsed().as_secs_f64();
        let left = seconds * (self.rows as f64 - done) / (done - self.before as f64);
        let line = format!("{} of {} rows in {seconds:.0} s, about {left:.0} s left", done as usize, self.rows);
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
