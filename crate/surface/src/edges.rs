//! Which half-edges of a triangle list lie on the same edge, and which triangles to flip so that neighbours agree.

use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use heatwalk_base::csr::{Csr, NONE};
use heatwalk_base::parallel::{self, Numbers};
use heatwalk_base::sort;

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

/// Which edges half-edges lie on, each of which is walked around once, however many of its half-edges are asked for.
#[derive(Debug, Default)]
pub struct EdgeNames {
    first: BTreeMap<HalfedgeId, HalfedgeId>,
}

impl EdgeNames {
    /// The first half-edge of the same edge.
    pub fn first(&mut self, edges: &Edges, halfedge: HalfedgeId) -> HalfedgeId {
        if let Some(&first) = self.first.get(&halfedge) {
            return first;
        }
        let first = edges.first(halfedge);
        self.first.extend(edges.around(first).map(|halfedge| (halfedge, first)));
        first
    }
}

impl Edges {
    /// Finds the half-edges between the same vertices, and the faces whose three vertices an earlier face has, in any order,
    /// ascending.
    pub fn new(faces: &[[VertexId; 3]], corners: &Corners, threads: NonZeroUsize) -> (Self, Vec<FaceId>) {
        let next = Numbers::identity(3 * faces.len());
        let duplicates = parallel::map(corners.ranges(threads), |vertices| {
            let (mut duplicates, mut apexes) = (Vec::new(), Vec::new());
            // Half-edges from or to a higher vertex, below the number of that.
            let mut star: Vec<u64> = Vec::new();
            for vertex in vertices.map(VertexId::from_index) {
                star.clear();
                for &corner in corners.row(vertex) {
                    let (face, before) = (faces[corner.triangle().index()], corner.previous_in_triangle());
                    let ends = [(face[corner.next_in_triangle().corner()], corner), (face[before.corner()], before)];
                    let higher = ends.into_iter().filter(|&(other, _)| other > vertex);
                    star.extend(higher.map(|(other, halfedge)| u64::from(other.0) << 32 | u64::from(halfedge.0)));
                }
                star.sort_unstable();
                for edge in star.chunk_by(|a, b| a >> 32 == b >> 32).filter(|edge| edge.len() > 1) {
                    let halfedges = edge.iter().map(|&pair| HalfedgeId(pair as u32));
                    for (halfedge, after) in halfedges.clone().zip(halfedges.clone().cycle().skip(1)) {
                        next.set(halfedge.0, after.0);
                    }
                    let apex = |halfedge: HalfedgeId| origin(faces, halfedge.previous_in_triangle());
                    apexes.clear();
                    apexes.extend(halfedges.map(|halfedge| (apex(halfedge), halfedge.triangle())));
                    sort::sort(&mut apexes);
                    duplicates.extend(apexes.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1].1));
                }
            }
            duplicates
        });
        let mut duplicates = duplicates.concat();
        sort::sort(&mut duplicates);
        duplicates.dedup();
        (Self { next: next.into_elements() }, duplicates)
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

    /// The first half-edge of the same edge.
    pub(crate) fn first(&self, halfedge: HalfedgeId) -> HalfedgeId {
        let last =
            self.around(halfedge).find(|&at| self.next_on_edge(at) <= at).expect("a cycle ascends but for one step");
        self.next_on_edge(last)
    }

    fn halfedges(&self) -> impl ExactSizeIterator<Item = HalfedgeId> + Clone + use<> {
        (0..self.next.len() as u32).map(HalfedgeId)
    }

    /// One half-edge of each edge: its last one.
    pub fn representatives(&self) -> impl Iterator<Item = HalfedgeId> + Clone + '_ {
        self.representatives_in(0..self.next.len())
    }

    /// Those of them in a range of half-edges.
    pub(crate) fn representatives_in(&self, halfedges: Range<usize>) -> impl Iterator<Item = HalfedgeId> + Clone + '_ {
        halfedges.map(HalfedgeId::from_index).filter(|&halfedge| self.next_on_edge(halfedge) <= halfedge)
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

    /// The edges without some faces, ascending, in the order of the others.
    pub fn without(&self, removed: &[FaceId]) -> Self {
        let mut is_kept = vec![true; self.next.len() / 3];
        for face in removed {
            is_kept[face.index()] = false;
        }
        let mut count = 0;
        let mut renumbered = Vec::with_capacity(is_kept.len());
        for &is_kept in &is_kept {
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

    /// The edges with only half-edges of one class on each; one without a class is alone.
    pub(crate) fn parted(&self, class: impl Fn(HalfedgeId) -> Option<bool>) -> Self {
        let mut next: Vec<HalfedgeId> = self.halfedges().collect();
        for last in self.representatives() {
            // Of each class the first half-edge of the edge and the last one so far.
            let mut cycles: [Option<[HalfedgeId; 2]>; 2] = [None; 2];
            for halfedge in self.around(self.next_on_edge(last)) {
                let Some(class) = class(halfedge) else { continue };
                let [first, before] = cycles[usize::from(class)].unwrap_or([halfedge; 2]);
                next[before.index()] = halfedge;
                next[halfedge.index()] = first;
                cycles[usize::from(class)] = Some([first, halfedge]);
            }
        }
        Self { next }
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

    /// Twin of each half-edge: its mate where the two run in opposite directions, else number [`NONE`]; and whether all mates
    /// do.
    pub(crate) fn twins(&self, faces: &[[VertexId; 3]], threads: NonZeroUsize) -> (Vec<HalfedgeId>, bool) {
        let does_agree = AtomicBool::new(true);
        let twins = parallel::collect(self.next.len(), threads, |halfedge| {
            let halfedge = HalfedgeId::from_index(halfedge);
            let Some(mate) = self.mate(halfedge) else { return HalfedgeId(NONE) };
            if same_direction(faces, halfedge, mate) {
                does_agree.store(false, Ordering::Relaxed);
                return HalfedgeId(NONE);
            }
            mate
        });
        (twins, does_agree.into_inner())
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
