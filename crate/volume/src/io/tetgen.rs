//! TetGen (`.node` and `.ele`; Si, "TetGen 1.5 user's manual", section 5.2): vertices in one file, tetrahedra in the other, counted
//! from 0 or 1 as the first vertex is. Attributes and boundary markers are skipped.

use glam::DVec3;
use heatwalk_model::io::{Budget, text};

use super::cells::{Kind, NamedCells, NamedMesh, Numbers, Shape};
use super::error::Result;
use super::input::{Encoding, Input};

const TETGEN: &str = "TetGen";

/// Nodes of a tetrahedron of second order.
const CURVED: usize = 10;

/// `nodes`, `elements`: the contents of both files.
pub fn read<'a>(budget: &'a Budget, nodes: &[u8], elements: &[u8]) -> Result<NamedMesh<'a>> {
    let (positions, first) = read_nodes(budget, text(nodes))?;
    let cells = read_elements(budget, text(elements))?;
    Ok(NamedMesh { format: TETGEN, numbers: Numbers::From(first, positions.len() as u32), positions, cells })
}

fn text(bytes: &[u8]) -> Input<'_> {
    Input::new(TETGEN, bytes, Encoding::Text { comment: Some(b'#') })
}

fn size(input: &mut Input, what: &str) -> Result<usize> {
    let number = input.long(what)?;
    input.count(number, what)
}

/// The numbers of the first line, the last of which may be left out.
fn header<const N: usize>(input: &mut Input, names: [&str; N], mut header: [usize; N]) -> Result<[usize; N]> {
    let words = input.words();
    if words.is_empty() {
        return Err(input.damaged(&format!("{} is expected, but the file ends", names[0])).into());
    }
    for ((number, word), name) in header.iter_mut().zip(words).zip(names) {
        let found = word.parse();
        *number =
            found.map_err(|_| input.damaged(&format!("{name} is expected, but {} is found", text::quoted(word))))?;
    }
    Ok(header)
}

/// Positions, and the number of the first one.
fn read_nodes(budget: &Budget, mut input: Input) -> Result<(Vec<DVec3>, u64)> {
    let names = ["the number of vertices", "the dimension", "the number of attributes", "the number of markers"];
    let [count, dimension, attributes, markers] = header(&mut input, names, [0, 3, 0, 0])?;
    if dimension != 3 {
        let remedy = "give every vertex three coordinates";
        return Err(input.unsupported(format!("the dimension {dimension}"), remedy).into());
    }
    let mut positions = budget.list(input.plausible(count))?;
    let mut first = 0;
    for index in 0..count as u64 {
        let number = size(&mut input, "the number of a vertex")? as u64;
        if index == 0 {
            first = number;
        } else if number.checked_sub(first) != Some(index) {
            return Err(input.damaged(&format!("vertex {} is expected, but {number} is found", first + index)).into());
        }
        let mut position = [0.0; 3];
        for coordinate in &mut position {
            *coordinate = input.double("a coordinate of a vertex")?;
        }
        for _ in 0..attributes.saturating_add(markers) {
            input.double("an attribute of a vertex")?;
        }
        budget.push(&mut positions, position.into())?;
    }
    Ok((positions, first))
}

fn read_elements<'a>(budget: &'a Budget, mut input: Input) -> Result<NamedCells<'a>> {
    let names = ["the number of tetrahedra", "the number of vertices of a tetrahedron", "the number of attributes"];
    let kind = Kind::Solid(Shape::Tetrahedron);
    let corners = kind.corner_count();
    let [count, nodes, attributes] = header(&mut input, names, [0, corners, 0])?;
    if nodes != corners && nodes != CURVED {
        return Err(input.damaged(&format!("a tetrahedron has 4 or {CURVED} vertices, not {nodes}")).into());
    }
    let mut cells = NamedCells::new(budget);
    for _ in 0..count {
        size(&mut input, "the number of a tetrahedron")?;
        for node in 0..nodes {
            let number = size(&mut input, "a vertex of a tetrahedron")?;
            if node < corners {
                cells.corner(kind, number as u64)?;
            }
        }
        for _ in 0..attributes {
            input.double("an attribute of a tetrahedron")?;
        }
        cells.end(kind, nodes > corners)?;
    }
    Ok(cells)
}
