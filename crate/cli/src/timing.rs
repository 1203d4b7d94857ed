//! Work with the time that it takes.

use std::mem;
use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use anyhow::Result;
use heatwalk::{Bridges, DistanceOptions, DistanceSolver, Element, Method, Stage, Surface, VertexId, WeldRule};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use crate::args::Bridging;
use crate::complaint::complain;
use crate::input::Input;
use crate::report::milliseconds;

pub fn build(input: &Input, weld: WeldRule, threads: NonZeroUsize) -> Result<(Arc<Surface>, f64)> {
    let start = Instant::now();
    let surface = Surface::build_by(&input.model.soup, weld, threads)?;
    Ok((Arc::new(surface), milliseconds(start)))
}

/// Finds what joins the components of a solver's surface, and gives the milliseconds that it took.
pub fn join(solver: &mut DistanceSolver, bridging: &Bridging) -> Result<f64> {
    let start = Instant::now();
    let whole = Arc::clone(solver.whole());
    solver.join(&whole, bridging.rule, bridging.links)?;
    let join_ms = milliseconds(start);
    for warning in warnings(solver.joined().bridges()) {
        complain(&format!("warning: {warning}"));
    }
    Ok(join_ms)
}

/// What may be otherwise than the surface is meant.
fn warnings(bridges: &Bridges) -> Vec<String> {
    let (places, gap) = (bridges.across_cracks().count(), bridges.crack_width());
    let across = format!(
        "paths cross gaps between boundaries, up to {gap} wide, at {places} places; --bridge off keeps both sides apart"
    );
    let some = "parts meet in more places than are looked at; those that meet elsewhere alone are of different groups, \
                and links may be wider than the least";
    let told = [(places > 0).then_some(across), (!bridges.is_complete()).then(|| some.to_owned())];
    told.into_iter().flatten().collect()
}

/// A surface's solver, ready to be asked, and what that took in milliseconds.
pub struct Prepared {
    pub solver: DistanceSolver,
    /// From positions to a surface that can be asked, with all that a search in windows needs of it.
    pub build_ms: f64,
    /// Factors; 0 where there are none.
    pub precompute_ms: f64,
    /// The stages of factoring in the order of the work; together they are all of it.
    pub stages_ms: Vec<(Stage, f64)>,
}

/// `solver`: with the milliseconds that building its surface and finding its bridges took.
pub fn prepare((mut solver, build_ms): (DistanceSolver, f64), options: &DistanceOptions) -> Result<Prepared> {
    let start = Instant::now();
    let mut begun: Vec<(Stage, f64)> = Vec::new();
    solver.prepare(options, &mut |stage, _| {
        begun.push((stage, milliseconds(start)));
        ControlFlow::Continue(())
    })?;
    let prepared_ms = milliseconds(start);
    if options.method != Method::Heat {
        return Ok(Prepared { solver, build_ms: build_ms + prepared_ms, precompute_ms: 0.0, stages_ms: Vec::new() });
    }
    let ends = begun.iter().skip(1).map(|&(_, begin)| begin).chain([prepared_ms]);
    let mut before = 0.0;
    let lasted = |end: f64| end - mem::replace(&mut before, end);
    let stages_ms = begun.iter().map(|&(stage, _)| stage).zip(ends.map(lasted)).collect();
    Ok(Prepared { solver, build_ms, precompute_ms: prepared_ms, stages_ms })
}

/// So many vertices, the same ones at every run.
pub fn sample(surface: &Surface, count: u32) -> Vec<VertexId> {
    let mut random = SplitMix64::seed_from_u64(1);
    let draw = |_| VertexId::from_index(random.random_range(0..surface.vertex_count()));
    (0..count).map(draw).collect()
}

/// Median time of a solve over single sources.
pub fn median_solve_ms<A>(vertices: &[VertexId], mut solve: impl FnMut(VertexId) -> Result<A>) -> Result<f64> {
    let mut times = Vec::with_capacity(vertices.len());
    for &vertex in vertices {
        let start = Instant::now();
        // Kept until the clock has stopped, so that the work is not optimised away.
        let answer = solve(vertex)?;
        times.push(milliseconds(start));
        drop(answer);
    }
    times.sort_by(f64::total_cmp);
    Ok(0.5 * (times[(times.len() - 1) / 2] + times[times.len() / 2]))
}
