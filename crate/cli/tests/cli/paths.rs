//! Paths.

use std::fs;

use serde_json::Value;

use crate::{flat, folder, json, refused, succeed};

#[test]
fn path_across_the_grid() {
    let folder = folder("path");
    // Along the diagonal of the unit square, corner to corner.
    for name in ["p.obj", "p.csv"] {
        let answer = json(&folder, &["path", "grid.ply", "--from", "0", "--to", "120", "--output", name]);
        let points = answer["points"].as_array().unwrap();
        assert_eq!(points[0], serde_json::json!([0.0, 0.0, 0.0]));
        assert_eq!(points[points.len() - 1], serde_json::json!([1.0, 0.0, -1.0]));
        let (length, distance) = (answer["length"].as_f64().unwrap(), answer["distance"].as_f64().unwrap());
        // No way is shorter than the straight one; ten cells across, the heat method is good to some percent.
        assert!((2.0_f64.sqrt() - 1e-9..1.5).contains(&length), "{length}");
        assert!((distance - 2.0_f64.sqrt()).abs() < 0.15, "{distance}");
    }
    assert!(fs::read_to_string(folder.join("p.obj")).unwrap().contains("\nl 1 2"));
    assert!(fs::read_to_string(folder.join("p.csv")).unwrap().starts_with("x,y,z\n"));
    assert!(succeed(&folder, &["path", "grid.ply", "--from", "3", "--to", "3"]).contains("length"));
}

/// Where `TRIANGLE:0.2,0.3,0.5` lies on the flat square.
fn place(triangle: usize) -> [f64; 3] {
    let soup = flat();
    let [a, b, c] = soup.triangles[triangle].map(|vertex| soup.positions[vertex as usize]);
    (a * 0.2 + b * 0.3 + c * 0.5).to_array()
}

fn length(from: [f64; 3], to: [f64; 3]) -> f64 {
    (from[0] - to[0]).hypot(from[2] - to[2])
}

fn number(answer: &Value, key: &str) -> f64 {
    answer[key].as_f64().unwrap()
}

fn end(answer: &Value, last: bool) -> [f64; 3] {
    let points = answer["points"].as_array().unwrap();
    let point = if last { points.last() } else { points.first() };
    serde_json::from_value(point.unwrap().clone()).unwrap()
}

#[test]
fn a_path_joins_places_inside_triangles() {
    let folder = folder("path_places");
    let ends = ["path", "flat.ply", "--from", "3:0.2,0.3,0.5", "--to", "100:0.2,0.3,0.5"];
    let straight = length(place(3), place(100));
    for options in
        [&["--near", "0"][..], &["--near", "0", "--solver", "cg"], &["--near", "0", "--straighten"], &["--exact"]]
    {
        let answer = json(&folder, &[&ends[..], options].concat());
        // A point of a face is a weighted sum of its corners, up to rounding.
        assert!(length(end(&answer, false), place(3)) < 1e-12, "{options:?}: {answer}");
        assert!(length(end(&answer, true), place(100)) < 1e-12, "{options:?}: {answer}");
        let length = number(&answer, "length");
        // No way is shorter than the straight one; eight cells across, that of the heat method is near it.
        assert!((straight - 1e-12..1.2 * straight).contains(&length), "{options:?}: {length} {straight}");
    }
}

#[test]
fn where_distances_are_exact_places_are_as_far_apart_as_the_path_is_long() {
    let folder = folder("path_exact_places");
    let places = [("3:0.2,0.4,0.4", "3:0.21,0.4,0.39"), ("3:0.2,0.3,0.5", "100:0.2,0.3,0.5"), ("7", "7:0.2,0.3,0.5")];
    for (from, to) in places.into_iter().chain([("3:0.2,0.3,0.5", "3:0.2,0.3,0.5")]) {
        let answer = json(&folder, &["path", "flat.ply", "--from", from, "--to", to]);
        let (distance, straight) = (number(&answer, "distance"), length(end(&answer, false), end(&answer, true)));
        assert_eq!(
            (distance, &answer["distance_interpolated"]),
            (number(&answer, "length"), &false.into()),
            "{answer}"
        );
        assert!((distance - straight).abs() < 1e-12, "{from} {to}: {distance} {straight}");
    }
    let by_heat = ["path", "flat.ply", "--from", "3:0.2,0.4,0.4", "--to", "80", "--method", "heat"];
    assert_eq!(json(&folder, &by_heat)["distance_interpolated"], true);
    let near_by_heat = ["path", "flat.ply", "--from", "3:0.2,0.4,0.4", "--to", "3:0.21,0.4,0.39", "--method", "heat"];
    let answer = json(&folder, &near_by_heat);
    assert_eq!((&answer["distance"], &answer["distance_interpolated"]), (&answer["length"], &false.into()), "{answer}");
}

#[test]
fn straightened_and_exact_paths_on_a_flat_square_are_straight() {
    let folder = folder("straight");
    for (from, to, straight) in [
        ("1", "75", 1.0_f64.hypot(0.25)),
        ("0", "80", 2.0_f64.sqrt()),
        ("5", "5", 0.0),
        ("3:0.2,0.3,0.5", "100:0.2,0.3,0.5", length(place(3), place(100))),
        ("3:0.2,0.3,0.5", "80", length(place(3), [1.0, 0.0, -1.0])),
    ] {
        let ends = ["path", "flat.ply", "--from", from, "--to", to];
        // On a flat convex surface every locally shortest path is straight, whatever it was made from.
        let straightened = json(&folder, &[&ends[..], &["--near", "0", "--straighten"]].concat());
        assert!((number(&straightened, "length") - straight).abs() < 1e-9, "{from} to {to}: {straightened}");
        let exact = json(&folder, &[&ends[..], &["--exact"]].concat());
        for key in ["length", "distance"] {
            assert!((number(&exact, key) - straight).abs() < 1e-9, "{from} to {to}, {key}: {exact}");
        }
        assert_eq!(exact["factor_nonzeros"], 0);
        for key in ["read", "build", "precompute", "solve", "path"] {
            assert!(exact["timings_ms"][key].as_f64().unwrap() >= 0.0, "{key}");
        }
    }
}

#[test]
fn straightening_never_lengthens() {
    let folder = folder("straighten_torus");
    let ends = ["path", "torus.ply", "--from", "5", "--to", "150"];
    let by_heat = [&ends[..], &["--near", "0"]].concat();
    let descent = number(&json(&folder, &by_heat), "length");
    let straightened = number(&json(&folder, &[&by_heat[..], &["--straighten"]].concat()), "length");
    let exact = number(&json(&folder, &[&ends[..], &["--exact"]].concat()), "length");
    assert!(straightened < descent, "{straightened} {descent}");
    assert!(exact <= straightened + 1e-12, "{exact} {straightened}");
}

#[test]
fn a_path_is_straightened_or_exact_and_stays_on_its_component() {
    let folder = folder("path_refused");
    let ends = ["path", "flat.ply", "--from", "0", "--to", "80"];
    assert!(refused(&folder, &[&ends[..], &["--exact", "--straighten"]].concat()).contains("cannot be used"));
    let apart = ["path", "two.obj", "--from", "0", "--to", "3"];
    assert!(refused(&folder, &[&apart[..], &["--straighten"]].concat()).contains("not connected"));
    assert!(refused(&folder, &[&apart[..], &["--exact"]].concat()).contains("not connected"));
}

#[test]
fn a_bezier_curve_goes_from_the_first_place_to_the_last() {
    let folder = folder("path_bezier");
    let ends = ["path", "flat.ply", "--from", "0", "--via", "8", "--to", "80", "--bezier"];
    let answer = json(&folder, &ends);
    let [from, via, to] = [0, 8, 80].map(|vertex| flat().positions[vertex]);
    assert!(length(end(&answer, false), from.to_array()) < 1e-12 && length(end(&answer, true), to.to_array()) < 1e-12);
    // The parabola in a right corner of sides 1.
    assert!((from.distance(via) - 1.0).abs() < 1e-6 && (via.distance(to) - 1.0).abs() < 1e-6);
    let parabola = 1.0 + 1.0_f64.asinh() / 2.0_f64.sqrt();
    assert!((number(&answer, "length") - parabola).abs() < 1e-3, "{answer}");
    assert_eq!((&answer["method"], &answer["distance"]), (&"exact".into(), &answer["length"]));
    for more in [&["--exact"][..], &["--straighten"], &["--method", "heat"]] {
        refused(&folder, &[&ends[..], more].concat());
    }
    assert!(refused(&folder, &["path", "flat.ply", "--from", "0", "--to", "80", "--bezier"]).contains("--via"));
    assert!(
        refused(&folder, &["path", "shape:cube", "--from", "0", "--via", "1", "--to", "8", "--bezier"])
            .contains("--bezier")
    );
}
