//! Errors and times of distances inside of meshes, against closed forms: `cargo run --release -p heatwalk-volume --example inside
//! [--large] [--write FOLDER]`. With `--large`, also meshes of half a million tetrahedra. With `--write`, each
//! mesh is left in FOLDER with its source and its exact distances, for other programs to be asked the same, and `million.msh` is a cube
//! of a million tetrahedra. The time of a source is the median of nine, after another source.

#[path = "../tests/common/mod.rs"]
mod common;

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::time::Instant;

use common::{around_cylinder, around_sphere};
use glam::DVec3;
use heatwalk::VertexId;
use heatwalk::go_on;
use heatwalk_volume::io::write;
use heatwalk_volume::{TetMesh, TetSoup, VolumeMethod, VolumeOptions, VolumeSolver, shapes};

/// Exact distance between two places.
type Exact = fn(DVec3, DVec3) -> f64;

/// Name, mesh, places of sources by their names, and exact distances.
type Case = (&'static str, TetSoup, [(&'static str, DVec3); 2], Exact);

/// How often a source is asked for.
const TIMES: usize = 9;

const HOLE: f64 = 0.4;
const INNER: f64 = 0.5;

/// Cells along each side of a cube of about a million tetrahedra.
const MILLION: usize = 55;

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let folder = arguments.iter().position(|argument| argument == "--write").and_then(|place| arguments.get(place + 1));
    let sizes = if arguments.iter().any(|argument| argument == "--large") { 3 } else { 2 };
    println!(
        "| mesh | tetrahedra | source | march mean / max (%) | heat mean / max (%) | march (ms) | heat precompute / solve (ms) |"
    );
    println!("| --- | ---: | --- | ---: | ---: | ---: | ---: |");
    for size in 0..sizes {
        let scale = 1 << size;
        let straight: Exact = DVec3::distance;
        let beside = |x, y, z| [("middle", DVec3::ZERO), ("aside", DVec3::new(x, y, z))];
        let cases: [Case; 5] = [
            ("cube", shapes::cube(12 * scale, 0.2), beside(-0.7, 0.4, 0.9), straight),
            ("ball", shapes::ball(8 * scale, 0.2), beside(-0.7, 0.4, 0.3), straight),
            ("tube", shapes::straight_tube(4.0, 7 * scale, 0.2), beside(-3.7, 0.4, 0.3), straight),
            (
                "pierced cube",
                shapes::pierced_cube(HOLE, 4 * scale, 0.15),
                [("inside", DVec3::new(-0.7, 0.0, 0.0)), ("at the hole", DVec3::new(-HOLE, 0.0, 0.4))],
                |a, b| around_cylinder(HOLE)(a, b),
            ),
            (
                "cave",
                shapes::cave(INNER, 4 * scale, 0.15),
                [("inside", DVec3::new(-0.7, 0.1, 0.2)), ("at the inner sphere", DVec3::new(-INNER, 0.0, 0.0))],
                |a, b| around_sphere(INNER)(a, b),
            ),
        ];
        for (name, soup, sources, exact) in cases {
            measure(name, &soup, &sources, exact, folder.map(Path::new));
        }
    }
    if let Some(folder) = folder {
        let million = write::msh(&shapes::cube(MILLION, 0.2), None);
        fs::write(Path::new(folder).join("million.msh"), million).expect("the folder is there");
    }
}

fn measure(name: &str, soup: &TetSoup, sources: &[(&str, DVec3)], exact: Exact, folder: Option<&Path>) {
    let mesh = TetMesh::build(soup).expect("a generated mesh");
    let first = VertexId(0);
    let mut march = VolumeSolver::new(mesh);
    let mesh = march.mesh().clone();
    let mut heat = VolumeSolver::new(mesh.clone());
    let by_heat = VolumeOptions::by(VolumeMethod::Heat);
    let start = Instant::now();
    heat.prepare(&by_heat, &mut go_on).expect("a generated mesh");
    let precompute = milliseconds(start);
    for &(place, near) in sources {
        let nearest = |a: &usize, b: &usize| {
            let far = |vertex: usize| mesh.positions()[vertex].distance_squared(near);
            far(*a).total_cmp(&far(*b))
        };
        let source = VertexId((0..mesh.vertex_count()).min_by(nearest).expect("a vertex") as u32);
        let truth: Vec<f64> = mesh.positions().iter().map(|&position| exact(mesh.position(source), position)).collect();
        march.distance(&[first], &VolumeOptions::default()).expect("a vertex");
        let (marched, march_ms) = timed(|| march.distance(&[source], &VolumeOptions::default()).expect("a vertex"));
        heat.distance(&[first], &by_heat).expect("a vertex");
        let (heated, heat_ms) = timed(|| heat.distance(&[source], &by_heat).expect("a vertex"));
        let [march_errors, heat_errors] = [marched, heated].map(|distance| errors(&distance.values, &truth));
        let tetrahedra = mesh.tetrahedron_count();
        println!(
            "| {name} | {tetrahedra} | {place} | {march_errors} | {heat_errors} | {march_ms:.2} | {precompute:.0} / {heat_ms:.2} |"
        );
        if let Some(folder) = folder {
            write(&folder.join(format!("{name} {} {place}.txt", mesh.tetrahedron_count())), &mesh, source, &truth);
        }
    }
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

/// An answer, and the median of the milliseconds that it takes.
fn timed<T>(mut ask: impl FnMut() -> T) -> (T, f64) {
    let mut measured = || {
        let start = Instant::now();
        (ask(), milliseconds(start))
    };
    let mut times: Vec<f64> = (1..TIMES).map(|_| measured().1).collect();
    let (answer, last) = measured();
    times.push(last);
    times.sort_by(f64::total_cmp);
    (answer, times[TIMES / 2])
}

/// Mean and largest relative error, in per cent.
fn errors(values: &[f64], truth: &[f64]) -> String {
    let errors = values.iter().zip(truth).filter(|&(_, &truth)| truth > 0.0);
    let errors: Vec<f64> = errors.map(|(value, truth)| 100.0 * (value - truth).abs() / truth).collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    format!("{mean:.4} / {:.3}", errors.iter().copied().fold(0.0, f64::max))
}

/// Vertices with their exact distance, tetrahedra, and before them how many there are and the source.
fn write(path: &Path, mesh: &TetMesh, source: VertexId, truth: &[f64]) {
    let mut text = format!("{} {} {source}\n", mesh.vertex_count(), mesh.tetrahedron_count());
    for (position, truth) in mesh.positions().iter().zip(truth) {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{} {} {} {truth}", position.x, position.y, position.z);
    }
    for [a, b, c, d] in mesh.tetrahedra() {
        let _ = writeln!(text, "{a} {b} {c} {d}");
    }
    fs::write(path, text).expect("the folder is there");
}
