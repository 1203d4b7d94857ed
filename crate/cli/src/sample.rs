//! `heatwalk sample`.

use std::sync::Arc;
use std::time::Instant;

use anyhow::Result;
use glam::DVec3;
use heatwalk::exact::exact_distance;
use heatwalk::{Element, InputPlace, SampleCount, VertexId, farthest_samples, go_on, relaxed};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;
use serde_json::{Value, json};

use crate::args::Sample;
use crate::input::Input;
use crate::output::Output;
use crate::place::Place;
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
        None => surface.first_vertex(),
        Some(seed) => VertexId(SplitMix64::seed_from_u64(seed).random_range(0..surface.vertex_count() as u32)),
    };
    let count = match (arguments.count, arguments.radius) {
        (_, Some(radius)) => SampleCount::Within(radius),
        (count, None) => SampleCount::Exactly(count.unwrap_or(1)),
    };
    let samples = farthest_samples(solver.exact_geometry(), first, count, &mut go_on)?;
    let mut radius = samples.covering_radius();
    let mut places: Vec<(Value, DVec3)> = Vec::new();
    let soup = &input.model.soup;
    if arguments.relax > 0 {
        let geometry = solver.exact_geometry();
        let relaxed = relaxed(geometry, &samples.vertices, arguments.relax, &mut go_on)?;
        let distances = exact_distance(&surface, &relaxed, &mut go_on)?;
        radius = distances.iter().copied().fold(0.0, f64::max);
        places.extend(relaxed.iter().map(|sample| {
            let place = sample.place();
            let written = Place::from(InputPlace::of(place, place.faces(&surface)[0], soup, &surface));
            (json!(written.to_string()), place.position(&surface))
        }));
    } else {
        let number = |&vertex: &VertexId| surface.inputs_of_vertex(vertex)[0].index();
        places.extend(samples.vertices.iter().map(number).map(|number| (json!(number), soup.positions[number])));
    }
    let sample_ms = milliseconds(start);
    if let Some(output) = output {
        // Weights are apart by commas.
        let written = |place: &Value| place.as_str().map_or_else(|| place.to_string(), |place| format!("\"{place}\""));
        output.write(places.iter().map(|(place, position)| (written(place), *position)), arguments.axis.up)?;
    }
    report.push("samples", places.len());
    report.push("covering_radius", radius);
    report.push("places", places.into_iter().map(|(place, _)| place).collect::<Vec<_>>());
    report.push("timings_ms", json!({ "read": input.read_ms, "build": build_ms, "sample": sample_ms }));
    Ok(report.render(arguments.mesh.json))
}
