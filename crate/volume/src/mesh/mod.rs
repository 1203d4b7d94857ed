//! Tetrahedral meshes: checked tetrahedra with their neighbors.

mod boundary;
mod build;
mod faces;
pub(crate) mod locate;
pub(crate) mod quality;
mod report;

use std::num::NonZeroU64;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};

use glam::DVec3;
use heatwalk::VertexId;

use crate::boxes::Boxes;
use crate::lists::Lists;

pub use boundary::Boundary;
pub(crate) use build::components;
pub(crate) use locate::{Crossing, Sight, Start};
pub use quality::Quality;
pub use report::MeshReport;

/// In place of a number: there is none.
pub(crate) const NONE: u32 = u32::MAX;

/// Corners of the face opposite each corner of a tetrahedron, counter-clockwise seen from outside where the tetrahedron is
/// positively oriented.
pub(crate) const FACES: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// Corners at the ends of the six edges of a tetrahedron.
pub(crate) const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

/// A tetrahedron of a [`TetMesh`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TetId(pub u32);

impl TetId {
    /// Its number, counted from 0.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Names a mesh, so that an answer is not read on another one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MeshId(NonZeroU64);

impl MeshId {
    fn next() -> Self {
        static LAST: AtomicU64 = AtomicU64::new(0);
        Self(NonZeroU64::MIN.saturating_add(LAST.fetch_add(1, Ordering::Relaxed)))
    }
}

/// Tetrahedra of positive volume and orientation with their neighbors across faces. Vertices are those of the input that some
/// tetrahedron uses, in the order of the input; vertices of equal position stay apart, as files keep them where they mean a
/// crack.
#[derive(Debug)]
pub struct TetMesh {
    id: MeshId,
    /// A power of two that positions are divided by where products of many lengths are computed; 1 where those are numbers anyway.
    unit: f64,
    positions: Vec<DVec3>,
    tetrahedra: Vec<[u32; 4]>,
    /// `#T × 4`, the tetrahedron beyond the face opposite each corner, or [`NONE`].
    neighbors: Vec<[u32; 4]>,
    /// Tetrahedra around each vertex.
    around: Lists,
    /// Vertices at the other ends of each vertex's edges, ascending.
    adjacent: Lists,
    components: Vec<u32>,
    input_of_vertex: Vec<u32>,
    vertex_of_input: Vec<u32>,
    tetrahedron_of_input: Vec<u32>,
    report: MeshReport,
    /// Made by the first question where a place is.
    boxes: OnceLock<Boxes>,
}

impl TetMesh {
    /// Names this mesh.
    pub fn id(&self) -> MeshId {
        self.id
    }

    /// `#V × 3`, in the file's unit.
    pub fn positions(&self) -> &[DVec3] {
        &self.positions
    }

    /// `#T × 4`, corners of each tetrahedron; the last one sees the others counter-clockwise.
    pub fn tetrahedra(&self) -> &[[u32; 4]] {
        &self.tetrahedra
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// Number of tetrahedra.
    pub fn tetrahedron_count(&self) -> usize {
        self.tetrahedra.len()
    }

    /// What building found and did.
    pub fn report(&self) -> &MeshReport {
        &self.report
    }

    /// Where a vertex is.
    pub fn position(&self, vertex: VertexId) -> DVec3 {
        self.positions[vertex.0 as usize]
    }

    /// Where the corners of a tetrahedron are.
    #[inline]
    pub fn corners(&self, tetrahedron: TetId) -> [DVec3; 4] {
        self.tetrahedra[tetrahedron.index()].map(|vertex| self.positions[vertex as usize])
    }

    /// The tetrahedron beyond the face opposite corner `corner` (0 to 3); none at the boundary.
    pub fn neighbor(&self, tetrahedron: TetId, corner: usize) -> Option<TetId> {
        Some(self.neighbors[tetrahedron.index()][corner]).filter(|&other| other != NONE).map(TetId)
    }

    /// The tetrahedra that a vertex is a corner of.
    pub fn tetrahedra_of(&self, vertex: VertexId) -> impl ExactSizeIterator<Item = TetId> + '_ {
        self.around.row(vertex.0).iter().map(|&tetrahedron| TetId(tetrahedron))
    }

    /// The connected component of each vertex (`#V`), by shared faces, edges or vertices, counted from 0 in the order of their first
    /// vertices.
    pub fn components(&self) -> &[u32] {
        &self.components
    }

    /// The vertex of a vertex of the input; none where no tetrahedron uses it.
    pub fn vertex_of_input(&self, input: usize) -> Option<VertexId> {
        self.vertex_of_input.get(input).copied().filter(|&vertex| vertex != NONE).map(VertexId)
    }

    /// The vertex of the input that a vertex is.
    pub fn input_of_vertex(&self, vertex: VertexId) -> usize {
        self.input_of_vertex[vertex.0 as usize] as usize
    }

    /// The tetrahedron of a tetrahedron of the input; none where it was flat or a duplicate.
    pub fn tetrahedron_of_input(&self, input: usize) -> Option<TetId> {
        self.tetrahedron_of_input.get(input).copied().filter(|&tetrahedron| tetrahedron != NONE).map(TetId)
    }

    /// Values of vertices of the input from values of vertices; `absent` where no tetrahedron uses the vertex.
    pub fn to_inputs(&self, values: &[f64], absent: f64) -> Vec<f64> {
        let value = |&vertex: &u32| if vertex == NONE { absent } else { values[vertex as usize] };
        self.vertex_of_input.iter().map(value).collect()
    }

    /// The least and the largest coordinates of vertices.
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        self.positions.iter().fold(none, |(low, high), &position| (low.min(position), high.max(position)))
    }

    /// Mean length of the edges, in the file's unit.
    pub fn mean_edge(&self) -> f64 {
        let (mut sum, mut count) = (0.0, 0_usize);
        for vertex in 0..self.vertex_count() as u32 {
            for &other in self.adjacent.row(vertex).iter().filter(|&&other| other > vertex) {
                sum += self.positions[vertex as usize].distance(self.positions[other as usize]);
                count += 1;
            }
        }
        sum / count as f64
    }

    /// The mesh in a unit that all can be computed in, and that unit in its own.
    pub(crate) fn in_unit(self: &Arc<Self>) -> (Arc<Self>, f64) {
        if self.unit == 1.0 {
            return (Arc::clone(self), 1.0);
        }
        let scaled = Self {
            id: self.id,
            unit: 1.0,
            positions: self.positions.iter().map(|&position| self.scaled(position)).collect(),
            tetrahedra: self.tetrahedra.clone(),
            neighbors: self.neighbors.clone(),
            around: self.around.clone(),
            adjacent: self.adjacent.clone(),
            components: self.components.clone(),
            input_of_vertex: self.input_of_vertex.clone(),
            vertex_of_input: self.vertex_of_input.clone(),
            tetrahedron_of_input: self.tetrahedron_of_input.clone(),
            report: self.report.clone(),
            boxes: OnceLock::new(),
        };
        (Arc::new(scaled), self.unit)
    }

    /// A place, or a vector, in that unit.
    pub(crate) fn scaled(&self, place: DVec3) -> DVec3 {
        place / self.unit
    }

    /// Where the corners of a tetrahedron are in that unit.
    pub(crate) fn scaled_corners(&self, tetrahedron: TetId) -> [DVec3; 4] {
        self.corners(tetrahedron).map(|corner| self.scaled(corner))
    }

    /// Boxes around the tetrahedra, once something has made them.
    pub(crate) fn boxes(&self) -> &OnceLock<Boxes> {
        &self.boxes
    }

    pub(crate) fn neighbors(&self) -> &[[u32; 4]] {
        &self.neighbors
    }

    pub(crate) fn around(&self) -> &Lists {
        &self.around
    }

    /// The tetrahedra around an edge: of its ends, the one with fewer is looked around, since n edges may meet at the other.
    pub(crate) fn around_edge(&self, ends: [u32; 2]) -> impl Iterator<Item = u32> + '_ {
        let [one, other] = ends.map(|end| self.around.row(end));
        let (around, beyond) = if other.len() < one.len() { (other, ends[0]) } else { (one, ends[1]) };
        around.iter().copied().filter(move |&tetrahedron| self.tetrahedra[tetrahedron as usize].contains(&beyond))
    }

    pub(crate) fn adjacent(&self) -> &Lists {
        &self.adjacent
    }
}

/// Six times the volume of a tetrahedron, negative where its last corner sees the others clockwise.
#[inline]
pub(crate) fn six_volumes([a, b, c, d]: [DVec3; 4]) -> f64 {
    (b - a).cross(c - a).dot(d - a)
}
