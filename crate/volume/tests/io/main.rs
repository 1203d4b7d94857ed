//! Readers and writers of tetrahedral meshes: the same mesh in every format, and damaged copies of it.

mod files;
#[cfg(not(target_arch = "wasm32"))]
#[cfg(feature = "meshio")]
mod meshio;

use std::collections::HashMap;

use heatwalk::surface::Error as FileError;
use heatwalk_volume::TetSoup;
use heatwalk_volume::io::{self, CellCounts, Error, Format, Result, TetFile, write};

use crate::files::{Encoding, Mesh, TETRAHEDRON, TRIANGLE};

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
    }
    mesh.cells.clear();
    let empty = read("a.mesh", b"MeshVersionFormatted 1 Dimension 3 Vertices 0 End").unwrap_err();
    assert_eq!(empty.code(), "no-tetrahedra");
    let unknown = read("a.obj", b"v 0 0 0").unwrap_err().to_string();
    assert!(unknown.contains("a.obj") && unknown.contains(".msh"), "{unknown}");
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
    assert!(read("a.vtk", polyhedron.as_bytes()).unwrap_err().to_string().contains("type 42"));
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

const DAMAGED_COPIES: usize = 2000;

/// Copies with one to three random bytes replaced, the same at every run.
fn damaged_copies(bytes: &[u8]) -> impl Iterator<Item = Vec<u8>> {
    let mut state = 1_u64;
    let mut random = move |below: usize| {
        // Multiplier and increment of Knuth's MMIX.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    (0..DAMAGED_COPIES).map(move |_| {
        let mut damaged = bytes.to_vec();
        for _ in 0..=random(3) {
            damaged[random(bytes.len())] = random(256) as u8;
        }
        damaged
    })
}
