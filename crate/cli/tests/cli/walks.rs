//! Walks straight on.

use std::fs;

use serde_json::{Value, json};

use crate::{flat, folder, json as answered, refused, succeed};

fn walked(folder: &std::path::Path, options: &[&str]) -> Value {
    answered(folder, &[&["walk"], options].concat())
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn on_a_plane_a_walk_is_a_straight_line_and_comes_back() {
    let folder = folder("walk");
    let there = ["flat.ply", "--from", "3:0.2,0.3,0.5", "--direction", "1,5,-0.5", "--length", "0.3"];
    let answer = walked(&folder, &[&there[..], &["--output", "walk.csv"]].concat());
    let points = answer["points"].as_array().unwrap();
    let (start, end) = (numbers(&points[0]), numbers(&answer["end"]));
    assert_eq!(points.last().unwrap(), &answer["end"]);
    let step = 0.3 / 1.25_f64.sqrt();
    assert!((end[0] - start[0] - step).abs() < 1e-12 && (end[2] - start[2] + 0.5 * step).abs() < 1e-12, "{answer}");
    assert!((answer["length"].as_f64().unwrap() - 0.3).abs() < 1e-12);
    assert_eq!(answer["at_boundary"], json!(false));
    assert!(fs::read_to_string(folder.join("walk.csv")).unwrap().starts_with("x,y,z\n"));
    let told = succeed(&folder, &[&["walk"], &there[..]].concat());
    let [x, y, z] = [0, 1, 2].map(|axis| &answer["end"][axis]);
    assert!(told.contains(&format!("\nend                    {x},{y},{z}\n")), "{told}");
    // From where it ended, against the direction that it had there.
    let back: Vec<String> = numbers(&answer["direction"]).iter().map(|part| (-part).to_string()).collect();
    let place = answer["place"].as_str().unwrap();
    let answer = walked(&folder, &["flat.ply", "--from", place, "--direction", &back.join(","), "--length", "0.3"]);
    let end = numbers(&answer["end"]);
    assert!(end.iter().zip(&start).all(|(a, b)| (a - b).abs() < 1e-12), "{answer}");
}

#[test]
fn a_walk_ends_at_the_boundary_and_may_be_told_the_triangle_to_begin_in() {
    let folder = folder("walk_ends");
    let answer = walked(&folder, &["flat.ply", "--from", "0", "--direction", "1,0,-0.3", "--length", "9"]);
    assert_eq!(answer["at_boundary"], json!(true));
    assert!(answer["length"].as_f64().unwrap() < 2.0);
    // Wherever it begins at a corner of a plane, it is the same one.
    let short = ["flat.ply", "--from", "12", "--direction", "0.2,0,-1", "--length", "0.05"];
    let end = walked(&folder, &short)["end"].clone();
    let soup = flat();
    let around = (0..soup.triangles.len()).filter(|&triangle| soup.triangles[triangle].contains(&12));
    for triangle in around.map(|triangle| triangle.to_string()) {
        let answer = walked(&folder, &[&short[..], &["--triangle", &triangle]].concat());
        let [named, best] = [&answer["end"], &end].map(numbers);
        assert!(named.iter().zip(&best).all(|(a, b)| (a - b).abs() < 1e-12), "{answer}");
    }
}

#[test]
fn refuses_what_is_no_walk() {
    let folder = folder("walk_refused");
    let from = |more: &[&str]| refused(&folder, &[&["walk", "flat.ply", "--from", "0"], more].concat());
    assert!(from(&["--direction", "0,1,0", "--length", "1"]).contains("not square to the surface"));
    assert!(from(&["--direction", "0,0,0", "--length", "1"]).contains("three numbers"));
    assert!(from(&["--direction", "1,0,0", "--length", "-1"]).contains("positive"));
    assert!(from(&["--direction", "1,0,0", "--length", "1", "--triangle", "99999"]).contains("does not exist"));
    assert!(from(&["--direction", "1,0,0", "--length", "1", "--output", "a.ply"]).contains(".obj"));
    let inside = ["walk", "shape:cube", "--from", "0", "--direction", "1,0,0", "--length", "1"];
    assert!(refused(&folder, &inside).contains("not inside of tetrahedra"));
}
