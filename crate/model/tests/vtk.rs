//! VTK files, legacy and XML, in all their encodings: the same square by triangles, quads, polygons, strips.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use glam::DVec3;
use heatwalk_model::Error;
use heatwalk_surface::{Error as SurfaceError, Soup, WarningCode};
use miniz_oxide::deflate::compress_to_vec_zlib;

use crate::reading::{areas, cut_short_at_every_byte, flip_bytes, part_names, read};

const POINTS: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];

fn text<T: ToString>(numbers: &[T]) -> String {
    numbers.iter().map(T::to_string).collect::<Vec<_>>().join(" ")
}

/// A legacy file with the square's points and some more statements.
fn ascii(dataset: &str, cells: &str) -> String {
    format!(
        "# vtk DataFile Version 4.2\nsquare\nASCII\nDATASET {dataset}\nPOINTS 4 float\n{}\n{cells}\n",
        text(&POINTS)
    )
}

fn assert_square(soup: &Soup) {
    assert_eq!(soup.positions, [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y]);
    assert_eq!(areas(soup), [0.5, 0.5]);
}

#[test]
fn legacy_cells_make_the_same_square() {
    for cells in [
        "POLYGONS 2 8\n3 0 1 2\n3 0 2 3",
        "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nPOLYGONS 1 5\n4 0 1 2 3\nPOINT_DATA 4\nSCALARS s float 1\nLOOKUP_TABLE default\n1 2 3 4",
        "TRIANGLE_STRIPS 1 5\n4 0 1 3 2",
        // Since version 5 where cells begin, then their points.
        "METADATA\nINFORMATION 0\n\nPOLYGONS 3 6\nOFFSETS vtktypeint64\n0 3 6\nCONNECTIVITY vtktypeint64\n0 1 2 0 2 3",
    ] {
        assert_square(&read("square.vtk", ascii("POLYDATA", cells)).unwrap());
    }
    for (cells, types) in [
        ("2 8\n3 0 1 2\n3 0 2 3", "2\n5\n5"),
        ("1 5\n4 0 1 2 3", "1\n9"),
        ("1 5\n4 0 1 3 2", "1\n8"),
        ("2 8\n4 0 1 2 3\n2 0 1", "2\n7\n3"),
        ("2 12\n4 0 1 3 2\n6 0 1 2 3 0 1", "2\n6\n13"),
    ] {
        assert_square(
            &read("square.vtk", ascii("UNSTRUCTURED_GRID", &format!("CELLS {cells}\nCELL_TYPES {types}"))).unwrap(),
        );
    }
    // The corners of a curved triangle.
    let curved = read("a.vtk", ascii("UNSTRUCTURED_GRID", "CELLS 1 7\n6 0 1 2 3 3 3\nCELL_TYPES 1\n22")).unwrap();
    assert_eq!(curved.triangles, [[0, 1, 2]]);
    assert_eq!(part_names(&curved), ["a"]);
}

fn binary() -> Vec<u8> {
    let mut bytes =
        b"# vtk DataFile Version 3.0\nsquare\nBINARY\nDATASET POLYDATA\nFIELD FieldData 1\nTIME 1 1 double\n".to_vec();
    bytes.extend(3.0_f64.to_be_bytes());
    bytes.extend(b"\nPOINTS 4 float\n");
    bytes.extend(POINTS.iter().flat_map(|number| number.to_be_bytes()));
    bytes.extend(b"\nPOLYGONS 2 8\n");
    bytes.extend([3_i32, 0, 1, 2, 3, 0, 2, 3].iter().flat_map(|number| number.to_be_bytes()));
    bytes.push(b'\n');
    bytes
}

fn binary_with_offsets() -> Vec<u8> {
    let mut bytes = b"# vtk DataFile Version 5.1\nsquare\nBINARY\nDATASET POLYDATA\nPOINTS 4 double\n".to_vec();
    bytes.extend(POINTS.iter().flat_map(|&number| f64::from(number).to_be_bytes()));
    bytes.extend(b"\nPOLYGONS 2 4\nOFFSETS vtktypeint64\n");
    bytes.extend([0_i64, 4].iter().flat_map(|number| number.to_be_bytes()));
    bytes.extend(b"\nCONNECTIVITY vtktypeint64\n");
    bytes.extend([0_i64, 1, 2, 3].iter().flat_map(|number| number.to_be_bytes()));
    bytes.push(b'\n');
    bytes
}

#[test]
fn legacy_binary_files_are_big_endian() {
    assert_square(&read("square.vtk", binary()).unwrap());
    assert_square(&read("told by its first bytes", binary_with_offsets()).unwrap());
}

/// How an XML file has its arrays.
#[derive(Clone, Copy, PartialEq)]
enum Encoding {
    Ascii,
    Base64,
    Raw,
    AppendedBase64,
}

fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let letters = bytes.chunks(3).flat_map(|group| {
        let bits = group.iter().fold(0_u32, |bits, &byte| bits << 8 | u32::from(byte)) << (8 * (3 - group.len()));
        (0..4).map(move |k| if k <= group.len() { LETTERS[(bits >> (18 - 6 * k) & 63) as usize] } else { b'=' })
    });
    letters.map(char::from).collect()
}

/// An XML file with the square in two blocks of each array where they are packed.
fn document(encoding: Encoding, is_packed: bool, is_little: bool) -> Vec<u8> {
    let mut appended = Vec::new();
    let mut array = |name: &str, kind: &str, ascii: String, mut bytes: Vec<u8>, size: usize| {
        if encoding == Encoding::Ascii {
            return format!("<DataArray Name=\"{name}\" type=\"{kind}\" format=\"ascii\">\n {ascii}\n</DataArray>");
        }
        if !is_little {
            bytes.chunks_mut(size).for_each(<[u8]>::reverse);
        }
        let words = |words: &[usize]| -> Vec<u8> {
            let bytes =
                |&word: &usize| if is_little { (word as u64).to_le_bytes() } else { (word as u64).to_be_bytes() };
            words.iter().flat_map(bytes).collect()
        };
        let (header, data) = if is_packed {
            let block = bytes.len() / size / 2 * size + size;
            let packed: Vec<Vec<u8>> = bytes.chunks(block).map(|block| compress_to_vec_zlib(block, 6)).collect();
            let mut header = vec![packed.len(), block, bytes.len() % block];
            header.extend(packed.iter().map(Vec::len));
            (words(&header), packed.concat())
        } else {
            (words(&[bytes.len()]), bytes)
        };
        let start = appended.len();
        match encoding {
            Encoding::Raw => appended.extend([header, data].concat()),
            // What is packed has a header that is encoded by itself.
            _ if is_packed => appended.extend((base64(&header) + &base64(&data)).into_bytes()),
            _ => appended.extend(base64(&[header, data].concat()).into_bytes()),
        }
        if encoding == Encoding::Base64 {
            let text = String::from_utf8(appended.split_off(start)).unwrap();
            format!("<DataArray type=\"{kind}\" Name=\"{name}\" format=\"binary\">\n  {text}\n</DataArray>")
        } else {
            format!("<DataArray type=\"{kind}\" Name=\"{name}\" format=\"appended\" offset=\"{start}\"/>")
        }
    };
    let bytes = |numbers: &[i64]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>();
    let points = array("Points", "Float32", text(&POINTS), POINTS.iter().flat_map(|n| n.to_le_bytes()).collect(), 4);
    let connectivity = array("connectivity", "Int64", "0 1 2 0 2 3".to_owned(), bytes(&[0, 1, 2, 0, 2, 3]), 8);
    let offsets = array("offsets", "Int64", "3 6".to_owned(), bytes(&[3, 6]), 8);
    let compressor = if is_packed { "compressor=\"vtkZLibDataCompressor\"" } else { "" };
    let order = if is_little { "LittleEndian" } else { "BigEndian" };
    let mut file = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{order}\" header_type=\"UInt64\" {compressor}>\
         <PolyData><Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\"><PointData><DataArray type=\"String\" Name=\"s\"/></PointData>\
         <Points>{points}</Points><Polys>{connectivity}{offsets}</Polys></Piece></PolyData>"
    )
    .into_bytes();
    if matches!(encoding, Encoding::Raw | Encoding::AppendedBase64) {
        let name = if encoding == Encoding::Raw { "raw" } else { "base64" };
        file.extend(format!("<AppendedData encoding=\"{name}\">\n _").bytes());
        file.extend(appended);
        file.extend(b"\n</AppendedData>");
    }
    file.extend(b"</VTKFile>\n");
    file
}

const ENCODINGS: [Encoding; 4] = [Encoding::Ascii, Encoding::Base64, Encoding::Raw, Encoding::AppendedBase64];

#[test]
fn documents_hold_the_same_square_however_they_are_encoded() {
    for encoding in ENCODINGS {
        for (is_packed, is_little) in [(false, true), (true, true), (false, false), (true, false)] {
            assert_square(&read("square.vtp", document(encoding, is_packed, is_little)).unwrap());
        }
    }
    let bytes = document(Encoding::Base64, true, true);
    assert_square(&read("told by its first bytes", bytes).unwrap());
}

#[test]
fn pieces_are_parts_and_grids_have_types() {
    let piece = format!(
        "<Piece><Points><DataArray type=\"Float32\">{}</DataArray></Points><Cells>\
         <DataArray type=\"Int32\" Name=\"connectivity\">0 1 2 3 0 1</DataArray><DataArray type=\"Int32\" Name=\"offsets\">4 6</DataArray>\
         <DataArray type=\"UInt8\" Name=\"types\">9 3</DataArray></Cells></Piece>",
        text(&POINTS)
    );
    let document = |pieces: &str| {
        format!("<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid>{pieces}</UnstructuredGrid></VTKFile>")
    };
    assert_square(&read("a.vtu", document(&piece)).unwrap());
    let two = read("a.vtu", document(&piece.repeat(2))).unwrap();
    assert_eq!(part_names(&two), ["a 0", "a 1"]);
    assert_eq!((two.positions.len(), two.triangles[2]), (8, [4, 5, 6]));
    let volume = read("a.vtu", document(&piece.replace(">9 3<", ">10 3<"))).unwrap_err();
    assert!(volume.to_string().contains("1 cell that fills space was left out"), "{volume}");
    // Beside faces, what fills space is left out.
    let mixed = read("a.vtu", document(&(piece.replace(">9 3<", ">10 3<") + &piece))).unwrap();
    assert_eq!((mixed.triangles.len(), mixed.warnings[0].code), (2, WarningCode::VolumesLeftOut));
}

#[test]
fn errors_name_the_place() {
    let square = |cells: &str| ascii("POLYDATA", cells);
    for (bad, place) in [
        (square("POLYGONS 1 5\n4 0 1 2"), "byte"),
        (square("POLYGONS 1 5\n9 0 1 2 3"), "cell 0"),
        (square("POLYGONS 1 5\n4 0 1 2 -3"), "face 0"),
        (square("POLYGONS 99999999999 99999999999\n"), "byte"),
        (square("POLYGONS one 5\n"), "POLYGONS statement"),
        (ascii("UNSTRUCTURED_GRID", "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 0"), "cell 0"),
        (ascii("UNSTRUCTURED_GRID", "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n5"), "too few points"),
        (ascii("STRUCTURED_GRID", ""), "STRUCTURED_GRID"),
        (square("").replace("ASCII", "UTF8"), "line 3"),
        ("<VTKFile type=\"ImageData\"></VTKFile>".to_owned(), "ImageData"),
        ("<VTKFile compressor=\"vtkLZ4DataCompressor\"></VTKFile>".to_owned(), "vtkLZ4DataCompressor"),
        ("<VTKFile><Points><DataArray type=\"Float32\">0 0 x</DataArray></Points></VTKFile>".to_owned(), "byte"),
        ("<VTKFile><Points><DataArray type=\"Float32\">0 0 0".to_owned(), "cut short"),
        (
            "<VTKFile><Points><DataArray type=\"Float32\" format=\"binary\">/////w==</DataArray></Points></VTKFile>"
                .to_owned(),
            "damaged",
        ),
    ] {
        let error = read("a.vtk", &bad).unwrap_err().to_string();
        assert!(error.contains(place), "{error}");
    }
    let error = read("a.vtk", square("POLYGONS 1 4\n3 0 1 4")).unwrap_err().to_string();
    assert_eq!(error, "VTK, face 0: vertex 4 does not exist; there are 4, counted from 0");
    assert!(matches!(read("a.vtk", square("LINES 1 3\n2 0 1")), Err(Error::Surface(SurfaceError::Empty { .. }))));
}

#[test]
fn damaged_files_do_not_panic() {
    let mut files =
        vec![binary(), binary_with_offsets(), ascii("POLYDATA", "TRIANGLE_STRIPS 1 5\n4 0 1 3 2").into_bytes()];
    files.push(ascii("UNSTRUCTURED_GRID", "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n9").into_bytes());
    for encoding in ENCODINGS {
        files.extend([false, true].map(|is_packed| document(encoding, is_packed, true)));
    }
    for bytes in files {
        cut_short_at_every_byte("a.vtk", &bytes);
        flip_bytes("a.vtk", &bytes);
    }
}
