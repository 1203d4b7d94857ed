//! The real binary on small files.

mod animations;
mod batch;
mod brains;
mod cells;
mod clouds;
mod coordinates;
mod curves;
mod directions;
mod exact;
mod files;
mod fill;
mod ground;
mod index;
mod isolines;
mod joining;
mod lists;
mod loops;
mod matrix;
mod method;
mod options;
mod pairs;
mod paths;
mod samples;
mod sources;
mod table;
mod usage;
mod volume;
mod walks;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use heatwalk::Soup;
use heatwalk_model::io::write;
use heatwalk_shapes as shapes;
use serde_json::Value;

/// A flat unit square whose coordinates are exact. Vertex `(i, j)` is number `9 i + j`, at x = i / 8, z = −j / 8.
fn flat() -> Soup {
    shapes::grid(8, 8)
}

/// A folder of its own for each test, with a torus, two flat unit squares, a damaged file and one of two components.
fn folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    fs::create_dir_all(&folder).unwrap();
    for (name, soup) in
        [("torus.ply", shapes::torus(1.0, 0.4, 24, 12)), ("grid.ply", shapes::grid(10, 10)), ("flat.ply", flat())]
    {
        fs::write(folder.join(name), write::distance_ply(&soup, &vec![0.0; soup.positions.len()])).unwrap();
    }
    let whole = fs::read(folder.join("torus.ply")).unwrap();
    fs::write(folder.join("cut.ply"), &whole[..whole.len() / 2]).unwrap();
    let two = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 9 9 9\ng near\nf 1 2 3\ng far\nf 4 5 6\n";
    fs::write(folder.join("two.obj"), two).unwrap();
    folder
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_heatwalk")).current_dir(folder).args(arguments).output().unwrap()
}

fn succeed(folder: &Path, arguments: &[&str]) -> String {
    let output = run(folder, arguments);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && stderr.is_empty(), "{arguments:?}: {stderr}");
    String::from_utf8(output.stdout).unwrap()
}

fn json(folder: &Path, arguments: &[&str]) -> Value {
    let text = succeed(folder, &[arguments, &["--json"]].concat());
    serde_json::from_str(&text).unwrap()
}

/// Exit code 2, nothing on standard output, exactly one line on standard error, which is returned.
fn refused(folder: &Path, arguments: &[&str]) -> String {
    let output = run(folder, arguments);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {stderr}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    assert_eq!(stderr.lines().count(), 1, "{arguments:?}: {stderr}");
    assert!(stderr.ends_with('\n'));
    stderr
}

/// What `distance` answers, one value an input vertex.
fn distances(folder: &Path, arguments: &[&str]) -> Vec<f64> {
    succeed(folder, &[&["distance"], arguments, &["--output", "distances.csv"]].concat());
    let csv = fs::read_to_string(folder.join("distances.csv")).unwrap();
    csv.lines().skip(1).map(|line| line.split_once(',').unwrap().1.parse().unwrap()).collect()
}

/// The largest difference of two answers.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn zeros(values: &[f64]) -> Vec<usize> {
    (0..values.len()).filter(|&vertex| values[vertex] == 0.0).collect()
}
