//! Poses of animations.

use std::fs;
use std::path::PathBuf;

use serde_json::json;

use super::{folder, json, refused, succeed};

/// A folder with a triangle that an animation makes three times as large in two seconds.
fn with_animation(test: &str) -> PathBuf {
    let folder = folder(test);
    let numbers: [f32; 17] = [0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 2., 1., 1., 1., 3., 3., 3.];
    let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    fs::write(folder.join("moving.bin"), &bytes).unwrap();
    let accessor = |view: usize, kind: &str, count: usize| json!({ "bufferView": view, "componentType": 5126, "type": kind, "count": count });
    let view = |offset: usize, length: usize| json!({ "buffer": 0, "byteOffset": offset, "byteLength": length });
    let document = json!({
        "asset": { "version": "2.0" },
        "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
        "buffers": [{ "byteLength": bytes.len(), "uri": "moving.bin" }],
        "bufferViews": [view(0, 36), view(36, 8), view(44, 24)],
        "accessors": [accessor(0, "VEC3", 3), accessor(1, "SCALAR", 2), accessor(2, "VEC3", 2)],
        "animations": [{
            "name": "Grow",
            "channels": [{ "sampler": 0, "target": { "node": 0, "path": "scale" } }],
            "samplers": [{ "input": 1, "output": 2 }]
        }]
    });
    fs::write(folder.join("moving.gltf"), document.to_string()).unwrap();
    folder
}

#[test]
fn info_names_them() {
    let folder = with_animation("animations_info");
    let report = json(&folder, &["info", "moving.gltf"]);
    assert_eq!(report["animations"], json!([{ "animation": 0, "name": "Grow", "seconds": 2.0, "left_out": 0 }]));
    assert!(succeed(&folder, &["info", "moving.gltf"]).contains("animation 0            Grow, 2.0 s"));
    assert_eq!(json(&folder, &["info", "torus.ply"])["animations"], json!([]));
}

#[test]
fn distance_and_path_are_measured_in_the_pose() {
    let folder = with_animation("animations_pose");
    for (time, scale) in [("0", 1.0), ("1", 2.0), ("2", 3.0)] {
        let pose = ["--animation", "Grow", "--time", time];
        let distance = json(&folder, &[&["distance", "moving.gltf", "--source", "0"], &pose[..]].concat());
        assert!((distance["max_distance"].as_f64().unwrap() - scale).abs() < 1e-12, "{time}");
        let ends = ["path", "moving.gltf", "--from", "1", "--to", "2"];
        let path = json(&folder, &[&ends[..], &["--animation", "0", "--time", time]].concat());
        assert!((path["length"].as_f64().unwrap() - scale * 2.0_f64.sqrt()).abs() < 1e-12, "{time}");
    }
}

#[test]
fn what_there_is_not_is_refused() {
    let folder = with_animation("animations_refused");
    for (arguments, problem) in [
        (&["--animation", "Run"][..], "there is no animation Run; the file has Grow"),
        (
            &["--animation", "Grow", "--time", "2.5"],
            "--time 2.5 is after the end of the animation Grow, which lasts 2 s",
        ),
        (&["--animation", "Grow", "--time", "-1"], "time is -1; it must be 0 s or more, and finite"),
        (&["--time", "1"], "--animation <NAME>"),
    ] {
        let said = refused(&folder, &[&["info", "moving.gltf"], arguments].concat());
        assert!(said.contains(problem), "{said}");
    }
}
