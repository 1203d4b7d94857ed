//! Loops, and paths by way of places.

use std::f64::consts::{PI, TAU};
use std::fs;

use crate::{folder, json as answered, refused, run, succeed};

#[test]
fn loops_around_the_handle_of_a_torus_are_told_and_written() {
    let folder = folder("loops");
    let of_handles = ["loop", "torus.ply", "--handles"];
    let answer = answered(&folder, &[&of_handles[..], &["--output", "loops.csv"]].concat());
    let lengths: Vec<f64> =
        answer["loops"].as_array().unwrap().iter().map(|path| path["length"].as_f64().unwrap()).collect();
    // A meridian of twelve sides, in a plane of vertices or beside it, and the inner equator of 24.
    let polygon = |count: f64, radius: f64| 2.0 * count * radius * (PI / count).sin();
    assert_eq!(lengths.len(), 2);
    assert!((lengths[0] - polygon(12.0, 0.4)).abs() < 0.01 * TAU * 0.4, "{lengths:?}");
    assert!((lengths[1] - polygon(24.0, 0.6)).abs() < 1e-9, "{lengths:?}");
    let rows = fs::read_to_string(folder.join("loops.csv")).unwrap();
    assert!(rows.starts_with("loop,x,y,z\n0,") && rows.contains("\n1,"), "{rows}");
    assert!(succeed(&folder, &of_handles).contains(&format!("\nloop 1                 length {}\n", lengths[1])));
    succeed(&folder, &[&of_handles[..], &["--output", "loops.obj"]].concat());
    assert_eq!(fs::read_to_string(folder.join("loops.obj")).unwrap().matches("\nl ").count(), 2);
}

#[test]
fn loops_through_places_are_held_or_free() {
    let folder = folder("loops_places");
    let through = ["loop", "torus.ply", "--through", "0", "--through", "96", "--through", "192"];
    let length = |options: &[&str]| {
        let answer = answered(&folder, &[&through[..], options].concat());
        let points = answer["points"].as_array().unwrap();
        assert_eq!(points.first(), points.last());
        answer["length"].as_f64().unwrap()
    };
    let (held, free) = (length(&["--output", "held.obj"]), length(&["--free"]));
    assert!(free < held, "{free} for {held}");
    assert!(fs::read_to_string(folder.join("held.obj")).unwrap().contains("\nl 1 2"));
    let one = answered(&folder, &["loop", "torus.ply", "--through", "7:0.2,0.3,0.5"]);
    assert!((one["length"].as_f64().unwrap() - TAU * 0.4).abs() < 0.1, "{one}");
}

#[test]
fn where_there_is_no_loop_it_is_said() {
    let folder = folder("loops_refused");
    let none = run(&folder, &["loop", "shape:icosphere", "--handles", "--json"]);
    assert!(none.status.success());
    let told = String::from_utf8(none.stderr).unwrap();
    assert!(told.contains("no handle") && String::from_utf8(none.stdout).unwrap().contains("\"loops\":[]"), "{told}");
    let free = ["loop", "shape:icosphere", "--through", "0", "--through", "20", "--through", "40", "--free"];
    assert!(refused(&folder, &free).contains("the loop shrinks to a point"));
    assert!(refused(&folder, &["loop", "shape:icosphere", "--through", "0"]).contains("the loop shrinks to a point"));
    let apart = ["loop", "two.obj", "--bridge", "off", "--through", "0", "--through", "1", "--through", "3"];
    assert!(refused(&folder, &apart).contains("not connected"));
    assert!(refused(&folder, &["loop", "flat.ply"]).contains("--through"));
    assert!(refused(&folder, &["loop", "flat.ply", "--handles", "--free"]).contains("--free"));
    assert!(refused(&folder, &["loop", "shape:cube", "--handles"]).contains("give the surface"));
}

#[test]
fn a_path_goes_by_way_of_places() {
    let folder = folder("via");
    let ends = ["path", "flat.ply", "--from", "0", "--to", "80"];
    for options in [&["--exact"][..], &[], &["--method", "heat", "--straighten"]] {
        let answer = answered(&folder, &[&ends[..], &["--via", "8", "--via", "40"], options].concat());
        // Along a side, then back half of the diagonal, and the other half of the other one.
        assert!((answer["length"].as_f64().unwrap() - 1.0 - 2.0_f64.sqrt()).abs() < 1e-9, "{answer}");
        let points = answer["points"].as_array().unwrap();
        assert_eq!(points[0], serde_json::json!([0.0, 0.0, 0.0]));
        assert_eq!(points[points.len() - 1], serde_json::json!([1.0, 0.0, -1.0]));
        assert!(points.contains(&serde_json::json!([0.5, 0.0, -0.5])), "{answer}");
    }
    let inside = ["path", "shape:cube", "--from", "0", "--via", "3", "--to", "0"];
    let there_and_back = answered(&folder, &inside)["length"].as_f64().unwrap();
    let there = answered(&folder, &["path", "shape:cube", "--from", "0", "--to", "3"])["length"].as_f64().unwrap();
    assert!((there_and_back - 2.0 * there).abs() < 1e-9 * there);
    assert!(refused(&folder, &[&ends[..], &["--via", "999"]].concat()).contains("999"));
}
