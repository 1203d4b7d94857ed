//! VTK (Kitware, "VTK File Formats"): the surfaces of polygonal data and unstructured grids, in legacy files (`.vtk`), ASCII or
//! binary, and in XML files (`.vtp`, `.vtu`), ASCII, base64 or appended, compressed by zlib or not. Of curved cells the corners are
//! read.

mod array;
mod base64;
mod document;
mod legacy;

use glam::DVec3;

use super::reader::Reporter;
use super::triangulate::Polygons;
use crate::error::{Error, Result};
use crate::soup::Soup;

const VTK: Reporter = Reporter("VTK");

/// Whether the file begins as one of either kind does.
pub fn has_header(bytes: &[u8]) -> bool {
    legacy::has_header(bytes) || document::has_header(bytes)
}

pub fn read(name: &str, bytes: &[u8]) -> Result<Soup> {
    let pieces = if document::has_header(bytes) { document::read(bytes)? } else { vec![legacy::read(bytes)?] };
    let mut soup = Soup::default();
    let (count, has_volumes) = (pieces.len(), pieces.iter().any(|piece| piece.has_volumes));
    for (index, piece) in pieces.into_iter().enumerate() {
        let first = soup.positions.len() as u32;
        let triangles = piece.faces.triangulate_all(&piece.positions)?;
        soup.triangles.extend(triangles.into_iter().map(|corners| corners.map(|vertex| first + vertex)));
        soup.positions.extend(piece.positions);
        soup.end_part(if count == 1 { name.to_owned() } else { format!("{name} {index}") });
    }
    if soup.triangles.is_empty() && has_volumes {
        return Err(Error::Unsupported {
            format: "VTK",
            feature: "a mesh whose cells are no faces (tetrahedra, hexahedra, ...)".to_owned(),
            remedy: "extract its surface and save that".to_owned(),
        });
    }
    Ok(soup)
}

/// Points and the faces among the cells over them.
#[derive(Default)]
struct Piece {
    positions: Vec<DVec3>,
    faces: Polygons,
    has_volumes: bool,
}

/// Types of cells (`vtkCellType.h`) that are more than one face, or not simply a polygon of their points.
mod cell {
    pub const STRIP: u64 = 6;
    pub const POLYGON: u64 = 7;
    const TRIANGLE: u64 = 5;
    const PIXEL: u64 = 8;
    const QUAD: u64 = 9;
    /// Quadratic, biquadratic, of higher order, Lagrange, Bézier.
    const CURVED_TRIANGLES: [u64; 5] = [22, 34, 61, 69, 76];
    const CURVED_QUADS: [u64; 6] = [23, 28, 30, 62, 70, 77];
    /// Points, lines, curves.
    const THIN: [u64; 10] = [0, 1, 2, 3, 4, 21, 35, 60, 68, 75];

    /// Which points of a cell are the corners of its face.
    pub enum Corners {
        All,
        Of(&'static [usize]),
        /// It is a point or a line.
        Thin,
        /// It fills space, or is not known.
        Volume,
    }

    pub fn corners(kind: u64) -> Corners {
        match kind {
            POLYGON => Corners::All,
            TRIANGLE => Corners::Of(&[0, 1, 2]),
            QUAD => Corners::Of(&[0, 1, 2, 3]),
            // Points of pixels run along rows.
            PIXEL => Corners::Of(&[0, 1, 3, 2]),
            kind if CURVED_TRIANGLES.contains(&kind) => Corners::Of(&[0, 1, 2]),
            kind if CURVED_QUADS.contains(&kind) => Corners::Of(&[0, 1, 2, 3]),
            kind if THIN.contains(&kind) => Corners::Thin,
            _ => Corners::Volume,
        }
    }
}

impl Piece {
    fn set_positions(&mut self, coordinates: &[f64]) {
        self.positions = coordinates.as_chunks::<3>().0.iter().map(|&position| position.into()).collect();
    }

    /// Adds a cell of a type over some points.
    fn add_cell(&mut self, kind: u64, points: &[f64]) -> Result<()> {
        if kind == cell::STRIP {
            for (index, corners) in points.windows(3).enumerate() {
                // Every second triangle of a strip runs the other way.
                let (second, third) = if index % 2 == 0 { (1, 2) } else { (2, 1) };
                self.add_face([corners[0], corners[second], corners[third]].into_iter())?;
            }
            return Ok(());
        }
        match cell::corners(kind) {
            cell::Corners::All => self.add_face(points.iter().copied()),
            cell::Corners::Of(corners) => {
                let missing =
                    || VTK.at(format!("cell {}", self.faces.count()), "it has too few points; save the file again");
                let corners: Option<Vec<f64>> = corners.iter().map(|&corner| points.get(corner).copied()).collect();
                self.add_face(corners.ok_or_else(missing)?.into_iter())
            }
            cell::Corners::Thin => Ok(()),
            cell::Corners::Volume => {
                self.has_volumes = true;
                Ok(())
            }
        }
    }

    fn add_face(&mut self, points: impl Iterator<Item = f64>) -> Result<()> {
        for point in points {
            let vertex = array::whole(point).ok_or_else(|| {
                VTK.at(
                    format!("face {}", self.faces.count()),
                    "a point index is negative or not whole; repair the file",
                )
            })?;
            self.faces.corner(vertex, self.positions.len())?;
        }
        self.faces.close();
        Ok(())
    }

    /// Adds cells, each of the points from the end of the one before it on.
    fn add_cells(&mut self, points: &[f64], ends: &[f64], kind: impl Fn(usize) -> Option<u64>) -> Result<()> {
        let mut start = 0;
        for (index, &end) in ends.iter().enumerate() {
            let broken = || VTK.at(format!("cell {index}"), "its type or its points are missing; the file is damaged");
            let end = array::whole(end).and_then(|end| usize::try_from(end).ok()).ok_or_else(broken)?;
            let own = points.get(start..end).ok_or_else(broken)?;
            self.add_cell(kind(index).ok_or_else(broken)?, own)?;
            start = end;
        }
        Ok(())
    }
}
