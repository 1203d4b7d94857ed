//! Work with the time that it takes.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use anyhow::Result;
use heatwalk::{HeatSolver, Parameters, Source, Surface, SurfacePoint};

use crate::input::Input;
use crate::report::milliseconds;

pub fn build(input: &Input) -> Result<(Arc<Surface>, f64)> {
    let start = Instant::now();
    let surface = Surface::build(&input.soup)?;
    Ok((Arc::new(surface), milliseconds(start)))
}

pub fn factor(surface: &Arc<Surface>, parameters: Parameters) -> Result<(HeatSolver, f64)> {
    let start = Instant::now();
    let solver = HeatSolver::new(Arc::clone(surface), parameters, &mut |_, _| ControlFlow::Continue(()))?;
    Ok((solver, milliseconds(start)))
}

/// Median time of a solve over `count` single sources, the same ones at every run.
pub fn median_solve_ms<A>(surface: &Surface, count: u32, mut solve: impl FnMut(Source) -> Result<A>) -> Result<f64> {
    let points = surface.point_count() as u64;
    let mut state = 1_u64;
    let mut times = Vec::with_capacity(count as usize);
    for _ in 0..count {
        // Multiplier and increment of Knuth's MMIX; its high bits are the random ones.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let source = SurfacePoint::Vertex(((state >> 33) % points) as u32).into();
        let start = Instant::now();
        // Kept until the clock has stopped, so that the work is not optimised away.
        let answer = solve(source)?;
        times.push(milliseconds(start));
        drop(answer);
    }
    times.sort_by(f64::total_cmp);
    Ok(0.5 * (times[(times.len() - 1) / 2] + times[times.len() / 2]))
}
