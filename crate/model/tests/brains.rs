//! Surfaces of brains: GIFTI in all its encodings, FreeSurfer's triangles and quadrilaterals.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use glam::DVec3;
use heatwalk_model::io::labels::Labels;
use heatwalk_model::io::write::overlay::Overlay;
use heatwalk_model::{Error, io};
use heatwalk_surface::{Soup, Unit};
use miniz_oxide::deflate::compress_to_vec_zlib;

use crate::reading::{cut_short_at_every_byte, damaged_copies, flip_bytes, part_names, read};

const POINTS: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.5, 0.0, 1.0, 0.0];
const TRIANGLES: [i32; 6] = [0, 1, 2, 0, 2, 3];
/// What no reader of coordinates may take for them.
const TRANSFORM: &str = "<CoordinateSystemTransformMatrix><DataSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></DataSpace>\
    <TransformedSpace><![CDATA[NIFTI_XFORM_TALAIRACH]]></TransformedSpace>\
    <MatrixData>9 0 0 7 0 9 0 7 0 0 9 7 0 0 0 1</MatrixData></CoordinateSystemTransformMatrix>";

fn array(intent: &str, kind: &str, columns: usize, attributes: &str, inner: &str, data: &str) -> String {
    format!(
        "<DataArray Intent=\"NIFTI_INTENT_{intent}\" DataType=\"NIFTI_TYPE_{kind}\" Dimensionality=\"2\" Dim0=\"{}\" Dim1=\"{columns}\" \
         {attributes}>{inner}<Data>{data}</Data></DataArray>\n",
        if intent == "POINTSET" { 4 } else { 2 }
    )
}

fn document(arrays: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n\
         <GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">\n<MetaData><MD><Name><![CDATA[Date]]></Name><Value><![CDATA[a < b]]></Value></MD></MetaData>\n\
         <LabelTable/>\n{arrays}</GIFTI>\n"
    )
}

/// A file of the square; `encode` makes text of the bytes of numbers.
fn square(encoding: &str, is_little: bool, encode: impl Fn(&[u8]) -> String) -> String {
    let attributes = format!(
        "ArrayIndexingOrder=\"RowMajorOrder\" Encoding=\"{encoding}\" Endian=\"{}Endian\"",
        if is_little { "Little" } else { "Big" }
    );
    let points = POINTS.iter().flat_map(|number| if is_little { number.to_le_bytes() } else { number.to_be_bytes() });
    let corners = TRIANGLES.iter().flat_map(|index| if is_little { index.to_le_bytes() } else { index.to_be_bytes() });
    let points = encode(&points.collect::<Vec<u8>>());
    let corners = encode(&corners.collect::<Vec<u8>>());
    document(
        &[
            array("POINTSET", "FLOAT32", 3, &attributes, TRANSFORM, &points),
            array("TRIANGLE", "INT32", 3, &attributes, "", &corners),
        ]
        .concat(),
    )
}

fn ascii(points: &str, triangles: &str) -> String {
    let attributes = "ArrayIndexingOrder=\"RowMajorOrder\" Encoding=\"ASCII\" Endian=\"LittleEndian\"";
    document(
        &[
            array("POINTSET", "FLOAT32", 3, attributes, TRANSFORM, points),
            array("TRIANGLE", "INT32", 3, attributes, "", triangles),
        ]
        .concat(),
    )
}

const POINTS_TEXT: &str = "0 0 0\n1 0 0\n1 1 0.5\n0 1 0";

fn packed(bytes: &[u8]) -> String {
    BASE64_STANDARD.encode(compress_to_vec_zlib(bytes, 6))
}

fn assert_square(soup: &Soup) {
    assert_eq!(soup.positions, [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.5), DVec3::Y]);
    assert_eq!(soup.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(soup.unit, Some(Unit::Millimeter));
}

#[test]
fn gifti_in_all_encodings_is_the_same_square() {
    let text = ascii(POINTS_TEXT, "0 1 2 0 2 3");
    let soup = read("lh.surf.gii", &text).unwrap();
    assert_square(&soup);
    assert_eq!(part_names(&soup), ["lh.surf"]);
    assert_square(&read("without-extension", &text).unwrap());
    for is_little in [true, false] {
        assert_square(
            &read("a.gii", square("Base64Binary", is_little, |bytes| BASE64_STANDARD.encode(bytes))).unwrap(),
        );
        assert_square(&read("a.gii", square("GZipBase64Binary", is_little, packed)).unwrap());
        // Broken into lines.
        let lines = |bytes: &[u8]| {
            let text = packed(bytes).into_bytes();
            text.chunks(7).map(|line| format!("\n  {}", String::from_utf8_lossy(line))).collect::<String>()
        };
        assert_square(&read("a.gii", square("GZipBase64Binary", is_little, lines)).unwrap());
    }
    let by_columns = ascii("0 1 1 0  0 0 1 1  0 0 0.5 0", "0 0  1 2  2 3").replace("RowMajor", "ColumnMajor");
    assert_square(&read("a.gii", by_columns).unwrap());
}

#[test]
fn gifti_may_have_its_numbers_in_another_file() {
    let points: Vec<u8> = [0; 5].into_iter().chain(POINTS.iter().flat_map(|number| number.to_le_bytes())).collect();
    let external =
        "Encoding=\"ExternalFileBinary\" Endian=\"LittleEndian\" ExternalFileName=\"a.dat\" ExternalFileOffset=\"5\"";
    let text = document(
        &[
            array("POINTSET", "FLOAT32", 3, external, "", ""),
            array("TRIANGLE", "INT32", 3, "Encoding=\"ASCII\"", "", "0 1 2 0 2 3"),
        ]
        .concat(),
    );
    let soup = io::read("a.gii", text.as_bytes(), &|uri| (uri == "a.dat").then(|| points.clone())).unwrap().soup;
    assert_square(&soup);
    assert_eq!(read("a.gii", &text), Err(Error::MissingResource { uri: "a.dat".to_owned() }));
    let short = io::read("a.gii", text.as_bytes(), &|_| Some(points[..50].to_vec()));
    assert!(short.unwrap_err().to_string().contains("the array POINTSET is damaged or cut short"));
}

#[test]
fn what_is_wrong_with_gifti_is_said() {
    let good = ascii(POINTS_TEXT, "0 1 2 0 2 3");
    for (text, said) in [
        (ascii(POINTS_TEXT, "0 1 2 0 2 4"), "face 1: vertex 4 does not exist; there are 4, counted from 0"),
        (ascii(POINTS_TEXT, "0 1 2 0 2 -1"), "face 1: vertex -1 is no index"),
        (ascii(POINTS_TEXT, "0 1 2 0 2"), "the array TRIANGLE is damaged or cut short"),
        (ascii("0 0 0 1 0 0 1 1 0,5 0 1 0", "0 1 2 0 2 3"), "decimal comma"),
        (square("GZipBase64Binary", true, |_| "AAAA".to_owned()), "the array POINTSET is damaged"),
        (square("Base64Binary", true, |_| "????".to_owned()), "the array POINTSET is damaged"),
        (good.replace("Dim0=\"2\"", "Dim0=\"99999999999999999\""), "the array TRIANGLE is damaged"),
        (good.replace("NIFTI_TYPE_INT32", "NIFTI_TYPE_RGB24"), "the array TRIANGLE has no size or no type of numbers"),
        (good.replace("POINTSET", "SHAPE"), "there is no surface in it"),
        (good.replace("TRIANGLE", "POINTSET"), "several surfaces in one file"),
        (good.replace("Dim0=\"4\" Dim1=\"3\"", "Dim0=\"6\" Dim1=\"2\""), "rows of 2 numbers in place of 3"),
        (good.replace("</Data>", ""), "not well-formed"),
    ] {
        let error = read("a.gii", &text).expect_err(said).to_string();
        assert!(error.contains(said), "{error}\n{said}");
    }
}

/// A file of triangles with what FreeSurfer writes behind them.
fn freesurfer() -> Vec<u8> {
    let mut bytes = b"\xFF\xFF\xFEcreated by hand on Monday\n\n".to_vec();
    bytes.extend([4_i32, 2].iter().flat_map(|count| count.to_be_bytes()));
    bytes.extend(POINTS.iter().flat_map(|number| number.to_be_bytes()));
    bytes.extend(TRIANGLES.iter().flat_map(|index| index.to_be_bytes()));
    bytes.extend([0_i32, 0, 20].iter().flat_map(|number| number.to_be_bytes()));
    bytes.extend(b"valid = 1\ncras = 1.0 2.0 3.0\n");
    bytes
}

/// The square as one quadrilateral, which begins at this corner.
fn quads(width: usize, first: u8) -> Vec<u8> {
    let mut bytes = if width == 2 { b"\xFF\xFF\xFF".to_vec() } else { b"\xFF\xFF\xFD".to_vec() };
    bytes.extend([0, 0, 4, 0, 0, 1]);
    for number in POINTS {
        if width == 2 {
            bytes.extend(((number * 100.0) as i16).to_be_bytes());
        } else {
            bytes.extend(number.to_be_bytes());
        }
    }
    bytes.extend((0..4).flat_map(|corner| [0, 0, (first + corner) % 4]));
    bytes
}

#[test]
fn surfaces_of_freesurfer() {
    for name in ["lh.pial", "lh.white", "rh.inflated", "lh.sphere", "lh.orig", "lh.smoothwm", "lh.sphere.reg"] {
        assert_square(&read(name, freesurfer()).unwrap());
    }
    let soup = read("lh.pial", freesurfer()).unwrap();
    assert_eq!(part_names(&soup), ["lh"]);
    for width in [2, 4] {
        let even = read("lh.orig", quads(width, 0)).unwrap();
        assert_eq!(even.positions, soup.positions);
        assert_eq!(even.triangles, [[0, 1, 3], [2, 3, 1]]);
        assert_eq!(read("lh.orig", quads(width, 1)).unwrap().triangles, [[1, 2, 3], [1, 3, 0]]);
    }
}

#[test]
fn what_is_wrong_with_freesurfer_is_said() {
    let good = freesurfer();
    let index = good.len() - 12 - b"valid = 1\ncras = 1.0 2.0 3.0\n".len() - 1;
    let mut missing = good.clone();
    missing[index] = 4;
    let mut many = good.clone();
    many[29] = 0x7F;
    for (bytes, said) in [
        (missing, "FreeSurfer, face 1: vertex 4 does not exist; there are 4, counted from 0"),
        (many, "the file is cut short"),
        (good[..60].to_vec(), "byte 60: the file is cut short"),
        (b"#!ascii version of lh.pial\n4 2\n".to_vec(), "it does not begin as a surface of FreeSurfer does"),
    ] {
        let error = read("lh.pial", &bytes).expect_err(said).to_string();
        assert!(error.contains(said), "{error}\n{said}");
    }
}

#[test]
fn overlays_hold_values_of_vertices() {
    let (near, far) = ([0.0, 1.5, f64::INFINITY], [2.0, 0.25, 3.0]);
    let bits = |values: [f64; 3], bytes: fn(f32) -> [u8; 4]| values.map(|value| bytes(value as f32)).concat();
    let curvature = Overlay::Curvature.bytes(&[("distance", &near)], 7);
    assert_eq!(
        curvature,
        [b"\xFF\xFF\xFF\0\0\0\x03\0\0\0\x07\0\0\0\x01".to_vec(), bits(near, f32::to_be_bytes)].concat()
    );

    let columns = [("near", &near[..]), ("far", &far[..])];
    let mgh = Overlay::Mgh.bytes(&columns, 7);
    assert_eq!(mgh.len(), 284 + 2 * 12);
    assert_eq!(mgh[..28], [1, 3, 1, 1, 2, 3, 0].map(i32::to_be_bytes).concat());
    assert_eq!(mgh[284..], [bits(near, f32::to_be_bytes), bits(far, f32::to_be_bytes)].concat());

    for (overlay, intent) in [(Overlay::Shape, "SHAPE"), (Overlay::Func, "NONE")] {
        let text = String::from_utf8(overlay.bytes(&columns, 7)).unwrap();
        assert_eq!(text.matches(&format!("Intent=\"NIFTI_INTENT_{intent}\"")).count(), 2);
        assert!(text.contains(&BASE64_STANDARD.encode(bits(far, f32::to_le_bytes))), "{text}");
        assert!(
            text.contains("NumberOfDataArrays=\"2\"")
                && text.contains("<Value>far</Value>")
                && text.contains("Dim0=\"3\"")
        );
    }
}

/// Labels of four vertices: one without a name, and one by a key that is in no table.
fn label_gii() -> String {
    let table = "<LabelTable><Label Key=\"0\" Red=\"1\" Green=\"1\" Blue=\"1\" Alpha=\"0\">???</Label>\
         <Label Key=\"12\" Red=\"1\"><![CDATA[L_V1 & V2]]></Label><Label Key=\"7\"><![CDATA[medial wall]]></Label></LabelTable>";
    let keys = "<DataArray Intent=\"NIFTI_INTENT_LABEL\" DataType=\"NIFTI_TYPE_INT32\" Dimensionality=\"1\" Dim0=\"4\" Encoding=\"ASCII\">\
         <Data>7 12 0 99</Data></DataArray>";
    document(keys).replace("<LabelTable/>", table)
}

/// The same labels, with colors in the place of keys; `version` of the table.
fn annot(version: u8) -> Vec<u8> {
    let word = |number: i32| number.to_be_bytes();
    let text = |text: &str| [&word(text.len() as i32 + 1)[..], text.as_bytes(), &[0]].concat();
    let names = [("???", [25, 5, 25]), ("L_V1 & V2", [1, 2, 3]), ("medial wall", [200, 0, 255])];
    let color = |[red, green, blue]: [i32; 3]| red + (green << 8) + (blue << 16);
    let mut bytes = word(4).to_vec();
    for (vertex, color) in [(0, color(names[2].1)), (1, color(names[1].1)), (2, color(names[0].1)), (3, 999)] {
        bytes.extend([word(vertex), word(color)].concat());
    }
    bytes.extend(word(1));
    if version == 2 {
        bytes.extend([&word(-2)[..], &word(35), &text("table.txt"), &word(3)].concat());
    } else {
        bytes.extend([&word(3)[..], &text("table.txt")].concat());
    }
    for (index, (name, [red, green, blue])) in (0..).zip(names) {
        let number = if version == 2 { word(10 * index).to_vec() } else { Vec::new() };
        bytes.extend([&number[..], &text(name), &word(red), &word(green), &word(blue), &word(0)].concat());
    }
    bytes
}

#[test]
fn labels_are_the_same_of_gifti_and_freesurfer() {
    let expected = Labels {
        names: ["???", "L_V1 & V2", "medial wall"].map(str::to_owned).to_vec(),
        of_vertices: vec![Some(2), Some(1), Some(0), None],
    };
    assert_eq!(io::read_labels(label_gii().as_bytes()).unwrap(), expected);
    assert_eq!(io::read_labels(&annot(1)).unwrap(), expected);
    assert_eq!(io::read_labels(&annot(2)).unwrap(), expected);
    assert_eq!(expected.vertices(1).collect::<Vec<_>>(), [1]);
    assert_eq!([0, 1, 2].map(|label| expected.is_parcel(label)), [false, true, true]);
    assert!(Labels::are_in("lh.aparc.ANNOT") && Labels::are_in("a.label.gii") && !Labels::are_in("a.csv"));
}

#[test]
fn what_is_wrong_with_labels_is_said() {
    let keys = label_gii();
    let (start, end) = (keys.find("<DataArray").unwrap(), keys.find("</GIFTI>").unwrap());
    let twice = [&keys[..end], &keys[start..end], &keys[end..]].concat();
    let mut missing = annot(2);
    missing[7] = 4;
    for (bytes, said) in [
        (twice.into_bytes(), "several maps of labels in one file"),
        (ascii(POINTS_TEXT, "0 1 2 0 2 3").into_bytes(), "there are no labels in it"),
        (missing, "byte 4: vertex 4 does not exist; there are 4, counted from 0"),
        (annot(2)[..36].to_vec(), "has no table of names"),
        (annot(1)[..60].to_vec(), "cut short"),
        (vec![0xFF; 40], "the count is not a whole number"),
        (vec![0x7F; 40], "cut short"),
    ] {
        let error = io::read_labels(&bytes).expect_err(said).to_string();
        assert!(error.contains(said), "{error}\n{said}");
    }
    for bytes in [label_gii().into_bytes(), annot(1), annot(2)] {
        (0..bytes.len()).for_each(|length| drop(io::read_labels(&bytes[..length])));
        for damaged in damaged_copies(&bytes) {
            if let Ok(labels) = io::read_labels(&damaged) {
                assert!(labels.of_vertices.iter().flatten().all(|&label| (label as usize) < labels.names.len()));
            }
        }
    }
}

#[test]
fn damaged_brains_do_not_panic() {
    let files: [(&str, Vec<u8>); 5] = [
        ("a.gii", ascii(POINTS_TEXT, "0 1 2 0 2 3").into()),
        ("b.gii", square("GZipBase64Binary", true, packed).into()),
        ("lh.pial", freesurfer()),
        ("lh.orig", quads(2, 0)),
        ("rh.orig", quads(4, 0)),
    ];
    for (name, bytes) in files {
        cut_short_at_every_byte(name, &bytes);
        flip_bytes(name, &bytes);
    }
}
