//! One mesh in every format and encoding.

use std::fmt::Write as _;

use glam::DVec3;

/// A shape of cells: its number in VTK and in Gmsh, its keyword and its number in Medit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Kind(u8, i32, &'static str, i32);

pub const TETRAHEDRON: Kind = Kind(10, 4, "Tetrahedra", 8);
pub const CURVED: Kind = Kind(24, 11, "TetrahedraP2", 30);
pub const HEXAHEDRON: Kind = Kind(12, 5, "Hexahedra", 10);
pub const PRISM: Kind = Kind(13, 6, "Prisms", 9);
pub const PYRAMID: Kind = Kind(14, 7, "Pyramids", 49);
pub const TRIANGLE: Kind = Kind(5, 2, "Triangles", 6);

/// Cells over points.
pub struct Mesh {
    pub points: Vec<DVec3>,
    pub cells: Vec<(Kind, Vec<u32>)>,
}

impl Mesh {
    /// A cube with a pyramid of half its volume on top, half a cube beside it, and a tetrahedron on the triangle of that; and one
    /// face. 11 / 6 + 1 / 12 in volume.
    pub fn mixed() -> Self {
        let points = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 1.0],
            [1.0, 1.0, 1.0],
            [0.0, 1.0, 1.0],
            [0.5, 0.5, 2.0],
            [2.0, 0.0, 0.0],
            [2.0, 0.0, 1.0],
            [1.0, 0.0, 1.5],
        ];
        let cells = vec![
            (HEXAHEDRON, vec![0, 1, 2, 3, 4, 5, 6, 7]),
            (PYRAMID, vec![4, 5, 6, 7, 8]),
            (PRISM, vec![1, 9, 2, 5, 10, 6]),
            (TETRAHEDRON, vec![5, 10, 6, 11]),
            (TRIANGLE, vec![0, 1, 2]),
        ];
        Self { points: points.map(DVec3::from).to_vec(), cells }
    }

    /// A tetrahedron of second order and a plain one.
    pub fn curved() -> Self {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let middles = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)].map(|(a, b)| 0.5 * (corners[a] + corners[b]));
        let points = corners.into_iter().chain(middles).chain([-DVec3::X]).collect();
        Self { points, cells: vec![(CURVED, (0..10).collect()), (TETRAHEDRON, vec![0, 2, 10, 3])] }
    }

    /// The cells of each kind, in the order of their first ones.
    fn blocks(&self) -> Vec<(Kind, Vec<&[u32]>)> {
        let mut blocks: Vec<(Kind, Vec<&[u32]>)> = Vec::new();
        for (kind, cell) in &self.cells {
            match blocks.iter_mut().find(|block| block.0 == *kind) {
                Some(block) => block.1.push(cell),
                None => blocks.push((*kind, vec![cell])),
            }
        }
        blocks
    }
}

/// How a file has its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Encoding {
    Text,
    Little,
    Big,
}

/// A file that grows by numbers.
pub struct File {
    pub bytes: Vec<u8>,
    encoding: Encoding,
}

impl File {
    pub fn new(encoding: Encoding) -> Self {
        Self { bytes: Vec::new(), encoding }
    }

    pub fn text(&mut self, text: impl AsRef<str>) -> &mut Self {
        self.bytes.extend(text.as_ref().bytes());
        self
    }

    fn number<const N: usize>(&mut self, text: String, mut bytes: [u8; N]) -> &mut Self {
        match self.encoding {
            Encoding::Text => return self.text(text + " "),
            Encoding::Little => {}
            Encoding::Big => bytes.reverse(),
        }
        self.bytes.extend(bytes);
        self
    }

    pub fn int(&mut self, value: i32) -> &mut Self {
        self.number(value.to_string(), value.to_le_bytes())
    }

    pub fn long(&mut self, value: i64) -> &mut Self {
        self.number(value.to_string(), value.to_le_bytes())
    }

    pub fn float(&mut self, value: f64) -> &mut Self {
        self.number(value.to_string(), (value as f32).to_le_bytes())
    }

    pub fn double(&mut self, value: f64) -> &mut Self {
        self.number(value.to_string(), value.to_le_bytes())
    }

    /// The end of a line, in text alone.
    fn end(&mut self) -> &mut Self {
        if self.encoding == Encoding::Text { self.text("\n") } else { self }
    }
}

pub fn medit_text(mesh: &Mesh) -> Vec<u8> {
    let mut text = String::from("# a comment\nMeshVersionFormatted 2\nDimension\n3\n\nNormals 1 0 0 1\n");
    let mut blocks = mesh.blocks();
    // Cells may come before vertices.
    let last = blocks.split_off(1);
    let write = |blocks: &[(Kind, Vec<&[u32]>)], text: &mut String| {
        for (kind, cells) in blocks {
            write!(text, "{}\n{}\n", kind.2, cells.len()).unwrap();
            for cell in cells {
                cell.iter().for_each(|corner| write!(text, "{} ", corner + 1).unwrap());
                text.push_str("7 # reference\n");
            }
        }
    };
    write(&blocks, &mut text);
    writeln!(text, "Vertices {}", mesh.points.len()).unwrap();
    mesh.points.iter().for_each(|point| writeln!(text, "{} {} {} 0", point.x, point.y, point.z).unwrap());
    write(&last, &mut text);
    text.push_str("End\nafter the end");
    text.into_bytes()
}

pub fn medit_binary(mesh: &Mesh, version: i32, encoding: Encoding) -> Vec<u8> {
    let mut file = File::new(encoding);
    file.int(1).int(version);
    let place = |file: &mut File, bytes: usize| {
        let size = if version >= 3 { 8 } else { 4 };
        let next = file.bytes.len() + size + bytes;
        if version >= 3 {
            file.long(next as i64)
        } else {
            file.int(next as i32)
        };
    };
    let whole = |file: &mut File, value: usize| {
        if version == 4 {
            file.long(value as i64)
        } else {
            file.int(value as i32)
        };
    };
    let (int, real) = (if version == 4 { 8 } else { 4 }, if version == 1 { 4 } else { 8 });
    file.int(3);
    place(&mut file, 4);
    file.int(3);
    // A section that is skipped: corners.
    file.int(13);
    place(&mut file, 2 * int);
    whole(&mut file, 1);
    whole(&mut file, 1);
    file.int(4);
    place(&mut file, int + mesh.points.len() * (3 * real + int));
    whole(&mut file, mesh.points.len());
    for point in &mesh.points {
        for coordinate in point.to_array() {
            if version == 1 {
                file.float(coordinate)
            } else {
                file.double(coordinate)
            };
        }
        whole(&mut file, 0);
    }
    for (kind, cells) in mesh.blocks() {
        file.int(kind.3);
        place(&mut file, int + cells.len() * (cells[0].len() + 1) * int);
        whole(&mut file, cells.len());
        for cell in cells {
            cell.iter().for_each(|&corner| whole(&mut file, corner as usize + 1));
            whole(&mut file, 7);
        }
    }
    file.int(54);
    place(&mut file, 0);
    file.bytes
}

/// Nodes are counted from 5, backward.
fn node(mesh: &Mesh, vertex: u32) -> i32 {
    4 + (mesh.points.len() as i32 - vertex as i32)
}

fn gmsh_head(version: &str, encoding: Encoding) -> File {
    let mut file = File::new(encoding);
    file.text(format!("$MeshFormat\n{version} {} 8\n", i32::from(encoding != Encoding::Text)));
    if encoding != Encoding::Text {
        file.int(1).text("\n");
    }
    file.text("$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"$Nodes of all\"\n$EndPhysicalNames\n");
    file
}

pub fn gmsh_rows(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let mut file = gmsh_head("2.2", encoding);
    file.text(format!("$Nodes\n{}\n", mesh.points.len()));
    for (vertex, point) in (0..).zip(&mesh.points) {
        file.int(node(mesh, vertex));
        point.to_array().iter().for_each(|&coordinate| {
            file.double(coordinate);
        });
        file.end();
    }
    file.text(format!("\n$EndNodes\n$Elements\n{}\n", mesh.cells.len()));
    let mut number = 0;
    for (kind, cells) in mesh.blocks() {
        if encoding != Encoding::Text {
            file.int(kind.1).int(cells.len() as i32).int(2);
        }
        for cell in cells {
            number += 1;
            file.int(number);
            if encoding == Encoding::Text {
                file.int(kind.1).int(2);
            }
            file.int(3).int(1);
            cell.iter().for_each(|&corner| {
                file.int(node(mesh, corner));
            });
            file.end();
        }
    }
    file.text("\n$EndElements\n");
    file.bytes
}

/// `is_tagged`: version 4.0, else 4.1.
pub fn gmsh_blocks(mesh: &Mesh, is_tagged: bool, encoding: Encoding) -> Vec<u8> {
    let mut file = gmsh_head(if is_tagged { "4.0" } else { "4.1" }, encoding);
    let count = mesh.points.len();
    file.text("$Nodes\n").long(2).long(count as i64);
    if !is_tagged {
        file.long(5).long(4 + count as i64);
    }
    // The first block has parameters: it is of a surface.
    for (dimension, block) in [(2, 0..3), (3, 3..count)] {
        let entity = if is_tagged { [1, dimension] } else { [dimension, 1] };
        file.end().int(entity[0]).int(entity[1]).int(i32::from(dimension == 2)).long(block.len() as i64).end();
        if !is_tagged {
            block.clone().for_each(|vertex| {
                file.long(node(mesh, vertex as u32).into()).end();
            });
        }
        for vertex in block {
            if is_tagged {
                file.int(node(mesh, vertex as u32));
            }
            mesh.points[vertex].to_array().iter().for_each(|&coordinate| {
                file.double(coordinate);
            });
            if dimension == 2 {
                file.double(0.25).double(0.75);
            }
            file.end();
        }
    }
    let blocks = mesh.blocks();
    file.text("\n$EndNodes\n$Elements\n").long(blocks.len() as i64).long(mesh.cells.len() as i64);
    if !is_tagged {
        file.long(1).long(mesh.cells.len() as i64);
    }
    for (kind, cells) in blocks {
        file.end().int(3).int(1).int(kind.1).long(cells.len() as i64).end();
        for (number, cell) in (1..).zip(cells) {
            if is_tagged {
                file.int(number)
            } else {
                file.long(number.into())
            };
            for &corner in cell {
                let number = node(mesh, corner);
                if is_tagged {
                    file.int(number)
                } else {
                    file.long(number.into())
                };
            }
            file.end();
        }
    }
    file.text("\n$EndElements\n$NodeData\n1\n\"a view\"\n$EndNodeData\n");
    file.bytes
}

/// Legacy; bytes are big-endian.
pub fn vtk(mesh: &Mesh, encoding: Encoding) -> Vec<u8> {
    let mut file = File::new(encoding);
    let name = if encoding == Encoding::Text { "ASCII" } else { "BINARY" };
    file.text(format!("# vtk DataFile Version 3.0\nmesh\n{name}\nDATASET UNSTRUCTURED_GRID\n"));
    file.text(format!("POINTS {} double\n", mesh.points.len()));
    mesh.points.iter().flat_map(|point| point.to_array()).for_each(|coordinate| {
        file.double(coordinate);
    });
    let length: usize = mesh.cells.iter().map(|(_, cell)| 1 + cell.len()).sum();
    file.text(format!("\nCELLS {} {length}\n", mesh.cells.len()));
    for (_, cell) in &mesh.cells {
        file.int(cell.len() as i32);
        cell.iter().for_each(|&corner| {
            file.int(corner as i32);
        });
    }
    file.text(format!("\nCELL_TYPES {}\n", mesh.cells.len()));
    mesh.cells.iter().for_each(|(kind, _)| {
        file.int(kind.0.into());
    });
    file.text("\n");
    file.bytes
}

/// Nodes and elements, counted from `first`; of the tetrahedra alone.
pub fn tetgen(mesh: &Mesh, first: usize) -> [Vec<u8>; 2] {
    let mut nodes = format!("# nodes\n{} 3 1 1\n", mesh.points.len());
    for (number, point) in (first..).zip(&mesh.points) {
        writeln!(nodes, "{number} {} {} {}  0.5 1", point.x, point.y, point.z).unwrap();
    }
    let cells: Vec<_> = mesh.cells.iter().filter(|(kind, _)| *kind == TETRAHEDRON).collect();
    let mut elements = format!("{} 4 1\n", cells.len());
    for (number, (_, cell)) in (first..).zip(cells) {
        write!(elements, "  {number}").unwrap();
        cell.iter().for_each(|&corner| write!(elements, "  {}", corner as usize + first).unwrap());
        elements.push_str("  1.0\n");
    }
    elements.push_str("# Generated by tetgen\n");
    [nodes.into_bytes(), elements.into_bytes()]
}
