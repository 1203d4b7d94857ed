//! Cells of other shapes into tetrahedra.
//!
//! Every face is split by diagonals through its vertex of the lowest number, so that two cells agree on a face which they share
//! (Dompierre, Labbé, Vallet, Camarero, "How to subdivide pyramids, prisms, and hexahedra into tetrahedra", 1999). A cell becomes
//! the tetrahedra from its own lowest vertex to the triangles of the faces that do not have this vertex: two of a pyramid, three
//! of a prism, six of a hexahedron.

use std::collections::HashMap;
use std::fmt;

use glam::DVec3;
use heatwalk::Soup;
use heatwalk::surface::{WarningCode, Warnings};
use heatwalk_model::io::{Budget, triangulate::Polygons};

use super::error::{Error, Result};
use crate::soup::TetSoup;

/// The shape of a cell that fills space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    Tetrahedron,
    Pyramid,
    Prism,
    /// A ring of four corners, then the ring above it.
    Hexahedron,
    PentagonalPrism,
    HexagonalPrism,
}

impl Shape {
    /// How many corners it has, which come first among the nodes of curved cells.
    pub fn corner_count(self) -> usize {
        match self {
            Self::Tetrahedron => 4,
            Self::Pyramid => 5,
            Self::Prism => 6,
            Self::Hexahedron => 8,
            Self::PentagonalPrism => 10,
            Self::HexagonalPrism => 12,
        }
    }

    /// Its faces by their corners, counter-clockwise from outside.
    fn faces(self) -> &'static [&'static [usize]] {
        match self {
            Self::Tetrahedron => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
            Self::Pyramid => &[&[0, 3, 2, 1], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
            Self::Prism => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
            Self::Hexahedron => {
                &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]]
            }
            Self::PentagonalPrism => &[
                &[0, 4, 3, 2, 1],
                &[5, 6, 7, 8, 9],
                &[0, 1, 6, 5],
                &[1, 2, 7, 6],
                &[2, 3, 8, 7],
                &[3, 4, 9, 8],
                &[4, 0, 5, 9],
            ],
            Self::HexagonalPrism => &[
                &[0, 5, 4, 3, 2, 1],
                &[6, 7, 8, 9, 10, 11],
                &[0, 1, 7, 6],
                &[1, 2, 8, 7],
                &[2, 3, 9, 8],
                &[3, 4, 10, 9],
                &[4, 5, 11, 10],
                &[5, 0, 6, 11],
            ],
        }
    }
}

/// What the cells of a file were, before they became tetrahedra.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct CellCounts {
    /// Cells that were tetrahedra.
    pub tetrahedra: usize,
    /// Pyramids, each of which became two tetrahedra.
    pub pyramids: usize,
    /// Prisms (wedges) over triangles, pentagons or hexagons; three tetrahedra and more each.
    pub prisms: usize,
    /// Hexahedra, six tetrahedra each.
    pub hexahedra: usize,
    /// Those of all these cells that were of second or higher order and of which the corners alone were taken.
    pub curved: usize,
    /// Triangles, quadrilaterals and polygons, which were left out.
    pub faces: usize,
}

impl CellCounts {
    /// Cells that fill space.
    pub fn volumes(&self) -> usize {
        self.tetrahedra + self.pyramids + self.prisms + self.hexahedra
    }
}

/// What was changed, in words without a full stop; nothing where nothing was.
impl fmt::Display for CellCounts {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let named = [(self.hexahedra, "hexahedra"), (self.prisms, "prisms"), (self.pyramids, "pyramids")];
        let named: Vec<String> =
            named.iter().filter(|(count, _)| *count > 0).map(|(count, name)| format!("{count} {name}")).collect();
        if !named.is_empty() {
            write!(formatter, "{} were split into tetrahedra", named.join(", "))?;
        }
        if self.curved > 0 {
            let separator = if named.is_empty() { "" } else { "; " };
            write!(formatter, "{separator}of {} curved cells the corners were taken", self.curved)?;
        }
        Ok(())
    }
}

/// What a cell of a file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A point or a line, of which nothing is wanted.
    Thin,
    /// A polygon of so many corners.
    Face(usize),
    Solid(Shape),
}

impl Kind {
    /// How many corners it has, which come first among its nodes.
    pub fn corner_count(self) -> usize {
        match self {
            Self::Thin => 0,
            Self::Face(corners) => corners,
            Self::Solid(shape) => shape.corner_count(),
        }
    }
}

/// Cells that become tetrahedra.
pub struct Cells<'a> {
    budget: &'a Budget,
    pub tetrahedra: Vec<[u32; 4]>,
    pub counts: CellCounts,
}

impl<'a> Cells<'a> {
    pub fn new(budget: &'a Budget) -> Self {
        Self { budget, tetrahedra: Vec::new(), counts: CellCounts::default() }
    }

    /// Adds a cell by its corners, of which some may be equal: hexahedra that stand for prisms are written so.
    pub fn add(&mut self, shape: Shape, corners: &[u32], is_curved: bool) -> Result<()> {
        self.counts.curved += usize::from(is_curved);
        match shape {
            Shape::Tetrahedron => self.counts.tetrahedra += 1,
            Shape::Pyramid => self.counts.pyramids += 1,
            Shape::Prism | Shape::PentagonalPrism | Shape::HexagonalPrism => self.counts.prisms += 1,
            Shape::Hexahedron => self.counts.hexahedra += 1,
        }
        if let (Shape::Tetrahedron, &[a, b, c, d]) = (shape, corners) {
            return Ok(self.budget.push(&mut self.tetrahedra, [a, b, c, d])?);
        }
        let apex = corners.iter().copied().min().unwrap_or_default();
        for face in shape.faces() {
            if face.iter().any(|&corner| corners[corner] == apex) {
                continue;
            }
            let count = face.len();
            let lowest = (0..count).min_by_key(|&place| corners[face[place]]).unwrap_or_default();
            let corner = |step: usize| corners[face[(lowest + step) % count]];
            for step in 1..count - 1 {
                let [a, b, c] = [corner(0), corner(step), corner(step + 1)];
                if a != b && b != c && c != a {
                    self.budget.push(&mut self.tetrahedra, [a, c, b, apex])?;
                }
            }
        }
        Ok(())
    }
}

/// Cells whose vertices are known by the numbers that the file gives them; it may do so after the cells.
pub struct NamedCells<'a> {
    budget: &'a Budget,
    /// Shapes of those that fill space, and whether they are curved.
    solids: Vec<(Shape, bool)>,
    /// Of all these, one after another.
    solid_corners: Vec<u64>,
    /// Corners of each face, and whether it is curved.
    faces: Vec<(u8, bool)>,
    /// Of all faces, one after another.
    face_corners: Vec<u64>,
}

impl<'a> NamedCells<'a> {
    pub fn new(budget: &'a Budget) -> Self {
        Self { budget, solids: Vec::new(), solid_corners: Vec::new(), faces: Vec::new(), face_corners: Vec::new() }
    }

    /// Adds a corner to the cell that the next [`Self::end`] ends.
    pub fn corner(&mut self, kind: Kind, number: u64) -> Result<()> {
        let budget = self.budget;
        match kind {
            Kind::Thin => {}
            Kind::Face(_) => budget.push(&mut self.face_corners, number)?,
            Kind::Solid(_) => budget.push(&mut self.solid_corners, number)?,
        }
        Ok(())
    }

    /// Ends a cell, which has as many corners as its kind.
    pub fn end(&mut self, kind: Kind, is_curved: bool) -> Result<()> {
        let budget = self.budget;
        match kind {
            Kind::Thin => {}
            Kind::Face(corners) => budget.push(&mut self.faces, (corners as u8, is_curved))?,
            Kind::Solid(shape) => budget.push(&mut self.solids, (shape, is_curved))?,
        }
        Ok(())
    }
}

/// What a file holds, as it names it.
pub struct NamedMesh<'a> {
    pub format: &'static str,
    /// In file order.
    pub positions: Vec<DVec3>,
    pub numbers: Numbers,
    pub cells: NamedCells<'a>,
}

impl NamedMesh<'_> {
    fn vertex(&self, element: &'static str, index: usize, number: u64) -> Result<u32> {
        let missing = Error::NoSuchVertex { format: self.format, element, index, vertex: number };
        self.numbers.get(number).ok_or(missing)
    }

    /// The tetrahedra.
    pub fn tetrahedra(self) -> Result<(TetSoup, CellCounts)> {
        let mut cells = Cells::new(self.cells.budget);
        cells.counts.faces = self.cells.faces.len();
        let mut rest = &self.cells.solid_corners[..];
        let mut corners = Vec::new();
        for (index, &(shape, is_curved)) in self.cells.solids.iter().enumerate() {
            let (own, others) = rest.split_at(shape.corner_count());
            corners.clear();
            for &number in own {
                corners.push(self.vertex("cell", index, number)?);
            }
            cells.add(shape, &corners, is_curved)?;
            rest = others;
        }
        Ok((TetSoup { positions: self.positions, tetrahedra: cells.tetrahedra }, cells.counts))
    }

    /// The faces, as one part of a name.
    pub fn surface(self, name: &str) -> Result<Soup> {
        let mut warnings = Warnings::default();
        let mut polygons = Polygons::new(self.cells.budget);
        let mut rest = &self.cells.face_corners[..];
        let place = |face: usize| format!("face {face}");
        for (index, &(corners, is_curved)) in self.cells.faces.iter().enumerate() {
            let (own, others) = rest.split_at(corners.into());
            for &number in own {
                polygons.corner(self.vertex("face", index, number)?.into())?;
            }
            polygons.close()?;
            if is_curved {
                warnings.add(WarningCode::Straightened, || place(index));
            }
            rest = others;
        }
        let (triangles, polygons) = polygons.triangulate_all(&self.positions, &mut warnings, place)?;
        Ok(Soup { polygons, warnings: warnings.into_vec(), ..Soup::single(name, self.positions, triangles) })
    }
}

/// The vertex of each number of a file.
pub enum Numbers {
    /// They follow each other from this one on.
    From(u64, u32),
    Any(HashMap<u64, u32>),
}

impl Numbers {
    pub fn get(&self, number: u64) -> Option<u32> {
        match self {
            Self::From(first, count) => {
                number.checked_sub(*first).and_then(|index| u32::try_from(index).ok()).filter(|index| index < count)
            }
            Self::Any(vertices) => vertices.get(&number).copied(),
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use heatwalk_model::io::Budget;

    use super::{Cells, Shape};

    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// Corners of each shape with a volume of 1 or, of the prisms over polygons, that of the polygon.
    fn solid(shape: Shape) -> (Vec<DVec3>, f64) {
        let ring = |corners: u32| {
            let corner =
                move |k| glam::DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / f64::from(corners)).extend(0.0);
            let points: Vec<DVec3> = (0..corners).map(corner).collect();
            let area = 0.5 * f64::from(corners) * (std::f64::consts::TAU / f64::from(corners)).sin();
            (points.iter().copied().chain(points.iter().map(|&point| point + DVec3::Z)).collect(), area)
        };
        match shape {
            Shape::Tetrahedron => (vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z], 1.0 / 6.0),
            Shape::Pyramid => {
                let square = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y];
                (square.into_iter().chain([DVec3::Z]).collect(), 1.0 / 3.0)
            }
            Shape::Prism => ring(3),
            Shape::Hexahedron => ring(4),
            Shape::PentagonalPrism => ring(5),
            Shape::HexagonalPrism => ring(6),
        }
    }

    #[test]
    fn a_cell_keeps_its_volume_and_orientation_however_it_is_numbered() {
        for shape in [
            Shape::Tetrahedron,
            Shape::Pyramid,
            Shape::Prism,
            Shape::Hexahedron,
            Shape::PentagonalPrism,
            Shape::HexagonalPrism,
        ] {
            let (points, volume) = solid(shape);
            let count = points.len();
            assert_eq!(count, shape.corner_count());
            for step in (1..count).filter(|step| (1..count).all(|k| step * k % count != 0)) {
                for first in 0..count {
                    let corners: Vec<u32> = (0..count).map(|k| ((first + k * step) % count) as u32).collect();
                    let budget = Budget::of_file(0);
                    let mut cells = Cells::new(&budget);
                    cells.add(shape, &corners, false).unwrap();
                    let position = |vertex: u32| points[corners.iter().position(|&corner| corner == vertex).unwrap()];
                    let volumes = cells.tetrahedra.iter().map(|tetrahedron| {
                        let [a, b, c, d] = tetrahedron.map(position);
                        (b - a).cross(c - a).dot(d - a) / 6.0
                    });
                    let volumes: Vec<f64> = volumes.collect();
                    assert!(volumes.iter().all(|&volume| volume > 0.0), "{shape:?} {corners:?}: {volumes:?}");
                    let sum: f64 = volumes.iter().sum();
                    assert!((sum - volume).abs() < 1e-12, "{shape:?} {corners:?}: {sum}");
                }
            }
        }
    }

    #[test]
    fn a_hexahedron_that_stands_for_a_prism_becomes_three_tetrahedra() {
        let budget = Budget::of_file(0);
        let mut cells = Cells::new(&budget);
        cells.add(Shape::Hexahedron, &[0, 1, 2, 2, 4, 5, 6, 6], false).unwrap();
        assert_eq!(cells.tetrahedra.len(), 3);
    }
}
