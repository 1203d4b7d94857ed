//! VTK (Kitware, "VTK File Formats"): the surfaces of polygonal data and unstructured grids, in legacy files (`.vtk`), ASCII or
//! binary, and in XML files (`.vtp`, `.vtu`), ASCII, base64 or appended, compressed by zlib or not. Of curved cells the corners are
//! read. What fills space is no surface; [`volumes`] gives it to those who know what to do with it.

mod base64;
mod document;
mod legacy;
mod piece;

use glam::DVec3;
use heatwalk_surface::{Soup, Warning, WarningCode, Warnings};

use self::piece::{Piece, VTK};
use super::scalar::whole;
use crate::error::Result;
use crate::io::budget::Budget;
use crate::io::format::Format;
use crate::model::Model;

/// The cells of a file that fill space, of all its pieces.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct VolumeCells {
    /// `#P × 3`, all points in file order, in the file's unit.
    pub positions: Vec<DVec3>,
    /// The type of each cell, as in `vtkCellType.h`.
    pub kinds: Vec<u64>,
    /// The points of all cells, one cell after another, as indices into `positions`.
    pub points: Vec<u32>,
    /// Of each cell, where its points end.
    pub ends: Vec<usize>,
    /// How many cells are faces, which are left out.
    pub faces: usize,
    /// What else was left out.
    pub warnings: Vec<Warning>,
}

pub(super) const FORMAT: Format = Format {
    extensions: &["vtk", "vtp", "vtu"],
    is: has_header,
    read: |budget, name, bytes, _| read(budget, name, bytes).map(Model::from),
    upward: None,
};

/// Whether the file begins as one of either kind does.
pub fn has_header(bytes: &[u8]) -> bool {
    legacy::has_header(bytes) || document::has_header(bytes)
}

fn pieces<'a>(budget: &'a Budget, bytes: &[u8]) -> Result<Vec<Piece<'a>>> {
    Ok(if document::has_header(bytes) { document::read(budget, bytes)? } else { vec![legacy::read(budget, bytes)?] })
}

/// The cells of a file that fill space; none where there is none such.
///
/// # Errors
/// [`Malformed`](crate::Error::Malformed), [`Unsupported`](crate::Error::Unsupported) and
/// [`OverBudget`](crate::Error::OverBudget), as [`read`](super::read).
pub fn volumes(budget: &Budget, bytes: &[u8]) -> Result<VolumeCells> {
    let volumes = volumes_of(budget, bytes);
    budget.finish()?;
    volumes
}

fn volumes_of(budget: &Budget, bytes: &[u8]) -> Result<VolumeCells> {
    let mut all = VolumeCells::default();
    let mut warnings = Warnings::default();
    for piece in pieces(budget, bytes)? {
        let (first, before, count) = (all.positions.len(), all.points.len(), piece.positions.len());
        budget.reserve(&mut all.positions, count)?;
        budget.reserve(&mut all.points, piece.volumes.points.len())?;
        budget.reserve(&mut all.ends, piece.volumes.ends.len())?;
        budget.reserve(&mut all.kinds, piece.volumes.kinds.len())?;
        for (place, &point) in piece.volumes.points.iter().enumerate() {
            let index = whole(point).and_then(|index| usize::try_from(index).ok()).filter(|&index| index < count);
            let number = index.and_then(|index| u32::try_from(first + index).ok());
            all.points.push(number.ok_or_else(|| {
                let cell = piece.volumes.ends.partition_point(|&end| end <= place);
                VTK.at(
                    format!("volume cell {cell}"),
                    format!("it uses point {point}, but there are only {count}; repair the file"),
                )
            })?);
        }
        all.ends.extend(piece.volumes.ends.iter().map(|end| before + end));
        all.kinds.extend(piece.volumes.kinds);
        all.positions.extend(piece.positions);
        all.faces += piece.faces.count();
        warnings.add_many(WarningCode::LinesLeftOut, piece.thin, || "cells".to_owned());
    }
    all.warnings = warnings.into_vec();
    Ok(all)
}

/// What a type of cells is called (`vtkCellType.h`), where it has no points in a fixed order or is not known at all.
pub fn cell_name(kind: u64) -> String {
    match kind {
        41 => "a convex point set".to_owned(),
        42 => "a polyhedron".to_owned(),
        51..=56 => "a parametric cell".to_owned(),
        other => format!("a cell of type {other}"),
    }
}

pub(super) fn read(budget: &Budget, name: &str, bytes: &[u8]) -> Result<Soup> {
    let pieces = pieces(budget, bytes)?;
    let mut soup = Soup::default();
    let mut warnings = Warnings::default();
    let count = pieces.len();
    for (index, piece) in pieces.into_iter().enumerate() {
        let of_piece = if count == 1 { String::new() } else { format!("piece {index}, ") };
        let first = soup.positions.len() as u32;
        let place = |face: usize| format!("{of_piece}face {face}");
        piece
            .faces
            .check(piece.positions.len())
            .map_err(|missing| VTK.no_vertex(place(missing.polygon), missing.vertex, piece.positions.len(), 0))?;
        let (triangles, polygons) = piece.faces.triangulate_all(&piece.positions, &mut warnings, place)?;
        let before = soup.triangles.len();
        budget.reserve(&mut soup.polygons, polygons.len())?;
        soup.polygons.extend(polygons.into_iter().map(|range| before + range.start..before + range.end));
        budget.reserve(&mut soup.triangles, triangles.len())?;
        budget.reserve(&mut soup.positions, piece.positions.len())?;
        soup.triangles.extend(triangles.into_iter().map(|corners| corners.map(|vertex| first + vertex)));
        soup.positions.extend(piece.positions);
        soup.end_part(if count == 1 { name.to_owned() } else { format!("{name} {index}") });
        warnings.add_many(WarningCode::VolumesLeftOut, piece.volumes.kinds.len(), || format!("{of_piece}cells"));
        warnings.add_many(WarningCode::LinesLeftOut, piece.thin, || format!("{of_piece}cells"));
        warnings.add_many(WarningCode::Straightened, piece.curved, || format!("{of_piece}cells"));
    }
    soup.warnings = warnings.into_vec();
    Ok(soup)
}
