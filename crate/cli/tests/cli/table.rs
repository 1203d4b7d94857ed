//! Table 1 of the report.

use serde_json::Value;

use crate::{folder, json, refused, run, succeed};

const SOLVERS: [&str; 2] = ["conjugate_gradients", "cholesky"];

#[test]
fn a_row_for_each_mesh() {
    let folder = folder("table");
    let text = succeed(&folder, &["table", "torus.ply", "two.obj", "grid.ply", "--repeat", "4"]);
    let lines: Vec<&str> = text.lines().take_while(|line| line.starts_with('|')).collect();
    assert_eq!(lines.len(), 5, "{text}");
    assert!(lines.iter().all(|line| line.chars().count() == lines[0].chars().count()), "{text}");
    let cells = |line: &str| line.split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    assert_eq!(cells(lines[0])[1..=2], ["mesh", "triangles"]);
    for (line, name, triangles) in [(2, "torus.ply", "576"), (3, "two.obj", "2"), (4, "grid.ply", "200")] {
        let cells = cells(lines[line]);
        assert_eq!(cells[1..=2], [name, triangles]);
        // Six columns between the outer bars.
        assert_eq!(cells.len(), 8, "{text}");
        assert!(cells[3..7].iter().all(|cell| cell.parse::<f64>().unwrap() >= 0.0), "{text}");
    }
    assert!(text.contains("4 with Cholesky, 3 with conjugate gradients"), "{text}");
    let one = succeed(&folder, &["table", "torus.ply", "--repeat", "1", "--exact"]);
    assert!(one.contains("1 with Cholesky, 1 with conjugate gradients") && one.contains("far field"), "{one}");
    assert_eq!(cells(one.lines().nth(2).unwrap()).len(), 10, "{one}");
}

#[test]
fn json_has_an_object_for_each_mesh() {
    let folder = folder("table_json");
    let rows = json(&folder, &["table", "torus.ply", "grid.ply", "--repeat", "2"]);
    let rows = rows.as_array().unwrap();
    assert_eq!(rows.len(), 2);
    for (row, name, triangles) in [(&rows[0], "torus.ply", 576), (&rows[1], "grid.ply", 200)] {
        assert_eq!((&row["name"], &row["triangles"]), (&name.into(), &triangles.into()));
        for solver in SOLVERS {
            for key in ["precompute_ms", "solve_ms"] {
                assert!(row[solver][key].as_f64().unwrap() > 0.0, "{solver} {key}: {row}");
            }
            assert!(row[solver].get("mean_error_percent").is_none());
        }
    }
}

#[test]
fn shapes_and_single_parts_have_rows() {
    let folder = folder("table_parts");
    let rows = json(&folder, &["table", "shape:strip", "two.obj#0", "two.obj", "--repeat", "1"]);
    assert_eq!((&rows[0]["name"], &rows[1]["name"]), (&"shape:strip".into(), &"two.obj#0".into()));
    assert_eq!((&rows[1]["triangles"], &rows[2]["triangles"]), (&1.into(), &2.into()));
    assert!(rows[0]["triangles"].as_u64().unwrap() > 100);
    let output = run(&folder, &["table", "two.obj#7"]);
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(!output.status.success() && error.contains("two.obj#7") && error.contains("part 7"), "{error}");
    let error = refused(&folder, &["info", "shape:cuboid"]);
    assert!(error.contains("cuboid") && error.contains("torus"), "{error}");
}

#[test]
fn errors_are_against_exact_distances() {
    let folder = folder("table_exact");
    let options = ["--near", "0", "--t", "1", "--operator", "plain", "--boundary", "neumann"];
    let arguments = [&["torus.ply", "--exact", "--repeat", "1"], &options[..]].concat();
    let rows = json(&folder, &[&["table"], &arguments[..]].concat());
    let compared = json(&folder, &[&["distance", "torus.ply", "--source", "0", "--compare"], &options[..]].concat());
    for key in ["mean_error_percent", "max_error_percent"] {
        let expected = compared[key].as_f64().unwrap();
        assert!(expected > 0.1, "the heat method is not exact: {compared}");
        for solver in SOLVERS {
            let value = rows[0][solver][key].as_f64().unwrap();
            // The torus is so small that conjugate gradients lose nothing.
            assert!((value - expected).abs() < 1e-3, "{solver} {key}: {value} {expected}");
        }
    }
}

#[test]
fn the_others_are_done_where_a_mesh_fails() {
    let folder = folder("table_failure");
    let meshes = ["table", "missing.off", "torus.ply", "cut.ply", "grid.ply", "--repeat", "1"];
    let output = run(&folder, &meshes);
    let [stdout, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(stderr.lines().count(), 2, "{stderr}");
    assert!(stderr.lines().zip(["missing.off", "cut.ply"]).all(|(line, name)| line.contains(name)), "{stderr}");
    assert!(stdout.contains("| missing.off |         – |"), "{stdout}");
    assert!(
        stdout.contains("| torus.ply   |       576 |") && stdout.contains("| grid.ply    |       200 |"),
        "{stdout}"
    );

    let output = run(&folder, &[&meshes[..], &["--json"]].concat());
    assert_eq!(output.status.code(), Some(2));
    let rows: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(rows[0]["error"].as_str().unwrap().contains("missing.off"), "{rows}");
    assert!(rows[2]["error"].as_str().unwrap().contains("cut short"), "{rows}");
    assert_eq!((&rows[1]["triangles"], &rows[3]["triangles"]), (&576.into(), &200.into()));
}

#[test]
fn bad_usage_of_the_table_is_refused() {
    let folder = folder("table_refused");
    assert!(refused(&folder, &["table"]).contains("<MESH>"));
    assert!(refused(&folder, &["table", "torus.ply", "--repeat", "0"]).contains("repeat"));
    assert!(refused(&folder, &["table", "torus.ply", "--t", "0"]).contains("positive"));
}
