//! From a soup to a mesh.

use std::collections::HashSet;
use std::ops::RangeInclusive;
use std::sync::OnceLock;

use glam::DVec3;
use heatwalk::surface::MOST_COORDINATE;
use heatwalk::surface::scale::scale;
use heatwalk_base::union_find::UnionFind;

use crate::error::{Error, Result};
use crate::lists::Lists;
use crate::mesh::report::MeshReport;
use crate::mesh::{EDGES, MeshId, NONE, TetMesh, faces, six_volumes};
use crate::soup::TetSoup;

/// Largest coordinates that meshes may have, in their unit: squares of lengths are numbers then, with room for sums of them.
const SIZES: RangeInclusive<f64> = MOST_COORDINATE.recip()..=MOST_COORDINATE;

/// The same where all is computed in the mesh's own unit: eighth powers of edges, which angles are found by, are then normal numbers, also
/// those of edges of a millionth.
const SIZES_OF_PRODUCTS: RangeInclusive<f64> = 1e-30..=1e30;

/// A tetrahedron is flat where its volume is below this share of the cube of its longest edge, over 6: what rounding of its
/// corners to 53 bits makes of four points in a plane that is a few thousand edges from the origin.
const FLAT: f64 = 1e-12;

impl TetMesh {
    /// Checks and connects the tetrahedra of a soup. Flat and duplicate ones are left out, inverted ones are turned, vertices that
    /// none uses are left out; the [report](TetMesh::report) counts all that.
    ///
    /// ```
    /// use glam::DVec3;
    /// use heatwalk_volume::{TetMesh, TetSoup};
    ///
    /// let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    /// let mesh = TetMesh::build(&TetSoup { positions, tetrahedra: vec![[0, 2, 1, 3]] })?;
    /// assert_eq!(mesh.report().inverted_tetrahedra, 1);
    /// assert_eq!(mesh.tetrahedra(), [[0, 1, 2, 3]]);
    /// assert!((mesh.report().volume - 1.0 / 6.0).abs() < 1e-15);
    /// # Ok::<(), heatwalk_volume::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NoTetrahedra`]; [`Error::IndexOutOfRange`]; [`Error::NotFinite`]; [`Error::BadSize`]; [`Error::AllFlat`];
    /// [`Error::NonManifoldFace`]; [`Error::TooMany`].
    pub fn build(soup: &TetSoup) -> Result<Self> {
        let TetSoup { positions, tetrahedra } = soup;
        check(soup)?;
        let unit = unit(size(soup))?;
        let mut report =
            MeshReport { input_vertices: positions.len(), input_tetrahedra: tetrahedra.len(), ..MeshReport::default() };
        let (kept, tetrahedron_of_input) = clean(soup, unit, &mut report);
        if kept.is_empty() {
            return Err(Error::AllFlat { tetrahedra: tetrahedra.len() });
        }
        let mut vertex_of_input = vec![NONE; positions.len()];
        for &vertex in kept.iter().flatten() {
            vertex_of_input[vertex as usize] = 0;
        }
        let mut input_of_vertex = Vec::new();
        for (input, vertex) in vertex_of_input.iter_mut().enumerate().filter(|(_, vertex)| **vertex != NONE) {
            *vertex = input_of_vertex.len() as u32;
            input_of_vertex.push(input as u32);
        }
        let positions: Vec<DVec3> = input_of_vertex.iter().map(|&input| positions[input as usize]).collect();
        let kept: Vec<[u32; 4]> =
            kept.iter().map(|corners| corners.map(|input| vertex_of_input[input as usize])).collect();
        let neighbors = faces::neighbors(positions.len(), &kept)
            .map_err(|error| in_numbers_of_input(error, &tetrahedron_of_input, &input_of_vertex))?;

        let vertices = positions.len();
        let corner = |(tetrahedron, corners): (usize, &[u32; 4])| corners.map(|vertex| (vertex, tetrahedron as u32));
        let around = Lists::group(vertices, || kept.iter().enumerate().flat_map(corner));
        let adjacent = adjacent(&kept, &around);
        let (components, count) = components(vertices, kept.iter().copied());
        report.vertices = vertices;
        report.tetrahedra = kept.len();
        report.components = count;
        report.unreferenced_vertices = vertex_of_input.len() - vertices;
        report.boundary_faces = neighbors.iter().flatten().filter(|&&other| other == NONE).count();
        let corners = |corners: &[u32; 4]| corners.map(|vertex| positions[vertex as usize]);
        report.volume = kept.iter().map(|tetrahedron| six_volumes(corners(tetrahedron))).sum::<f64>() / 6.0;
        Ok(Self {
            id: MeshId::next(),
            unit,
            positions,
            tetrahedra: kept,
            neighbors,
            around,
            adjacent,
            components,
            input_of_vertex,
            vertex_of_input,
            tetrahedron_of_input,
            report,
            boxes: OnceLock::new(),
        })
    }
}

/// Refuses what cannot be numbered or measured.
fn check(TetSoup { positions, tetrahedra }: &TetSoup) -> Result<()> {
    if tetrahedra.is_empty() {
        return Err(Error::NoTetrahedra);
    }
    // Sides are numbered by 32 bits, four a tetrahedron.
    let most = NONE as usize / 4;
    for (what, count) in [("vertices", positions.len()), ("tetrahedra", tetrahedra.len())] {
        if count > most {
            return Err(Error::TooMany { what, count, most });
        }
    }
    for (tetrahedron, corners) in tetrahedra.iter().enumerate() {
        for &vertex in corners {
            let Some(position) = positions.get(vertex as usize) else {
                return Err(Error::IndexOutOfRange { tetrahedron, vertex, vertices: positions.len() });
            };
            if !position.is_finite() {
                return Err(Error::NotFinite { vertex, position: position.to_array() });
            }
        }
    }
    Ok(())
}

/// The largest coordinate of corners by its absolute value.
fn size(TetSoup { positions, tetrahedra }: &TetSoup) -> f64 {
    let of_corner = |&vertex: &u32| positions[vertex as usize].abs().max_element();
    tetrahedra.iter().flatten().map(of_corner).fold(0.0, f64::max)
}

/// As [`TetMesh::unit`], for a size. Where that is 0, all tetrahedra are flat.
fn unit(size: f64) -> Result<f64> {
    if size == 0.0 || SIZES_OF_PRODUCTS.contains(&size) {
        Ok(1.0)
    } else if SIZES.contains(&size) {
        Ok(scale(size).recip())
    } else {
        Err(Error::BadSize { size, least: *SIZES.start(), most: *SIZES.end() })
    }
}

/// The tetrahedra that stay, in positive orientation, and the number of each of the input among them, or [`NONE`].
fn clean(TetSoup { positions, tetrahedra }: &TetSoup, unit: f64, report: &mut MeshReport) -> (Vec<[u32; 4]>, Vec<u32>) {
    let mut kept: Vec<[u32; 4]> = Vec::with_capacity(tetrahedra.len());
    let mut number = vec![NONE; tetrahedra.len()];
    let mut seen: HashSet<[u32; 4]> = HashSet::with_capacity(tetrahedra.len());
    for (&(mut corners), number) in tetrahedra.iter().zip(&mut number) {
        let points = corners.map(|vertex| positions[vertex as usize] / unit);
        let longest = EDGES.iter().map(|&[a, b]| points[a].distance(points[b])).fold(0.0, f64::max);
        // Taken relative to the longest edge, so that neither underflows.
        let volume = six_volumes(points.map(|point| (point - points[0]) / longest));
        // Not a number where all corners are one point.
        if volume.is_nan() || volume.abs() <= FLAT {
            report.flat_tetrahedra += 1;
            continue;
        }
        let mut sorted = corners;
        sorted.sort_unstable();
        if !seen.insert(sorted) {
            report.duplicate_tetrahedra += 1;
            continue;
        }
        if volume < 0.0 {
            corners.swap(1, 2);
            report.inverted_tetrahedra += 1;
        }
        *number = kept.len() as u32;
        kept.push(corners);
    }
    (kept, number)
}

/// The same error with tetrahedra and vertices as the input counts them.
fn in_numbers_of_input(error: Error, tetrahedron_of_input: &[u32], input_of_vertex: &[u32]) -> Error {
    let Error::NonManifoldFace { tetrahedra, vertices } = error else { return error };
    let input = |kept: u32| tetrahedron_of_input.iter().position(|&number| number == kept).unwrap_or_default() as u32;
    Error::NonManifoldFace {
        tetrahedra: tetrahedra.map(input),
        vertices: vertices.map(|vertex| input_of_vertex[vertex as usize]),
    }
}

/// Vertices at the other ends of each vertex's edges, ascending.
fn adjacent(tetrahedra: &[[u32; 4]], around: &Lists) -> Lists {
    let mut pairs = Vec::new();
    let mut others = Vec::new();
    for vertex in 0..around.rows() as u32 {
        others.clear();
        others.extend(around.row(vertex).iter().flat_map(|&tetrahedron| tetrahedra[tetrahedron as usize]));
        others.sort_unstable();
        others.dedup();
        pairs.extend(others.iter().filter(|&&other| other != vertex).map(|&other| (vertex, other)));
    }
    Lists::group(around.rows(), || pairs.iter().copied())
}

/// Component of each vertex, and how many there are.
pub(crate) fn components(vertices: usize, tetrahedra: impl Iterator<Item = [u32; 4]>) -> (Vec<u32>, usize) {
    let connected = UnionFind::new(vertices);
    for [a, b, c, d] in tetrahedra {
        connected.join(a, b);
        connected.join(b, c);
        connected.join(c, d);
    }
    let (components, count) = connected.sets();
    (components, count as usize)
}
