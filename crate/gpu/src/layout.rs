//! A surface as the shaders take it: intrinsic Delaunay triangles in patches, lengths in mean edges.

use glam::DVec3;
use heatwalk::operator::Flips;
use heatwalk::operator::intrinsic::IntrinsicTriangulation;
use heatwalk::surface::triangle;
use heatwalk::{CutVertex, Element, HalfedgeId, Surface};
use heatwalk_base::csr::distribute;
use heatwalk_base::parallel;
use std::sync::Arc;

use crate::error::{Error, Result};
use crate::patches::{Capacity, Faces, PatchSize, bisect};
use crate::records::{CORNER_BITS, FaceRecord, LEAVING, NONE, PATCH_WORDS, PatchRecord};

/// The longest edge, in mean edges: beyond, single precision does not tell places apart that are an edge from each other.
const MOST_EDGES: f64 = 1e6;

/// Mean edges, in the file's unit, that distances in single precision can be written in.
const UNITS: std::ops::RangeInclusive<f64> = 1e-30..=1e30;

/// Numbers of half-edges and of the places of their windows are below 2³¹.
const MOST_FACES: usize = (1 << 31) / 8;

/// What is made once for a surface, on the processor, and then held by devices.
#[derive(Debug)]
pub struct Layout {
    surface: Arc<Surface>,
    pub(crate) triangles: Triangles,
    pub(crate) flips: Flips,
    /// Mean length of an edge of the intrinsic triangulation, in the file's unit.
    pub(crate) mean_edge: f64,
    pub(crate) capacity: Capacity,
    /// `#F`, in the order of patches.
    pub(crate) faces: Vec<FaceRecord>,
    pub(crate) patches: Vec<PatchRecord>,
    /// The records of patches, then their edges and vertices.
    pub(crate) tables: Vec<u32>,
    /// `#F`, where each face is in the order of patches, and its patch.
    pub(crate) place_of_face: Vec<u32>,
    pub(crate) patch_of_face: Vec<u32>,
    /// The patches around each vertex: where they begin, and they.
    around_start: Vec<u32>,
    around: Vec<u32>,
    /// Directed edges between patches.
    pub(crate) edge_count: u32,
    /// Numbers of the state of all patches.
    pub(crate) state_count: u32,
}

/// The intrinsic triangles, on the vertices of the surface.
#[derive(Debug)]
pub(crate) struct Triangles {
    triangulation: IntrinsicTriangulation,
    /// `#F × 3`.
    vertices: Vec<[u32; 3]>,
}

impl Faces for Triangles {
    fn vertices(&self, face: u32) -> [u32; 3] {
        self.vertices[face as usize]
    }

    fn twins(&self, face: u32) -> [Option<u32>; 3] {
        [0, 1, 2].map(|k| self.triangulation.twin(HalfedgeId(3 * face + k)).map(|twin| twin.0))
    }
}

impl Triangles {
    fn new(surface: &Surface) -> (Self, Flips) {
        let (triangulation, flips) = IntrinsicTriangulation::delaunay_of_sheet(surface);
        let vertex = |side: u32| surface.vertex_of_cut(CutVertex(triangulation.ends(HalfedgeId(side))[0].0)).0;
        let vertices = (0..triangulation.face_count() as u32).map(|face| [0, 1, 2].map(|k| vertex(3 * face + k)));
        (Self { vertices: vertices.collect(), triangulation }, flips)
    }

    /// Lengths of the sides of a face, in the file's unit.
    pub(crate) fn lengths(&self, face: u32) -> [f64; 3] {
        [0, 1, 2].map(|k| self.triangulation.length(HalfedgeId(3 * face + k)))
    }

    fn count(&self) -> u32 {
        self.vertices.len() as u32
    }

    /// Mean length of an edge, in the file's unit.
    fn mean_edge(&self) -> f64 {
        let (mut sum, mut count) = (0.0, 0_usize);
        for face in 0..self.count() {
            let (lengths, twins) = (self.lengths(face), self.twins(face));
            for k in 0..3 {
                if twins[k].is_none_or(|twin| twin > 3 * face + k as u32) {
                    sum += lengths[k];
                    count += 1;
                }
            }
        }
        sum / count as f64
    }
}

impl Layout {
    /// Of a surface whose edges are all between two faces of one orientation, or on the boundary.
    ///
    /// # Errors
    /// [`Error::NotManifold`]; [`Error::TooLarge`] from 2²⁸ faces on; [`Error::LongEdge`]; [`Error::UnitOutOfRange`].
    pub fn new(surface: &Arc<Surface>) -> Result<Self> {
        Self::with_patches(surface, PatchSize::of_mesh(surface.face_count()))
    }

    /// The same with patches of this size instead of that which suits most cards.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_patches(surface: &Arc<Surface>, size: PatchSize) -> Result<Self> {
        if !surface.is_oriented_manifold() {
            return Err(Error::NotManifold { edges: cut_edges(surface) });
        }
        if surface.face_count() >= MOST_FACES {
            let (needed, limit) = (surface.face_count() as u64, MOST_FACES as u64 - 1);
            return Err(Error::TooLarge { what: "triangles", needed, limit, unit: "numbers" });
        }
        let capacity = size.capacity();
        let (triangles, flips) = Triangles::new(surface);
        let mean_edge = triangles.mean_edge();
        require_range(&triangles, mean_edge)?;
        let center = |face: &[u32; 3]| {
            face.iter().map(|&vertex| surface.position(heatwalk::VertexId(vertex))).sum::<DVec3>() / 3.0
        };
        let centers: Vec<DVec3> = triangles.vertices.iter().map(center).collect();
        let (order, starts) = bisect(&triangles, &centers, capacity);
        let mut place_of_face = vec![0; order.len()];
        let mut patch_of_face = vec![0; order.len()];
        for (patch, bounds) in (0..).zip(starts.windows(2)) {
            for place in bounds[0]..bounds[1] {
                let face = order[place as usize] as usize;
                (place_of_face[face], patch_of_face[face]) = (place, patch);
            }
        }
        let mut layout = Self {
            surface: Arc::clone(surface),
            flips,
            mean_edge,
            capacity,
            faces: vec![bytemuck::Zeroable::zeroed(); order.len()],
            patches: Vec::with_capacity(starts.len() - 1),
            tables: Vec::new(),
            place_of_face,
            patch_of_face,
            around_start: Vec::new(),
            around: Vec::new(),
            edge_count: 0,
            state_count: 0,
            triangles,
        };
        layout.fill(&order, &starts);
        Ok(layout)
    }

    /// The surface that it is of.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// Numbers of the patches around a vertex.
    pub(crate) fn patches_around(&self, vertex: u32) -> &[u32] {
        let bounds = [vertex, vertex + 1].map(|vertex| self.around_start[vertex as usize] as usize);
        &self.around[bounds[0]..bounds[1]]
    }

    /// Makes the records and tables of patches that have these faces.
    fn fill(&mut self, order: &[u32], starts: &[u32]) {
        let edges = self.edges_between(order, starts);
        let mut vertices: Vec<u32> = Vec::new();
        let mut patch_of_vertex: Vec<u32> = Vec::new();
        let mut local = vec![[NONE; 2]; self.surface.vertex_count()];
        for (patch, bounds) in (0..).zip(starts.windows(2)) {
            let first_vertex = vertices.len();
            for place in bounds[0]..bounds[1] {
                let face = order[place as usize];
                let mut corners = 0;
                for (k, vertex) in (0..).zip(self.triangles.vertices(face)) {
                    let known = &mut local[vertex as usize];
                    if known[0] != patch {
                        *known = [patch, (vertices.len() - first_vertex) as u32];
                        vertices.push(vertex);
                        patch_of_vertex.push(patch);
                    }
                    corners |= known[1] << (CORNER_BITS * k);
                }
                self.faces[place as usize] = self.record(face, bounds[0], corners, &edges);
            }
            let [first_edge, end_edge] = [patch, patch + 1].map(|patch| edges.start[patch as usize]);
            let record = PatchRecord {
                first_face: bounds[0],
                face_count: bounds[1] - bounds[0],
                first_edge,
                edge_count: end_edge - first_edge,
                vertex_count: (vertices.len() - first_vertex) as u32,
                edges: 0,
                vertices: 0,
                state: 6 * bounds[0] + 2 * first_edge + first_vertex as u32,
            };
            self.patches.push(record);
        }
        self.edge_count = edges.halfedges.len() as u32;
        self.state_count = 6 * order.len() as u32 + 2 * self.edge_count + vertices.len() as u32;
        let row = |index: usize| Some(vertices[index] as usize);
        let item = |index: usize| patch_of_vertex[index];
        let count = self.surface.vertex_count();
        (self.around_start, self.around) = distribute(count, vertices.len(), parallel::ONE, row, item);
        self.write_tables(&edges, &vertices);
    }

    /// The directed edges between patches, by the patch that they leave.
    fn edges_between(&self, order: &[u32], starts: &[u32]) -> Edges {
        let mut edges = Edges { start: vec![0], halfedges: Vec::new(), of_halfedge: vec![NONE; 3 * order.len()] };
        for bounds in starts.windows(2) {
            for &face in &order[bounds[0] as usize..bounds[1] as usize] {
                for (halfedge, twin) in (3 * face..).zip(self.triangles.twins(face)) {
                    if twin.is_some_and(|twin| self.patch_of(twin) != self.patch_of(halfedge)) {
                        edges.of_halfedge[halfedge as usize] = edges.halfedges.len() as u32;
                        edges.halfedges.push(halfedge);
                    }
                }
            }
            edges.start.push(edges.halfedges.len() as u32);
        }
        edges
    }

    /// The patch of a half-edge.
    pub(crate) fn patch_of(&self, halfedge: u32) -> u32 {
        self.patch_of_face[halfedge as usize / 3]
    }

    /// Number of a half-edge in the order of patches.
    pub(crate) fn place_of(&self, halfedge: u32) -> u32 {
        3 * self.place_of_face[halfedge as usize / 3] + halfedge % 3
    }

    /// A half-edge as its patch counts it, whose first face is there.
    fn local(&self, halfedge: u32, first_face: u32) -> u32 {
        self.place_of(halfedge) - 3 * first_face
    }

    fn record(&self, face: u32, first_face: u32, corners: u32, edges: &Edges) -> FaceRecord {
        let patch = self.patch_of_face[face as usize];
        let lengths = self.triangles.lengths(face).map(|length| length / self.mean_edge);
        let cosine = |k: usize| {
            let [opposite, before] = [lengths[(k + 1) % 3], lengths[(k + 2) % 3]];
            let difference = (before - opposite) * (before + opposite);
            ((lengths[k] * lengths[k] + difference) / (2.0 * lengths[k] * before)).clamp(-1.0, 1.0) as f32
        };
        let twins = self.triangles.twins(face);
        let first_edge = edges.start[patch as usize];
        let neighbor = |k: usize| match twins[k] {
            None => NONE,
            Some(twin) if self.patch_of(twin) == patch => self.local(twin, first_face),
            Some(_) => LEAVING | (edges.of_halfedge[3 * face as usize + k] - first_edge),
        };
        FaceRecord {
            lengths: lengths.map(|length| length as f32),
            area: 2.0 * triangle::area_of_lengths(lengths) as f32,
            cosines: [0, 1, 2].map(cosine),
            corners,
            neighbors: [0, 1, 2].map(neighbor),
            padding: 0,
        }
    }

    fn write_tables(&mut self, edges: &Edges, vertices: &[u32]) {
        let mut tables = vec![0; PATCH_WORDS * self.patches.len()];
        for patch in 0..self.patches.len() {
            self.patches[patch].edges = tables.len() as u32;
            let range = edges.start[patch] as usize..edges.start[patch + 1] as usize;
            for &halfedge in &edges.halfedges[range] {
                let twin =
                    self.triangles.twins(halfedge / 3)[halfedge as usize % 3].expect("an edge between two patches");
                let local = self.local(halfedge, self.patches[patch].first_face);
                tables.extend([local, self.patch_of(twin), edges.of_halfedge[twin as usize]]);
            }
        }
        let mut around = vec![NONE; self.surface.vertex_count()];
        for vertex in 0..around.len() {
            let patches = self.patches_around(vertex as u32);
            if patches.len() > 1 {
                around[vertex] = tables.len() as u32;
                tables.push(patches.len() as u32);
                tables.extend(patches);
            }
        }
        let mut vertices = vertices.iter();
        for patch in &mut self.patches {
            patch.vertices = tables.len() as u32;
            let own = vertices.by_ref().take(patch.vertex_count as usize);
            tables.extend(own.flat_map(|&vertex| [vertex, around[vertex as usize]]));
        }
        tables[..PATCH_WORDS * self.patches.len()].copy_from_slice(bytemuck::cast_slice(&self.patches));
        self.tables = tables;
    }
}

/// The directed edges between patches.
struct Edges {
    /// `#patches + 1`, where those that leave each begin.
    start: Vec<u32>,
    /// The half-edge by which windows leave.
    halfedges: Vec<u32>,
    /// `3 #F`, the edge of each half-edge, or [`NONE`].
    of_halfedge: Vec<u32>,
}

/// How many edges are not between two faces of one orientation.
fn cut_edges(surface: &Surface) -> usize {
    let (edges, mesh) = (surface.edges(), surface.mesh());
    let is_cut = |edge: &HalfedgeId| !edges.is_single(*edge) && mesh.twin(*edge).index() >= 3 * surface.face_count();
    edges.representatives().filter(|edge| edges.is_branching(*edge) || is_cut(edge)).count()
}

/// Refuses lengths that single precision cannot measure.
fn require_range(triangles: &Triangles, mean_edge: f64) -> Result<()> {
    let longest = (0..triangles.count()).flat_map(|face| triangles.lengths(face)).fold(0.0, f64::max);
    if longest > MOST_EDGES * mean_edge {
        return Err(Error::LongEdge { times: longest / mean_edge });
    }
    if UNITS.contains(&mean_edge) { Ok(()) } else { Err(Error::UnitOutOfRange { mean_edge }) }
}

#[cfg(test)]
mod tests;
