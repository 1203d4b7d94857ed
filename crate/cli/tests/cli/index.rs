//! Indices of distances.

use std::fs;

use serde_json::Value;

use crate::{folder, json, refused, succeed};

/// A tenth of all pairs of a torus.
fn pairs() -> String {
    (0..288).flat_map(|from| (0..288).step_by(10).map(move |to| format!("{from},{to}\n"))).collect()
}

fn numbers(told: &Value, name: &str) -> Vec<f64> {
    told[name].as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn bounds_of_an_index_hold_exact_distances() {
    let folder = folder("index");
    fs::write(folder.join("pairs.txt"), pairs()).unwrap();
    let made = json(&folder, &["index", "torus.ply", "--output", "torus.hwindex", "--threads", "1"]);
    let bytes = fs::read(folder.join("torus.hwindex")).unwrap();
    assert_eq!(made["bytes"], bytes.len());
    succeed(&folder, &["index", "torus.ply", "--output", "again.hwindex", "--threads", "3"]);
    assert!(fs::read(folder.join("again.hwindex")).unwrap() == bytes);

    let ask = ["pairs", "torus.ply", "--pairs", "pairs.txt"];
    let exact = numbers(&json(&folder, &ask), "distances");
    let told = json(&folder, &[&ask[..], &["--index", "torus.hwindex"]].concat());
    let [upper, lower] = ["distances", "at_least"].map(|name| numbers(&told, name));
    let mut errors = 0.0;
    for ((exact, upper), lower) in exact.iter().zip(&upper).zip(&lower) {
        assert!(*lower <= exact * (1.0 + 1e-12) && exact * (1.0 - 1e-12) <= *upper, "{lower} {exact} {upper}");
        errors += if *exact > 0.0 { upper / exact - 1.0 } else { *upper };
    }
    // The triangles are a tenth of the torus long: of larger meshes it is far less.
    assert!(errors / (exact.len() as f64) < 0.01, "{}", errors / exact.len() as f64);
    let csv = succeed(&folder, &[&ask[..], &["--index", "torus.hwindex", "--output", "-"]].concat());
    assert_eq!(csv.lines().next(), Some("from,to,distance,at_least"));
    assert_eq!(csv.lines().count(), 1 + exact.len());
}

#[test]
fn other_components_and_vertices_of_no_triangle_are_at_infinity() {
    let folder = folder("index_apart");
    fs::write(folder.join("pairs.txt"), "0,1\n0,4\n0,6\n6,6\n").unwrap();
    succeed(&folder, &["index", "two.obj", "--output", "two.hwindex"]);
    let csv = ["pairs", "two.obj", "--pairs", "pairs.txt", "--index", "two.hwindex", "--output", "-"];
    let rows: Vec<String> = succeed(&folder, &csv).lines().skip(1).map(str::to_owned).collect();
    assert!(rows[0].starts_with("0,1,1.0000"), "{rows:?}");
    assert_eq!(rows[1..], ["0,4,inf,inf", "0,6,inf,inf", "6,6,inf,inf"]);
}

#[test]
fn lengths_that_32_bits_do_not_hold_are_indexed_too() {
    let folder = folder("index_sizes");
    fs::write(folder.join("pairs.txt"), "0,1\n0,2\n").unwrap();
    for size in ["1e-120", "1e120"] {
        let square = format!("v 0 0 0\nv {size} 0 0\nv {size} {size} 0\nv 0 {size} 0\nf 1 2 3\nf 1 3 4\n");
        fs::write(folder.join("square.obj"), square).unwrap();
        succeed(&folder, &["index", "square.obj", "--output", "square.hwindex"]);
        let told = json(&folder, &["pairs", "square.obj", "--pairs", "pairs.txt", "--index", "square.hwindex"]);
        for name in ["distances", "at_least"] {
            let sides = numbers(&told, name).into_iter().map(|length| length / size.parse::<f64>().unwrap());
            let sides: Vec<f64> = sides.collect();
            assert!((sides[0] - 1.0).abs() < 1e-6 && (sides[1] - 2.0_f64.sqrt()).abs() < 1e-6, "{name}: {sides:?}");
        }
    }
}

#[test]
fn bad_indices_are_refused() {
    let folder = folder("index_refused");
    fs::write(folder.join("pairs.txt"), "0,1\n").unwrap();
    fs::write(folder.join("places.txt"), "0 5:1,0,0\n").unwrap();
    succeed(&folder, &["index", "torus.ply", "--output", "torus.hwindex"]);
    let bytes = fs::read(folder.join("torus.hwindex")).unwrap();
    let mut flipped = bytes.clone();
    flipped[bytes.len() / 2] ^= 1;
    let mut newer = bytes.clone();
    newer[8] = 99;
    for (name, bytes) in [
        ("cut", &bytes[..bytes.len() / 3]),
        ("short", &bytes[..12]),
        ("flipped", &flipped),
        ("newer", &newer),
        ("text", b"no"),
    ] {
        fs::write(folder.join(format!("{name}.hwindex")), bytes).unwrap();
    }
    for (index, hint) in [
        ("cut.hwindex", "damaged or cut short"),
        ("short.hwindex", "damaged or cut short"),
        ("flipped.hwindex", "damaged or cut short"),
        ("newer.hwindex", "version 99"),
        ("text.hwindex", "no index of distances"),
        ("missing.hwindex", "cannot read missing.hwindex"),
    ] {
        let line = refused(&folder, &["pairs", "torus.ply", "--pairs", "pairs.txt", "--index", index]);
        assert!(line.contains(hint), "{index}: {line}");
    }
    let indexed = ["--index", "torus.hwindex"];
    for (arguments, hint) in [
        (&["grid.ply", "--pairs", "pairs.txt"][..], "another mesh"),
        (&["torus.ply", "--pairs", "places.txt"], "5:1,0,0 is no vertex"),
        (&["torus.ply", "--pairs", "pairs.txt", "--bridge", "off"], "knows no bridges"),
    ] {
        let line = refused(&folder, &[&["pairs"], arguments, &indexed].concat());
        assert!(line.contains(hint), "{arguments:?}: {line}");
    }
    for (arguments, hint) in [
        (&["torus.ply", "--output", "d.csv"][..], ".hwindex"),
        (&["torus.ply", "--output", "-"], "give its file a name"),
        (&["torus.ply"], "--output"),
        (&["shape:cube", "--output", "d.hwindex"], "tetrahedra"),
    ] {
        let line = refused(&folder, &[&["index"], arguments].concat());
        assert!(line.contains(hint), "{arguments:?}: {line}");
    }
}
