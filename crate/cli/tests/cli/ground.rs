//! Costs and walls.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use super::{difference, distances, flat, folder, json, refused, run};

/// Rows of triangle,cost for the triangles of [`flat`] beyond x = ½.
fn dear_half() -> String {
    let soup = flat();
    let mut rows = "face,cost\n".to_owned();
    for (face, triangle) in soup.triangles.iter().enumerate() {
        let middle: f64 = triangle.iter().map(|&corner| soup.positions[corner as usize].x / 3.0).sum();
        if middle > 0.5 {
            writeln!(rows, "{face},3").unwrap();
        }
    }
    rows
}

#[test]
fn weights_of_a_file_make_ways_dearer() {
    let folder = folder("weights");
    fs::write(folder.join("costs.csv"), dear_half()).unwrap();
    // Vertices (0, 4) and (8, 4) are opposite each other: half of the way costs 1, half 3.
    let found = distances(&folder, &["flat.ply", "--source", "4", "--weights", "costs.csv"]);
    assert!((found[4 * 9 + 4] - 0.5).abs() < 1e-9 && (found[8 * 9 + 4] - 2.0).abs() < 1e-4, "{}", found[8 * 9 + 4]);
    let heat = distances(&folder, &["flat.ply", "--source", "4", "--weights", "costs.csv", "--method", "heat"]);
    assert!(difference(&found, &heat) < 0.1);

    let path =
        json(&folder, &["path", "flat.ply", "--from", "76", "--to", "4", "--weights", "costs.csv", "--straighten"]);
    assert!((path["cost"].as_f64().unwrap() - 2.0).abs() < 1e-6, "{path}");
    assert!((path["length"].as_f64().unwrap() - 1.0).abs() < 1e-6, "{path}");
    let refracted =
        json(&folder, &["path", "flat.ply", "--from", "80", "--to", "0", "--weights", "costs.csv", "--straighten"]);
    let [cost, length] = ["cost", "length"].map(|name| refracted[name].as_f64().unwrap());
    assert!(length > 2.0_f64.sqrt() * 1.01 && cost < 2.0 * 2.0_f64.sqrt() * 0.99, "{cost} {length}");
    let exact = refused(&folder, &["distance", "flat.ply", "--source", "4", "--weights", "costs.csv", "--exact"]);
    assert!(exact.contains("different costs"), "{exact}");
}

#[test]
fn weights_are_read_from_attributes_and_colors() {
    let folder = folder("attributes");
    let soup = flat();
    let mut ply = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float mud\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        soup.positions.len(),
        soup.triangles.len()
    );
    for at in &soup.positions {
        writeln!(ply, "{} {} {} 0 0 0 2.5", at.x, at.y, at.z).unwrap();
    }
    for [a, b, c] in &soup.triangles {
        writeln!(ply, "3 {a} {b} {c}").unwrap();
    }
    fs::write(folder.join("mud.ply"), ply).unwrap();
    let plain = distances(&folder, &["flat.ply", "--source", "0"]);
    for (name, cost) in [("mud", 2.5), ("COLOR", 10.0)] {
        let found = distances(&folder, &["mud.ply", "--source", "0", "--weights", &format!("attribute:{name}")]);
        let scaled: Vec<f64> = plain.iter().map(|value| cost * value).collect();
        assert!(difference(&found, &scaled) < 1e-6);
    }
    let unknown = refused(&folder, &["distance", "mud.ply", "--source", "0", "--weights", "attribute:sand"]);
    assert!(unknown.contains("no attribute sand") && unknown.contains("mud"), "{unknown}");
}

#[test]
fn bad_attributes_are_named_by_their_vertices_but_those_that_no_triangle_uses() {
    let folder = folder("bad-attributes");
    let ply = |first: i32, last: i32| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty float w\n\
             element face 1\nproperty list uchar int vertex_indices\nend_header\n9 9 9 -5\n0 0 0 {first}\n1 0 0 10\n0 1 0 {last}\n3 1 2 3\n"
        )
    };
    for (first, last, expected) in [
        (-7, 10, "attribute:w: a cost is -7 at vertex 1; it must be from 0.001 to 1000"),
        (-7, 2000, "a cost is -7 at vertex 1, and out of range at 1 more"),
        (10, 0, "a cost is 0 at vertex 3;"),
    ] {
        fs::write(folder.join("a.ply"), ply(first, last)).unwrap();
        let told = refused(&folder, &["distance", "a.ply", "--source", "1", "--weights", "attribute:w"]);
        assert!(told.contains(expected), "{told}");
    }
    fs::write(folder.join("a.ply"), ply(10, 10)).unwrap();
    let found = distances(&folder, &["a.ply", "--source", "1", "--weights", "attribute:w"]);
    assert!((found[2] - 10.0).abs() < 1e-9, "{found:?}");
}

/// The distances of a square that lies level in the plane of x and z, which an option does not change.
fn free_where_level(folder: &Path, option: [&str; 2]) -> Vec<f64> {
    let question = ["flat.ply", "--source", "0"];
    let plain = distances(folder, &question);
    let level = distances(folder, &[&question[..], &option].concat());
    assert!(difference(&plain, &level) < 1e-9);
    plain
}

#[test]
fn slopes_cost_by_the_axis_that_points_up() {
    let folder = folder("slopes");
    let plain = free_where_level(&folder, ["--slope-cost", "tobler"]);
    let upright = distances(&folder, &["flat.ply", "--source", "0", "--slope-cost", "tobler", "--up", "z"]);
    assert!((upright[80] / plain[80] - 1000.0).abs() < 1e-6, "{}", upright[80]);
}

#[test]
fn heights_cost_by_the_axis_that_points_up() {
    let folder = folder("heights");
    free_where_level(&folder, ["--height-cost", "3"]);
    // Up the side of length 1, where the costs of the eight cells' two triangles are 9 to the power of their heights.
    let upright = distances(&folder, &["flat.ply", "--source", "0", "--height-cost", "9", "--up", "x"]);
    let cost = |third: f64| (0..8).map(|cell| 9.0_f64.powf((f64::from(cell) + third / 3.0) / 8.0) / 8.0).sum::<f64>();
    assert!((cost(1.0)..=cost(2.0)).contains(&upright[72]), "{} {} {}", upright[72], cost(1.0), cost(2.0));
    // Both multiply.
    fs::write(folder.join("costs.csv"), (0..128).map(|face| format!("{face},2\n")).collect::<String>()).unwrap();
    let dear = ["flat.ply", "--source", "0", "--height-cost", "9", "--up", "x", "--weights", "costs.csv"];
    let dear = distances(&folder, &dear);
    assert!((dear[72] / upright[72] - 2.0).abs() < 1e-9, "{} {}", dear[72], upright[72]);
    for bad in ["0", "-1", "inf", "steep"] {
        let told = refused(&folder, &["distance", "flat.ply", "--source", "0", "--height-cost", bad]);
        assert!(told.contains("--height-cost") && told.contains("0.001 to 1000"), "{told}");
    }
}

#[test]
fn walls_of_triangles_and_of_edges_are_walked_around() {
    let folder = folder("walls");
    let plain = distances(&folder, &["flat.ply", "--source", "4"]);
    // Edges on the line x = ½, from the side z = 0 up to z = −⅞.
    let edges: String = (0..7).map(|j| format!("{},{}\n", 36 + j, 37 + j)).collect();
    fs::write(folder.join("edges.csv"), edges).unwrap();
    let found = distances(&folder, &["flat.ply", "--source", "0", "--walls", "edges.csv", "--exact"]);
    let around = (0.5_f64.powi(2) + 0.875_f64.powi(2)).sqrt();
    assert!((found[72] - 2.0 * around).abs() < 1e-9, "{} {around}", found[72]);

    // Both columns of triangles next to that line, all the way: nothing gets beyond.
    let soup = flat();
    let mut faces = String::new();
    for (face, triangle) in soup.triangles.iter().enumerate() {
        let middle: f64 = triangle.iter().map(|&corner| soup.positions[corner as usize].x / 3.0).sum();
        if (middle - 0.5).abs() < 0.125 {
            writeln!(faces, "{face}").unwrap();
        }
    }
    fs::write(folder.join("faces.csv"), &faces).unwrap();
    let found = distances(&folder, &["flat.ply", "--source", "4", "--walls", "faces.csv"]);
    assert!(found[76].is_infinite() && (found[18] - plain[18]).abs() < 1e-12);
    let inside = faces.lines().next().unwrap();
    let source = format!("{inside}:0.2,0.3,0.5");
    let told = refused(&folder, &["distance", "flat.ply", "--source", &source, "--walls", "faces.csv"]);
    assert!(told.contains("wall") && told.contains(inside), "{told}");
}

#[test]
fn bad_rows_are_named_by_their_lines() {
    let folder = folder("bad-ground");
    let distance =
        |option: &str, rows: &str| refused(&folder, &["distance", "flat.ply", "--source", "0", option, rows]);
    let check = |option: &str, rows: &str, expected: &str| {
        fs::write(folder.join("rows.csv"), rows).unwrap();
        let told = distance(option, "rows.csv");
        assert!(told.contains(expected), "{told}");
    };
    for (rows, expected) in [
        ("0,1\n1,0\n", "line 2: the cost is 0"),
        ("0,1\n1,-2\n", "line 2: the cost is -2"),
        ("0,NaN\n", "line 1: the cost is NaN"),
        ("0,1\n9999,1\n", "line 2: there is no triangle 9999"),
        ("0,1\n3\n", "line 2: give a triangle and its cost"),
        ("0,1\nx,y\n", "line 2"),
        (
            "0,1\n1,0\n2,-3\n3,5000\n",
            "line 2: the cost is 0; it must be from 0.001 to 1000; what nobody may enter belongs in --walls; 2 more rows are wrong, too",
        ),
        ("0,1\rx,y\rz,z", "line 2: \"x,y\" is no row of numbers; 1 more rows are wrong, too"),
        ("face,cost\n3,2\n3,2\n3,4\n", "line 4: triangle 3 costs 4 here and 2 in line 2"),
    ] {
        check("--weights", rows, expected);
    }
    for (rows, expected) in [
        ("0\n128\n", "line 2: there is no triangle 128"),
        ("0,80\n", "line 1: no edge joins the vertices 0 and 80"),
        ("0,1,2\n", "line 1: give a triangle"),
    ] {
        check("--walls", rows, expected);
    }
    let missing = distance("--weights", "none.csv");
    assert!(missing.contains("none.csv"), "{missing}");
    assert!(!run(&folder, &["distance", "flat.ply", "--source", "0", "--slope-cost", "steep"]).status.success());
}

#[test]
fn tetrahedra_have_costs_and_walls_too() {
    let folder = folder("tetrahedra-ground");
    let mesh = ["shape:cave", "--source", "0"];
    let plain = distances(&folder, &mesh);
    let tetrahedra = json(&folder, &["info", "shape:cave"])["tetrahedra"].as_u64().unwrap();
    let costs: String = (0..tetrahedra).map(|tetrahedron| format!("{tetrahedron},2.5\n")).collect();
    fs::write(folder.join("costs.csv"), costs).unwrap();
    let dear = distances(&folder, &[&mesh[..], &["--weights", "costs.csv"]].concat());
    let scaled: Vec<f64> = plain.iter().map(|value| 2.5 * value).collect();
    assert!(difference(&dear, &scaled) < 1e-9);
    // Walls around everything but the first tetrahedron.
    let walls: String = (1..tetrahedra).map(|tetrahedron| format!("{tetrahedron}\n")).collect();
    fs::write(folder.join("walls.csv"), walls).unwrap();
    let shut = json(&folder, &["distance", "shape:cave", "--source", "0:0.25,0.25,0.25,0.25", "--walls", "walls.csv"]);
    assert_eq!(shut["unreachable"].as_u64().unwrap() + 4, plain.len() as u64, "{shut}");
    for [option, value] in [["--slope-cost", "tobler"], ["--height-cost", "2"]] {
        let told = refused(&folder, &["distance", "shape:cave", "--source", "0", option, value]);
        assert!(told.contains(option), "{told}");
    }
}
