//! From the command line to a solver that can be asked for distances on a surface.

use anyhow::Result;
use heatwalk::{DistanceOptions, Source, Up};

use crate::args::Question;
use crate::input::Input;
use crate::report::Report;
use crate::timing::{Prepared, build, join, prepare};

/// All that is known before distances are asked for.
pub struct Posed {
    pub input: Input,
    pub sources: Vec<Source>,
    pub prepared: Prepared,
    /// With what is to be told of the surface.
    pub report: Report,
}

/// Reads, checks and prepares. `up`: the axis of the file that slopes are measured against.
pub fn pose(question: &Question, up: Up, options: &DistanceOptions) -> Result<Posed> {
    let input = Input::of(&question.mesh)?;
    question.sources.iter().try_for_each(|source| source.place.check(&input.soup))?;
    question.lines.iter().try_for_each(|line| line.check(&input.soup))?;
    let threads = question.mesh.threads();
    let (surface, built_ms) = build(&input, question.mesh.weld, threads)?;
    let ground = question.ground.on(&input.soup, &surface, up)?;
    let mut sources =
        question.sources.iter().map(|source| source.on(&input.soup, &ground.surface)).collect::<Result<Vec<_>>>()?;
    for line in &question.lines {
        sources.extend(line.on(&ground.surface, question.closed)?);
    }
    let mut report = Report::default();
    let joined = join(&surface, &question.bridging, threads);
    report.push_surface(surface.report());
    report.push_unit(input.unit);
    report.push_warnings(&input.file.warnings);
    report.push_bridges(&joined.bridges, joined.contacts, &joined.links);
    let build_ms = built_ms + joined.join_ms;
    let solver = ground.solver(&surface, joined.bridges, threads);
    let prepared = prepare((solver, build_ms), options)?;
    Ok(Posed { input, sources, prepared, report })
}
