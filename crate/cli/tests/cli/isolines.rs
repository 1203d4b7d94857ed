//! `heatwalk isolines`: what it tells, and files that the readers of this project read back.

use std::f64::consts::PI;
use std::fs;

use heatwalk::Surface;
use heatwalk_model::io;
use serde_json::Value;

use super::{folder, json, refused, succeed};

fn numbers(value: &Value, key: &str) -> Vec<f64> {
    value["isolines"].as_array().unwrap().iter().map(|isoline| isoline[key].as_f64().unwrap()).collect()
}

#[test]
fn isolines_tells_values_lengths_areas_and_how_many_are_closed() {
    let folder = folder("isolines");
    // From one side of the unit square, distance is exact and linear.
    let line = ["isolines", "flat.ply", "--line", "0,8"];
    let spaced = json(&folder, &[&line[..], &["--spacing", "0.25"]].concat());
    assert_eq!(numbers(&spaced, "value"), [0.25, 0.5, 0.75]);
    for (length, area) in numbers(&spaced, "length").iter().zip(numbers(&spaced, "enclosed_area")) {
        assert!((length - 1.0).abs() < 1e-9 && [0.25, 0.5, 0.75].iter().any(|value| (area - value).abs() < 1e-9));
    }
    assert_eq!(numbers(&spaced, "closed"), [0.0; 3]);
    let counted = json(&folder, &[&line[..], &["--count", "3"]].concat());
    assert!(
        numbers(&counted, "value").iter().zip([0.25, 0.5, 0.75]).all(|(value, share)| (value - share).abs() < 1e-9)
    );
    let given = json(&folder, &["isolines", "torus.ply", "--source", "0", "--values", "0.3,9"]);
    assert_eq!((numbers(&given, "curves"), numbers(&given, "closed")), (vec![1.0, 0.0], vec![1.0, 0.0]));
    let words = succeed(&folder, &[&line[..], &["--count", "1"]].concat());
    assert!(words.contains("1 curves, 0 closed"), "{words}");
}

#[test]
fn isolines_of_exact_distances_are_curves_and_others_chords() {
    let folder = folder("isolines_exact");
    // A quarter of a circle around a corner of the unit square.
    let of = |method: &[&str]| {
        let corner = ["isolines", "flat.ply", "--source", "0", "--values", "0.5", "--method"];
        let told = json(&folder, &[&corner[..], method].concat());
        let length = numbers(&told, "length")[0] / (0.25 * PI);
        let area = numbers(&told, "enclosed_area")[0] / (PI / 16.0);
        (told["curves"].as_str().unwrap().to_owned(), (length - 1.0).abs().max((area - 1.0).abs()))
    };
    let (words, error) = of(&["exact"]);
    assert_eq!(words, "exact to about 0.001 of the length");
    assert!(error < 1e-3, "{error}");
    let (words, error) = of(&["heat", "--near", "0"]);
    assert_eq!(words, "chords of triangles");
    assert!(error > 1e-3, "{error}");
}

#[test]
fn strips_are_read_back_with_the_area_of_the_surface() {
    let folder = folder("strips");
    let strips = ["--count", "7", "--strips", "--output", "strips.obj"];
    succeed(&folder, &[&["isolines", "torus.ply", "--source", "0"][..], &strips].concat());
    let area = |name: &str| {
        let soup = io::read(name, &fs::read(folder.join(name)).unwrap(), &|_| None).unwrap().soup;
        let surface = Surface::build(&soup).unwrap();
        let area: f64 = surface.mesh().faces().map(|face| surface.face_area(face)).sum();
        (area, soup.parts.len(), surface.report().boundary_loops)
    };
    let ((whole, ..), (cut, strips, loops)) = (area("torus.ply"), area("strips.obj"));
    assert!((cut / whole - 1.0).abs() < 1e-12);
    assert_eq!((strips, loops), (8, 0));
}

#[test]
fn curves_are_written_as_csv_obj_dxf_svg_pdf_and_glb() {
    let folder = folder("curves");
    let write = |name: &str| {
        succeed(&folder, &["isolines", "flat.ply", "--line", "0,8", "--values", "0.25,0.3", "--output", name]);
        fs::read(folder.join(name)).unwrap()
    };
    let text = |name: &str| String::from_utf8(write(name)).unwrap();
    let csv = text("a.csv");
    let rows: Vec<Vec<f64>> =
        csv.lines().skip(1).map(|row| row.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    assert!(rows.iter().all(|row| row[2] == 0.0 && (row[3] - row[1]).abs() < 1e-9), "{csv}");
    assert_eq!(rows.iter().filter(|row| row[1] == 0.25).count(), 9);
    assert_eq!(text("a.obj").matches("\nl ").count(), 2);
    let dxf = text("a.dxf");
    assert_eq!(dxf.matches("\nPOLYLINE\n").count(), 2);
    assert!(dxf.contains("ISOLINE_0_0_25") && dxf.ends_with("  0\nEOF\n"));
    assert_eq!(text("a.svg").matches("<path").count(), 2);
    assert!(write("a.glb").starts_with(b"glTF"));
    assert!(write("a.pdf").starts_with(b"%PDF-1.4\n"));
    let unroll = ["--count", "3", "--unroll", "--output", "sheet.svg"];
    let told = json(&folder, &[&["isolines", "flat.ply", "--line", "0,8"][..], &unroll].concat());
    assert_eq!(told["left_out"], Value::Array(Vec::new()));
    assert_eq!(fs::read_to_string(folder.join("sheet.svg")).unwrap().matches("<path").count(), 4);
}

#[test]
fn refuses_what_cannot_be_drawn() {
    let folder = folder("isolines_refused");
    let asked = |more: &[&str]| refused(&folder, &[&["isolines", "torus.ply", "--source", "0"], more].concat());
    assert!(asked(&[]).contains("--spacing"));
    assert!(asked(&["--spacing", "-1"]).contains("a spacing is a positive number"));
    assert!(asked(&["--spacing", "1e-9"]).contains("choose a larger spacing"));
    assert!(asked(&["--count", "3", "--output", "a.ply"]).contains(".obj, .dxf, .svg, .pdf, .csv or .glb"));
    assert!(asked(&["--count", "1", "--unroll", "--output", "a.svg"]).contains("cannot be unrolled"));
    assert!(!folder.join("a.svg").exists());
    assert!(asked(&["--count", "1", "--unit", "none", "--output", "a.pdf"]).contains("choose one by --unit"));
    // Narrower than triangles, which have no vertex within.
    let mixed = ["--values", "0.5,0.501", "--unroll", "--output", "sheet.pdf"];
    let told = json(&folder, &[&["isolines", "torus.ply", "--source", "0"][..], &mixed].concat());
    assert_eq!(told["left_out"], serde_json::json!(["strip_0_below_0.5", "strip_2_above_0.501"]));
    assert!(fs::read(folder.join("sheet.pdf")).unwrap().starts_with(b"%PDF-1.4\n"));
}
