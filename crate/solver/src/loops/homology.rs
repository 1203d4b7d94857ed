//! Classes of closed curves along edges, with coefficients in ℤ₂: curves of one class bound a part of the surface together. A curve is told by
//! how often it crosses each curve of a basis (annotations of edges: Busaryev, Cabello, Chen, Dey, Wang, "Annotating simplices with a
//! homology basis and its applications", 2012).

use std::collections::HashMap;

use heatwalk_base::csr::NONE;
use heatwalk_base::sort;
use heatwalk_surface::{Element, FaceId, HalfedgeId, HalfedgeMesh, Path};

use super::cut_graph::Tree;

/// A bit for each curve that crosses all of the basis: whether it does so an odd number of times.
pub(super) type Class = Vec<u64>;

/// A basis of closed curves through faces, each of which crosses one edge that is neither in a tree of vertices nor in one of faces.
/// Boundary loops count as filled.
pub(super) struct Cocycles {
    count: usize,
    /// Of each edge, by the least of its half-edges, the curves that cross it an odd number of times.
    crossed: HashMap<HalfedgeId, Class>,
}

impl Cocycles {
    pub fn new(mesh: &HalfedgeMesh, tree: &Tree) -> Self {
        let faces = mesh.face_count() + mesh.boundary_loops().len();
        // The half-edge by which each face is left for the one before it.
        let mut back = vec![HalfedgeId(NONE); faces];
        let mut is_seen = vec![false; faces];
        let mut stack = Vec::new();
        for root in mesh.faces() {
            if std::mem::replace(&mut is_seen[root.index()], true) {
                continue;
            }
            stack.push(root);
            while let Some(face) = stack.pop() {
                for halfedge in mesh.halfedges_of_face(face).filter(|&halfedge| !tree.has(mesh, halfedge)) {
                    let twin = mesh.twin(halfedge);
                    let other = mesh.face(twin);
                    if !std::mem::replace(&mut is_seen[other.index()], true) {
                        back[other.index()] = twin;
                        stack.push(other);
                    }
                }
            }
        }
        let is_back = |halfedge: HalfedgeId| back[mesh.face(halfedge).index()] == halfedge;
        let is_crossed_once = |&halfedge: &HalfedgeId| {
            let twin = mesh.twin(halfedge);
            halfedge < twin && !tree.has(mesh, halfedge) && !is_back(halfedge) && !is_back(twin)
        };
        let generators: Vec<HalfedgeId> = mesh.halfedges().filter(is_crossed_once).collect();
        let words = generators.len().div_ceil(64);
        let mut crossed: HashMap<HalfedgeId, Class> = HashMap::new();
        for (number, &generator) in generators.iter().enumerate() {
            let mut cross = |halfedge: HalfedgeId| {
                let class = crossed.entry(edge(mesh, halfedge)).or_insert_with(|| vec![0; words]);
                class[number / 64] ^= 1 << (number % 64);
            };
            cross(generator);
            for side in [generator, mesh.twin(generator)] {
                let step = |face: FaceId| Some(back[face.index()]).filter(|back| back.0 != NONE);
                let mut next = step(mesh.face(side));
                while let Some(halfedge) = next {
                    cross(halfedge);
                    next = step(mesh.face(mesh.twin(halfedge)));
                }
            }
        }
        Self { count: generators.len(), crossed }
    }

    /// Twice the number of handles on an orientable surface.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The class of a closed curve along half-edges.
    pub fn class(&self, mesh: &HalfedgeMesh, around: &[HalfedgeId]) -> Class {
        let mut class = vec![0; self.count.div_ceil(64)];
        for halfedge in around {
            if let Some(crossed) = self.crossed.get(&edge(mesh, *halfedge)) {
                add(&mut class, crossed);
            }
        }
        class
    }
}

/// Of these the shortest whose classes are independent, the shortest first.
pub(super) fn independent(mut found: Vec<(Path, Class)>) -> Vec<(Path, Class)> {
    sort::sort_by(&mut found, |(a, _), (b, _)| a.length().total_cmp(&b.length()));
    // By the place of their first bit; no other has a bit there that comes after it.
    let mut reduced: HashMap<usize, Class> = HashMap::new();
    found.retain(|(_, class)| {
        let mut class = class.clone();
        while let Some(bit) = first_bit(&class) {
            match reduced.get(&bit) {
                Some(other) => add(&mut class, other),
                None => {
                    reduced.insert(bit, class);
                    return true;
                }
            }
        }
        false
    });
    found
}

fn first_bit(class: &[u64]) -> Option<usize> {
    let word = class.iter().position(|&word| word != 0)?;
    Some(64 * word + class[word].trailing_zeros() as usize)
}

fn add(class: &mut [u64], other: &[u64]) {
    class.iter_mut().zip(other).for_each(|(word, other)| *word ^= other);
}

fn edge(mesh: &HalfedgeMesh, halfedge: HalfedgeId) -> HalfedgeId {
    halfedge.min(mesh.twin(halfedge))
}
