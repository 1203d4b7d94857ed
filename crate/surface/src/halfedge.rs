//! Half-edge connectivity, in the words of geometry-central.

use std::num::NonZeroUsize;

use heatwalk_base::csr::NONE;
use heatwalk_base::parallel;
use heatwalk_base::sort;

use crate::edges::Corners;
use crate::element::{CutVertex, CutVertexData, Element, FaceId, HalfedgeId, VertexId};

/// Oriented manifold triangle connectivity. Every half-edge has a twin and a next: boundary loops are capped by
/// boundary faces, whose half-edges run against the triangles beside them.
///
/// Invariants: `twin(twin(h)) == h != twin(h)`; `next` is a permutation whose cycles are the faces; a half-edge and
/// its twin run in opposite directions; the half-edges that leave a vertex form one cycle of `next(twin(h))`.
#[derive(Debug, Clone)]
pub struct HalfedgeMesh {
    /// `#H`, the vertex that each half-edge leaves.
    vertex: Vec<CutVertex>,
    /// `#H`.
    twin: Vec<HalfedgeId>,
    /// Successor of each boundary half-edge; a triangle's follow from their numbers.
    boundary_next: Vec<HalfedgeId>,
    /// Boundary face of each boundary half-edge.
    boundary_face: Vec<FaceId>,
    /// One half-edge of each boundary face.
    loops: Vec<HalfedgeId>,
    /// `#V`, a half-edge that leaves the vertex: the boundary one where there is one.
    outgoing: Vec<HalfedgeId>,
    triangles: u32,
}

impl HalfedgeMesh {
    /// Builds the mesh from oriented triangles and the twin of each of their half-edges (number [`NONE`]: no twin, so
    /// boundary or cut). Returns it with the welded vertex of each of its own. The first fan of triangles around welded
    /// vertex `v` becomes vertex `v`; further fans become vertices after the last welded one.
    pub(crate) fn from_twins(
        faces: &[[VertexId; 3]],
        corners: &Corners,
        mut twin: Vec<HalfedgeId>,
        threads: NonZeroUsize,
    ) -> (Self, CutVertexData<VertexId>) {
        let triangles = faces.len() as u32;
        let interior = faces.len() * 3;
        let vertex_count = corners.rows().len();
        let around = faces.as_flattened();
        let mut vertex = parallel::collect(interior, threads, |halfedge| CutVertex(around[halfedge].0));
        let mut outgoing = parallel::collect(vertex_count, threads, |_| HalfedgeId(NONE));
        let mut welded = parallel::collect(vertex_count, threads, VertexId::from_index);
        let cut = parallel::map_parts(corners.ranges(threads), &mut outgoing, |vertices, outgoing| {
            let mut cut: Vec<HalfedgeId> = Vec::new();
            for (vertex, outgoing) in vertices.map(VertexId::from_index).zip(outgoing) {
                let Some(&corner) = corners.row(vertex).first() else { continue };
                let mut faces = 0;
                *outgoing = visit_fan(&twin, corner, |_| faces += 1);
                if faces < corners.row(vertex).len() {
                    cut.extend_from_slice(corners.row(vertex));
                }
            }
            cut
        });
        let mut cut = cut.concat();
        sort::sort(&mut cut);
        let mut is_done = vec![false; cut.len()];
        for index in 0..cut.len() {
            if is_done[index] {
                continue;
            }
            let (corner, welded_vertex) = (cut[index], around[cut[index].index()]);
            let fan = if corners.row(welded_vertex)[0] == corner {
                CutVertex(welded_vertex.0)
            } else {
                outgoing.push(HalfedgeId(NONE));
                welded.push(welded_vertex);
                CutVertex(outgoing.len() as u32 - 1)
            };
            outgoing[fan.index()] = visit_fan(&twin, corner, |halfedge| {
                vertex[halfedge.index()] = fan;
                is_done[cut.binary_search(&halfedge).expect("a corner there")] = true;
            });
        }
        let is_alone = |&halfedge: &usize| twin[halfedge].0 == NONE;
        let alone =
            parallel::map(parallel::ranges(interior, threads), |range| range.filter(is_alone).collect::<Vec<_>>());
        let alone = alone.concat();
        vertex.reserve_exact(alone.len());
        twin.reserve_exact(alone.len());
        for halfedge in alone.into_iter().map(HalfedgeId::from_index) {
            let boundary = HalfedgeId::from_index(vertex.len());
            let origin = vertex[halfedge.next_in_triangle().index()];
            twin[halfedge.index()] = boundary;
            vertex.push(origin);
            twin.push(halfedge);
            outgoing[origin.index()] = boundary;
        }
        let boundary_next: Vec<HalfedgeId> =
            twin[interior..].iter().map(|inner| outgoing[vertex[inner.index()].index()]).collect();
        let mut boundary_face = vec![FaceId(NONE); boundary_next.len()];
        let mut loops = Vec::new();
        for start in 0..boundary_next.len() {
            if boundary_face[start].0 != NONE {
                continue;
            }
            let face = FaceId(triangles + loops.len() as u32);
            loops.push(HalfedgeId((interior + start) as u32));
            let mut outer = start;
            while boundary_face[outer].0 == NONE {
                boundary_face[outer] = face;
                outer = boundary_next[outer].index() - interior;
            }
        }
        (Self { vertex, twin, boundary_next, boundary_face, loops, outgoing, triangles }, welded.into())
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.outgoing.len()
    }

    /// Number of triangles, boundary faces not counted.
    pub fn face_count(&self) -> usize {
        self.triangles as usize
    }

    /// Number of half-edges, twice the number of edges.
    pub fn halfedge_count(&self) -> usize {
        self.vertex.len()
    }

    /// The vertex that the half-edge leaves.
    pub fn vertex(&self, halfedge: HalfedgeId) -> CutVertex {
        self.vertex[halfedge.index()]
    }

    /// The vertex that the half-edge enters.
    pub fn tip(&self, halfedge: HalfedgeId) -> CutVertex {
        self.vertex(self.twin(halfedge))
    }

    /// The half-edge along the same edge in the opposite direction.
    pub fn twin(&self, halfedge: HalfedgeId) -> HalfedgeId {
        self.twin[halfedge.index()]
    }

    /// The following half-edge of the same face, counter-clockwise in a triangle.
    pub fn next(&self, halfedge: HalfedgeId) -> HalfedgeId {
        match halfedge.index().checked_sub(self.face_count() * 3) {
            Some(outer) => self.boundary_next[outer],
            None => halfedge.next_in_triangle(),
        }
    }

    /// The face on the half-edge's left.
    pub fn face(&self, halfedge: HalfedgeId) -> FaceId {
        match halfedge.index().checked_sub(self.face_count() * 3) {
            Some(outer) => self.boundary_face[outer],
            None => halfedge.triangle(),
        }
    }

    /// Whether the face caps a boundary loop.
    pub fn is_boundary(&self, face: FaceId) -> bool {
        face.0 >= self.triangles
    }

    /// Whether the vertex lies on a boundary loop.
    pub fn is_boundary_vertex(&self, vertex: CutVertex) -> bool {
        self.is_boundary(self.face(self.outgoing[vertex.index()]))
    }

    /// A half-edge that leaves the vertex: the one on the boundary where there is one.
    pub fn halfedge_of_vertex(&self, vertex: CutVertex) -> HalfedgeId {
        self.outgoing[vertex.index()]
    }

    /// A half-edge of the face; of a triangle, the one that leaves its first corner.
    pub fn halfedge_of_face(&self, face: FaceId) -> HalfedgeId {
        match face.0.checked_sub(self.triangles) {
            Some(cap) => self.loops[cap as usize],
            None => face.halfedge(0),
        }
    }

    /// All vertices.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = CutVertex> + use<> {
        (0..self.vertex_count() as u32).map(CutVertex)
    }

    /// All triangles.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = FaceId> + use<> {
        (0..self.triangles).map(FaceId)
    }

    /// All half-edges, those of boundary faces last.
    pub fn halfedges(&self) -> impl ExactSizeIterator<Item = HalfedgeId> + use<> {
        (0..self.halfedge_count() as u32).map(HalfedgeId)
    }

    /// The faces that cap the boundary loops.
    pub fn boundary_loops(&self) -> impl ExactSizeIterator<Item = FaceId> + use<> {
        (self.triangles..self.triangles + self.loops.len() as u32).map(FaceId)
    }

    /// The half-edges of a face in order.
    pub fn halfedges_of_face(&self, face: FaceId) -> impl Iterator<Item = HalfedgeId> + '_ {
        cycle(self.halfedge_of_face(face), |halfedge| self.next(halfedge))
    }

    /// The half-edges that leave a vertex, clockwise.
    pub fn outgoing(&self, vertex: CutVertex) -> impl Iterator<Item = HalfedgeId> + '_ {
        cycle(self.halfedge_of_vertex(vertex), |halfedge| self.next(self.twin(halfedge)))
    }

    /// Number of connected components, those that share only a cut vertex counted apart.
    pub fn components(&self) -> usize {
        let mut seen = vec![false; self.face_count()];
        let mut stack = Vec::new();
        let mut components = 0;
        for start in self.faces() {
            if seen[start.index()] {
                continue;
            }
            components += 1;
            seen[start.index()] = true;
            stack.push(start);
            while let Some(face) = stack.pop() {
                for halfedge in self.halfedges_of_face(face) {
                    let other = self.face(self.twin(halfedge));
                    if !self.is_boundary(other) && !std::mem::replace(&mut seen[other.index()], true) {
                        stack.push(other);
                    }
                }
            }
        }
        components
    }

    /// `#V − #E + #F` with boundary faces not counted.
    pub fn euler_characteristic(&self) -> i64 {
        self.vertex_count() as i64 - self.halfedge_count() as i64 / 2 + self.face_count() as i64
    }
}

/// Visits the corners of the fan that a corner is part of, and returns one: that with nothing clockwise of it, or the given one.
fn visit_fan(twin: &[HalfedgeId], corner: HalfedgeId, mut visit: impl FnMut(HalfedgeId)) -> HalfedgeId {
    let mut last = corner;
    loop {
        visit(last);
        last = twin[last.previous_in_triangle().index()];
        if last == corner {
            return corner;
        }
        if last.0 == NONE {
            break;
        }
    }
    let mut first = corner;
    while twin[first.index()].0 != NONE {
        first = twin[first.index()].next_in_triangle();
        visit(first);
    }
    first
}

fn cycle(start: HalfedgeId, step: impl Fn(HalfedgeId) -> HalfedgeId) -> impl Iterator<Item = HalfedgeId> {
    std::iter::successors(Some(start), move |&halfedge| Some(step(halfedge)).filter(|&after| after != start))
}
