//! Places by coordinates.

use serde_json::Value;

use crate::{difference, distances, folder, json, refused, run};

#[test]
fn coordinates_are_taken_at_the_nearest_point_of_the_surface() {
    let folder = folder("coordinates");
    // Vertex 40 is the middle of the unit square, in the plane y = 0.
    let middle = distances(&folder, &["flat.ply", "--source", "40", "--exact"]);
    let above = distances(&folder, &["flat.ply", "--source", "@0.5,0.001,-0.5", "--exact"]);
    assert_eq!(middle, above);
    let told = json(&folder, &["distance", "flat.ply", "--source", "@0.5,0.001,-0.5@2"]);
    let snapped = &told["snapped"][0];
    assert_eq!((&snapped["given"], &snapped["place"]), (&Value::from("@0.5,0.001,-0.5"), &Value::from("40")));
    assert_eq!(snapped["distance"], 0.001);
    assert_eq!(told["max_distance"].as_f64().unwrap(), 2.0 + 0.5_f64.sqrt());

    // Inside of a triangle: distances are those from there in the plane.
    let inside = distances(&folder, &["flat.ply", "--source", "@0.3,0,-0.7", "--exact"]);
    let straight: Vec<f64> = crate::flat().positions.iter().map(|at| (at.x - 0.3).hypot(at.z + 0.7)).collect();
    assert!(difference(&inside, &straight) < 1e-12);
    let path = json(&folder, &["path", "flat.ply", "--from", "@0.1,0,-0.2", "--to", "@0.9,0,-0.8", "--exact"]);
    assert!((path["length"].as_f64().unwrap() - 1.0).abs() < 1e-12);
    assert_eq!(path["snapped"].as_array().unwrap().len(), 2);
    let curve = distances(&folder, &["flat.ply", "--curve", "@0,0,0 @1,0,0"]);
    assert!(difference(&curve, &crate::flat().positions.iter().map(|at| -at.z).collect::<Vec<_>>()) < 1e-12);
    for command in [
        "log-map flat.ply --source @0.3,0,-0.3",
        "transport flat.ply --vector @0.3,0,-0.3:1,0,0",
        "walk flat.ply --from @0.3,0,-0.3 --direction 1,0,0 --length 0.1",
        "loop torus.ply --through @1.4,0,0",
        "cells flat.ply --source @0,0,0 --source @1,0,-1",
        "mean flat.ply --source @0,0,0@2 --source @1,0,-1",
        "isolines flat.ply --source @0,0,0 --count 2",
        "distance shape:cube --source @0,0,0",
    ] {
        let arguments: Vec<&str> = command.split(' ').collect();
        let told = json(&folder, &arguments);
        let is_surface = command != "distance shape:cube --source @0,0,0";
        assert_eq!(told["snapped"].is_array(), is_surface, "{command}: {told}");
    }
}

#[test]
fn coordinates_far_from_the_surface_are_told_and_bad_ones_refused() {
    let folder = folder("far_coordinates");
    let output = run(&folder, &["distance", "flat.ply", "--source", "@0.5,0.1,-0.5"]);
    let [told, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    assert!(
        output.status.success() && stderr.contains("@0.5,0.1,-0.5 is 0.1 away from the surface, 7.1 %"),
        "{stderr}"
    );
    assert!(told.contains("snapped 0              @0.5,0.1,-0.5 to 40, 0.1 away\n"), "{told}");
    for (place, hint) in [
        ("@", "three finite coordinates"),
        ("@1,2", "three finite coordinates"),
        ("@1,2,3,4", "three finite coordinates"),
        ("@nan,0,0", "three finite coordinates"),
        ("@0,inf,0", "three finite coordinates"),
        ("@x,0,0", "three finite coordinates"),
        ("@1,2,3@x", "the distance that the source starts from"),
        ("@1e200,0,0", "too far from the surface"),
    ] {
        let line = refused(&folder, &["distance", "flat.ply", "--source", place]);
        assert!(line.contains(hint), "{place}: {line}");
    }
    let line = refused(&folder, &["distance", "shape:cube", "--source", "@9,9,9"]);
    assert!(line.contains("outside of all tetrahedra"), "{line}");
}
