//! Standard error and the exit status.

use std::io::{self, Write};

/// The exit status of bad input and bad usage alike: the caller has to change something.
pub const FAILURE: u8 = 2;

/// One line on standard error, whatever file names the message quotes.
pub fn complain(message: &str) {
    let line: String = message.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    // If standard error is gone too, the exit code has to say it alone.
    let _ = writeln!(io::stderr(), "heatwalk: {}", line.trim());
}
