//! Farthest samples.

use std::fs;

use serde_json::json;

use crate::{folder, json as answered, refused, succeed};

#[test]
fn samples_of_a_square_are_its_corners_first() {
    let folder = folder("samples");
    let answer = answered(&folder, &["sample", "flat.ply", "--count", "5", "--output", "places.csv"]);
    let mut corners: Vec<u64> = answer["places"].as_array().unwrap()[..4].iter().map(|n| n.as_u64().unwrap()).collect();
    assert_eq!(corners[..2], [0, 80]);
    corners.sort_unstable();
    assert_eq!(corners, [0, 8, 72, 80]);
    // The middle comes next.
    assert_eq!(answer["places"][4], json!(40));
    assert!((answer["covering_radius"].as_f64().unwrap() - 0.5).abs() < 1e-12);
    let csv = fs::read_to_string(folder.join("places.csv")).unwrap();
    let rows: Vec<&str> = csv.lines().collect();
    assert_eq!((rows.len(), rows[0]), (6, "place,x,y,z"));
    let middle: Vec<f64> = rows[5].split(',').map(|cell| cell.parse().unwrap()).collect();
    assert_eq!(middle, [40.0, 0.5, 0.0, -0.5]);
}

#[test]
fn a_radius_is_kept_a_seed_gives_the_same_again_and_each_component_has_one() {
    let folder = folder("samples_radius");
    let within = |more: &[&str]| answered(&folder, &[&["sample", "torus.ply", "--radius", "0.7"], more].concat());
    let seeded = within(&["--seed", "7"]);
    assert!(seeded["covering_radius"].as_f64().unwrap() <= 0.7);
    assert_eq!(seeded["places"], within(&["--seed", "7"])["places"]);
    assert_ne!(seeded["places"], within(&[])["places"]);
    let two = answered(&folder, &["sample", "two.obj", "--count", "2"]);
    assert_eq!(two["places"], json!([0, 3]));
}

#[test]
fn relaxed_samples_lie_in_the_middles_of_their_cells() {
    let folder = folder("samples_relaxed");
    let answer = answered(&folder, &["sample", "flat.ply", "--count", "1", "--relax", "30", "--output", "one.csv"]);
    assert!((answer["covering_radius"].as_f64().unwrap() - 0.5_f64.sqrt()).abs() < 1e-6);
    let csv = fs::read_to_string(folder.join("one.csv")).unwrap();
    let numbers: Vec<f64> = csv.lines().nth(1).unwrap().rsplit(',').take(3).map(|cell| cell.parse().unwrap()).collect();
    assert!((numbers[0] + 0.5).abs() < 1e-6 && (numbers[2] - 0.5).abs() < 1e-6, "{csv}");
    let radius = |more: &[&str]| {
        let answer = answered(&folder, &[&["sample", "torus.ply", "--count", "12"], more].concat());
        answer["covering_radius"].as_f64().unwrap()
    };
    assert!(radius(&["--relax", "20"]) < radius(&[]));
}

#[test]
fn the_mean_of_places_of_a_square_is_theirs_in_the_plane() {
    let folder = folder("mean");
    let answer = answered(&folder, &["mean", "flat.ply", "--source", "0", "--source", "80@3", "--source", "8"]);
    let position: Vec<f64> = answer["position"].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    assert!((position[0] - 0.6).abs() < 1e-9 && (position[2] + 0.8).abs() < 1e-9, "{position:?}");
    let told = succeed(&folder, &["mean", "flat.ply", "--source", "0", "--source", "80@3", "--source", "8"]);
    let line = told.lines().find(|line| line.starts_with("position")).unwrap();
    let told: Vec<f64> = line.split_whitespace().nth(1).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    assert_eq!(told, position);
    let place = answer["place"].as_str().unwrap();
    assert!(
        answered(&folder, &["walk", "flat.ply", "--from", place, "--direction", "1,0,0", "--length", "0.1"])
            .is_object()
    );
    let asked = |more: &[&str]| refused(&folder, &[&["mean", "flat.ply"], more].concat());
    assert!(asked(&[]).contains("--source"));
    assert!(asked(&["--source", "1@-1"]).contains("positive weight"));
    assert!(asked(&["--source", "99"]).contains("99"));
    assert!(refused(&folder, &["mean", "two.obj", "--source", "0", "--source", "4"]).contains("reach"));
}

#[test]
fn refuses_what_is_no_number_of_samples() {
    let folder = folder("samples_refused");
    let asked = |more: &[&str]| refused(&folder, &[&["sample", "flat.ply"], more].concat());
    assert!(asked(&[]).contains("--count"));
    assert!(asked(&["--count", "0"]).contains("at least 1"));
    assert!(asked(&["--radius", "-1"]).contains("positive"));
    assert!(asked(&["--count", "3", "--radius", "1"]).contains("--radius"));
    assert!(asked(&["--count", "3", "--output", "a.obj"]).contains(".csv"));
    assert!(refused(&folder, &["sample", "shape:cube", "--count", "3"]).contains("not of the inside of tetrahedra"));
}
