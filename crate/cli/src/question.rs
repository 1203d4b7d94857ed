//! From the command line to a solver that can be asked for distances on a surface.

use anyhow::{Result, ensure};
use heatwalk::heat::VectorHeat;
use heatwalk::{DistanceOptions, DistanceSolver, Source, Up, go_on};

use crate::args::{Bridging, Mesh, Question, Solving};
use crate::input::Input;
use crate::locate::Locator;
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
    let places = question.places()?;
    let input = Input::of(&question.mesh)?;
    places.iter().try_for_each(|source| source.place.check(&input.model.soup))?;
    question.lines.iter().try_for_each(|line| line.check(&input.model.soup))?;
    let (solver, mut report, build_ms) = walkable(&input, &question.mesh, &question.solving, up)?;
    let locator = Locator::new(&input.model.soup, solver.surface());
    let mut sources = places.iter().map(|source| locator.source(source)).collect::<Result<Vec<_>>>()?;
    locator.tell(&mut report);
    for line in &question.lines {
        sources.extend(line.on(solver.surface(), question.closed)?);
    }
    let prepared = prepare((solver, build_ms), options)?;
    Ok(Posed { input, sources, prepared, report })
}

/// The solver of a surface with its bridges, walls and costs, what is to be told of it, and the milliseconds that it took. `up`: the axis
/// of the file that the ground is measured against.
pub fn walkable(input: &Input, mesh: &Mesh, solving: &Solving, up: Up) -> Result<(DistanceSolver, Report, f64)> {
    let (mut solver, built_ms) = unjoined(input, mesh)?;
    solving.ground.lay(&mut solver, &input.model, up)?;
    with_bridges((solver, built_ms), input, &solving.bridging)
}

/// The same without walls and costs.
pub fn joined(input: &Input, mesh: &Mesh, bridging: &Bridging) -> Result<(DistanceSolver, Report, f64)> {
    with_bridges(unjoined(input, mesh)?, input, bridging)
}

/// What diffuses vectors on the surface of a solver.
///
/// # Errors
/// Bridges.
pub fn diffusion(solver: &DistanceSolver) -> Result<VectorHeat> {
    let has_portals = !solver.joined().bridges().portals().is_empty();
    ensure!(!has_portals, "heat carries nothing across bridges; give --bridge off");
    Ok(VectorHeat::new(solver.surface(), &mut go_on)?)
}

fn unjoined(input: &Input, mesh: &Mesh) -> Result<(DistanceSolver, f64)> {
    let threads = mesh.threads();
    let (surface, built_ms) = build(input, mesh.weld, threads)?;
    Ok((DistanceSolver::on_threads(surface, threads), built_ms))
}

fn with_bridges(
    (mut solver, built_ms): (DistanceSolver, f64),
    input: &Input,
    bridging: &Bridging,
) -> Result<(DistanceSolver, Report, f64)> {
    let join_ms = join(&mut solver, bridging)?;
    let mut report = Report::default();
    report.push_surface(solver.whole().report());
    input.tell(&mut report);
    report.push_joined(solver.joined());
    Ok((solver, report, built_ms + join_ms))
}
