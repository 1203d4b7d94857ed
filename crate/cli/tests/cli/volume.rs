//! Tetrahedra: what the commands answer and what they refuse.

use std::fs;
use std::path::{Path, PathBuf};

use heatwalk_volume::io::write;
use heatwalk_volume::shapes;

use super::{distances, folder, json, refused, succeed};

/// A folder with a pierced cube, in which vertex 0 is at a corner of the hole's rim.
fn with_mesh(test: &str) -> PathBuf {
    let folder = folder(test);
    fs::write(folder.join("pierced.msh"), write::msh(&shapes::pierced_cube(0.4, 2, 0.0), None)).unwrap();
    folder
}

#[test]
fn info_tells_tetrahedra_volume_and_angles() {
    let folder = with_mesh("volume_info");
    let info = json(&folder, &["info", "pierced.msh"]);
    assert_eq!(info["tetrahedra"], 6 * 2 * 16 * 4);
    assert_eq!(info["components"], 1);
    let hole = 16.0 / 2.0 * 0.4_f64.powi(2) * (std::f64::consts::TAU / 16.0).sin();
    let volume = info["volume"].as_f64().unwrap();
    assert!((volume - 2.0 * (4.0 - hole)).abs() < 1e-9, "{volume}");
    let angle = |name: &str| info[name].as_f64().unwrap();
    assert!(angle("least_dihedral_angle") > 5.0 && angle("largest_dihedral_angle") < 170.0);
    assert!(succeed(&folder, &["info", "shape:cave"]).contains("mean least dihedral angle"));
}

#[test]
fn info_tells_what_cells_became() {
    let folder = folder("volume_cells");
    let nodes = "1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n9 0.5 0.5 2";
    let file = |elements: &str| {
        format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n{nodes}\n$EndNodes\n$Elements\n{elements}\n$EndElements\n"
        )
    };
    fs::write(folder.join("mixed.msh"), file("2\n1 5 0 1 2 3 4 5 6 7 8\n2 7 0 5 6 7 8 9")).unwrap();
    fs::write(folder.join("faces.msh"), file("1\n1 2 0 1 2 3")).unwrap();
    let info = json(&folder, &["info", "mixed.msh"]);
    let count = |name: &str| info[name].as_u64().unwrap();
    assert_eq!(
        [count("split_hexahedra"), count("split_prisms"), count("split_pyramids"), count("tetrahedra")],
        [1, 0, 1, 8]
    );
    assert_eq!(json(&folder, &["info", "faces.msh"])["faces"], 1, "without tetrahedra, the faces are a surface");
}

#[test]
fn distances_are_those_inside_by_either_method() {
    let folder = with_mesh("volume_distance");
    let marched = distances(&folder, &["pierced.msh", "--source", "0"]);
    assert_eq!(marched[0], 0.0);
    let answer = json(&folder, &["distance", "pierced.msh", "--source", "0"]);
    assert_eq!((answer["method"].as_str(), answer["factor_nonzeros"].as_u64()), (Some("march"), Some(0)));
    let heated = distances(&folder, &["pierced.msh", "--source", "0", "--method", "heat", "--near", "2"]);
    let mean = heated.iter().zip(&marched).map(|(a, b)| (a - b).abs()).sum::<f64>() / marched.len() as f64;
    assert!(mean > 0.0 && mean < 0.1, "{mean}");
    let by_option = json(&folder, &["distance", "pierced.msh", "--source", "0", "--t", "2"]);
    assert_eq!((by_option["method"].as_str(), by_option["time_factor"].as_f64()), (Some("heat"), Some(2.0)));
    let near = distances(&folder, &["pierced.msh", "--source", "0@0.5", "--max-distance", "1"]);
    assert!(near.iter().any(|value| value.is_infinite()) && near[0] == 0.5);
}

#[test]
fn places_are_in_tetrahedra_as_the_file_counts_them() {
    let folder = with_mesh("volume_places");
    let soup = shapes::pierced_cube(0.4, 2, 0.0);
    let corners = soup.tetrahedra[17];
    for (corner, weights) in ["1,0,0,0", "0,1,0,0", "0,0,1,0", "0,0,0,1"].iter().enumerate() {
        let values = distances(&folder, &["pierced.msh", "--source", &format!("17:{weights}")]);
        assert_eq!(values[corners[corner] as usize], 0.0, "corner {corner}");
    }
}

#[test]
fn paths_and_distances_are_written() {
    let folder = with_mesh("volume_path");
    let path = json(
        &folder,
        &["path", "pierced.msh", "--from", "40", "--to", "3:0.25,0.25,0.25,0.25", "--output", "path.csv"],
    );
    let points = path["points"].as_array().unwrap().len();
    assert_eq!(fs::read_to_string(folder.join("path.csv")).unwrap().lines().count(), points + 1);
    assert!(path["length"].as_f64().unwrap() > 0.0);
    for name in ["distance.vtu", "distance.msh"] {
        succeed(&folder, &["distance", "pierced.msh", "--source", "0", "--output", name]);
        assert_eq!(json(&folder, &["info", name])["tetrahedra"], 6 * 2 * 16 * 4, "{name}");
    }
}

#[test]
fn each_source_has_a_column_of_its_own() {
    let folder = with_mesh("volume_each");
    let both = ["distance", "pierced.msh", "--source", "0", "--source", "40@0.5", "--each"];
    let answer = json(&folder, &[&both[..], &["--output", "each.csv"]].concat());
    let maxima: Vec<f64> =
        answer["each"].as_array().unwrap().iter().map(|answer| answer["max_distance"].as_f64().unwrap()).collect();
    let alone = ["0", "40@0.5"].map(|source| distances(&folder, &["pierced.msh", "--source", source]));
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    assert_eq!(maxima, [largest(&alone[0]), largest(&alone[1])]);
    let csv = fs::read_to_string(folder.join("each.csv")).unwrap();
    assert!(csv.starts_with("vertex,distance_0,distance_1\n"));
    for (vertex, line) in csv.lines().skip(1).enumerate() {
        let values: Vec<f64> = line.split(',').skip(1).map(|value| value.parse().unwrap()).collect();
        assert_eq!(values, [alone[0][vertex], alone[1][vertex]]);
    }
    assert!(refused(&folder, &[&both[..], &["--output", "each.vtu"]].concat()).contains(".csv"));
}

#[test]
fn heat_is_compared_with_the_march() {
    let folder = with_mesh("volume_compare");
    let ask = ["distance", "pierced.msh", "--source", "0", "--compare"];
    let answer = json(&folder, &[&ask[..], &["--method", "heat", "--near", "0"]].concat());
    let [mean, most] = ["mean_error_percent", "max_error_percent"].map(|name| answer[name].as_f64().unwrap());
    assert!(mean > 0.1 && mean < 10.0 && most > mean, "{mean} {most}");
    assert!(refused(&folder, &ask).contains("--method heat"));
}

#[test]
fn lines_along_edges_are_sources() {
    let folder = with_mesh("volume_lines");
    // Vertices of the hole's rim at z = -1 are 5 apart, as many as there are along the hole.
    let values = distances(&folder, &["pierced.msh", "--line", "0,10"]);
    for vertex in [0, 5, 10] {
        assert_eq!(values[vertex], 0.0, "{vertex}");
    }
    let closed = distances(&folder, &["pierced.msh", "--line", "0,25,50", "--closed"]);
    let on_line = closed.iter().filter(|value| **value == 0.0).count();
    assert_eq!(on_line, 16);
    let told = refused(&folder, &["distance", "pierced.msh", "--line", "0,9999"]);
    assert!(told.contains("vertex 9999 does not exist"), "{told}");
}

#[test]
fn what_is_for_surfaces_is_refused() {
    let folder = with_mesh("volume_refused");
    let ask = |options: &[&str]| {
        refused(Path::new(&folder), &[&["distance", "pierced.msh", "--source", "0"], options].concat())
    };
    for options in [
        &["--operator", "plain"][..],
        &["--windows", "2"],
        &["--exact"],
        &["--repeat", "3"],
        &["--weld", "exact"],
        &["--part", "0"],
        &["--bridge", "off"],
        &["--method", "propagation"],
    ] {
        assert!(ask(options).contains("surfaces"), "{options:?}");
    }
    assert!(ask(&["--method", "march", "--t", "1"]).contains("has no effect with --method march"));
    assert!(ask(&["--source", "1:0.2,0.3,0.5"]).contains("four"));
    assert!(ask(&["--source", "9999"]).contains("vertex 9999 does not exist"));
    assert!(ask(&["--source", "9999:1,0,0,0"]).contains("tetrahedron 9999 does not exist"));
    assert!(ask(&["--source", "7:1,1,0,0"]).contains("tetrahedron 7"));
    assert!(ask(&["--output", "x.ply"]).contains(".vtu"));
    let on_surface = |options: &[&str]| refused(&folder, &[&["distance", "torus.ply"], options].concat());
    assert!(on_surface(&["--source", "0", "--method", "march"]).contains("tetrahedra"));
    assert!(on_surface(&["--source", "1:0.25,0.25,0.25,0.25"]).contains("three"));
}

#[test]
fn distance_from_the_boundary_is_how_deep_a_vertex_is_inside() {
    let folder = folder("volume_depth");
    let cube = shapes::cube(4, 0.1);
    fs::write(folder.join("cube.msh"), write::msh(&cube, None)).unwrap();
    let from_boundary = ["distance", "cube.msh", "--curve", "boundary"];
    let answer = json(&folder, &from_boundary);
    assert_eq!((&answer["method"], &answer["unreachable"]), (&"exact".into(), &0.into()));
    for (depth, position) in distances(&folder, &from_boundary[1..]).iter().zip(&cube.positions) {
        assert!((depth - (1.0 - position.abs().max_element())).abs() < 1e-12, "{depth} at {position}");
    }
    let says = |more: &[&str]| refused(&folder, &[&from_boundary[..], more].concat());
    assert!(says(&["--method", "heat"]).contains("exact"));
    assert!(says(&["--max-distance", "1"]).contains("--max-distance"));
    assert!(says(&["--signed"]).contains("--signed"));
    assert!(refused(&folder, &["distance", "cube.msh", "--curve", "0 5"]).contains("--curve boundary"));
}
