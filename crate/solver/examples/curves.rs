//! Distance from curves beside that from a point, in time, and against distance from points along the curve.
//!
//! `cargo run --release -p heatwalk --example curves -- MESH...`

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use heatwalk::exact::{ExactGeometry, exact_distance};
use heatwalk::{
    Curve, Element, FaceId, Place, Source, Surface, VertexId, curve_distance, go_on, signed_curve_distance,
};
use heatwalk_model::io;

/// Runs of each that are timed, in turn.
const RUNS: usize = 9;

/// Places that each curve goes through.
const PLACES: usize = 6;

/// Points along the curve.
const POINTS: f64 = 10_000.0;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| mesh | lines | point, ms | curve / point | signed / point | above points | below points, by spacing² / d |"
    );
    println!("|---|---|---|---|---|---|---|");
    std::env::args().skip(1).try_for_each(|path| measure(Path::new(&path)))
}

fn measure(path: &Path) -> Result<(), Box<dyn Error>> {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().unwrap_or(Path::new(""));
    let soup = io::read(&name, &fs::read(path)?, &|uri| fs::read(folder.join(uri)).ok())?.soup;
    let surface = Arc::new(Surface::build(&soup)?);
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
    let main = surface.component(surface.faces()[FaceId(0)][0]);
    let faces: Vec<FaceId> =
        surface.faces().ids().filter(|&face| surface.component(surface.faces()[face][0]) == main).collect();
    let place = |k: usize| Place::Face { face: faces[k * 7919 * 31 % faces.len()], weights: [0.5, 0.2, 0.3] };
    let places: Vec<Place> = (1..=PLACES).map(place).collect();
    let curve = Curve::through(&geometry, &places, true, &mut go_on)?;

    let [mut point, mut ratios, mut signed] = [Vec::new(), Vec::new(), Vec::new()];
    for _ in 0..RUNS {
        let timed = |run: &dyn Fn() -> heatwalk::Result<()>| -> heatwalk::Result<f64> {
            let start = Instant::now();
            run()?;
            Ok(1e3 * start.elapsed().as_secs_f64())
        };
        let of_point = timed(&|| exact_distance(&surface, &[places[0]], &mut go_on).map(|all| drop(black_box(all))))?;
        let curves = [curve.clone()];
        let of_curve = timed(&|| curve_distance(&geometry, &curves, &mut go_on).map(|all| drop(black_box(all))))?;
        let with_sign =
            timed(&|| signed_curve_distance(&geometry, &curves, &mut go_on).map(|all| drop(black_box(all))))?;
        point.push(of_point);
        ratios.push(of_curve / of_point);
        signed.push(with_sign / of_point);
    }

    let spacing = curve.length(&surface)? / POINTS;
    let of_points = exact_distance(&surface, &points(&surface, &curve, spacing)?, &mut go_on)?;
    let found = curve_distance(&geometry, &[curve.clone()], &mut go_on)?;
    let (mut above, mut below) = (0.0_f64, 0.0_f64);
    for vertex in (0..surface.vertex_count()).map(VertexId::from_index).filter(|&vertex| found[vertex].is_finite()) {
        let excess = of_points[vertex] - found[vertex];
        above = above.max(-excess / of_points[vertex]);
        if found[vertex] > 10.0 * spacing {
            below = below.max(excess * found[vertex] / (spacing * spacing));
        }
    }
    let [point, ratio, signed] = [point, ratios, signed].map(median);
    let lines = curve.lines().len();
    println!("| {name} | {lines} | {point:.1} | {ratio:.2} | {signed:.2} | {above:.1e} | {below:.3} |");
    Ok(())
}

fn points(surface: &Surface, curve: &Curve, spacing: f64) -> heatwalk::Result<Vec<Source>> {
    let mut sources = Vec::new();
    for line in curve.lines() {
        let [start, end] = line.ends.map(|place| place.weights_in(surface, line.face));
        let length = line.ends[0].position(surface).distance(line.ends[1].position(surface));
        let parts = (length / spacing).ceil().max(1.0);
        for part in 0..=parts as u32 {
            let share = f64::from(part) / parts;
            let weights = std::array::from_fn(|k| start[k] + share * (end[k] - start[k]));
            sources.push(surface.source(Place::Face { face: line.face, weights }, 0.0)?);
        }
    }
    Ok(sources)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
