//! Places from files, and several at once.

use std::fs;

use crate::{distances, folder, json, refused, succeed};

#[test]
fn sources_of_a_file_are_those_of_the_command_line() {
    let folder = folder("source_files");
    let list = "# of the square\n12\n\n 5:0.2,0.3,0.5@0.25   # with a start\r\n@0.5,0,-0.5\n";
    fs::write(folder.join("sources.txt"), list).unwrap();
    let given = ["--source", "80", "--source", "12", "--source", "5:0.2,0.3,0.5@0.25", "--source", "@0.5,0,-0.5"];
    let [listed, given] = [&["--source", "80", "--sources", "sources.txt"][..], &given].map(|sources| {
        let each = json(&folder, &[&["distance", "flat.ply", "--each"], sources].concat());
        (distances(&folder, &[&["flat.ply"], sources].concat()), each["each"].clone())
    });
    assert_eq!(listed, given);
    for (command, counted) in [("cells", "cells"), ("isolines", "isolines")] {
        let more: &[&str] = if command == "isolines" { &["--count", "2"] } else { &[] };
        let told = json(&folder, &[&[command, "flat.ply", "--sources", "sources.txt"], more].concat());
        assert!(told[counted] == 3 || told[counted].as_array().unwrap().len() == 2, "{told}");
    }
    let weighted = json(&folder, &["mean", "flat.ply", "--sources", "sources.txt"]);
    let same = ["--source", "12", "--source", "5:0.2,0.3,0.5@0.25", "--source", "@0.5,0,-0.5"];
    assert_eq!(weighted["place"], json(&folder, &[&["mean", "flat.ply"], &same[..]].concat())["place"]);
    let inside = distances(
        &folder,
        &["shape:cube", "--sources", "vertex.txt"].map(|word| {
            fs::write(folder.join("vertex.txt"), "0\n").unwrap();
            word
        }),
    );
    assert_eq!(inside[0], 0.0);
}

#[test]
fn bad_files_of_places_are_refused() {
    let folder = folder("bad_source_files");
    fs::write(folder.join("empty.txt"), "# nothing\n\n").unwrap();
    fs::write(folder.join("bad.txt"), "1\n\nx\n").unwrap();
    fs::write(folder.join("high.txt"), "1\n81\n").unwrap();
    for (file, hint) in [
        ("missing.txt", "cannot read missing.txt"),
        ("empty.txt", "there is no source; write one a line"),
        ("bad.txt", "bad.txt, line 3: give a vertex"),
        ("high.txt", "vertex 81 does not exist"),
    ] {
        let line = refused(&folder, &["distance", "flat.ply", "--sources", file]);
        assert!(line.contains(hint), "{file}: {line}");
    }
}

#[test]
fn a_path_may_lead_to_several_places() {
    let folder = folder("several_paths");
    let several = ["path", "flat.ply", "--from", "0", "--to", "80", "--to", "8", "--output"];
    let told = json(&folder, &[&several[..], &["paths.csv"]].concat());
    let paths = told["paths"].as_array().unwrap();
    assert_eq!((paths.len(), &paths[0]["to"], &paths[1]["to"]), (2, &"80".into(), &"8".into()));
    for (path, to) in paths.iter().zip(["80", "8"]) {
        let alone = json(&folder, &["path", "flat.ply", "--from", "0", "--to", to]);
        assert_eq!((&path["length"], &path["points"]), (&alone["length"], &alone["points"]));
    }
    let csv = fs::read_to_string(folder.join("paths.csv")).unwrap();
    assert!(csv.starts_with("path,x,y,z\n0,") && csv.lines().any(|line| line.starts_with("1,")), "{csv}");
    let text = succeed(&folder, &[&several[..], &["paths.obj"]].concat());
    assert!(text.contains("path 1                 to 8, distance 1.0, length 1.0\n"), "{text}");
    assert_eq!(fs::read_to_string(folder.join("paths.obj")).unwrap().matches("\nl ").count(), 2);
    let inside = json(&folder, &["path", "shape:cube", "--from", "0", "--to", "1", "--to", "2"]);
    let alone = json(&folder, &["path", "shape:cube", "--from", "0", "--to", "2"]);
    assert_eq!(inside["paths"][1]["length"], alone["length"]);
}
