//! Which half-edges of a triangle list lie on the same edge, and which triangles to flip so that neighbours agree.

use crate::csr::{Csr, NONE};
use crate::element::{Element, FaceId, HalfedgeId, VertexId};

/// The corners of each vertex, by the half-edges that leave them.
pub type Corners = Csr<VertexId, HalfedgeId>;

/// The edges of a triangle list. Half-edge `3 f + k` runs from corner `k` of face `f` to the next corner.
#[derive(Debug, Clone)]
pub struct Edges {
    /// `3 #F`, the next half-edge of the same edge, of either direction. Those of an edge form a cycle, ascending up to
    /// the step from the last to the first.
    next: Vec<HalfedgeId>,
}

impl Edges {
    /// Finds the half-edges between the same vertices.
    pub fn new(faces: &[[VertexId; 3]], corners: &Corners) -> Self {
        let mut next: Vec<HalfedgeId> = (0..3 * faces.len() as u32).map(HalfedgeId).collect();
        // Per vertex the lower one that it was last met from, and the latest half-edge between the two.
        let mut latest = vec![[NONE; 2]; corners.rows().len()];
        for (vertex, row) in corners.rows() {
            for &corner in row {
                let (face, before) = (faces[corner.triangle().index()], corner.previous_in_triangle());
                let (after, k) = (corner.next_in_triangle().corner(), before.corner());
                for (other, halfedge) in [(face[after], corner), (face[k], before)] {
                    if other <= vertex {
                        continue;
                    }
                    let [from, last] = std::mem::replace(&mut latest[other.index()], [vertex.0, halfedge.0]);
                    if from == vertex.0 {
                        next[halfedge.index()] = std::mem::replace(&mut next[last as usize], halfedge);
                    }
                }
            }
        }
        Self { next }
    }

    /// The next half-edge of the same edge, the given one where it is alone.
    pub fn next_on_edge(&self, halfedge: HalfedgeId) -> HalfedgeId {
        self.next[halfedge.index()]
    }

    /// The half-edges of the same edge, from the given one on.
    pub fn around(&self, halfedge: HalfedgeId) -> impl Iterator<Item = HalfedgeId> + '_ {
        let next = move |&at: &HalfedgeId| Some(self.next_on_edge(at)).filter(|&next| next != halfedge);
        std::iter::successors(Some(halfedge), next)
    }

    fn halfedges(&self) -> impl ExactSizeIterator<Item = HalfedgeId> + Clone + use<> {
        (0..self.next.len() as u32).map(HalfedgeId)
    }

    /// One half-edge of each edge: its last one.
    pub fn representatives(&self) -> impl Iterator<Item = HalfedgeId> + Clone + '_ {
        self.halfedges().filter(|&halfedge| self.next_on_edge(halfedge) <= halfedge)
    }

    /// Whether the edge has one face only.
    pub fn is_single(&self, halfedge: HalfedgeId) -> bool {
        self.next_on_edge(halfedge) == halfedge
    }

    /// The other half-edge of the same edge where exactly two faces meet.
    pub fn mate(&self, halfedge: HalfedgeId) -> Option<HalfedgeId> {
        let next = self.next_on_edge(halfedge);
        (next != halfedge && self.next_on_edge(next) == halfedge).then_some(next)
    }

    /// Whether the edge has three faces or more.
    pub fn is_branching(&self, halfedge: HalfedgeId) -> bool {
        !self.is_single(halfedge) && self.mate(halfedge).is_none()
    }

    /// The faces whose three vertices an earlier face has, in any order; ascending.
    pub fn duplicates(&self, faces: &[[VertexId; 3]]) -> Vec<FaceId> {
        let apex = |halfedge: HalfedgeId| origin(faces, halfedge.previous_in_triangle());
        let mut duplicates = Vec::new();
        let mut apexes: Vec<(VertexId, FaceId)> = Vec::new();
        for last in self.representatives().filter(|&last| !self.is_single(last)) {
            if let Some(first) = self.mate(last) {
                if apex(first) == apex(last) {
                    duplicates.push(last.triangle());
                }
                continue;
            }
            apexes.clear();
            apexes.extend(self.around(last).map(|halfedge| (apex(halfedge), halfedge.triangle())));
            apexes.sort_unstable();
            duplicates.extend(apexes.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1].1));
        }
        duplicates.sort_unstable();
        duplicates.dedup();
        duplicates
    }

    /// The edges of the faces that are kept, in their order.
    pub fn kept(&self, is_kept: &[bool]) -> Self {
        let mut count = 0;
        let mut renumbered = Vec::with_capacity(is_kept.len());
        for &is_kept in is_kept {
            renumbered.push(FaceId(count));
            count += u32::from(is_kept);
        }
        let is_kept = |halfedge: HalfedgeId| is_kept[halfedge.triangle().index()];
        let next_kept = |halfedge: HalfedgeId| {
            let mut next = self.next_on_edge(halfedge);
            while !is_kept(next) {
                next = self.next_on_edge(next);
            }
            renumbered[next.triangle().index()].halfedge(next.corner())
        };
        Self { next: self.halfedges().filter(|&halfedge| is_kept(halfedge)).map(next_kept).collect() }
    }

    /// The edges after corners 1 and 2 of some faces changed places.
    pub fn flipped(&self, is_flipped: impl Fn(FaceId) -> bool) -> Self {
        let moved = |halfedge: HalfedgeId| {
            let face = halfedge.triangle();
            if is_flipped(face) { face.halfedge(2 - halfedge.corner()) } else { halfedge }
        };
        Self { next: self.halfedges().map(|halfedge| moved(self.next_on_edge(moved(halfedge)))).collect() }
    }

    /// The faces to flip so that as many neighbours as possible agree, the fewer in each connected component.
    pub fn faces_to_flip(&self, faces: &[[VertexId; 3]]) -> Vec<FaceId> {
        let disagrees = |last: HalfedgeId| self.mate(last).is_some_and(|mate| same_direction(faces, last, mate));
        if !self.representatives().any(disagrees) {
            return Vec::new();
        }
        let mut flipped: Vec<Option<bool>> = vec![None; faces.len()];
        let mut component: Vec<FaceId> = Vec::new();
        let mut result = Vec::new();
        for start in 0..faces.len() {
            if flipped[start].is_some() {
                continue;
            }
            component.clear();
            component.push(FaceId::from_index(start));
            flipped[start] = Some(false);
            let mut done = 0;
            let mut flips = 0;
            while done < component.len() {
                let face = component[done];
                done += 1;
                let is_flipped = flipped[face.index()] == Some(true);
                flips += usize::from(is_flipped);
                for halfedge in [0, 1, 2].map(|k| face.halfedge(k)) {
                    let Some(mate) = self.mate(halfedge) else { continue };
                    let other = mate.triangle();
                    if flipped[other.index()].is_none() {
                        flipped[other.index()] = Some(is_flipped ^ same_direction(faces, halfedge, mate));
                        component.push(other);
                    }
                }
            }
            let minority = flips * 2 <= component.len();
            result.extend(component.iter().copied().filter(|&face| flipped[face.index()] == Some(minority)));
        }
        result
    }

    /// Twin of each half-edge: its mate where the two run in opposite directions, else number [`NONE`].
    pub(crate) fn twins(&self, faces: &[[VertexId; 3]]) -> Vec<HalfedgeId> {
        let twin = |halfedge| {
            let mate = self.mate(halfedge).filter(|&mate| !same_direction(faces, halfedge, mate));
            mate.unwrap_or(HalfedgeId(NONE))
        };
        self.halfedges().map(twin).collect()
    }
}

/// The vertex that a half-edge leaves.
fn origin(faces: &[[VertexId; 3]], halfedge: HalfedgeId) -> VertexId {
    faces[halfedge.triangle().index()][halfedge.corner()]
}

/// Whether two half-edges of one edge leave the same vertex.
fn same_direction(faces: &[[VertexId; 3]], a: HalfedgeId, b: HalfedgeId) -> bool {
    origin(faces, a) == origin(faces, b)
}
