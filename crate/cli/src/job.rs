//! A process that batch has started.

use std::io::{self, Read};
use std::process::{self, ExitCode};
use std::thread;

use serde_json::json;

use crate::args::Command;
use crate::commands;
use crate::complaint::FAILURE;
use crate::destination::print;
use crate::sentence::{code_of, sentence};

/// Runs a command, ends with standard input, and tells an error as an object on standard output.
pub fn job(command: &Command) -> ExitCode {
    thread::spawn(|| {
        // Nothing is ever written to it.
        let _ = io::stdin().read(&mut [0]);
        process::exit(i32::from(FAILURE));
    });
    let (text, exit) = match commands::run(command) {
        Ok(answer) => (answer.text, ExitCode::SUCCESS),
        Err(error) => {
            let error = json!({ "code": code_of(&error), "sentence": sentence(&error) });
            (json!({ "error": error }).to_string(), ExitCode::from(FAILURE))
        }
    };
    match print(text.as_bytes()) {
        Ok(_) => exit,
        Err(_) => ExitCode::from(FAILURE),
    }
}
