//! Readers of OFF, OBJ, PLY and STL, and all writers: good files, odd files, damaged files. glTF has its own tests.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::reading;

use glam::DVec3;
use heatwalk_model::Error;
use heatwalk_model::io::{upward, write};
use heatwalk_shapes as shapes;
use heatwalk_surface::{Error as SurfaceError, Soup, Surface, Unit};
use serde_json::{Value, json};

use crate::reading::{areas, part_names, read, read_model};

fn fails(name: &str, text: &str, place: &str) {
    let error = read(name, text).unwrap_err().to_string();
    assert!(error.contains(place), "{error}");
}

// ---- OFF

const SQUARE_OFF: &str = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

#[test]
fn off_variants_hold_the_same_square() {
    let square = read("square.off", SQUARE_OFF).unwrap();
    assert_eq!(square.positions[2], DVec3::new(1.0, 1.0, 0.0));
    assert_eq!(square.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(part_names(&square), ["square"]);
    for variant in [
        "OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
        "OFF4 1 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n4 0 1 2 3",
        "# made by hand\nOFF # header\n\n4 1\n0 0 0 # a corner\n1 0 0\n\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n",
        "COFF\n4 1 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n1 1 0 0 0 0 0\n0 1 0 9 9 9 9\n4 0 1 2 3 0.5 0.5 0.5\n",
        "STCNOFF\n4 1 0\n0 0 0 0 0 1 9\n1 0 0 0 0 1 9\n1 1 0 0 0 1 9\n0 1 0 0 0 1 9\n4 0 1 2 3\n",
        "4OFF\n4 1 0\n0 0 0 2\n2 0 0 2\n2 2 0 2\n0 2 0 2\n4 0 1 2 3\n",
    ] {
        assert_eq!(read("square.off", variant).unwrap(), square, "{variant}");
    }
    assert_eq!(read("square", SQUARE_OFF).unwrap(), square, "told by its first bytes");
}

#[test]
fn off_errors_name_the_place() {
    let index = read("a.off", SQUARE_OFF.replace("4 0 1 2 3", "3 0 1 4")).unwrap_err().to_string();
    assert_eq!(index, "OFF, line 7: vertex 4 does not exist; there are 4, counted from 0");
    for (bad, place) in [
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n1 x 0\n0 1 0\n4 0 1 2 3\n", "line 5"),
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2\n", "line 7"),
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 -3\n", "line 7"),
        ("OFF\n99999999999999 1 0\n0 0 0\n", "end of file"),
        ("OFF\n4 99999999999999 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "end of file"),
        ("OFF\n-4 1 0\n", "line 2"),
        ("OFF", "end of file"),
        ("", "a.off is empty"),
    ] {
        fails("a.off", bad, place);
    }
    assert!(matches!(read("a.off", "OFF BINARY\n\0\0\0\x04"), Err(Error::Unsupported { .. })));
    assert!(matches!(
        read("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"),
        Err(Error::Surface(SurfaceError::Empty { .. }))
    ));
    assert!(matches!(read("picture.png", "\u{1}PNG"), Err(Error::UnknownFormat { .. })));
    let refused = read("model.FBX", "Kaydara FBX Binary").unwrap_err().to_string();
    assert!(refused.contains("convert model.FBX to GLB, in Blender"), "{refused}");
}

// ---- OBJ

const TWO_GROUPS_OBJ: &str = "# two groups\r\nmtllib x.mtl\r\nv 0 0 0 1 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nvt 0 0\r\n\
                              vn 0 0 1\r\ng empty\r\ng left\r\nf 1/1/1 2/1/1 3/1/1\r\ng right\r\nf 1//1 3//1 \\\r\n4//1\r\n\
                              g left\r\nf -4/1 -3/1 -1/1\r\n";

#[test]
fn obj_groups_are_parts() {
    let soup = read("two.obj", TWO_GROUPS_OBJ).unwrap();
    assert_eq!(part_names(&soup), ["left", "right"], "reopened groups join, empty ones drop");
    assert_eq!(soup.triangles, [[0, 1, 2], [0, 2, 3], [0, 1, 3]], "in the order of the file");
    assert_eq!([0, 1].map(|part: usize| soup.parts[part].triangles().collect::<Vec<_>>()), [vec![0, 2], vec![1]]);
    let soup = read("o.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no A\ng x\nf 1 2 3\no B\ng x\nf 3 2 1\n").unwrap();
    assert_eq!(part_names(&soup), ["x", "x"], "groups of different objects are different parts");
    let soup = read("plain.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").unwrap();
    assert_eq!(part_names(&soup), ["plain"]);
}

#[test]
fn polygons_are_known_by_their_triangles() {
    // A triangle, a square and a pentagon.
    let vertices = [[0, 0], [1, 0], [1, 1], [0, 1], [2, 0], [3, 0], [3, 1], [2, 1], [4, 0], [5, 0], [5, 1]];
    let own = |start: &str| vertices.iter().map(|[x, y]| format!("{start}{x} {y} 0\n")).collect::<String>();
    let off = format!("OFF\n11 3 0\n{}3 0 1 2\n4 4 5 6 7\n5 8 9 10 7 4\n", own(""));
    let obj = format!("{}g a\nf 1 2 3\ng b\nf 5 6 7 8\nf 9 10 11 8 5\n", own("v "));
    let ply = format!(
        "ply\nformat ascii 1.0\nelement vertex 11\nproperty float x\nproperty float y\nproperty float z\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n{}3 0 1 2\n4 4 5 6 7\n5 8 9 10 7 4\n",
        own("")
    );
    let vtk = format!(
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 11 float\n{}POLYGONS 3 15\n3 0 1 2\n4 4 5 6 7\n5 8 9 10 7 4\n",
        own("")
    );
    for (name, text) in [("a.off", &off), ("a.obj", &obj), ("a.ply", &ply), ("a.vtk", &vtk)] {
        let soup = read(name, text).unwrap();
        assert_eq!(soup.triangles.len(), 6, "{name}");
        assert_eq!(soup.polygons, [1..3, 3..6], "{name}");
        assert_eq!(Surface::build(&soup).unwrap().report().polygons, 3, "{name}");
    }
    let soup = read("a.obj", &obj).unwrap();
    assert_eq!(soup.select(&[1]).unwrap().polygons, [0..2, 2..5]);
    assert!(soup.select(&[0]).unwrap().polygons.is_empty());
    // What is chosen alone counts.
    assert_eq!(Surface::build(&soup.chosen(&[1]).unwrap()).unwrap().report().polygons, 2);
}

#[test]
fn polygons_are_triangulated_without_turning_a_triangle() {
    // An arrowhead whose fan from the first corner would fold over, an L, and a comb with collinear corners.
    for (outline, area) in [
        (vec![(0.0, 0.0), (2.0, -2.0), (1.0, 0.0), (2.0, 2.0)], 2.0),
        (vec![(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)], 5.0),
        (
            vec![
                (0.0, 0.0),
                (1.0, 0.0),
                (2.0, 0.0),
                (5.0, 0.0),
                (5.0, 3.0),
                (4.0, 3.0),
                (4.0, 1.0),
                (3.0, 1.0),
                (3.0, 3.0),
                (2.0, 3.0),
                (2.0, 1.0),
                (1.0, 1.0),
                (1.0, 3.0),
                (0.0, 3.0),
            ],
            11.0,
        ),
        (vec![(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (1.0, 1.0)], 1.0),
    ] {
        let count = outline.len();
        for start in 0..count {
            let mut text: String = outline.iter().map(|(x, y)| format!("v {x} {y} 7\n")).collect();
            text += "f";
            (0..count).for_each(|i| text += &format!(" {}", (start + i) % count + 1));
            let soup = read("polygon.obj", &text).unwrap();
            assert_eq!(soup.triangles.len(), count - 2);
            let areas = areas(&soup);
            assert!(areas.iter().all(|&area| area > 0.0), "{areas:?} from {start} of {outline:?}");
            assert!((areas.iter().sum::<f64>() - area).abs() < 1e-12);
        }
    }
}

#[test]
fn obj_errors_name_the_place() {
    for (bad, place) in [
        ("v 0 0\n", "line 1"),
        ("v 0 0 0\nf 1 2 0\n", "line 2"),
        ("v 0 0 0\nf 1 one 1\n", "line 2"),
        ("v 0 0 0\nf -1 -1 -2\n", "line 2"),
    ] {
        fails("a.obj", bad, place);
    }
    for index in [9, 4_000_000_000_u64, 99_999_999_999] {
        let file = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 {index}\n");
        let error = read("a.obj", file).unwrap_err().to_string();
        assert_eq!(error, format!("OBJ, line 5: vertex {index} does not exist; there are 3, counted from 1"));
    }
}

// ---- PLY

const SQUARE_PLY: &str = "ply\nformat ascii 1.0\ncomment x\nelement tag 1\nproperty list uchar float numbers\n\
    element vertex 4\nproperty uchar red\nproperty float z\nproperty double y\nproperty short x\n\
    element face 1\nproperty list uchar int vertex_indices\nproperty float quality\nend_header\n\
    2 0.5 0.25\n255 0 0 0\n255 0 0 1\n255 0 1 1\n255 0 1 0\n4 0 1 2 3 0.5\n";

fn binary_ply(little: bool) -> Vec<u8> {
    let encoding = if little { "binary_little_endian" } else { "binary_big_endian" };
    let (header, _) = SQUARE_PLY.split_once("end_header\n").unwrap();
    let mut bytes = (header.replace("ascii", encoding) + "end_header\n").into_bytes();
    let mut put = |value: &[u8]| bytes.extend(value.iter().rev());
    let mut value = |big: &[u8]| if little { put(big) } else { put(&big.iter().rev().copied().collect::<Vec<_>>()) };
    value(&[2]);
    value(&0.5_f32.to_be_bytes());
    value(&0.25_f32.to_be_bytes());
    for (x, y) in [(0_i16, 0.0_f64), (1, 0.0), (1, 1.0), (0, 1.0)] {
        value(&[255]);
        value(&0_f32.to_be_bytes());
        value(&y.to_be_bytes());
        value(&x.to_be_bytes());
    }
    value(&[4]);
    (0..4_i32).for_each(|index| value(&index.to_be_bytes()));
    value(&0.5_f32.to_be_bytes());
    bytes
}

#[test]
fn ply_in_three_encodings() {
    let square = read("square.off", SQUARE_OFF).unwrap();
    assert_eq!(read("square.ply", SQUARE_PLY).unwrap(), square);
    assert_eq!(read("square.ply", binary_ply(true)).unwrap(), square);
    assert_eq!(read("square.ply", binary_ply(false)).unwrap(), square);
    assert_eq!(read("square.ply", SQUARE_PLY.replace('\n', "\r\n")).unwrap(), square);
    let strips =
        SQUARE_PLY.replace("element face 1", "element tristrips 1").replace("4 0 1 2 3 0.5", "8 0 1 3 2 -1 0 1 2 0.5");
    assert_eq!(read("strips.ply", strips).unwrap().triangles, [[0, 1, 3], [3, 1, 2], [0, 1, 2]]);
}

#[test]
fn a_comment_of_a_ply_says_the_unit() {
    let said =
        |comment: &str| read("square.ply", SQUARE_PLY.replacen('\n', &format!("\n{comment}\n"), 1)).unwrap().unit;
    assert_eq!(said("comment lengths in in"), Some(Unit::Inch));
    assert_eq!(said("comment lengths in parsecs"), None);
    assert_eq!(said("comment made by hand"), None);
}

#[test]
fn further_properties_of_ply_vertices_are_attributes() {
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float mud\nproperty float y\nproperty float z\n\
               property uchar flag\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
               0 2.5 0 0 7\n1 0.5 0 0 8\n0 1 1 0 9\n3 0 1 2\n";
    let soup = read("mud.ply", ply).unwrap();
    assert_eq!(soup.positions[1], DVec3::X);
    assert_eq!(soup.attribute("mud").unwrap(), [2.5, 0.5, 1.0]);
    assert_eq!(soup.attribute("flag").unwrap(), [7.0, 8.0, 9.0]);
}

#[test]
fn ply_colors_are_light() {
    let colored = |kind: &str, color: &str| {
        let file = format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty {kind} red\nproperty {kind} green\n\
             property {kind} blue\nproperty {kind} alpha\nproperty float y\nproperty float z\n\
             element face 1\nproperty list uchar int vertex_indices\nend_header\n\
             0 {color} 0 0\n1 0 0 0 0 0 0\n0 0 0 0 0 1 0\n3 0 1 2\n"
        );
        read_model("triangle.ply", file).unwrap()
    };
    // Half as bright to the eye is 0.2140 of the light (IEC 61966-2-1); alpha is a share as it is.
    let first = |kind, color| colored(kind, color).appearance.colors[0];
    assert_eq!(first("uchar", "255 0 10 51"), [65535, 0, 199, 13107]);
    assert_eq!(first("float", "0.5 1 2 0.5"), [14027, 65535, 65535, 32768]);
    assert_eq!(first("ushort", "65535 0 32768 65535"), [65535, 0, 14028, 65535]);
    assert_eq!(colored("uchar", "255 0 10 51").soup.positions[2], DVec3::Y);
    assert!(read_model("square.ply", SQUARE_PLY).unwrap().appearance.is_empty(), "red alone is no color");
}

#[test]
fn ply_errors_name_the_place() {
    for (from, to, place) in [
        ("4 0 1 2 3 0.5", "4 0 1 -2 3 0.5", "face 0"),
        ("4 0 1 2 3 0.5", "4 0 1", "face 0"),
        ("property short x\n", "property short u\n", "element vertex"),
        ("uchar int", "uchar quad", "line 12"),
        ("element vertex 4", "element vertex 4000000000000", "vertex 5"),
        ("end_header\n", "", "header"),
        ("element tag 1\n", "element nothing 99999999999999\nelement tag 1\n", "face 0"),
    ] {
        let bad = SQUARE_PLY.replace(from, to);
        match read("a.ply", &bad) {
            Err(error) => assert!(error.to_string().contains(place), "{error}"),
            // An element without properties takes no bytes, however many there are.
            Ok(_) => assert!(from.starts_with("element tag"), "{bad}"),
        }
    }
    let error = read("a.ply", SQUARE_PLY.replace("4 0 1 2 3 0.5", "4 0 1 2 7 0.5")).unwrap_err().to_string();
    assert_eq!(error, "PLY, face 0: vertex 7 does not exist; there are 4, counted from 0");
}

// ---- STL

const TWO_SOLIDS_STL: &str = "solid one\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n\
    endfacet\nendsolid one\nsolid\n  FACET normal 0 0 1\n outer loop\n vertex 0 0 1e0\n vertex 1 0 1\n VERTEX 0 1 1\n\
    endloop\nendfacet\nendsolid\n";

fn binary_stl(header: &[u8], triangles: u32) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(triangles.to_le_bytes());
    for triangle in 0..triangles {
        for value in [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, triangle as f32] {
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend([0, 0]);
    }
    bytes
}

#[test]
fn stl_ascii_and_binary() {
    let soup = read("two.stl", TWO_SOLIDS_STL).unwrap();
    assert_eq!(part_names(&soup), ["one", "two"], "a solid without a name takes the file's");
    assert_eq!((soup.positions.len(), soup.triangles.len()), (6, 2));
    for header in [&b"made by hand"[..], b"solid facet that lies about being text"] {
        let soup = read("b.stl", binary_stl(header, 3)).unwrap();
        assert_eq!(soup.triangles, [[0, 1, 2], [3, 4, 5], [6, 7, 8]]);
        assert_eq!(soup.positions[8], DVec3::new(0.0, 1.0, 2.0));
    }
    assert!(read("unnamed", binary_stl(b"", 2)).is_ok(), "told by its length");
    let mut long = binary_stl(b"", 2);
    long.push(0);
    assert_eq!(read("a.stl", &long).unwrap().triangles.len(), 2, "bytes after the last triangle are ignored");
    assert!(read("a.stl", &long[..130]).unwrap_err().to_string().contains("2 triangles are missing"));
    assert!(
        read("a.stl", TWO_SOLIDS_STL.replace("vertex 1 0 0", "vertex 1 0")).unwrap_err().to_string().contains("line 5")
    );
    assert!(read("a.stl", TWO_SOLIDS_STL.replace("vertex 1 0 0\n", "")).unwrap_err().to_string().contains("line 7"));
}

// ---- writers

#[test]
fn written_meshes_read_back() {
    let soup = shapes::torus(1.0, 0.4, 8, 6);
    let mut distance: Vec<f64> = soup.positions.iter().map(|position| position.x + 2.0).collect();
    distance[3] = f64::INFINITY;
    let ply = read("torus.ply", write::distance_ply(&soup, &distance)).unwrap();
    assert_eq!(ply.attribute("distance").unwrap(), distance);
    assert_eq!(Soup { attributes: Vec::new(), ..ply }, soup);
    let glb = write::distance_glb(&soup.clone().into(), &distance);
    let back = read("torus.glb", &glb).unwrap();
    assert_eq!(back.triangles, soup.triangles);
    assert_eq!(back.positions[5], soup.positions[5].as_vec3().as_dvec3());
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let root: Value = serde_json::from_slice(&glb[20..20 + length]).unwrap();
    let attributes = &root["meshes"][0]["primitives"][0]["attributes"];
    assert_eq!((&attributes["_DISTANCE"], &attributes["_REACHABLE"]), (&json!(1), &json!(2)));
    assert_eq!(root["accessors"][1]["min"], json!([0.0]));
    let start = 28 + length + root["bufferViews"][2]["byteOffset"].as_u64().unwrap() as usize;
    let reachable = glb[start..start + 4 * distance.len()].chunks_exact(4);
    let reachable: Vec<f32> = reachable.map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap())).collect();
    assert!(reachable.iter().enumerate().all(|(vertex, &flag)| flag == if vertex == 3 { 0.0 } else { 1.0 }));
    let greatest = distance.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max) as f32;
    assert_eq!(root["accessors"][1]["max"], json!([greatest]));
    assert_eq!(glb.len() % 4, 0);
    let path = write::polylines_obj(&[vec![DVec3::ZERO, DVec3::new(0.1, 1.0, -2.0)]]);
    assert!(String::from_utf8(path).unwrap().ends_with("v 0 0 0\nv 0.1 1 -2\nl 1 2\n"));
}

#[test]
fn gltf_and_3mf_say_what_is_up() {
    for (name, bytes, expected) in [
        ("a.gltf", b"{}".as_slice(), Some(DVec3::Y)),
        ("a.bin", b"glTF\x02\0\0\0", Some(DVec3::Y)),
        ("a.txt", b"\xEF\xBB\xBF{\"asset\":{}}", Some(DVec3::Y)),
        ("a.3MF", b"", Some(DVec3::Z)),
        ("a", b"PK\x03\x04", Some(DVec3::Z)),
        ("a.obj", b"v 0 0 0", None),
        ("a.stl", b"solid a", None),
        ("gltf", b"", None),
    ] {
        assert_eq!(upward(name, bytes), expected, "{name}");
    }
}

// ---- damage

#[test]
fn damaged_files_do_not_panic() {
    let files: [(&str, Vec<u8>); 7] = [
        ("a.off", SQUARE_OFF.into()),
        ("a.obj", TWO_GROUPS_OBJ.into()),
        ("a.ply", SQUARE_PLY.into()),
        ("b.ply", binary_ply(true)),
        ("c.ply", binary_ply(false)),
        ("a.stl", TWO_SOLIDS_STL.into()),
        ("b.stl", binary_stl(b"solid", 2)),
    ];
    for (name, bytes) in files {
        reading::cut_short_at_every_byte(name, &bytes);
        reading::flip_bytes(name, &bytes);
    }
}
