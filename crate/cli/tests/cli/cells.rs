//! Cells of sources.

use std::fs;

use crate::{folder, json as answered, refused};

#[test]
fn cells_of_a_square_are_its_halves() {
    let folder = folder("cells");
    let both = ["cells", "flat.ply", "--source", "0", "--source", "80"];
    let answer = answered(&folder, &[&both[..], &["--output", "cells.csv", "--borders", "borders.csv"]].concat());
    assert_eq!(answer["cells"], 2);
    let area = |cell: usize| answer["areas"][cell].as_f64().unwrap();
    assert!((area(0) - 0.5).abs() < 1e-6 && (area(1) - 0.5).abs() < 1e-6);
    assert!((answer["border_length"].as_f64().unwrap() - 2_f64.sqrt()).abs() < 1e-6);
    let csv = fs::read_to_string(folder.join("cells.csv")).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((rows.len(), rows[0].join(",").as_str()), (82, "vertex,source,distance"));
    assert_eq!((rows[1][1], rows[81][1], rows[81][0]), ("0", "1", "80"));
    let borders = fs::read_to_string(folder.join("borders.csv")).unwrap();
    assert!(borders.starts_with("curve,cell,other,closed,x"));
    // The bisector, where x is 1 + z.
    for row in borders.lines().skip(1) {
        let numbers: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        assert!((numbers[4] - 1.0 - numbers[6]).abs() < 1e-6, "{row}");
    }
    for file in ["borders.obj", "borders.dxf", "borders.svg"] {
        answered(&folder, &[&both[..], &["--borders", file]].concat());
        assert!(fs::read_to_string(folder.join(file)).unwrap().to_lowercase().contains("border_0_1"));
    }
    // Without borders, areas are not looked for unless they are wanted.
    assert!(answered(&folder, &both).get("areas").is_none());
    assert!(answered(&folder, &[&both[..], &["--areas"]].concat()).get("areas").is_some());
}

#[test]
fn what_is_not_reached_is_of_no_cell_and_bad_input_is_named() {
    let folder = folder("cells_refused");
    answered(&folder, &["cells", "two.obj", "--source", "0", "--output", "cells.csv"]);
    let csv = fs::read_to_string(folder.join("cells.csv")).unwrap();
    assert!(csv.lines().any(|line| line.ends_with(",,inf")));
    let asked = |more: &[&str]| refused(&folder, &[&["cells", "flat.ply"], more].concat());
    assert!(asked(&[]).contains("--source"));
    assert!(asked(&["--source", "81"]).contains("81"));
    assert!(asked(&["--source", "0", "--borders", "a.glb"]).contains(".obj, .dxf, .svg or .csv"));
    assert!(asked(&["--source", "0", "--output", "a.obj"]).contains(".csv"));
    assert!(refused(&folder, &["cells", "shape:cube", "--source", "0"]).contains("not of the inside of tetrahedra"));
}
