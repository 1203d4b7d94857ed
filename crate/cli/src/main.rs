//! `heatwalk`: geodesic distance and paths on mesh files.

mod args;
mod commands;
mod input;
mod output;
mod report;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;
use clap::error::ErrorKind;

use crate::args::Arguments;

/// Bad input and bad usage alike: the caller has to change something.
const FAILURE: u8 = 2;

fn main() -> ExitCode {
    let outcome = match Arguments::try_parse() {
        Ok(arguments) => commands::run(&arguments.command),
        Err(error) if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {
            Ok(error.render().to_string())
        }
        Err(error) => return fail(&args::in_one_sentence(&error)),
    };
    match outcome.map(|text| print(&text)) {
        Ok(Ok(())) => ExitCode::SUCCESS,
        // Whoever reads the pipe has seen enough.
        Ok(Err(error)) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Ok(Err(error)) => fail(&format!("cannot write to standard output: {error}")),
        Err(error) => fail(&format!("{error:#}")),
    }
}

fn print(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(text.as_bytes())?;
    stdout.flush()
}

/// One line on standard error, whatever file names the message quotes.
fn fail(message: &str) -> ExitCode {
    let line: String = message.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    // If standard error is gone too, the exit code has to say it alone.
    let _ = writeln!(io::stderr(), "heatwalk: {}", line.trim());
    ExitCode::from(FAILURE)
}
