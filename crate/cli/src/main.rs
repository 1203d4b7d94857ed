//! `heatwalk`: geodesic distance and paths on mesh files.

mod answer;
mod args;
mod batch;
mod cells;
mod checksum;
mod commands;
mod complaint;
mod curve;
mod destination;
mod distance;
mod fill;
mod ground;
mod index;
mod input;
mod isolines;
mod job;
mod labels;
mod lists;
mod locate;
mod log_map;
mod loops;
mod markdown;
mod matrix;
mod mean;
mod method;
mod number;
mod options;
mod output;
mod pairs;
mod path;
mod place;
mod progress;
mod question;
mod report;
mod sample;
mod sentence;
mod table;
mod timing;
mod transport;
mod volume;
mod walk;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;
use clap::error::ErrorKind;

use crate::args::Arguments;
use crate::complaint::{FAILURE, complain};

fn main() -> ExitCode {
    let outcome = match Arguments::try_parse() {
        Ok(arguments) if arguments.job => return job::job(&arguments.command),
        Ok(arguments) => commands::run(&arguments.command),
        Err(error) if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {
            Ok(error.render().to_string().into())
        }
        Err(error) => return fail(&args::in_one_sentence(&error)),
    };
    let answer = match outcome {
        Ok(answer) => answer,
        Err(error) => return fail(&sentence::sentence(&error)),
    };
    if let Err(error) = destination::print(answer.text.as_bytes()) {
        return fail(&sentence::sentence(&error));
    }
    // If standard error is gone, there is nobody to tell.
    let _ = io::stderr().write_all(answer.aside.as_bytes());
    answer.failures.iter().fold(ExitCode::SUCCESS, |_, failure| fail(failure))
}

fn fail(message: &str) -> ExitCode {
    complain(message);
    ExitCode::from(FAILURE)
}
