//! Distances from curves.

use std::fs;

use crate::{distances, folder, json as answered, refused};

/// Of a square of the unit square's middle, of side ½, counterclockwise from above: its distance, by columns and rows of vertices.
fn to_square(i: usize, j: usize) -> f64 {
    let [x, y] = [i, j].map(|at| (at as f64 / 8.0 - 0.5).abs() - 0.25);
    if x <= 0.0 && y <= 0.0 { x.max(y) } else { x.max(0.0).hypot(y.max(0.0)) }
}

#[test]
fn distances_are_from_all_points_of_curves_and_negative_inside() {
    let folder = folder("curves");
    fs::write(folder.join("curves.txt"), "20 56 60 24 20\n\n").unwrap();
    let from = |more: &[&str]| distances(&folder, &[&["flat.ply"], more].concat());
    let closed = from(&["--curve", "20 56 60 24", "--closed", "--signed"]);
    let of_file = from(&["--curve-file", "curves.txt", "--signed"]);
    let unsigned = from(&["--curve", "20 56 60 24 20"]);
    let by_heat = from(&["--curve", "20 56 60 24 20", "--signed", "--sign", "heat"]);
    for vertex in 0..81 {
        let right = to_square(vertex / 9, vertex % 9);
        assert!((closed[vertex] - right).abs() < 1e-12, "{} for {right} at {vertex}", closed[vertex]);
        assert!((unsigned[vertex] - right.abs()).abs() < 1e-12);
        assert!((by_heat[vertex] - right).abs() < 1e-12, "{} for {right} at {vertex}", by_heat[vertex]);
    }
    assert_eq!(closed, of_file);
    let boundary = from(&["--curve", "boundary"]);
    assert!((boundary[40] - 0.5).abs() < 1e-12 && boundary[8] == 0.0);

    let answer = answered(&folder, &["distance", "flat.ply", "--curve", "20 56 60 24", "--closed", "--signed"]);
    assert_eq!(
        (&answer["method"], &answer["sign"], &answer["curves_given"]),
        (&"exact".into(), &"nearest".into(), &1.into())
    );
    let number = |name: &str| answer[name].as_f64().unwrap();
    assert!((number("curve_length") - 2.0).abs() < 1e-12);
    assert!((number("min_distance") + 0.25).abs() < 1e-12 && (number("max_distance") - 0.125_f64.sqrt()).abs() < 1e-12);
    let open = answered(&folder, &["distance", "flat.ply", "--curve", "20 56 60 24", "--signed"]);
    assert_eq!(open["sign"], "heat");
}

#[test]
fn isolines_are_offsets_of_curves_on_both_sides() {
    let folder = folder("offsets");
    let square = ["isolines", "flat.ply", "--curve", "20 56 60 24", "--closed", "--signed", "--values=-0.125,0,0.125"];
    let answer = answered(&folder, &[&square[..], &["--output", "offsets.svg"]].concat());
    let lengths: Vec<f64> =
        answer["isolines"].as_array().unwrap().iter().map(|one| one["length"].as_f64().unwrap()).collect();
    // Sides of a quarter, of a half, and of a half with quarters of circles between.
    let right = [1.0, 2.0, 2.0 + std::f64::consts::FRAC_PI_4];
    assert!(lengths.iter().zip(right).all(|(length, right)| (length / right - 1.0).abs() < 0.002), "{lengths:?}");
    assert!(answer["curves"].as_str().unwrap().starts_with("exact"), "{answer}");
    assert!(fs::read_to_string(folder.join("offsets.svg")).unwrap().contains("<path"));
    // Beyond the ends of an open curve the sign jumps, which is no isoline at 0.
    let open = ["isolines", "flat.ply", "--curve", "38 42", "--signed", "--sign", "nearest", "--values", "0"];
    let length = answered(&folder, &open)["isolines"][0]["length"].as_f64().unwrap();
    assert!((length - 0.5).abs() < 0.26, "{length}");
}

#[test]
fn what_is_no_curve_is_named() {
    let folder = folder("curves_refused");
    let asked = |more: &[&str]| refused(&folder, &[&["distance", "flat.ply"], more].concat());
    assert!(
        asked(&["--curve", "3"]).contains("curve 0: the curve is given by 1 place; it must be given by two different")
    );
    assert!(asked(&["--curve", "3 x"]).contains("places apart by blanks"));
    assert!(asked(&["--curve", "3 99"]).contains("99"));
    assert!(asked(&["--signed", "--source", "3"]).contains("--signed is for distances from curves"));
    assert!(asked(&["--curve", "3 4", "--method", "heat"]).contains("distances from curves are exact"));
    assert!(asked(&["--curve", "3 4", "--max-distance", "1"]).contains("--max-distance"));
    assert!(asked(&["--curve", "3 4", "--source", "1"]).contains("cannot be used with"));
    assert!(asked(&["--curve-file", "none.txt"]).contains("none.txt"));
    fs::write(folder.join("bad.txt"), "1 2\n\n3 y\n").unwrap();
    assert!(asked(&["--curve-file", "bad.txt"]).contains("bad.txt, line 3: give places"));
    fs::write(folder.join("empty.txt"), "\n").unwrap();
    assert!(asked(&["--curve-file", "empty.txt"]).contains("there is no curve"));
    let far = refused(&folder, &["distance", "two.obj", "--curve", "0 4", "--bridge", "off"]);
    assert!(far.contains("curve 0"), "{far}");
    assert!(refused(&folder, &["distance", "torus.ply", "--curve", "boundary"]).contains("no boundary"));
    let inside = refused(&folder, &["distance", "shape:cube", "--curve", "0 1"]);
    assert!(inside.contains("inside of tetrahedra there are no curves"), "{inside}");
}
