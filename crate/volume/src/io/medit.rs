//! Medit and libMeshb (`.mesh`, `.meshb`; Maréchal, "Handling unstructured meshes in the Gamma Mesh Format", libMeshb 7): text,
//! or bytes of versions 1 to 4 in either order. Sections that are no vertices or cells are skipped.

use glam::DVec3;
use heatwalk_model::io::Budget;

use super::cells::{Kind, NamedCells, NamedMesh, Numbers, Shape};
use super::error::Result;
use super::input::{Encoding, Input};

const MEDIT: &str = "Medit";

/// What a text file begins with, after white space and comments.
const HEADER: &str = "MeshVersionFormatted";

/// First number of a binary file.
const ONE: i32 = 1;

/// Keywords of binary files that are no list of items, or are read here.
const DIMENSION: i64 = 3;
const VERTICES: i64 = 4;
const END: i64 = 54;

/// The sections of cells: keyword as text and as a number, kind, and nodes.
const CELLS: [(&str, i64, Kind, usize); 16] = [
    ("Triangles", 6, Kind::Face(3), 3),
    ("Quadrilaterals", 7, Kind::Face(4), 4),
    ("TrianglesP2", 24, Kind::Face(3), 6),
    ("QuadrilateralsQ2", 27, Kind::Face(4), 9),
    ("TrianglesP3", 90, Kind::Face(3), 10),
    ("TrianglesP4", 91, Kind::Face(3), 15),
    ("Tetrahedra", 8, Kind::Solid(Shape::Tetrahedron), 4),
    ("Prisms", 9, Kind::Solid(Shape::Prism), 6),
    ("Hexahedra", 10, Kind::Solid(Shape::Hexahedron), 8),
    ("Pyramids", 49, Kind::Solid(Shape::Pyramid), 5),
    ("TetrahedraP2", 30, Kind::Solid(Shape::Tetrahedron), 10),
    ("HexahedraQ2", 33, Kind::Solid(Shape::Hexahedron), 27),
    ("PrismsP2", 86, Kind::Solid(Shape::Prism), 18),
    ("PyramidsP2", 87, Kind::Solid(Shape::Pyramid), 14),
    ("TetrahedraP3", 96, Kind::Solid(Shape::Tetrahedron), 20),
    ("TetrahedraP4", 97, Kind::Solid(Shape::Tetrahedron), 35),
];

pub fn has_header(bytes: &[u8]) -> bool {
    binary(bytes).is_some() || text(bytes).word() == Some(HEADER)
}

fn text(bytes: &[u8]) -> Input<'_> {
    Input::new(MEDIT, bytes, Encoding::Text { comment: Some(b'#') })
}

/// The bytes after the head of a binary file, and its version.
fn binary(bytes: &[u8]) -> Option<(Input<'_>, i64)> {
    let is_little = match *bytes.first_chunk::<4>()? {
        head if head == ONE.to_le_bytes() => true,
        head if head == ONE.to_be_bytes() => false,
        _ => return None,
    };
    let mut input = Input::new(MEDIT, bytes, Encoding::Binary { is_little });
    input.seek(size_of_val(&ONE));
    let version = input.int("the version").ok().filter(|version| (1..=4).contains(version))?;
    Some((input, version))
}

pub fn read<'a>(budget: &'a Budget, bytes: &[u8]) -> Result<NamedMesh<'a>> {
    let mut mesh = Mesh { budget, positions: Vec::new(), cells: NamedCells::new(budget) };
    match binary(bytes) {
        Some((input, version)) => mesh.read_binary(input, version)?,
        None => mesh.read_text(text(bytes))?,
    }
    let numbers = Numbers::From(1, mesh.positions.len() as u32);
    Ok(NamedMesh { format: MEDIT, positions: mesh.positions, numbers, cells: mesh.cells })
}

/// What was read so far.
struct Mesh<'a> {
    budget: &'a Budget,
    positions: Vec<DVec3>,
    /// By vertices counted from 1.
    cells: NamedCells<'a>,
}

impl Mesh<'_> {
    fn read_text(&mut self, mut input: Input) -> Result<()> {
        while let Some(keyword) = input.word() {
            match keyword {
                "End" => break,
                HEADER => drop(input.int("the version")?),
                "Dimension" => dimension(&mut input)?,
                "Vertices" => self.vertices(&mut input, 2)?,
                // Numbers of sections that are skipped, too.
                _ => {
                    if let Some(&(_, _, kind, nodes)) = CELLS.iter().find(|section| section.0 == keyword) {
                        self.section(&mut input, kind, nodes, 2)?;
                    }
                }
            }
        }
        Ok(())
    }

    fn read_binary(&mut self, mut input: Input, version: i64) -> Result<()> {
        loop {
            let keyword = input.int("a keyword")?;
            if keyword == END {
                return Ok(());
            }
            let next = if version >= 3 { input.long("the next place")? } else { input.int("the next place")? };
            match keyword {
                DIMENSION => dimension(&mut input)?,
                VERTICES => self.vertices(&mut input, version)?,
                _ => {
                    if let Some(&(_, _, kind, nodes)) = CELLS.iter().find(|section| section.1 == keyword) {
                        self.section(&mut input, kind, nodes, version)?;
                    }
                }
            }
            // The end may be meant, and nothing leads back into what was read.
            let next = usize::try_from(next).unwrap_or_default();
            if next == 0 {
                return Ok(());
            }
            if next < input.position() || next > input.position() + input.rest().len() {
                return Err(input.damaged(&format!("the section before goes on at byte {next}")).into());
            }
            input.seek(next);
        }
    }

    fn vertices(&mut self, input: &mut Input, version: i64) -> Result<()> {
        let count = whole(input, version, "the number of vertices")?;
        let count = input.count(count, "the number of vertices")?;
        self.budget.reserve(&mut self.positions, input.plausible(count))?;
        for _ in 0..count {
            let mut position = [0.0; 3];
            for coordinate in &mut position {
                let what = "a coordinate of a vertex";
                *coordinate = if version == 1 { input.float(what)? } else { input.double(what)? };
            }
            whole(input, version, "the reference of a vertex")?;
            self.budget.push(&mut self.positions, position.into())?;
        }
        Ok(())
    }

    fn section(&mut self, input: &mut Input, kind: Kind, nodes: usize, version: i64) -> Result<()> {
        let count = whole(input, version, "the number of cells")?;
        let count = input.count(count, "the number of cells")?;
        for _ in 0..count {
            for node in 0..nodes {
                let vertex = whole(input, version, "a vertex of a cell")?;
                if node < kind.corner_count() {
                    self.cells.corner(kind, input.count(vertex, "a vertex of a cell")? as u64)?;
                }
            }
            whole(input, version, "the reference of a cell")?;
            self.cells.end(kind, nodes > kind.corner_count())?;
        }
        Ok(())
    }
}

fn dimension(input: &mut Input) -> Result<()> {
    match input.int("the dimension")? {
        3 => Ok(()),
        other => Err(input.unsupported(format!("the dimension {other}"), "give every vertex three coordinates").into()),
    }
}

/// A whole number of the size that a version has.
fn whole(input: &mut Input, version: i64, what: &str) -> Result<i64> {
    if version >= 4 { input.long(what) } else { input.int(what) }
}
