//! VTK (Kitware, "VTK File Formats"): the cells of unstructured grids that fill space, of legacy and XML files.

use heatwalk_model::Error as FileError;
use heatwalk_model::io::{Budget, vtk};

use super::cells::{CellCounts, Cells, Shape};
use super::error::Result;
use crate::soup::TetSoup;

/// A voxel's points run along rows; the ring of a hexahedron goes around.
const VOXEL: u64 = 11;
const VOXEL_CORNERS: [usize; 8] = [0, 1, 3, 2, 4, 5, 7, 6];

pub fn read(budget: &Budget, bytes: &[u8]) -> Result<(TetSoup, CellCounts)> {
    let grid = vtk::volumes(budget, bytes)?;
    let mut cells = Cells::new(budget);
    cells.counts.faces = grid.faces;
    let mut start = 0;
    let mut ring = Vec::new();
    for (index, (&kind, &end)) in grid.kinds.iter().zip(&grid.ends).enumerate() {
        let points = &grid.points[start..end];
        start = end;
        let Some((shape, is_curved)) = shape(kind) else {
            return Err(FileError::Unsupported {
                format: "VTK",
                feature: format!("volume cell {index}, {},", vtk::cell_name(kind)),
                remedy: "save a grid of tetrahedra, hexahedra, wedges and pyramids".to_owned(),
            }
            .into());
        };
        let Some(mut corners) = points.get(..shape.corner_count()) else {
            return Err(FileError::Malformed {
                format: "VTK",
                place: format!("volume cell {index}"),
                problem: "it has too few points; save the file again".to_owned(),
            }
            .into());
        };
        if kind == VOXEL {
            ring.clear();
            ring.extend(VOXEL_CORNERS.map(|corner| corners[corner]));
            corners = &ring;
        }
        cells.add(shape, corners, is_curved)?;
    }
    Ok((TetSoup { positions: grid.positions, tetrahedra: cells.tetrahedra }, cells.counts))
}

/// The shape of a type of cells (`vtkCellType.h`), and whether it is quadratic, of higher order, Lagrange or Bézier.
fn shape(kind: u64) -> Option<(Shape, bool)> {
    Some(match kind {
        10 => (Shape::Tetrahedron, false),
        VOXEL | 12 => (Shape::Hexahedron, false),
        13 => (Shape::Prism, false),
        14 => (Shape::Pyramid, false),
        15 => (Shape::PentagonalPrism, false),
        16 => (Shape::HexagonalPrism, false),
        24 | 64 | 71 | 78 => (Shape::Tetrahedron, true),
        25 | 29 | 33 | 67 | 72 | 79 => (Shape::Hexahedron, true),
        26 | 31 | 32 | 65 | 73 | 80 => (Shape::Prism, true),
        27 | 37 | 66 | 74 | 81 => (Shape::Pyramid, true),
        _ => return None,
    })
}
