//! What follows from the triangles and their edges alone.

use std::num::NonZeroUsize;

use heatwalk_base::parallel;
use heatwalk_base::union_find::UnionFind;

use crate::edges::{Corners, Edges};
use crate::element::{CutVertexData, HalfedgeId, VertexData, VertexId};
use crate::halfedge::HalfedgeMesh;

/// Half-edges, boundary and components.
pub(super) struct Connectivity {
    pub mesh: HalfedgeMesh,
    pub vertex_of_cut: CutVertexData<VertexId>,
    pub is_boundary: VertexData<bool>,
    pub is_oriented_manifold: bool,
    pub boundary_loops: usize,
    /// `#V`, counted from 0 in order of their first vertices.
    pub components: VertexData<u32>,
}

impl Connectivity {
    /// `twins` are those of the [edges](Edges::twins).
    pub fn new(
        faces: &[[VertexId; 3]],
        corners: &Corners,
        edges: &Edges,
        twins: Vec<HalfedgeId>,
        threads: NonZeroUsize,
    ) -> Self {
        let vertices = corners.rows().len();
        let (mesh, vertex_of_cut) = HalfedgeMesh::from_twins(faces, corners, twins, threads);
        let mut is_boundary: VertexData<bool> = vec![false; vertices].into();
        let mut is_oriented_manifold = true;
        for outer in (3 * faces.len() as u32..mesh.halfedge_count() as u32).map(HalfedgeId) {
            if edges.is_single(mesh.twin(outer)) {
                for vertex in [mesh.vertex(outer), mesh.tip(outer)] {
                    is_boundary[vertex_of_cut[vertex]] = true;
                }
            } else {
                is_oriented_manifold = false;
            }
        }
        let is_true_boundary = |halfedge: HalfedgeId| edges.is_single(mesh.twin(halfedge));
        let boundary_loops =
            mesh.boundary_loops().filter(|&cap| mesh.halfedges_of_face(cap).any(is_true_boundary)).count();
        let components = connected_components(faces, vertices, threads);
        Self { mesh, vertex_of_cut, is_boundary, is_oriented_manifold, boundary_loops, components }
    }
}

/// Number of the components of all vertices.
pub(super) fn component_count(components: &VertexData<u32>) -> usize {
    components.iter().max().map_or(0, |&last| last as usize + 1)
}

/// Connected component of each vertex.
fn connected_components(faces: &[[VertexId; 3]], vertices: usize, threads: NonZeroUsize) -> VertexData<u32> {
    let connected = UnionFind::new(vertices);
    parallel::map(parallel::ranges(faces.len(), threads), |range| {
        for &[a, b, c] in &faces[range] {
            connected.join(a.0, b.0);
            connected.join(b.0, c.0);
        }
    });
    connected.sets().0.into()
}
