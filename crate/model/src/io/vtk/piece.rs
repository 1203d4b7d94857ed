//! Cells to faces.

use glam::DVec3;

use crate::error::Result;
use crate::io::budget::Budget;
use crate::io::reader::Reporter;
use crate::io::scalar::whole;
use crate::io::triangulate::Polygons;

pub const VTK: Reporter = Reporter("VTK");

/// Points and the faces among the cells over them.
pub struct Piece<'a> {
    budget: &'a Budget,
    pub positions: Vec<DVec3>,
    pub faces: Polygons<'a>,
    /// How many points and lines were left out.
    pub thin: usize,
    /// Of how many faces the corners were taken, because they are curved.
    pub curved: usize,
    /// The cells that are no faces.
    pub volumes: Volumes,
}

/// Cells that are neither faces nor lines nor points, by their types and points.
#[derive(Default)]
pub struct Volumes {
    pub kinds: Vec<u64>,
    pub points: Vec<f64>,
    /// Of each cell, where its points end.
    pub ends: Vec<usize>,
}

/// Types of cells (`vtkCellType.h`) that are more than one face, or not simply a polygon of their points.
pub mod cell {
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

impl<'a> Piece<'a> {
    pub fn new(budget: &'a Budget) -> Self {
        Self {
            budget,
            positions: Vec::new(),
            faces: Polygons::new(budget),
            thin: 0,
            curved: 0,
            volumes: Volumes::default(),
        }
    }

    /// The positions, three numbers each.
    pub fn set_positions(&mut self, coordinates: &[f64]) -> Result<()> {
        let coordinates = coordinates.as_chunks::<3>().0;
        self.positions = self.budget.list(coordinates.len())?;
        self.positions.extend(coordinates.iter().copied().map(DVec3::from));
        Ok(())
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
                self.curved += usize::from(corners.len() < points.len());
                let corners: Option<Vec<f64>> = corners.iter().map(|&corner| points.get(corner).copied()).collect();
                self.add_face(corners.ok_or_else(missing)?.into_iter())
            }
            cell::Corners::Thin => {
                self.thin += 1;
                Ok(())
            }
            cell::Corners::Volume => {
                let Volumes { kinds, points: all, ends } = &mut self.volumes;
                self.budget.push(kinds, kind)?;
                self.budget.reserve(all, points.len())?;
                all.extend(points);
                self.budget.push(ends, all.len())
            }
        }
    }

    fn add_face(&mut self, points: impl Iterator<Item = f64>) -> Result<()> {
        for point in points {
            let vertex = whole(point).ok_or_else(|| {
                VTK.at(
                    format!("face {}", self.faces.count()),
                    "a point index is negative or not whole; repair the file",
                )
            })?;
            self.faces.corner(vertex)?;
        }
        self.faces.close()
    }

    /// Adds cells, each of the points from the end of the one before it on.
    pub fn add_cells(&mut self, points: &[f64], ends: &[f64], kind: impl Fn(usize) -> Option<u64>) -> Result<()> {
        let mut start = 0;
        for (index, &end) in ends.iter().enumerate() {
            let broken = || VTK.at(format!("cell {index}"), "its type or its points are missing; the file is damaged");
            let end = whole(end).and_then(|end| usize::try_from(end).ok()).ok_or_else(broken)?;
            let own = points.get(start..end).ok_or_else(broken)?;
            self.add_cell(kind(index).ok_or_else(broken)?, own)?;
            start = end;
        }
        Ok(())
    }
}
