//! Tetrahedra, and their distances, as bytes of a file.

use std::fmt::Write as _;

use crate::soup::TetSoup;

/// VTK's number of tetrahedra.
const VTK_TETRAHEDRON: u8 = 10;
/// Gmsh's number of tetrahedra.
const GMSH_TETRAHEDRON: i32 = 4;

/// A line `vertex,distance` for each vertex, counted from 0, after a head with the symbol of the `unit` where there is one; `inf` where
/// no source is reached.
pub fn csv(distance: &[f64], unit: Option<&str>) -> Vec<u8> {
    let head = unit.map_or_else(|| "vertex,distance\n".to_owned(), |unit| format!("vertex,distance ({unit})\n"));
    let rows = distance.iter().enumerate().map(|(vertex, value)| format!("{vertex},{value}\n"));
    std::iter::once(head).chain(rows).collect::<String>().into_bytes()
}

/// VTU (Kitware, "VTK File Formats"): an unstructured grid in doubles, appended raw and little-endian, with the point data
/// `distance` where given, one value a vertex, which may be infinite.
///
/// # Panics
/// If there is not one distance for each vertex.
pub fn vtu(soup: &TetSoup, distance: Option<&[f64]>) -> Vec<u8> {
    check(soup, distance);
    let mut appended = Appended::default();
    let data = distance.map(|distance| {
        let array = appended.array("Float64", "distance", 1, distance.iter().flat_map(|value| value.to_le_bytes()));
        format!("<PointData Scalars=\"distance\">{array}</PointData>")
    });
    let coordinates = soup.positions.iter().flat_map(|position| position.to_array());
    let points = appended.array("Float64", "Points", 3, coordinates.flat_map(f64::to_le_bytes));
    let corners = soup.tetrahedra.as_flattened();
    let connectivity = corners.iter().flat_map(|&corner| i64::from(corner).to_le_bytes());
    let connectivity = appended.array("Int64", "connectivity", 1, connectivity);
    let ends = (1..=soup.tetrahedra.len()).flat_map(|cell| (4 * cell as i64).to_le_bytes());
    let ends = appended.array("Int64", "offsets", 1, ends);
    let types = appended.array("UInt8", "types", 1, soup.tetrahedra.iter().map(|_| VTK_TETRAHEDRON));
    let mut bytes = format!(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <UnstructuredGrid><Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n\
         {}<Points>{points}</Points>\n<Cells>{connectivity}{ends}{types}</Cells>\n\
         </Piece></UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_",
        soup.positions.len(),
        soup.tetrahedra.len(),
        data.unwrap_or_default()
    )
    .into_bytes();
    bytes.extend(appended.bytes);
    bytes.extend(b"\n</AppendedData>\n</VTKFile>\n");
    bytes
}

/// Arrays after the XML.
#[derive(Default)]
struct Appended {
    bytes: Vec<u8>,
}

impl Appended {
    /// Appends an array after its length in bytes. Returns the element that refers to it.
    fn array(&mut self, kind: &str, name: &str, components: usize, bytes: impl Iterator<Item = u8>) -> String {
        let offset = self.bytes.len();
        self.bytes.extend([0; size_of::<u64>()]);
        let start = self.bytes.len();
        self.bytes.extend(bytes);
        let length = (self.bytes.len() - start) as u64;
        self.bytes[offset..start].copy_from_slice(&length.to_le_bytes());
        format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"appended\" offset=\"{offset}\"/>"
        )
    }
}

/// Gmsh 4.1, binary and little-endian: one volume, with the view `distance` where given, one value a vertex. Vertices at infinite
/// distance have no value in the view.
///
/// # Panics
/// If there is not one distance for each vertex.
pub fn msh(soup: &TetSoup, distance: Option<&[f64]>) -> Vec<u8> {
    check(soup, distance);
    let sizes = |values: &[usize]| values.iter().flat_map(|&value| (value as u64).to_le_bytes()).collect::<Vec<_>>();
    let ints = |values: &[i32]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<_>>();
    let (vertices, tetrahedra) = (soup.positions.len(), soup.tetrahedra.len());
    let mut bytes = b"$MeshFormat\n4.1 1 8\n".to_vec();
    bytes.extend(ints(&[1]));
    bytes.extend(b"\n$EndMeshFormat\n$Nodes\n");
    // One block, of the volume 1; vertices and tetrahedra are counted from 1.
    bytes.extend(sizes(&[1, vertices, 1, vertices]));
    bytes.extend(ints(&[3, 1, 0]));
    bytes.extend(sizes(&[vertices]));
    bytes.extend((1..=vertices as u64).flat_map(u64::to_le_bytes));
    bytes.extend(soup.positions.iter().flat_map(|position| position.to_array()).flat_map(f64::to_le_bytes));
    bytes.extend(b"\n$EndNodes\n$Elements\n");
    bytes.extend(sizes(&[1, tetrahedra, 1, tetrahedra]));
    bytes.extend(ints(&[3, 1, GMSH_TETRAHEDRON]));
    bytes.extend(sizes(&[tetrahedra]));
    for (number, corners) in (1_u64..).zip(&soup.tetrahedra) {
        bytes.extend(number.to_le_bytes());
        bytes.extend(corners.iter().flat_map(|&corner| (u64::from(corner) + 1).to_le_bytes()));
    }
    bytes.extend(b"\n$EndElements\n");
    if let Some(distance) = distance {
        let finite: Vec<(i32, f64)> =
            (1..).zip(distance.iter().copied()).filter(|(_, value)| value.is_finite()).collect();
        let mut head = String::from("$NodeData\n1\n\"distance\"\n1\n0.0\n");
        // Time step 0, one component. Writing to a String cannot fail.
        let _ = write!(head, "3\n0\n1\n{}\n", finite.len());
        bytes.extend(head.bytes());
        for (number, value) in finite {
            bytes.extend(number.to_le_bytes());
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend(b"\n$EndNodeData\n");
    }
    bytes
}

fn check(soup: &TetSoup, distance: Option<&[f64]>) {
    assert!(distance.is_none_or(|distance| distance.len() == soup.positions.len()), "one distance for each vertex");
}
