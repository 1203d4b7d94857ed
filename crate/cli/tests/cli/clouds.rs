//! Files of points without faces.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use heatwalk_shapes as shapes;
use serde_json::Value;

use crate::{flat, folder, refused, run};

/// What a command answers on a cloud, and the line that it says on standard error.
fn told(folder: &Path, arguments: &[&str]) -> (Value, String) {
    let output = run(folder, &[arguments, &["--json"]].concat());
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {stderr}");
    (serde_json::from_slice(&output.stdout).unwrap(), stderr)
}

/// Lines of three numbers.
fn lines(points: impl Iterator<Item = glam::DVec3>, before: &str) -> String {
    points.fold(String::new(), |mut text, point| {
        writeln!(text, "{before}{} {} {}", point.x, point.y, point.z).unwrap();
        text
    })
}

#[test]
fn points_of_any_format_are_a_surface_and_it_is_said_what_joins_them() {
    let folder = folder("clouds");
    let points = flat().positions;
    let body = lines(points.iter().copied(), "");
    let header =
        "ply\nformat ascii 1.0\nelement vertex 81\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
    for (name, text) in [
        ("a.ply", format!("{header}{body}")),
        ("a.obj", format!("{}p 1\n", lines(points.iter().copied(), "v "))),
        ("a.off", format!("OFF 81 0 0\n{body}")),
        ("a.xyz", body.clone()),
        ("a.csv", format!("x,y,z\n{}", body.replace(' ', ","))),
    ] {
        fs::write(folder.join(name), text).unwrap();
        let (answer, said) = told(&folder, &["path", name, "--from", "0", "--to", "80", "--exact"]);
        assert!((answer["length"].as_f64().unwrap() - 2.0_f64.sqrt()).abs() < 1e-12, "{answer}");
        let joined = "81 points without faces were joined by 128 triangles; 1 boundary loop; 0 points on no triangle";
        assert_eq!(said, format!("heatwalk: warning: {name}, {joined}\n"));
        let cloud = serde_json::json!({ "points": 81, "triangles": 128, "boundary_loops": 1, "unjoined_points": 0 });
        assert_eq!((&answer["cloud"], &answer["warnings"]), (&cloud, &serde_json::json!([])));
    }
    assert!(told(&folder, &["info", "flat.ply"]).0.get("cloud").is_none());
}

#[test]
fn what_works_on_meshes_works_on_clouds_and_points_keep_their_numbers() {
    let folder = folder("clouds_all");
    let mut points = shapes::icosphere(3).positions;
    points.insert(5, glam::DVec3::NAN);
    fs::write(folder.join("ball.xyz"), lines(points.iter().copied(), "")).unwrap();
    let (answer, said) = told(&folder, &["distance", "ball.xyz", "--source", "0", "--output", "d.csv"]);
    assert!(said.contains("0 boundary loops; 1 point on no triangle"), "{said}");
    assert_eq!(answer["unreachable"], 1);
    assert!((answer["max_distance"].as_f64().unwrap() - std::f64::consts::PI).abs() < 0.02);
    let rows = fs::read_to_string(folder.join("d.csv")).unwrap();
    assert!(rows.lines().count() == points.len() + 1 && rows.contains("\n5,inf\n"), "{rows}");
    for arguments in [
        &["isolines", "ball.xyz", "--source", "0", "--count", "3"][..],
        &["cells", "ball.xyz", "--source", "0", "--source", "90"],
        &["sample", "ball.xyz", "--count", "5"],
        &["mean", "ball.xyz", "--source", "10", "--source", "20"],
        &["walk", "ball.xyz", "--from", "0", "--direction", "1,0,0", "--length", "1"],
        &["log-map", "ball.xyz", "--source", "9"],
        &["distance", "ball.xyz", "--source", "0", "--method", "heat", "--output", "d.ply"],
        &["info", "ball.xyz"],
    ] {
        let (answer, said) = told(&folder, arguments);
        assert!(said.contains("643 points without faces"), "{said}");
        assert_eq!(answer["cloud"]["unjoined_points"], 1);
    }
    assert!(told(&folder, &["info", "d.ply"]).0.get("cloud").is_none(), "written with its triangles");
}

#[test]
fn what_is_no_surface_is_refused_in_a_sentence() {
    let folder = folder("clouds_refused");
    let refuse = |text: &str| {
        fs::write(folder.join("a.xyz"), text).unwrap();
        refused(&folder, &["distance", "a.xyz", "--source", "0"])
    };
    assert!(refuse("").contains("a.xyz is empty"));
    assert!(
        refuse("1 2 3\n")
            .contains("three points at least that are different and finite, and of the 1 here so many are: 1")
    );
    assert!(refuse(&"1 2 3\n".repeat(9)).contains("of the 9 here so many are: 1"));
    assert!(refuse(&(0..9).map(|k| format!("{k} {k} 0\n")).collect::<String>()).contains("lie on lines"));
    assert!(refuse("1 2\n").contains("line 1: a point needs three numbers"));
    let surface_of_free_form = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nsurf 0 1 0 1 1\n";
    fs::write(folder.join("a.obj"), surface_of_free_form).unwrap();
    assert!(refused(&folder, &["info", "a.obj"]).contains("free form"));
}
