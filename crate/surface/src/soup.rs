//! Triangle soup: what a file holds, before any connectivity.

use std::ops::Range;

use glam::DVec3;
use heatwalk_base::sort;

use crate::error::{Error, Result};
use crate::terrain::is_terrain;
use crate::triangle;
use crate::unit::{LengthUnit, Unit, UnitRule};
use crate::warning::Warning;

/// Triangles over shared vertices, in the order of the file.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Soup {
    /// `#V × 3`, input vertices in file order, in the file's unit, node transforms applied.
    #[cfg_attr(feature = "packed", serde(with = "heatwalk_base::packed::plain"))]
    pub positions: Vec<DVec3>,
    /// `#F × 3`, indices into `positions`, in file order. The triangles of a polygon follow each other, in the order of its corners.
    #[cfg_attr(feature = "packed", serde(with = "heatwalk_base::packed::plain"))]
    pub triangles: Vec<[u32; 3]>,
    /// The polygons of more than three corners, each as the range of `triangles` that it is cut into, ascending.
    pub polygons: Vec<Range<usize>>,
    /// The parts in file order, no triangle in two.
    pub parts: Vec<Part>,
    /// Triangles that are no part of the surface, as ranges of `triangles`, ascending: those of parts that were not [chosen](Self::chosen).
    pub inactive: Vec<Range<usize>>,
    /// Of the positions; None where the format does not say.
    pub unit: Option<Unit>,
    /// Further numbers that the file gives each vertex.
    pub attributes: Vec<Attribute>,
    /// What was left out of the file, or taken otherwise than it is written.
    pub warnings: Vec<Warning>,
}

/// Numbers of a file for its vertices that are neither shape nor look: an attribute `_NAME` of glTF, a scalar property of PLY's
/// vertices by its own name.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Attribute {
    /// As the file calls it.
    pub name: String,
    /// `#V`; NaN where the file has none.
    pub values: Vec<f64>,
}

/// A selectable piece of a file: a glTF mesh node, an OBJ group or object, an object of a 3MF file, a whole OFF, PLY or STL file.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Part {
    /// Name in the file, or a made one.
    pub name: String,
    /// Its triangles, as ranges of `Soup::triangles`, ascending; several where the file goes back to a part.
    pub ranges: Vec<Range<usize>>,
}

impl Part {
    /// Without triangles.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), ranges: Vec::new() }
    }

    /// Adds triangles behind those that it has.
    pub fn add(&mut self, triangles: Range<usize>) {
        match self.ranges.last_mut().filter(|last| last.end == triangles.start) {
            Some(last) => last.end = triangles.end,
            None if triangles.is_empty() => {}
            None => self.ranges.push(triangles),
        }
    }

    /// Its triangles, ascending.
    pub fn triangles(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        self.ranges.iter().cloned().flatten()
    }

    /// How many triangles it has.
    pub fn len(&self) -> usize {
        self.ranges.iter().map(Range::len).sum()
    }

    /// Whether it has no triangle.
    pub fn is_empty(&self) -> bool {
        self.ranges.is_empty()
    }
}

impl Soup {
    /// A soup of one part.
    pub fn single(name: &str, positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Self {
        let mut soup = Self { positions, triangles, ..Self::default() };
        soup.end_part(name);
        soup
    }

    /// Adds vertices, and triangles between them, which count them from 0.
    pub fn add(&mut self, positions: impl IntoIterator<Item = DVec3>, triangles: &[[u32; 3]]) {
        let first = self.positions.len() as u32;
        self.positions.extend(positions);
        self.triangles.extend(triangles.iter().map(|corners| corners.map(|corner| first + corner)));
    }

    /// Makes one more part of the triangles that have come since the last one; of none, nothing.
    pub fn end_part(&mut self, name: impl Into<String>) {
        let start = self.parts.last().and_then(|part| part.ranges.last()).map_or(0, |range| range.end);
        let mut part = Part::new(name);
        part.add(start..self.triangles.len());
        if !part.is_empty() {
            self.parts.push(part);
        }
    }

    /// The attribute of this name (`#V`, NaN where the file has none).
    ///
    /// # Errors
    /// [`Error::NoSuchAttribute`].
    pub fn attribute(&self, name: &str) -> Result<&[f64]> {
        let found = self.attributes.iter().find(|attribute| attribute.name == name);
        found.map(|attribute| attribute.values.as_slice()).ok_or_else(|| Error::NoSuchAttribute {
            name: name.to_owned(),
            names: self.attributes.iter().map(|attribute| attribute.name.as_str()).collect::<Vec<_>>().join(", "),
        })
    }

    /// Whether it is a height field along Z whose vertices lie on a grid along X and Y, or, as maps have them, farther from the
    /// origin than the ground is wide: digital elevation models are written so, with Z up and in meters.
    #[must_use]
    pub fn is_terrain(&self) -> bool {
        is_terrain(&self.positions, &self.triangles)
    }

    /// What its lengths are in, by a rule: where that is automatic and the format says no unit, meters for terrains
    /// ([`Self::is_terrain`]), else the one that the size of all of it suggests.
    #[must_use]
    pub fn length_unit(&self, rule: UnitRule) -> LengthUnit {
        match (rule, self.unit) {
            (UnitRule::Is(unit), _) => LengthUnit { unit, is_assumed: false },
            (UnitRule::Automatic, Some(unit)) => LengthUnit { unit: Some(unit), is_assumed: false },
            (UnitRule::Automatic, None) if self.is_terrain() => {
                LengthUnit { unit: Some(Unit::Meter), is_assumed: true }
            }
            (UnitRule::Automatic, None) => {
                let corners = self.triangles.as_flattened().iter();
                let positions = corners.filter_map(|&vertex| self.positions.get(vertex as usize).copied());
                let mut points = positions.filter(|position| position.is_finite());
                let Some(first) = points.next() else { return LengthUnit::default() };
                let (low, high) = points.fold((first, first), |(low, high), point| (low.min(point), high.max(point)));
                // Halves, so that what is as large as numbers can be does not overflow.
                let half_diagonal = triangle::length(0.5 * high - 0.5 * low);
                LengthUnit { unit: Some(Unit::assumed(2.0 * half_diagonal)), is_assumed: true }
            }
        }
    }

    /// Other triangles over its vertices, as one part: with the vertices that they use, in file order.
    ///
    /// # Errors
    /// [`Error::IndexOutOfRange`] where a triangle names a missing vertex.
    pub fn with_triangles(&self, name: &str, triangles: Vec<[u32; 3]>) -> Result<Self> {
        let mut is_kept = vec![false; self.positions.len()];
        mark(&mut is_kept, 0, &triangles)?;
        let mut other = self.over(&is_kept, triangles);
        other.end_part(name);
        Ok(other)
    }

    /// The triangles of the surface, as ranges of `triangles`, ascending.
    pub fn ranges(&self) -> Vec<Range<usize>> {
        complement(&self.inactive, self.triangles.len())
    }

    /// The chosen parts as the whole surface. All vertices and triangles stay, so that they count as in the file.
    ///
    /// # Errors
    /// [`Error::NoSuchPart`].
    pub fn chosen(&self, parts: &[usize]) -> Result<Self> {
        let parts = self.parts_of(parts)?;
        let inactive = complement(&joined(&parts), self.triangles.len());
        Ok(Self { parts, inactive, ..self.clone() })
    }

    /// The chosen parts alone, in file order, with the vertices that they use, in file order. Choosing every part
    /// keeps every vertex, used or not.
    ///
    /// # Errors
    /// As [`Self::selection`].
    pub fn select(&self, parts: &[usize]) -> Result<Self> {
        Ok(self.take(self.selection(parts)?))
    }

    /// What [`Self::select`] takes.
    ///
    /// # Errors
    /// [`Error::NoSuchPart`]; [`Error::IndexOutOfRange`] where a chosen triangle names a missing vertex.
    pub fn selection(&self, parts: &[usize]) -> Result<Selection> {
        let parts = self.parts_of(parts)?;
        if parts.len() == self.parts.len() {
            return Ok(self.active());
        }
        let ranges = joined(&parts);
        let mut is_kept = vec![false; self.positions.len()];
        for range in &ranges {
            mark(&mut is_kept, range.start, &self.triangles[range.clone()])?;
        }
        Ok(Selection { parts, ranges, is_kept })
    }

    /// All but the triangles that are no part of the surface.
    #[must_use]
    pub fn active(&self) -> Selection {
        Selection { parts: self.parts.clone(), ranges: self.ranges(), is_kept: vec![true; self.positions.len()] }
    }

    /// A selection of it as a soup of its own.
    #[must_use]
    pub fn take(&self, selection: Selection) -> Self {
        let Selection { mut parts, ranges, is_kept } = selection;
        // How many triangles come before each range.
        let before: Vec<usize> =
            ranges.iter().scan(0, |sum, range| Some(std::mem::replace(sum, *sum + range.len()))).collect();
        // Where triangles that are kept come to; none where they are not.
        let moved = |range: &Range<usize>| {
            let index = ranges.partition_point(|joined| joined.end <= range.start);
            let start = before.get(index)? + range.start.checked_sub(ranges[index].start)?;
            Some(start..start + range.len())
        };
        for part in &mut parts {
            let kept = std::mem::take(&mut part.ranges);
            kept.iter().filter_map(moved).for_each(|range| part.add(range));
        }
        let polygons = self.polygons.iter().filter_map(moved).collect();
        let mut triangles = Vec::new();
        for range in ranges {
            triangles.extend_from_slice(&self.triangles[range]);
        }
        Self { parts, polygons, ..self.over(&is_kept, triangles) }
    }

    /// Some of its parts, in file order.
    fn parts_of(&self, chosen: &[usize]) -> Result<Vec<Part>> {
        let parts = self.parts.len();
        let mut is_chosen = vec![false; parts];
        for &part in chosen {
            *is_chosen.get_mut(part).ok_or(Error::NoSuchPart { part, parts })? = true;
        }
        Ok(self.parts.iter().zip(is_chosen).filter(|&(_, is_chosen)| is_chosen).map(|(part, _)| part.clone()).collect())
    }

    /// Some of its vertices, with triangles over them that are yet numbered as all of them are; without parts.
    fn over(&self, is_kept: &[bool], mut triangles: Vec<[u32; 3]>) -> Self {
        let mut number = vec![u32::MAX; self.positions.len()];
        let mut positions = Vec::new();
        for (vertex, _) in is_kept.iter().enumerate().filter(|&(_, &is_kept)| is_kept) {
            number[vertex] = positions.len() as u32;
            positions.push(self.positions[vertex]);
        }
        for corner in triangles.iter_mut().flatten() {
            *corner = number[*corner as usize];
        }
        let of_kept = |attribute: &Attribute| {
            let values = attribute.values.iter().zip(is_kept).filter(|&(_, &is_kept)| is_kept);
            Attribute { name: attribute.name.clone(), values: values.map(|(&value, _)| value).collect() }
        };
        Self {
            positions,
            triangles,
            unit: self.unit,
            attributes: self.attributes.iter().map(of_kept).collect(),
            warnings: self.warnings.clone(),
            ..Self::default()
        }
    }
}

/// Triangles and vertices of a soup that a smaller one is made of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Selection {
    /// Numbered as all triangles are.
    parts: Vec<Part>,
    /// The triangles, ascending, those of all its parts among them.
    ranges: Vec<Range<usize>>,
    /// `#V`; those of its triangles at least.
    is_kept: Vec<bool>,
}

impl Selection {
    /// The triangles that are kept, ascending.
    pub fn triangles(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        self.ranges.iter().cloned().flatten()
    }

    /// `#V`, whether a vertex is kept.
    #[must_use]
    pub fn is_kept(&self) -> &[bool] {
        &self.is_kept
    }
}

/// Marks the vertices of triangles that are numbered from `first`.
fn mark(is_used: &mut [bool], first: usize, triangles: &[[u32; 3]]) -> Result<()> {
    let vertices = is_used.len();
    for (triangle, corners) in (first..).zip(triangles) {
        for &vertex in corners {
            let missing = Error::IndexOutOfRange { triangle, vertex: vertex.into(), vertices };
            *is_used.get_mut(vertex as usize).ok_or(missing)? = true;
        }
    }
    Ok(())
}

/// What of `0..count` is in none of some ranges, ascending.
fn complement(ranges: &[Range<usize>], count: usize) -> Vec<Range<usize>> {
    let starts = [0].into_iter().chain(ranges.iter().map(|range| range.end));
    let ends = ranges.iter().map(|range| range.start).chain([count]);
    starts.zip(ends).map(|(start, end)| start..end).filter(|range| !range.is_empty()).collect()
}

/// The triangles of some parts, as ranges, ascending.
fn joined(parts: &[Part]) -> Vec<Range<usize>> {
    let mut ranges: Vec<Range<usize>> = parts.iter().flat_map(|part| part.ranges.iter().cloned()).collect();
    sort::sort_by_key(&mut ranges, |range| range.start);
    let mut joined = Part::new("");
    ranges.into_iter().for_each(|range| joined.add(range));
    joined.ranges
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    /// A triangle whose bounding box has this diagonal, and a vertex far away that it does not use.
    fn of_size(diagonal: f64) -> Soup {
        let positions = vec![DVec3::ZERO, DVec3::X * 0.6 * diagonal, DVec3::Y * 0.8 * diagonal, DVec3::splat(1e9)];
        Soup::single("triangle", positions, vec![[0, 1, 2]])
    }

    #[test]
    fn the_size_suggests_a_unit_where_nothing_says_one() {
        let assumed = |unit| LengthUnit { unit: Some(unit), is_assumed: true };
        let sizes = [(0.2, Unit::Meter), (9.9, Unit::Meter), (10.1, Unit::Millimeter), (250.0, Unit::Millimeter)];
        for (diagonal, unit) in sizes.into_iter().chain([(9_999.0, Unit::Millimeter), (10_001.0, Unit::Meter)]) {
            assert_eq!(of_size(diagonal).length_unit(UnitRule::Automatic), assumed(unit), "{diagonal}");
        }
        assert_eq!(of_size(f64::MAX).length_unit(UnitRule::Automatic), assumed(Unit::Meter));
        assert_eq!(Soup::default().length_unit(UnitRule::Automatic), LengthUnit::default());
    }

    #[test]
    fn what_is_known_is_not_assumed() {
        let known = |unit| LengthUnit { unit, is_assumed: false };
        let stated = Soup { unit: Some(Unit::Inch), ..of_size(100.0) };
        assert_eq!(stated.length_unit(UnitRule::Automatic), known(Some(Unit::Inch)));
        for unit in [Some(Unit::Kilometer), None] {
            assert_eq!(stated.length_unit(UnitRule::Is(unit)), known(unit));
            assert_eq!(of_size(100.0).length_unit(UnitRule::Is(unit)), known(unit));
        }
    }
}
