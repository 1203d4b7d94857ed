//! Distances of pairs, and what is written to standard output.

use std::fs;

use crate::{flat, folder, json, refused, run, succeed};

#[test]
fn pairs_have_their_exact_distances_whichever_comes_first() {
    let folder = folder("pairs");
    let list = "0 80\n80 0 # the same\n12,40\n@0.25,0,-0.5 5:0.2,0.3,0.5\n0 0\n3 44\n0 17\n";
    fs::write(folder.join("pairs.txt"), list).unwrap();
    let told = json(&folder, &["pairs", "flat.ply", "--pairs", "pairs.txt", "--output", "pairs.csv"]);
    let distances: Vec<f64> =
        told["distances"].as_array().unwrap().iter().map(|distance| distance.as_f64().unwrap()).collect();
    let at = |vertex: usize| flat().positions[vertex];
    for (pair, [from, to]) in [(0, [0, 80]), (1, [80, 0]), (2, [12, 40]), (4, [0, 0]), (5, [3, 44]), (6, [0, 17])] {
        assert!((distances[pair] - at(from).distance(at(to))).abs() < 1e-14, "{pair}: {}", distances[pair]);
    }
    let corners = flat().triangles[5].map(|corner| at(corner as usize));
    let place = corners[0] * 0.2 + corners[1] * 0.3 + corners[2] * 0.5;
    assert!((distances[3] - place.distance(glam::DVec3::new(0.25, 0.0, -0.5))).abs() < 1e-14);
    let csv = fs::read_to_string(folder.join("pairs.csv")).unwrap();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!((lines.len(), lines[0]), (8, "from,to,distance"));
    assert!(lines[4].starts_with("\"@0.25,0,-0.5\",\"5:0.2,0.3,0.5\","), "{csv}");
    for threads in ["1", "3"] {
        let again =
            succeed(&folder, &["pairs", "flat.ply", "--pairs", "pairs.txt", "--output", "-", "--threads", threads]);
        assert_eq!(again, csv);
    }
    fs::write(folder.join("apart.txt"), "0 3\n").unwrap();
    assert_eq!(json(&folder, &["pairs", "two.obj", "--pairs", "apart.txt"])["unreachable"], 1);
}

#[test]
fn pairs_on_a_torus_are_as_far_apart_as_fields_say() {
    let folder = folder("pairs_torus");
    let list: String = (0..60).map(|number| format!("{} {}\n", 7 * (number % 5), (number * 37) % 288)).collect();
    fs::write(folder.join("pairs.txt"), list).unwrap();
    let told = json(&folder, &["pairs", "torus.ply", "--pairs", "pairs.txt"]);
    for number in 0..60 {
        let field = crate::distances(&folder, &["torus.ply", "--exact", "--source", &(7 * (number % 5)).to_string()]);
        let distance = told["distances"][number].as_f64().unwrap();
        assert!((distance - field[(number * 37) % 288]).abs() < 1e-12, "{number}");
    }
}

#[test]
fn bad_pairs_are_refused() {
    let folder = folder("bad_pairs");
    for (list, hint) in [
        ("0\n", "line 1: give two places"),
        ("0 1\n0 1 2\n", "line 2: give two places"),
        ("0 x\n", "line 1: give a vertex"),
        ("0 288\n", "vertex 288 does not exist"),
        ("", "there is no pair"),
    ] {
        fs::write(folder.join("pairs.txt"), list).unwrap();
        let line = refused(&folder, &["pairs", "torus.ply", "--pairs", "pairs.txt"]);
        assert!(line.contains(hint), "{list}: {line}");
    }
    let line = refused(&folder, &["pairs", "shape:cube", "--pairs", "pairs.txt"]);
    assert!(line.contains("tetrahedra"), "{line}");
}

#[test]
fn files_go_to_standard_output_and_nothing_else_does() {
    let folder = folder("standard_output");
    for (command, extension) in [
        ("distance torus.ply --source 0", "csv"),
        ("distance torus.ply --source 0", "ply"),
        ("distance torus.ply --source 0", "glb"),
        ("path torus.ply --from 0 --to 100", "csv"),
        ("path torus.ply --from 0 --to 100", "obj"),
        ("loop torus.ply --through 0", "csv"),
        ("isolines torus.ply --source 0 --count 2", "csv"),
        ("isolines torus.ply --source 0 --count 2", "svg"),
        ("sample torus.ply --count 4", "csv"),
        ("cells torus.ply --source 0 --source 100", "csv"),
        ("walk torus.ply --from 0 --direction 0,1,0 --length 1", "csv"),
        ("log-map torus.ply --source 0", "csv"),
        ("transport torus.ply --vector 0:0,1,0", "csv"),
        ("fill torus.ply --resolution 8", "msh"),
        ("distance shape:cube --source 0", "vtu"),
        ("matrix torus.ply --landmarks 3", "csv"),
        ("matrix torus.ply --landmarks 3", "npy"),
    ] {
        let command: Vec<&str> = command.split(' ').collect();
        let file = format!("out.{extension}");
        succeed(&folder, &[&command[..], &["--output", &file]].concat());
        let written = fs::read(folder.join(file)).unwrap();
        let output = run(&folder, &[&command[..], &[&format!("--output=-.{extension}")]].concat());
        assert!(output.status.success() && output.stderr.is_empty(), "{command:?}: {output:?}");
        assert!(output.stdout == written && !written.is_empty(), "{command:?} {extension}");
        if extension == "csv" {
            assert_eq!(run(&folder, &[&command[..], &["--output", "-"]].concat()).stdout, written, "{command:?}");
        }
    }
    let output = run(&folder, &["distance", "torus.ply", "--source", "0", "--output", "-", "--json"]);
    assert!(output.stdout.starts_with(b"vertex,distance\n") && output.stderr.starts_with(b"{\""));
    let both = ["cells", "torus.ply", "--source", "0", "--output", "-", "--borders", "-"];
    assert!(refused(&folder, &both).contains("only one file"));
    let sparse = ["matrix", "torus.ply", "--all", "--max-distance", "1", "--output=-.npz"];
    assert!(refused(&folder, &sparse).contains("put together at the end"));
}
