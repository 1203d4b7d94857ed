//! A tree of paths along edges from roots, and the graph of faces joined by the other edges, which cuts the surface open where leaves are
//! taken from it until there are none.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use heatwalk_base::csr::NONE;
use heatwalk_base::sort;
use heatwalk_base::union_find::UnionFind;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{CutVertex, Element, FaceId, HalfedgeId, HalfedgeMesh, VertexData, triangle};

/// Whether a loop around a boundary loop can shrink to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Caps {
    Filled,
    Open,
}

/// Paths along edges from roots to all vertices that they are joined to.
pub(super) struct Tree {
    /// `#V`, the half-edge from each vertex to the one before it; number [`NONE`] at roots and where there is no path.
    back: Vec<HalfedgeId>,
    /// `#V`, the distance of each vertex, infinite where there is no path.
    distances: Vec<f64>,
}

impl Tree {
    /// The shortest paths along edges (Dijkstra 1959) from roots, each of which counts where no path from those before leads to it. With
    /// `distances` (`#V` welded vertices) vertices come in their order, each after the neighbour by which it is nearest: so paths follow
    /// shortest ones through triangles.
    pub fn new(surface: &Surface, roots: impl Iterator<Item = CutVertex>, distances: Option<&VertexData<f64>>) -> Self {
        let mesh = surface.mesh();
        let position = |vertex| surface.position(surface.vertex_of_cut(vertex));
        let ranked =
            |vertex: CutVertex, path: f64| distances.map_or(path, |distances| distances[surface.vertex_of_cut(vertex)]);
        let mut tree = Self {
            back: vec![HalfedgeId(NONE); mesh.vertex_count()],
            distances: vec![f64::INFINITY; mesh.vertex_count()],
        };
        let mut is_done = vec![false; mesh.vertex_count()];
        let mut queue = BinaryHeap::new();
        for root in roots {
            if is_done[root.index()] {
                continue;
            }
            tree.distances[root.index()] = ranked(root, 0.0);
            queue.push(Reverse((0, root)));
            while let Some(Reverse((_, vertex))) = queue.pop() {
                if std::mem::replace(&mut is_done[vertex.index()], true) {
                    continue;
                }
                let distance = ranked(vertex, tree.distances[vertex.index()]);
                tree.distances[vertex.index()] = distance;
                for halfedge in mesh.outgoing(vertex) {
                    let next = mesh.tip(halfedge);
                    let path = distance + triangle::length(position(next) - position(vertex));
                    if !is_done[next.index()] && path < tree.distances[next.index()] {
                        tree.distances[next.index()] = path;
                        tree.back[next.index()] = mesh.twin(halfedge);
                        // Bits of non-negative floats order as the floats do.
                        queue.push(Reverse((ranked(next, path).to_bits(), next)));
                    }
                }
            }
        }
        tree
    }

    /// Whether the edge is one of its paths' or cannot be reached by them.
    pub fn has(&self, mesh: &HalfedgeMesh, halfedge: HalfedgeId) -> bool {
        let twin = mesh.twin(halfedge);
        let is_back = |halfedge: HalfedgeId| self.back[mesh.vertex(halfedge).index()] == halfedge;
        is_back(halfedge) || is_back(twin) || self.distances[mesh.vertex(halfedge).index()].is_infinite()
    }

    /// Of the loop over this edge.
    fn length(&self, surface: &Surface, halfedge: HalfedgeId) -> f64 {
        let mesh = surface.mesh();
        let ends = [mesh.vertex(halfedge), mesh.tip(halfedge)];
        let [a, b] = ends.map(|vertex| surface.position(surface.vertex_of_cut(vertex)));
        triangle::length(b - a) + ends.iter().map(|vertex| self.distances[vertex.index()]).sum::<f64>()
    }

    /// The loop from the root to an edge, over it, and back.
    pub fn around(&self, mesh: &HalfedgeMesh, halfedge: HalfedgeId) -> Vec<HalfedgeId> {
        let to_root = |vertex: CutVertex| {
            let back = |vertex: CutVertex| Some(self.back[vertex.index()]).filter(|back| back.0 != NONE);
            std::iter::successors(back(vertex), move |&step| back(mesh.tip(step)))
        };
        let mut around: Vec<HalfedgeId> = to_root(mesh.vertex(halfedge)).map(|step| mesh.twin(step)).collect();
        around.reverse();
        around.push(halfedge);
        around.extend(to_root(mesh.tip(halfedge)));
        around
    }
}

/// An edge each for the classes of loops that a tree tells apart, none of which shrinks to a point: of all in one class the one whose loop
/// is shortest.
pub(super) fn least_loops(surface: &Surface, tree: &Tree, caps: Caps) -> Vec<HalfedgeId> {
    let mesh = surface.mesh();
    let is_branch = |face: FaceId| caps == Caps::Open && mesh.is_boundary(face);
    let edge = |halfedge: HalfedgeId| halfedge.min(mesh.twin(halfedge));
    let is_first = |&halfedge: &HalfedgeId| edge(halfedge) == halfedge;
    let mut is_left = vec![false; mesh.halfedge_count()];
    let mut degree = vec![0_u32; mesh.face_count() + mesh.boundary_loops().len()];
    for halfedge in mesh.halfedges().filter(is_first).filter(|&halfedge| !tree.has(mesh, halfedge)) {
        is_left[halfedge.index()] = true;
        [halfedge, mesh.twin(halfedge)].iter().for_each(|&side| degree[mesh.face(side).index()] += 1);
    }
    let faces = || mesh.faces().chain(mesh.boundary_loops());
    let mut leaves: Vec<FaceId> = faces().filter(|face| degree[face.index()] == 1 && !is_branch(*face)).collect();
    while let Some(leaf) = leaves.pop() {
        let left = mesh.halfedges_of_face(leaf).find(|&halfedge| is_left[edge(halfedge).index()]);
        let Some(halfedge) = left else { continue };
        is_left[edge(halfedge).index()] = false;
        degree[leaf.index()] = 0;
        let other = mesh.face(mesh.twin(halfedge));
        degree[other.index()] -= 1;
        if degree[other.index()] == 1 && !is_branch(other) {
            leaves.push(other);
        }
    }
    // Over edges in a row loops are of one class.
    let rows = UnionFind::new(mesh.halfedge_count());
    for face in faces().filter(|face| degree[face.index()] == 2 && !is_branch(*face)) {
        let mut pair = mesh.halfedges_of_face(face).map(edge).filter(|halfedge| is_left[halfedge.index()]);
        if let (Some(a), Some(b)) = (pair.next(), pair.next()) {
            rows.join(a.0, b.0);
        }
    }
    let mut least: Vec<(u32, u64, HalfedgeId)> = mesh
        .halfedges()
        .filter(|halfedge| is_left[halfedge.index()])
        .map(|halfedge| (rows.least(halfedge.0), tree.length(surface, halfedge).to_bits(), halfedge))
        .collect();
    sort::sort(&mut least);
    least.dedup_by_key(|&mut (row, ..)| row);
    least.into_iter().map(|(.., halfedge)| halfedge).collect()
}
