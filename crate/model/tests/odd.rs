//! Files that are odd and valid, and files that are no mesh: what is read, what is told, what is refused in which words.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::reading;

use glam::DVec3;
use heatwalk_surface::{Soup, Surface, VertexData, WarningCode};

use crate::reading::{areas, part_names, read};

const OFF: &str = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
const OBJ: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
    element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
const STL: &str = "solid square\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n\
    facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid square\n";
const VTK: &str = "# vtk DataFile Version 3.0\nsquare\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n\
    POLYGONS 2 8\n3 0 1 2\n3 0 2 3\n";
const VTP: &str = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\">\n<PolyData>\n<Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\">\n\
    <Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0 1 0 0 1 1 0 0 1 0\n</DataArray>\n</Points>\n\
    <Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n0 1 2 0 2 3\n</DataArray>\n\
    <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n3 6\n</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";

const FILES: [(&str, &str); 6] =
    [("a.off", OFF), ("a.obj", OBJ), ("a.ply", PLY), ("a.stl", STL), ("a.vtk", VTK), ("a.vtp", VTP)];

/// That it is the unit square in two triangles, with nothing to tell.
fn assert_square(soup: &Soup, what: &str) {
    assert_eq!(soup.warnings, [], "{what}");
    assert_halves(soup, what);
}

fn assert_halves(soup: &Soup, what: &str) {
    assert_eq!(areas(soup), [0.5, 0.5], "{what}");
    let corner = soup.triangles[0].map(|vertex| soup.positions[vertex as usize])[2];
    assert_eq!(corner, DVec3::new(1.0, 1.0, 0.0), "{what}");
}

fn refused(name: &str, bytes: impl AsRef<[u8]>) -> String {
    read(name, bytes).expect_err(name).to_string()
}

#[test]
fn lines_of_text_end_by_cr_lf_both_or_any_of_them() {
    for (name, text) in FILES {
        let mut ends = ["\r\n", "\n", "\r"].into_iter().cycle();
        let mixed: String = text.split_inclusive('\n').map(|line| line.replace('\n', ends.next().unwrap())).collect();
        for variant in
            [text.to_owned(), text.replace('\n', "\r"), text.replace('\n', "\r\n"), mixed, format!("\u{feff}{text}")]
        {
            assert_square(&read(name, &variant).unwrap_or_else(|error| panic!("{error}: {variant:?}")), &variant);
        }
    }
    let sharp = "# made\rOFF\r# by hand\r4 2 0\r0 0 0\r1 0 0\r1 1 0\r0 1 0\r3 0 1 2 # one\r3 0 2 3";
    assert_square(&read("a.off", sharp).unwrap(), "comments");
    assert!(refused("a.obj", OBJ.replace("1 1 0", "1 one 0").replace('\n', "\r")).contains("line 3"));
    // After lone CRs, an LF behind the header is the first number.
    let bytes = b"ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty uchar x\rproperty uchar y\rproperty uchar z\r\
                  element face 1\rproperty list uchar uchar vertex_indices\rend_header\r\n\0\0\x0B\0\0\n\x01\0\x03\0\x01\x02";
    assert_eq!(read("a.ply", bytes).unwrap().positions, [DVec3::X * 10.0, DVec3::X * 11.0, DVec3::new(10.0, 1.0, 0.0)]);
}

#[test]
fn text_in_utf_16_is_told_as_such_in_every_format() {
    for (name, text) in FILES {
        for mark in ["", "\u{feff}"] {
            let units = || mark.encode_utf16().chain(text.encode_utf16());
            let little: Vec<u8> = units().flat_map(u16::to_le_bytes).collect();
            let big: Vec<u8> = units().flat_map(u16::to_be_bytes).collect();
            for bytes in [little, big] {
                assert!(refused(name, bytes).contains("this is UTF-16 text; save it as UTF-8"), "{name}");
            }
        }
    }
}

#[test]
fn decimal_commas_are_told_as_such_in_every_format() {
    for (name, text) in FILES {
        let error = refused(name, text.replacen("1 0 0", "1,5 0 0", 1));
        assert!(error.contains("\"1,5\" has a decimal comma"), "{error}");
    }
}

#[test]
fn what_is_no_number_harms_only_where_it_is_needed() {
    for spelling in ["nan", "-nan(ind)", "-1.#IND", "1.#QNAN", "1.#INF", "-inf", "NaN"] {
        let stl = STL.replace("normal 0 0 1", &format!("normal {spelling} {spelling} {spelling}"));
        assert_square(&read("a.stl", stl).unwrap(), spelling);
        let ply =
            PLY.replace("element face", "property float nx\nelement face").replace(" 0\n", &format!(" 0 {spelling}\n"));
        assert_square(&read("a.ply", ply.replace("element vertex 4 0", "element vertex 4")).unwrap(), spelling);
        for (name, text) in FILES {
            let used = read(name, text.replacen("1 1 0", &format!("1 1 {spelling}"), 1)).unwrap();
            let error = Surface::build(&used).unwrap_err().to_string();
            assert!(error.contains("not a finite number"), "{name}, {spelling}: {error}");
        }
    }
}

#[test]
fn off_has_its_letters_in_any_order_and_its_numbers_on_any_lines() {
    let with = |keyword: &str, further: &str| {
        let mut text = OFF.replacen("OFF", keyword, 1);
        for vertex in ["0 0 0", "1 0 0", "1 1 0", "0 1 0"] {
            text = text.replacen(&format!("\n{vertex}\n"), &format!("\n{vertex} {further}\n"), 1);
        }
        text
    };
    let (color, normal, texture) = ("255 0 0 255", "0 0 1", "0.5 0.5");
    let variants = [
        with("NCOFF", &format!("{normal} {color}")),
        with("CNOFF", &format!("{color} {normal}")),
        with("COFF", "255 0 0"),
        with("STOFF", texture),
        with("NSTOFF", &format!("{normal} {texture}")),
        with("CSTOFF", &format!("{color} {texture}")),
        with("NCSTOFF", &format!("{normal} {color} {texture}")),
        with("STCN4OFF", "1 0 0 1 255 0 0 255 0 0"),
        with("off", ""),
        OFF.replacen("OFF\n", "nOFF\n3\n", 1),
        OFF.replacen("OFF\n", "NnOFF 3\n", 1),
        OFF.replacen("OFF\n4 2 0", "4 2 0", 1),
        OFF.replacen("4 2 0", "4 2", 1),
        OFF.replacen("4 2 0", "4\n2\n0", 1),
        OFF.replace('\n', " "),
        OFF.replace(' ', "\n"),
        with("NOFF", normal).replace(' ', "\n"),
        with("NCOFF", &format!("{normal} {color}")).replace(['\n', ' '], "\r\n"),
        "OFF\n4 2\n0\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1\n2 3 0 2 3".to_owned(),
        OFF.replace("3 0 1 2\n3 0 2 3", "3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 1"),
    ];
    for variant in variants {
        assert_square(&read("a.off", &variant).unwrap_or_else(|error| panic!("{error}: {variant}")), &variant);
    }
    assert!(refused("a.off", OFF.replacen("OFF\n", "nOFF\n4\n", 1)).contains("a space of 4 dimensions"));
    assert!(refused("a.off", OFF.replacen("OFF", "CCOFF", 1)).contains("\"CCOFF\" is not an OFF header"));
    let longer = read("a.off", format!("{OFF}3 0 1 3\n")).unwrap();
    assert_halves(&longer, "faces beyond the count");
    assert_eq!((longer.warnings[0].code, longer.warnings[0].place.as_str()), (WarningCode::Trailing, "line 9"));
}

#[test]
fn stl_is_read_in_any_form() {
    let long = STL.replace("square", &"long name ".repeat(300));
    let named = |name: &str| STL.replacen("square", name, 1);
    let variants = [
        STL.replace('\n', " "),
        STL.replace('\n', "\r"),
        STL.replace(' ', "\n"),
        STL.replace("normal 0 0 1", "").replace('\n', " "),
        STL.to_uppercase(),
        long,
        named("the facet of a square"),
        named("my facet normal part"),
    ];
    for variant in variants {
        assert_square(&read("a.stl", &variant).unwrap_or_else(|error| panic!("{error}: {variant}")), &variant);
    }
    let one_line = format!("{STL} {}", STL.replace("square", "other")).replace('\n', " ");
    assert_eq!(part_names(&read("a.stl", one_line).unwrap()), ["square", "other"]);
}

#[test]
fn stl_facets_without_an_end_are_read_and_told() {
    let told = |file: String| {
        let soup = read("a.stl", file).unwrap();
        assert_halves(&soup, "both facets");
        let warning = &soup.warnings[0];
        (soup.warnings.len(), warning.code, warning.place.clone())
    };
    let first = STL.replacen("endloop\nendfacet\n", "", 1);
    assert_eq!(told(first), (1, WarningCode::UnendedFacets, "line 2".to_owned()));
    assert_eq!(told(STL.replacen("endfacet\n", "", 1)), (1, WarningCode::UnendedFacets, "line 2".to_owned()));
    assert_eq!(
        told(STL.replace("endfacet\nendsolid", "endsolid")),
        (1, WarningCode::UnendedFacets, "line 9".to_owned())
    );
    assert_eq!(told(STL.replace("endsolid square\n", "")), (1, WarningCode::NoEnd, "line 15".to_owned()));
    assert_square(&read("a.stl", STL.replace("endloop\n", "")).unwrap(), "loops need no end");
    for length in STL.find("vertex 0 1 0").unwrap()..STL.rfind("endfacet").unwrap() {
        assert!(refused("a.stl", &STL[..length]).contains("line"), "at {length}");
    }
    assert!(
        refused("a.stl", STL.replacen("vertex 1 0 0\n", "", 1).replacen("endfacet\n", "", 1)).contains("2 corners")
    );
    let text = refused("a.stl", STL.replace("solid", "body"));
    assert!(text.contains("begins with \"solid\""), "{text}");
}

#[test]
fn ply_has_indices_of_eight_bytes_and_one_list_of_vertices() {
    for kind in ["int64", "uint64", "long", "ulong", "uint", "uint8"] {
        assert_square(&read("a.ply", PLY.replace("int v", &format!("{kind} v"))).unwrap(), kind);
    }
    let mut bytes = PLY[..PLY.find("0 0 0").unwrap()]
        .replace("ascii", "binary_big_endian")
        .replace("int v", "uint64 v")
        .into_bytes();
    for corner in [[0.0_f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        bytes.extend([corner[0], corner[1], 0.0].into_iter().flat_map(f32::to_be_bytes));
    }
    for face in [[0_u64, 1, 2], [0, 2, 3]] {
        bytes.push(3);
        bytes.extend(face.into_iter().flat_map(u64::to_be_bytes));
    }
    assert_square(&read("a.ply", &bytes).unwrap(), "bytes");
    let end = bytes.len();
    bytes.push(7);
    let trailing = |bytes: &[u8]| {
        let warning = read("a.ply", bytes).unwrap().warnings[0].clone();
        assert_eq!(warning.code, WarningCode::Trailing);
        warning.place
    };
    assert_eq!(trailing(&bytes), format!("byte {end}"));
    // What is no UTF-8 counts as any other text.
    let text = [PLY.trim_ascii_end().as_bytes(), b"\n\n\xff\xff\xff\xff"].concat();
    let line = PLY.trim_ascii_end().lines().count() + 2;
    assert_eq!(trailing(&text), format!("line {line}"));
    let twice = PLY.replace(
        "element face",
        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face",
    );
    assert!(refused("a.ply", twice).contains("line 7: there are vertices twice"));
    let edges = PLY.replace("end_header", "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header");
    let warned = read("a.ply", edges + "0 1 1 2\n").unwrap().warnings;
    assert_eq!((warned.len(), warned[0].code, warned[0].count), (1, WarningCode::LinesLeftOut, 2));
}

#[test]
fn a_backslash_joins_lines_but_none_that_begins_a_statement() {
    let joined = OBJ.replace("f 1 2 3", "f 1 \\\n2 \\\n3").replace("1 1 0", "1 \\\r\n1 0");
    assert_square(&read("a.obj", joined).unwrap(), "joined");
    let names = [
        "g left\\",
        "# C:\\models\\",
        "usemtl a\\",
        "o b\\",
        "mtllib c\\d\\",
        "usemtl\\",
        "g\\",
        "s \\",
        "vt 0 0 \\",
        "vn 0 0 1\\",
        "#\\",
    ];
    for line in names {
        let soup = read("a.obj", OBJ.replace("f 1 2 3", &format!("{line}\nf 1 2 3"))).unwrap();
        assert_halves(&soup, line);
        let warning = &soup.warnings[0];
        assert_eq!((warning.code, warning.place.clone()), (WarningCode::UnjoinedLines, "line 5".to_owned()), "{line}");
    }
    let kept = read("a.obj", OBJ.replace("f 1 2 3", "f 1 2\\\n3\\")).unwrap();
    assert_halves(&kept, "a statement behind a backslash");
    assert_eq!(kept.warnings[0].code, WarningCode::UnjoinedLines);
    // A megabyte of joined lines: each letter was copied with each of them once.
    let long = format!("{}f 1 2 3 {}4\n", &OBJ[..OBJ.find('f').unwrap()], "\\\n".repeat(500_000));
    assert_eq!(read("a.obj", long).unwrap().triangles.len(), 2);
}

#[test]
fn damaged_files_do_not_panic() {
    for (name, text) in FILES {
        reading::cut_short_at_every_byte(name, text.as_bytes());
        reading::flip_bytes(name, text.as_bytes());
    }
}

#[test]
fn what_is_left_out_of_an_obj_is_told() {
    let soup = read("a.obj", format!("{OBJ}l 1 2\np 1\ncurv 0 1 1 2\nF 1 2 3\ns off\nvp 0.5\nf 1 2\n")).unwrap();
    let told: Vec<_> =
        soup.warnings.iter().map(|warning| (warning.code, warning.count, warning.place.as_str())).collect();
    assert_eq!(
        told,
        [
            (WarningCode::LinesLeftOut, 3, "line 7"),
            (WarningCode::CurvesLeftOut, 1, "line 9"),
            (WarningCode::UnknownStatements, 1, "line 10"),
        ]
    );
}

#[test]
fn a_file_without_faces_says_what_it_holds_instead() {
    for (name, file, words) in [
        ("a.obj", "", "a.obj is empty: nothing is in it"),
        ("a.stl", " \n\t", "a.stl is empty: nothing is in it"),
        (
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nelement face 0\nend_header\n",
            "a header and nothing else",
        ),
        (
            "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n",
            "a single point without faces",
        ),
        ("a.off", "OFF 3 0 0 0 0 0 1 0 0 0 1 0", "a cloud of 3 points"),
        ("a.off", "OFF", "the number of vertices is missing"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "1 point or line was left out"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nsurf 0 1 0 1 1\n", "free form"),
        ("a.obj", "hello\n", "1 statement is not known"),
        ("a.stl", "solid a\nendsolid a\n", "a header and nothing else"),
        ("a.obj", "<!DOCTYPE html><html>", "this is a web page"),
        (
            "a.vtk",
            "# vtk DataFile Version 3.0\na\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 0 0\nLINES 1 3\n2 0 1\n",
            "1 point or line",
        ),
    ] {
        let error = refused(name, file);
        assert!(error.contains(words), "{name}: {error}");
    }
}

// ---- polygons

/// A polygon in the plane z = 0 as the only face of a file.
fn polygon(outline: &[[f64; 2]]) -> Soup {
    let mut text: String = outline.iter().map(|[x, y]| format!("v {x} {y} 0\n")).collect();
    text += "f";
    (1..=outline.len()).for_each(|corner| text += &format!(" {corner}"));
    read("polygon.obj", text).unwrap()
}

fn area(outline: &[[f64; 2]]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|([a, b], [c, d])| 0.5 * (a * d - b * c)).sum()
}

#[test]
fn polygons_of_any_size_are_cut_inside_of_their_outline() {
    // A spiral, a comb and a star of many corners.
    let turn = |k: usize, radius: f64, turns: f64, of: usize| {
        let angle = turns * std::f64::consts::TAU * k as f64 / of as f64;
        [radius * angle.cos(), radius * angle.sin()]
    };
    let count = 6000;
    let outer = (0..count).map(|k| turn(k, 1.0 + 5.0 * k as f64 / count as f64, 5.0, count));
    let inner = (0..count).rev().map(|k| turn(k, 0.5 + 5.0 * k as f64 / count as f64, 5.0, count));
    let comb = (0..count).flat_map(|k| {
        let x = k as f64;
        [[x, 0.0], [x + 0.25, 9.0], [x + 0.5, 0.0]].map(|[x, y]| [x, -y])
    });
    let comb = comb.rev().chain([[0.0, -11.0], [count as f64, -11.0]]);
    let star = (0..count).map(|k| turn(k, if k % 2 == 0 { 1.0 } else { 0.1 }, 1.0, count));
    for outline in [outer.chain(inner).collect::<Vec<_>>(), comb.collect(), star.collect()] {
        let soup = polygon(&outline);
        let (areas, expected) = (areas(&soup), area(&outline));
        assert_eq!((soup.triangles.len(), soup.warnings.len()), (outline.len() - 2, 0));
        assert!(areas.iter().all(|area| area * expected.signum() > 0.0));
        // Each of the areas is rounded at its last digit.
        assert!((areas.iter().sum::<f64>() - expected).abs() < 1e-9 * expected.abs());
    }
}

#[test]
fn a_bridge_to_a_hole_is_no_edge_of_a_polygon() {
    let outline = [[0., 0.], [3., 0.], [3., 3.], [0., 3.], [0., 0.], [1., 1.], [1., 2.], [2., 2.], [2., 1.], [1., 1.]];
    let soup = polygon(&outline);
    assert_eq!((areas(&soup).iter().sum::<f64>(), soup.warnings.len()), (8.0, 0));
    assert!(areas(&soup).iter().all(|&area| area > 0.0));
}

#[test]
fn a_polygon_that_crosses_itself_is_told() {
    let star: Vec<[f64; 2]> = (0..5)
        .map(|k| {
            let angle = 2.0 * std::f64::consts::TAU * f64::from(k) / 5.0;
            [angle.cos(), angle.sin()]
        })
        .collect();
    for outline in [star, vec![[0., 0.], [2., 2.], [2., 0.], [0., 1.]]] {
        let soup = polygon(&outline);
        assert_eq!(soup.warnings[0].code, WarningCode::CrossedPolygons);
        assert_eq!(soup.triangles.len(), outline.len() - 2, "a guess");
    }
    assert!(polygon(&[[0., 0.], [1., 0.], [2., 0.], [3., 0.]]).warnings.is_empty(), "one without area crosses nothing");
}

// ---- numbers

#[test]
fn vertices_and_triangles_count_as_in_the_file_in_all_of_it_and_in_some_parts() {
    let vertices: String = (0..8).map(|k| format!("v {} {} 0\n", k % 4, k / 4)).collect();
    let faces = "g A\nf 1 2 6 5\ng B\nf 2 3 7\nusemtl x\ng A\nf 3 4 8\ng B\nf 2 7 6\n";
    let soup = read("a.obj", vertices + faces).unwrap();
    let expected = [[0, 1, 5], [0, 5, 4], [1, 2, 6], [2, 3, 7], [1, 6, 5]];
    assert_eq!(soup.triangles, expected);
    assert!(soup.ranges().into_iter().flatten().eq(0..5));
    let chosen = soup.chosen(&[1]).unwrap();
    assert_eq!((&chosen.triangles[..], &chosen.ranges()[..]), (&expected[..], &[2..3, 4..5][..]));
    let surface = Surface::build(&chosen).unwrap();
    let numbers: Vec<_> = (0..2).map(|face| surface.triangle_of_face(heatwalk_surface::FaceId(face)).0).collect();
    assert_eq!(numbers, [2, 4]);
    let x: VertexData<f64> = surface.positions().iter().map(|position| position.x).collect();
    let values = surface.to_inputs(&x, f64::INFINITY);
    assert_eq!(values, [f64::INFINITY, 1.0, 2.0, f64::INFINITY, f64::INFINITY, 1.0, 2.0, f64::INFINITY]);
    let alone = chosen.take(chosen.active());
    assert_eq!((alone.positions.len(), &alone.triangles[..]), (8, &[expected[2], expected[4]][..]));
    let compact = soup.select(&[1]).unwrap();
    assert_eq!((compact.triangles, compact.positions[0].x), (vec![[0, 1, 3], [0, 3, 2]], 1.0));
    assert!(compact.parts[0].triangles().eq(0..2));
    assert!(soup.chosen(&[2]).is_err());
}
