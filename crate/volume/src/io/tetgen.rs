//! TetGen (`.node` and `.ele`; Si, "TetGen 1.5 user's manual", section 5.2): vertices in one file, tetrahedra in the other, counted
//! from 0 or 1 as the first vertex is. Attributes and boundary markers are skipped.

use glam::DVec3;
use heatwalk::io::Budget;

use super::cells::{CellCounts, NamedCells, Shape};
use super::error::Result;
use super::input::{Encoding, Input};
use crate::soup::TetSoup;

const TETGEN: &str = "TetGen";

/// Nodes of a tetrahedron of second order.
const CURVED: usize = 10;

/// `nodes`, `elements`: the contents of both files.
pub fn read(budget: &Budget, nodes: &[u8], elements: &[u8]) -> Result<(TetSoup, CellCounts)> {
    let (positions, first) = read_nodes(budget, text(nodes))?;
    let cells = read_elements(budget, text(elements))?;
    let count = positions.len() as u64;
    let vertex = |number: u64| number.checked_sub(first).filter(|&index| index < count).map(|index| index as u32);
    Ok(cells.finish(TETGEN, vertex)?.into_soup(positions))
}

fn text(bytes: &[u8]) -> Input<'_> {
    Input::new(TETGEN, bytes, Encoding::Text { comment: Some(b'#') })
}

fn size(input: &mut Input, what: &str) -> Result<usize> {
    let number = input.long(what)?;
    input.count(number, what)
}

/// Positions, and the number of the first one.
fn read_nodes(budget: &Budget, mut input: Input) -> Result<(Vec<DVec3>, u64)> {
    let count = size(&mut input, "the number of vertices")?;
    let dimension = size(&mut input, "the dimension")?;
    if dimension != 3 {
        let remedy = "give every vertex three coordinates";
        return Err(input.unsupported(format!("the dimension {dimension}"), remedy).into());
    }
    let attributes = size(&mut input, "the number of attributes")?;
    let markers = size(&mut input, "the number of markers")?;
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
    let count = size(&mut input, "the number of tetrahedra")?;
    let nodes = size(&mut input, "the number of vertices of a tetrahedron")?;
    let corners = Shape::Tetrahedron.corner_count();
    if nodes != corners && nodes != CURVED {
        return Err(input.damaged(&format!("a tetrahedron has 4 or {CURVED} vertices, not {nodes}")).into());
    }
    let attributes = size(&mut input, "the number of attributes")?;
    let mut cells = NamedCells::new(budget);
    for _ in 0..count {
        size(&mut input, "the number of a tetrahedron")?;
        for node in 0..nodes {
            let number = size(&mut input, "a vertex of a tetrahedron")?;
            if node < corners {
                cells.corner(number as u64)?;
            }
        }
        for _ in 0..attributes {
            input.double("an attribute of a tetrahedron")?;
        }
        cells.end(Shape::Tetrahedron, nodes > corners)?;
    }
    Ok(cells)
}
