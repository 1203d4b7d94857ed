//! The commands. Each returns what it has to say.

use std::sync::Arc;

use anyhow::{Result, ensure};
use heatwalk::DistanceSolver;
use serde_json::json;

use crate::answer::Answer;
use crate::args::{Command, Info};
use crate::batch::batch;
use crate::cells::cells;
use crate::destination::is_standard;
use crate::distance::distance;
use crate::fill::fill;
use crate::index::index;
use crate::input::Input;
use crate::isolines::isolines;
use crate::log_map::log_map;
use crate::loops::loops;
use crate::matrix::matrix;
use crate::mean::mean;
use crate::pairs::pairs;
use crate::path::path;
use crate::report::Report;
use crate::sample::sample;
use crate::table::table;
use crate::timing::{build, join};
use crate::transport::transport;
use crate::volume;
use crate::walk::walk;

pub fn run(command: &Command) -> Result<Answer> {
    let standard = command.outputs().into_iter().flatten().filter(|path| is_standard(path)).count();
    ensure!(standard < 2, "only one file can be written to standard output; give the other one a name");
    let answer = answer(command)?;
    Ok(match standard {
        0 => answer,
        // There is the file alone. Who wants to know more reads it from standard error.
        _ if command.is_json() => Answer { aside: answer.text, text: String::new(), ..answer },
        _ => Answer { text: String::new(), ..answer },
    })
}

fn answer(command: &Command) -> Result<Answer> {
    match command {
        Command::Info(arguments) => info(arguments).map(Answer::from),
        Command::Distance(arguments) => distance(arguments).map(Answer::from),
        Command::Path(arguments) => path(arguments).map(Answer::from),
        Command::Loop(arguments) => loops(arguments).map(Answer::from),
        Command::Isolines(arguments) => isolines(arguments).map(Answer::from),
        Command::Cells(arguments) => cells(arguments).map(Answer::from),
        Command::Fill(arguments) => fill(arguments).map(Answer::from),
        Command::Sample(arguments) => sample(arguments).map(Answer::from),
        Command::Mean(arguments) => mean(arguments).map(Answer::from),
        Command::Walk(arguments) => walk(arguments).map(Answer::from),
        Command::LogMap(arguments) => log_map(arguments).map(Answer::from),
        Command::Transport(arguments) => transport(arguments).map(Answer::from),
        Command::Pairs(arguments) => pairs(arguments).map(Answer::from),
        Command::Index(arguments) => index(arguments).map(Answer::from),
        Command::Matrix(arguments) => matrix(arguments).map(Answer::from),
        Command::Batch(arguments) => batch(arguments),
        Command::Table(arguments) => Ok(table(arguments)),
    }
}

fn info(arguments: &Info) -> Result<String> {
    if let Some(input) = volume::Input::of(&arguments.mesh)? {
        return volume::info(arguments, &input);
    }
    let input = Input::of(&arguments.mesh)?;
    let (surface, build_ms) = build(&input, arguments.mesh.weld, arguments.mesh.threads())?;
    let mut report = Report::default();
    report.push_surface(surface.report());
    input.tell(&mut report);
    let mut solver = DistanceSolver::on_threads(Arc::clone(&surface), arguments.mesh.threads());
    let join_ms = join(&mut solver, &arguments.bridging)?;
    report.push_joined(solver.joined());
    report.push("polygons", surface.report().polygons);
    report.push_build(surface.report());
    report.push("mean_edge", surface.mean_edge());
    report.push_parts(&input.file.soup);
    report.push_animations(&input.file.motion);
    report.push("missing", input.file.appearance.missing.clone());
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "join": join_ms }));
    Ok(report.render(arguments.mesh.json))
}
