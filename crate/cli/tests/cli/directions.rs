//! Log maps, and vectors carried along shortest paths.

use std::fs;
use std::path::Path;

use serde_json::json;

use crate::{flat, folder, json as answered, refused, succeed};

/// The rows of a file that a command writes, without the header and the numbers of the vertices.
fn rows(folder: &Path, arguments: &[&str], header: &str) -> Vec<Vec<f64>> {
    succeed(folder, &[arguments, &["--output", "out.csv"]].concat());
    let csv = fs::read_to_string(folder.join("out.csv")).unwrap();
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some(header));
    let numbers = |(number, line): (usize, &str)| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        assert_eq!(cells[0], number as f64);
        cells[1..].to_vec()
    };
    lines.enumerate().map(numbers).collect()
}

#[test]
fn the_log_map_of_a_square_is_where_its_vertices_lie() {
    let folder = folder("log_map");
    let positions = flat().positions;
    for (place, from) in [("40", positions[40]), ("0:0,0,1", positions[flat().triangles[0][2] as usize])] {
        let arguments = ["log-map", "flat.ply", "--source", place, "--direction", "2,7,0"];
        // Seen from above, z points down where x points to the right.
        for (row, position) in rows(&folder, &arguments, "vertex,u,v").iter().zip(&positions) {
            let expected = [position.x - from.x, from.z - position.z];
            assert!((row[0] - expected[0]).abs() < 1e-12 && (row[1] - expected[1]).abs() < 1e-12, "{row:?}");
        }
    }
    for method in ["heat", "propagation"] {
        let arguments = ["log-map", "flat.ply", "--source", "40", "--method", method];
        assert_eq!(answered(&folder, &arguments)["method"], method);
        for (row, position) in rows(&folder, &arguments, "vertex,u,v").iter().zip(&positions) {
            let expected = [position.x - positions[40].x, positions[40].z - position.z];
            assert!((row[0] - expected[0]).abs() < 1e-9 && (row[1] - expected[1]).abs() < 1e-9, "{row:?}");
        }
    }
    let answer = answered(&folder, &["log-map", "flat.ply", "--source", "40"]);
    assert_eq!((&answer["method"], &answer["unreachable"]), (&json!("exact"), &json!(0)));
    assert_eq!((&answer["u_axis"], &answer["v_axis"]), (&json!([1.0, 0.0, 0.0]), &json!([0.0, 0.0, -1.0])));
    assert!(
        succeed(&folder, &["log-map", "flat.ply", "--source", "40"]).contains("\nu axis                 1.0,0.0,0.0\n")
    );
}

#[test]
fn vectors_on_a_square_are_those_of_the_nearest_place() {
    let folder = folder("transport");
    let arguments = ["transport", "flat.ply", "--vector", "0:1,9,-2", "--vector", "127:0.2,0.3,0.5:-3,0,0"];
    let vectors = rows(&folder, &arguments, "vertex,x,y,z");
    let expected = [[1.0, 0.0, -2.0], [-3.0, 0.0, 0.0]];
    for (vertex, expected) in [(0, expected[0]), (20, expected[0]), (60, expected[1]), (80, expected[1])] {
        assert!(vectors[vertex].iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{:?}", vectors[vertex]);
    }
    let turned = rows(&folder, &[&arguments[..], &["--up", "z"]].concat(), "vertex,x,y,z");
    assert!((turned[0][1] + 2.0).abs() < 1e-12, "{:?}", turned[0]);
}

#[test]
fn what_is_not_reached_has_no_numbers() {
    let folder = folder("directions_unreached");
    let row = rows(&folder, &["log-map", "two.obj", "--source", "0"], "vertex,u,v");
    let is_number: Vec<bool> = row.iter().map(|row| row.iter().all(|number| number.is_finite())).collect();
    assert_eq!(is_number, [true, true, true, false, false, false, false]);
    let by_heat = answered(
        &folder,
        &["transport", "flat.ply", "--vector", "0:1,9,-2", "--method", "heat", "--output", "heat.csv"],
    );
    assert_eq!((&by_heat["method"], &by_heat["without_vector"]), (&"heat".into(), &0.into()));
    for row in fs::read_to_string(folder.join("heat.csv")).unwrap().lines().skip(1) {
        let numbers: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        assert!((numbers[1] - 1.0).abs() < 1e-9 && numbers[2].abs() < 1e-9 && (numbers[3] + 2.0).abs() < 1e-9, "{row}");
    }
    let carried = answered(&folder, &["transport", "two.obj", "--vector", "0:1,0,0"]);
    assert_eq!(carried["without_vector"], json!(4));
}

#[test]
fn refuses_what_is_no_direction_and_no_vector() {
    let folder = folder("directions_refused");
    let map = |more: &[&str]| refused(&folder, &[&["log-map", "flat.ply"], more].concat());
    assert!(map(&[]).contains("--source"));
    assert!(map(&["--source", "3", "--source", "4"]).contains("--source"));
    assert!(map(&["--source", "999"]).contains("999"));
    assert!(map(&["--source", "3", "--direction", "0,1,0"]).contains("not square to the surface"));
    assert!(map(&["--source", "3", "--method", "auto"]).contains("exact"));
    assert!(map(&["--source", "3", "--output", "a.ply"]).contains("log maps are written as .csv"));
    let vector = |text: &str| refused(&folder, &["transport", "flat.ply", "--vector", text]);
    assert!(vector("3:0,1,0").contains("not square to the surface"));
    assert!(vector("3:0,0,0").contains("not square to the surface"));
    assert!(vector("3").contains("three numbers"));
    assert!(vector("999:1,0,0").contains("999"));
    assert!(refused(&folder, &["transport", "flat.ply"]).contains("--vector"));
    assert!(refused(&folder, &["log-map", "shape:cube", "--source", "0"]).contains("not of the inside of tetrahedra"));
    assert!(refused(&folder, &["transport", "shape:cube", "--vector", "0:1,0,0"]).contains("not inside of tetrahedra"));
}
