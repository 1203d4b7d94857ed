//! `heatwalk sample`.

use std::sync::Arc;
use std::time::Instant;

use anyhow::Result;
use heatwalk::{Element, SampleCount, Surface, VertexId, farthest_samples, go_on};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;
use serde_json::json;

use crate::args::Sample;
use crate::input::Input;
use crate::output::Output;
use crate::question::joined;
use crate::report::milliseconds;
use crate::volume;

/// Spreads samples over a surface.
pub fn sample(arguments: &Sample) -> Result<String> {
    volume::Input::refuse(&arguments.mesh, "samples are of a surface, not of the inside")?;
    let output = arguments.output.as_deref().map(Output::places).transpose()?;
    let input = Input::of(&arguments.mesh)?;
    let (mut solver, mut report, build_ms) = joined(&input, &arguments.mesh, &arguments.bridging)?;
    let surface = Arc::clone(solver.surface());
    let start = Instant::now();
    let first = match arguments.seed {
        None => first_vertex(&surface),
        Some(seed) => VertexId(SplitMix64::seed_from_u64(seed).random_range(0..surface.vertex_count() as u32)),
    };
    let count = match (arguments.count, arguments.radius) {
        (_, Some(radius)) => SampleCount::Within(radius),
        (count, None) => SampleCount::Exactly(count.unwrap_or(1)),
    };
    let samples = farthest_samples(solver.exact_geometry(), first, count, &mut go_on)?;
    let sample_ms = milliseconds(start);
    let numbers: Vec<usize> =
        samples.vertices.iter().map(|&vertex| surface.inputs_of_vertex(vertex)[0].index()).collect();
    if let Some(output) = output {
        let positions = numbers.iter().map(|&number| input.model.soup.positions[number]);
        output.write(numbers.iter().copied().zip(positions), arguments.axis.up)?;
    }
    report.push("samples", numbers.len());
    report.push("covering_radius", samples.covering_radius());
    report.push("places", numbers);
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "sample": sample_ms }));
    Ok(report.render(arguments.mesh.json))
}

/// That of the first vertex of the file that is on the surface.
fn first_vertex(surface: &Surface) -> VertexId {
    surface.vertices_of_inputs().iter().copied().flatten().next().unwrap_or(VertexId(0))
}
