//! Distances across contacts, as a Markdown table: surfaces cut into ten pieces, against exact distances on the whole
//! surfaces. Errors are mean % / 99th percentile %; times in milliseconds, the least of some runs, with their ratio to that
//! of the whole.
//!
//! `cargo run --release -p heatwalk --example contacts`

#[path = "../tests/common/mod.rs"]
mod common;

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

use common::pieces::{CHANGES, Change, Errors, Pieces, wholes};
use heatwalk::{
    BridgeRule, Bridges, DistanceOptions, DistanceSolver, Method, Surface, VertexData, VertexId, WeldRule, go_on,
};

/// Runs of which the least time counts.
const RUNS: usize = 60;

fn main() -> Result<(), Box<dyn Error>> {
    println!("| surface | pieces | portals | search, ms | exact | propagation | heat | exact, ms | propagation, ms |");
    println!("|---|---|---:|---:|---|---|---|---:|---:|");
    for whole in wholes() {
        let of_whole = answers(&whole.surface, Bridges::default(), whole.source)?;
        let exact = &of_whole[0].values;
        let errors = of_whole.iter().map(|answer| shown(Errors::between(&answer.values, exact)));
        let times = [0, 1].map(|method: usize| format!("{:.1}", of_whole[method].ms));
        println!("| {}, whole | 1 | | | {} | {} |", whole.name, cells(errors), cells(times));
        let welded = CHANGES.iter().filter(|(_, change)| matches!(change, Change::Noise(_)));
        let welded = welded.map(|&(name, change)| (format!("{name}, welded"), change, WeldRule::Automatic));
        let apart = CHANGES.iter().map(|&(name, change)| (name.to_owned(), change, WeldRule::Exact));
        for (name, change, rule) in apart.chain(welded) {
            let pieces = Pieces::new(&whole, change, rule);
            let (bridges, search) = timed(|| Ok(Bridges::find(&pieces.surface, BridgeRule::Automatic)))?;
            let components = pieces.surface.report().components;
            let portals = bridges.portals().len();
            let of_pieces = answers(&pieces.surface, bridges, pieces.source)?;
            let expected = pieces.copied(exact);
            let errors = of_pieces.iter().map(|answer| shown(Errors::between(&answer.values, &expected)));
            let time = |method: usize| {
                let [whole, cut] = [&of_whole, &of_pieces].map(|answers| answers[method].ms);
                format!("{cut:.1} ({:.2})", cut / whole)
            };
            let [errors, times] = [cells(errors), cells([0, 1].map(time))];
            println!("| {}, {name} | {components} | {portals} | {search:.1} | {errors} | {times} |", whole.name);
        }
    }
    Ok(())
}

fn cells(cells: impl IntoIterator<Item = String>) -> String {
    cells.into_iter().collect::<Vec<_>>().join(" | ")
}

fn shown(Errors { mean, high }: Errors) -> String {
    format!("{mean:.2} / {high:.1}")
}

/// A distance by one method.
struct Timed {
    values: VertexData<f64>,
    ms: f64,
}

/// By exact search, propagation and heat.
fn answers(surface: &Arc<Surface>, bridges: Bridges, source: VertexId) -> Result<Vec<Timed>, Box<dyn Error>> {
    let mut solver = DistanceSolver::new(Arc::clone(surface)).bridged(bridges);
    let by = |method| {
        let options = DistanceOptions::by(method);
        let (answer, ms) = timed(|| Ok(solver.distance(&[source], &options, &mut go_on)?))?;
        Ok(Timed { values: answer.distance.values, ms })
    };
    [Method::Exact, Method::Propagation, Method::Heat].into_iter().map(by).collect()
}

/// What is made, and the least time of some runs in milliseconds.
fn timed<T>(mut make: impl FnMut() -> Result<T, Box<dyn Error>>) -> Result<(T, f64), Box<dyn Error>> {
    let mut run = || {
        let start = Instant::now();
        let made = make()?;
        Ok::<_, Box<dyn Error>>((made, 1e3 * start.elapsed().as_secs_f64()))
    };
    let (made, mut least) = run()?;
    for _ in 1..RUNS {
        least = least.min(run()?.1);
    }
    Ok((made, least))
}
