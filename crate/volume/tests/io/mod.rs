//! Readers and writers of tetrahedral meshes: the same mesh in every format, and damaged copies of it.

#[path = "../../../model/tests/reading/damage.rs"]
mod damage;
mod files;
#[cfg(not(target_arch = "wasm32"))]
#[cfg(feature = "meshio")]
mod meshio;

use std::collections::HashMap;

use glam::DVec3;
use heatwalk::surface::WarningCode;
use heatwalk_model::Error as FileError;
use heatwalk_volume::TetSoup;
use heatwalk_volume::io::{self, CellCounts, Error, Format, Result, TetFile, write};

use damage::damaged_copies;
use files::{Encoding, Mesh, TETRAHEDRON, TRIANGLE};

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

const ENCODINGS: [Encoding; 3] = [Encoding::Text, Encoding::Little, Encoding::Big];

fn read(name: &str, bytes: &[u8]) -> Result<TetFile> {
    io::read(name, bytes, &|_| None)
}

fn volumes(soup: &TetSoup) -> Vec<f64> {
    let volume = |tetrahedron: &[u32; 4]| {
        let [a, b, c, d] = tetrahedron.map(|corner| soup.positions[corner as usize]);
        (b - a).cross(c - a).dot(d - a).abs() / 6.0
    };
    soup.tetrahedra.iter().map(volume).collect()
}

/// A mesh in all formats that hold any cells.
fn files(mesh: &Mesh) -> Vec<(&'static str, Vec<u8>)> {
    let mut files = vec![("a.mesh", files::medit_text(mesh))];
    for encoding in ENCODINGS {
        files.push(("a.msh", files::gmsh_rows(mesh, encoding)));
        files.push(("a.msh", files::gmsh_blocks(mesh, true, encoding)));
        files.push(("a.msh", files::gmsh_blocks(mesh, false, encoding)));
        if encoding != Encoding::Text {
            files.extend((1..=4).map(|version| ("a.meshb", files::medit_binary(mesh, version, encoding))));
        }
        if encoding != Encoding::Little {
            files.push(("a.vtk", files::vtk(mesh, encoding)));
        }
    }
    files
}

#[test]
fn every_format_holds_the_same_mixed_mesh() {
    let mesh = Mesh::mixed();
    for (name, bytes) in files(&mesh) {
        let head = String::from_utf8_lossy(&bytes[..40]).into_owned();
        let file = read(name, &bytes).unwrap_or_else(|error| panic!("{head}: {error}"));
        assert_eq!(file.soup.positions, mesh.points, "{head}");
        let counts = CellCounts { tetrahedra: 1, pyramids: 1, prisms: 1, hexahedra: 1, curved: 0, faces: 1 };
        assert_eq!(file.cells, counts, "{head}");
        assert_eq!(file.soup.tetrahedra.len(), 6 + 2 + 3 + 1, "{head}");
        let volumes = volumes(&file.soup);
        assert!(volumes.iter().all(|&volume| volume > 0.0), "{head}: {volumes:?}");
        let sum: f64 = volumes.iter().sum();
        assert!((sum - (1.0 + 1.0 / 3.0 + 0.5 + 1.0 / 12.0)).abs() < 1e-12, "{head}: {sum}");
        assert!(boundary_is_closed(&file.soup), "{head}");
        // The first bytes tell all but TetGen's formats.
        assert_eq!(Format::of("unnamed", &bytes), Format::of_name(name), "{head}");
    }
    assert_eq!(
        read("a.mesh", &files::medit_text(&mesh)).unwrap().cells.to_string(),
        "1 hexahedra, 1 prisms, 1 pyramids were split into tetrahedra"
    );
}

/// Whether each face is of one or two tetrahedra, and each edge of a face of one tetrahedron of an even number of such faces:
/// where cells split a shared face in two ways, both ways remain as faces of one, inside.
fn boundary_is_closed(soup: &TetSoup) -> bool {
    let mut faces: HashMap<[u32; 3], usize> = HashMap::new();
    for &[a, b, c, d] in &soup.tetrahedra {
        for mut face in [[a, b, c], [a, b, d], [a, c, d], [b, c, d]] {
            face.sort_unstable();
            *faces.entry(face).or_default() += 1;
        }
    }
    // Of the cube, the pyramid, the prism and the tetrahedron, less those that are shared: 2 · 4 + 4 + (1 + 2 · 2) + 3.
    faces.values().all(|&count| count <= 2) && faces.values().filter(|&&count| count == 1).count() == 20
}

#[test]
fn curved_cells_are_reduced_to_their_corners_and_counted() {
    for (name, bytes) in files(&Mesh::curved()) {
        let file = read(name, &bytes).unwrap();
        let mut tetrahedra = file.soup.tetrahedra;
        tetrahedra.sort_unstable();
        assert_eq!(tetrahedra, [[0, 1, 2, 3], [0, 2, 10, 3]]);
        assert_eq!(file.cells, CellCounts { tetrahedra: 2, curved: 1, ..CellCounts::default() });
        assert_eq!(file.cells.to_string(), "of 1 curved cells the corners were taken");
    }
}

#[test]
fn tetgen_counts_from_0_or_1_and_takes_either_file() {
    let mesh = Mesh::mixed();
    for first in 0..2 {
        let [nodes, elements] = files::tetgen(&mesh, first);
        let by_nodes = io::read("a.1.node", &nodes, &|uri| (uri == "a.1.ele").then(|| elements.clone())).unwrap();
        let by_elements = io::read("a.1.ele", &elements, &|uri| (uri == "a.1.node").then(|| nodes.clone())).unwrap();
        assert_eq!(by_nodes, by_elements);
        assert_eq!(by_nodes.soup.tetrahedra, [[5, 10, 6, 11]]);
        assert_eq!(by_nodes.soup.positions, mesh.points);
        let missing = read("a.1.node", &nodes).unwrap_err();
        assert_eq!(missing, Error::File(FileError::MissingResource { uri: "a.1.ele".to_owned() }));
    }
}

#[test]
fn files_without_tetrahedra_say_what_they_hold() {
    let mut mesh = Mesh::mixed();
    mesh.cells.retain(|(kind, _)| *kind == TRIANGLE);
    for (name, bytes) in files(&mesh) {
        let error = read(name, &bytes).unwrap_err();
        assert!(matches!(&error, Error::NoTetrahedra { faces: 1, .. }), "{error}");
        assert!(error.to_string().contains("1 face"), "{error}");
        let surface = io::read_surface(name, &bytes, &|_| None).unwrap();
        assert_eq!((surface.positions, surface.triangles.len()), (mesh.points.clone(), 1));
    }
    mesh.cells.clear();
    let empty = read("a.mesh", b"MeshVersionFormatted 1 Dimension 3 Vertices 0 End").unwrap_err();
    assert_eq!(empty.code(), "no-tetrahedra");
    let unknown = read("a.obj", b"v 0 0 0").unwrap_err().to_string();
    assert!(unknown.contains("a.obj") && unknown.contains(".msh"), "{unknown}");
}

/// A corner of the unit cube.
const CORNER: &str = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

#[test]
fn files_with_nothing_but_white_space_are_empty() {
    for nothing in ["", " \n\t", "\u{feff}"] {
        for name in ["a.mesh", "a.meshb", "a.msh", "a.vtk", "a.vtu", "a.node", "a.ele"] {
            let words = format!("no triangles: {name} is empty: nothing is in it; save or copy it again");
            assert_eq!(read(name, nothing.as_bytes()).unwrap_err().to_string(), words);
            let surface = io::read_surface(name, nothing.as_bytes(), &|_| None);
            assert_eq!(surface.unwrap_err().to_string(), words);
        }
    }
    let nodes = files::tetgen(&Mesh::mixed(), 1)[0].clone();
    let error = io::read("a.node", &nodes, &|_| Some(Vec::new())).unwrap_err().to_string();
    assert!(error.contains("a.ele is empty"), "{error}");
}

#[test]
fn gmsh_nodes_with_parameters_are_read() {
    let nodes = "1 0 0 0 0 1\n2 1 0 0 0 2\n3 0 1 0 1 1 0.5\n4 0 0 1 2 1 0.5 -nan(ind)\n";
    let text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n4\n{nodes}$EndParametricNodes\n$Elements\n1\n1 4 2 1 1 1 2 3 4\n\
         $EndElements\n"
    );
    for text in [text.clone(), text.replace('\n', "\r"), text.replace('\n', "\r\n")] {
        let soup = read("a.msh", text.as_bytes()).unwrap().soup;
        assert_eq!((soup.positions[3], &soup.tetrahedra[..]), (DVec3::Z, &[[0, 1, 2, 3]][..]));
    }
    let mut bytes = b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$ParametricNodes\n4\n".to_vec();
    for (number, position, entity) in [(1, DVec3::ZERO, 0), (2, DVec3::X, 3), (3, DVec3::Y, 1), (4, DVec3::Z, 2)] {
        bytes.extend(i32::to_le_bytes(number));
        bytes.extend(position.to_array().into_iter().flat_map(f64::to_le_bytes));
        bytes.extend([i32::to_le_bytes(entity), i32::to_le_bytes(1)].concat());
        (0..entity % 3).for_each(|_| bytes.extend(0.5_f64.to_le_bytes()));
    }
    bytes.extend(b"\n$EndParametricNodes\n$Elements\n1\n");
    bytes.extend([4, 1, 2, 1, 1, 1, 1, 2, 3, 4].into_iter().flat_map(i32::to_le_bytes));
    let soup = read("a.msh", &bytes).unwrap().soup;
    assert_eq!((soup.positions[3], &soup.tetrahedra[..]), (DVec3::Z, &[[0, 1, 2, 3]][..]));
}

#[test]
fn tetgen_counts_may_stand_alone_and_lines_end_by_any_sign() {
    let rows: String = (1..).zip(CORNER.lines()).map(|(number, row)| format!("{number} {row}\n")).collect();
    for (nodes, elements) in
        [("4", "1"), ("4 3", "1 4"), ("# made\n4 3 0", "1 4 0"), ("4 3 0 0 # here", "# x\n\n1 # one")]
    {
        let (nodes, elements) = (format!("{nodes}\n{rows}"), format!("{elements}\n1 1 2 3 4\n"));
        for end in ["\n", "\r", "\r\n"] {
            let nodes = nodes.replace('\n', end);
            let other = elements.replace('\n', end);
            let file = io::read("a.node", nodes.as_bytes(), &|_| Some(other.clone().into_bytes())).unwrap();
            assert_eq!((file.soup.positions[3], &file.soup.tetrahedra[..]), (DVec3::Z, &[[0, 1, 2, 3]][..]), "{nodes}");
        }
    }
}

#[test]
fn quadrilaterals_and_curved_triangles_are_a_surface() {
    let medit = "MeshVersionFormatted 2\rDimension 3 # flat\rVertices 4\r0 0 0 0\r1 0 0 0\r1 1 0 0\r0 1 0 0\rQuadrilaterals 1\r1 2 3 4 0\rEnd";
    let soup = io::read_surface("a.mesh", medit.as_bytes(), &|_| None).unwrap();
    assert_eq!((&soup.triangles[..], soup.parts[0].name.as_str()), (&[[0, 1, 2], [0, 2, 3]][..], "a"));
    let gmsh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0.5 0 0\n50 0.5 0.5 0\n60 0 0.5 0\n\
                $EndNodes\n$Elements\n2\n1 15 2 1 1 10\n2 9 2 1 1 10 20 30 40 50 60\n$EndElements\n";
    let soup = io::read_surface("a.msh", gmsh.as_bytes(), &|_| None).unwrap();
    assert_eq!((&soup.triangles[..], soup.warnings[0].code), (&[[0, 1, 2]][..], WarningCode::Straightened));
    let missing = gmsh.replace("1 1 10 20 30", "1 1 10 20 31");
    let error = io::read_surface("a.msh", missing.as_bytes(), &|_| None).unwrap_err().to_string();
    assert!(error.contains("face 0 refers to vertex 31"), "{error}");
}

#[test]
fn text_that_no_number_is_read_of_is_told_as_what_it_is() {
    let text = "MeshVersionFormatted 2\nDimension 3\nVertices 1\n0,5 0 0 0\n";
    let comma = read("a.mesh", text.as_bytes()).unwrap_err().to_string();
    assert!(comma.contains("line 4") && comma.contains("decimal comma"), "{comma}");
    for name in ["a.mesh", "a.msh", "a.vtk", "a.node"] {
        let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let error = io::read(name, &utf16, &|_| Some(Vec::new())).unwrap_err().to_string();
        assert!(error.contains("UTF-16"), "{error}");
    }
}

#[test]
fn errors_name_the_place() {
    let medit = |text: &str| ("a.mesh", format!("MeshVersionFormatted 2\nDimension 3\n{text}"));
    let gmsh = |text: &str| ("a.msh", format!("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n{text}"));
    for ((name, text), place) in [
        (medit("Vertices 1\n0 0 x 0\n"), "line 4"),
        (medit("Vertices 2\n0 0 0 0\n"), "the file ends"),
        (medit("Vertices 4000000000\n0 0 0 0\n"), "the file ends"),
        (medit("Vertices -1\n"), "-1"),
        (medit("Vertices 1\n0 0 0 0\nTetrahedra 1\n1 1 1 2 0\n"), "cell 0 refers to vertex 2"),
        (medit("Vertices 1\n0 0 0 0\nTetrahedra 1\n1 1 1 0 0\n"), "cell 0 refers to vertex 0"),
        (("a.mesh", "MeshVersionFormatted 2\nDimension 2\n".to_owned()), "dimension 2"),
        (gmsh("$Nodes\n1 1 1 1\n3 1 0 1\n1\n0 0\n$EndNodes\n"), "line 9"),
        (gmsh("$Elements\n1 1 1 1\n3 1 999 1\n1 1\n"), "type 999"),
        (gmsh("$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n"), "cell 0 refers to vertex 1"),
        (gmsh("$Nodes\n1 2 1 1\n3 1 0 2\n1\n1\n0 0 0\n0 0 0\n"), "node 1"),
        (("a.msh", "$MeshFormat\n3 0 8\n".to_owned()), "version 3"),
        (("a.msh", "$NOD\n1\n1 0 0 0\n".to_owned()), "version 1"),
        (("a.msh", "(0 \"another program's file\")".to_owned()), "$MeshFormat"),
        (("a.msh", "$Nodes\n1\n".to_owned()), "$MeshFormat"),
    ] {
        let error = read(name, text.as_bytes()).unwrap_err().to_string();
        assert!(error.contains(place), "{text}: {error}");
    }
    let [nodes, elements] = files::tetgen(&Mesh::mixed(), 1);
    for (broken, place) in [
        (String::from_utf8(nodes.clone()).unwrap().replace("\n3 ", "\n4 "), "vertex 3 is expected"),
        (String::from_utf8(nodes.clone()).unwrap().replace("12 3 1 1", "11 3 1 1"), "vertex 12"),
        (String::from_utf8(nodes).unwrap().replace("12 3 1 1", "12 2 1 1"), "dimension 2"),
    ] {
        let error = io::read("a.ele", &elements, &|_| Some(broken.clone().into_bytes())).unwrap_err().to_string();
        assert!(error.contains(place), "{error}");
    }
    let polyhedron = "# vtk DataFile Version 3.0\na\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n0 0 0\nCELLS 1 2\n1 0\nCELL_TYPES 1\n42\n";
    assert!(read("a.vtk", polyhedron.as_bytes()).unwrap_err().to_string().contains("volume cell 0, a polyhedron,"));
    let outside = polyhedron.replace("\n42", "\n10").replace("CELLS 1 2\n1 0", "CELLS 1 5\n4 0 0 0 1");
    assert!(read("a.vtk", outside.as_bytes()).unwrap_err().to_string().contains("point 1"));
}

/// Tetrahedra of a mesh alone, with a distance.
fn tetrahedra() -> (TetSoup, Vec<f64>) {
    let mut mesh = Mesh::mixed();
    mesh.cells.retain(|(kind, _)| *kind == TETRAHEDRON);
    let soup = read("a.mesh", &files::medit_text(&mesh)).unwrap().soup;
    let distance =
        (0..soup.positions.len()).map(|vertex| if vertex == 3 { f64::INFINITY } else { vertex as f64 }).collect();
    (soup, distance)
}

#[test]
fn what_is_written_is_read_back() {
    let (soup, distance) = tetrahedra();
    for distance in [None, Some(&distance[..])] {
        assert_eq!(read("a.vtu", &write::vtu(&soup, distance)).unwrap().soup, soup);
        assert_eq!(read("a.msh", &write::msh(&soup, distance)).unwrap().soup, soup);
    }
}

#[test]
fn damaged_files_do_not_panic() {
    let mesh = Mesh::mixed();
    let (soup, distance) = tetrahedra();
    let mut all = files(&mesh);
    all.push(("a.vtu", write::vtu(&soup, Some(&distance))));
    all.push(("a.msh", write::msh(&soup, Some(&distance))));
    for (name, bytes) in all {
        (0..bytes.len()).for_each(|length| read_damaged(name, &bytes[..length], &[]));
        damaged_copies(&bytes).for_each(|damaged| read_damaged(name, &damaged, &[]));
    }
    let [nodes, elements] = files::tetgen(&mesh, 1);
    for (name, bytes, other) in [("a.node", &nodes, &elements), ("a.ele", &elements, &nodes)] {
        (0..bytes.len()).for_each(|length| read_damaged(name, &bytes[..length], other));
        damaged_copies(bytes).for_each(|damaged| read_damaged(name, &damaged, other));
    }
}

/// An error is fine, a panic or an index out of range is not.
fn read_damaged(name: &str, bytes: &[u8], other: &[u8]) {
    if let Ok(TetFile { soup, .. }) = io::read(name, bytes, &|_| Some(other.to_vec())) {
        assert!(soup.tetrahedra.iter().flatten().all(|&corner| (corner as usize) < soup.positions.len()));
    }
}
