//! The log map beside distances, in time, and against exact paths, in degrees; that by heat against it; and vectors carried over the unit
//! sphere.
//!
//! `cargo run --release -p heatwalk --example directions -- MESH...`

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use glam::{DQuat, DVec3, dvec2};
use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::heat::VectorHeat;
use heatwalk::{Element, FaceId, Place, Surface, VertexId, Windows, go_on, log_map, propagated_log_map, transport};
use heatwalk_model::io;
use heatwalk_shapes::icosphere;

/// Pairs of a search and a log map that are timed.
const RUNS: usize = 15;

/// Vertices from which log maps are compared.
const SOURCES: usize = 9;

fn main() -> Result<(), Box<dyn Error>> {
    println!("| mesh | distances, ms | log map / distances, median | degrees from exact paths, median / 95 % / max |");
    println!("|---|---|---|---|");
    for path in std::env::args().skip(1) {
        measure(&surface_of(Path::new(&path))?, &path)?;
    }
    println!("\nlog maps, medians over vertices and {SOURCES} sources: degrees, share of the largest distance, ms");
    println!("| mesh | by propagation | by heat |");
    println!("|---|---|---|");
    for path in std::env::args().skip(1) {
        compare(&surface_of(Path::new(&path))?, &path)?;
    }
    sphere()
}

fn surface_of(path: &Path) -> Result<Arc<Surface>, Box<dyn Error>> {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().unwrap_or(Path::new(""));
    let soup = io::read(&name, &fs::read(path)?, &|uri| fs::read(folder.join(uri)).ok())?.soup;
    Ok(Arc::new(Surface::build(&soup)?))
}

/// Other log maps against that of exact paths, from vertices.
fn compare(surface: &Arc<Surface>, name: &str) -> Result<(), Box<dyn Error>> {
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(surface)));
    let heat = VectorHeat::new(surface, &mut go_on)?;
    let mut measured: [[Vec<f64>; 3]; 2] = Default::default();
    for source in (0..SOURCES).map(|place| VertexId::from_index(place * surface.vertex_count() / SOURCES)) {
        let exact = log_map(&geometry, source, None, &mut go_on)?;
        let most = exact.distances.iter().copied().filter(|distance| distance.is_finite()).fold(0.0, f64::max);
        for (is_by_heat, [angles, errors, times]) in [false, true].into_iter().zip(&mut measured) {
            let start = Instant::now();
            let other = if is_by_heat {
                heat.log_map(source, None, &mut go_on)?
            } else {
                propagated_log_map(&geometry, source, None, Windows::default(), &mut go_on)?
            };
            times.push(1e3 * start.elapsed().as_secs_f64());
            for vertex in surface.vertices().filter(|&vertex| vertex != source && exact.distances[vertex].is_finite()) {
                let [expected, place] = [&exact, &other].map(|map| map.coordinates[vertex]);
                angles.push(place.angle_to(expected).abs().to_degrees());
                errors.push(100.0 * place.distance(expected) / most);
            }
        }
    }
    let told = measured.map(|[mut angles, mut errors, mut times]| {
        let [angle, error, time] = [&mut angles, &mut errors, &mut times].map(|values| share(values, 0.5));
        format!("{angle:.2} / {error:.2} % / {time:.1}")
    });
    println!("| {name} | {} |", told.join(" | "));
    Ok(())
}

fn measure(surface: &Arc<Surface>, name: &str) -> Result<(), Box<dyn Error>> {
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(surface)));
    let face = FaceId::from_index(surface.face_count() / 3);
    let source = Place::Face { face, weights: [0.5, 0.2, 0.3] };
    let search = || -> heatwalk::Result<Wavefront> {
        let mut front = Wavefront::new(Arc::clone(&geometry), &[source])?;
        while !front.advance(f64::INFINITY, 20_000)? {}
        Ok(front)
    };
    let (mut fields, mut ratios) = (Vec::new(), Vec::new());
    for _ in 0..RUNS {
        let start = Instant::now();
        black_box(search()?.into_values());
        let field = start.elapsed().as_secs_f64();
        let start = Instant::now();
        black_box(log_map(&geometry, source, None, &mut go_on)?);
        fields.push(1e3 * field);
        ratios.push(start.elapsed().as_secs_f64() / field);
    }
    let (map, front) = (log_map(&geometry, source, None, &mut go_on)?, search()?);
    let mut angles = Vec::new();
    for vertex in surface.vertices().filter(|&vertex| front.values()[vertex].is_finite()) {
        let path = front.path_from_vertex(vertex)?;
        if let [.., before, end] = &path.points[..] {
            let first = before.position - end.position;
            let expected = dvec2(first.dot(map.axes[0]), first.dot(map.axes[1]));
            let mapped = map.coordinates[vertex];
            angles.push(mapped.perp_dot(expected).atan2(mapped.dot(expected)).abs().to_degrees());
        }
    }
    let [field, ratio] = [&mut fields, &mut ratios].map(|values| share(values, 0.5));
    let [median, most, largest] = [0.5, 0.95, 1.0].map(|part| share(&mut angles, part));
    println!("| {name} | {field:.1} | {ratio:.2} | {median:.1e} / {most:.1e} / {largest:.1e} |");
    Ok(())
}

/// On three quarters of the unit sphere, whose great circles turn vectors about their axes.
fn sphere() -> Result<(), Box<dyn Error>> {
    let surface = Arc::new(Surface::build(&icosphere(5))?);
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
    let heat = VectorHeat::new(&surface, &mut go_on)?;
    let [mut errors, mut by_heat] = [Vec::new(), Vec::new()];
    for source in (0..surface.vertex_count() as u32).step_by(997).map(VertexId) {
        let start = surface.position(source);
        let vector: DVec3 = start.any_orthonormal_vector();
        let carried = transport(&geometry, &[(source, vector)], &mut go_on)?;
        let diffused = heat.transport(&[(source, vector)], &mut go_on)?;
        for vertex in surface.vertices().filter(|&vertex| surface.position(vertex).dot(start) > -0.5) {
            let expected = DQuat::from_rotation_arc(start, surface.position(vertex)) * vector;
            errors.push(carried[vertex].angle_between(expected).to_degrees());
            by_heat.push(diffused[vertex].angle_between(expected).to_degrees());
        }
    }
    println!("\ntransport on the unit sphere of {} vertices, degrees, median / largest:", surface.vertex_count());
    for (name, mut errors) in [("exact paths", errors), ("heat", by_heat)] {
        let [median, largest] = [0.5, 1.0].map(|part| share(&mut errors, part));
        println!("{name}: {median:.3} / {largest:.3}");
    }
    Ok(())
}

/// The value that this share of all is not above.
fn share(values: &mut [f64], part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * part) as usize]
}
