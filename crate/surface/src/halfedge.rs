//! Half-edge connectivity and typed per-element arrays, in the words of geometry-central.

use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

use crate::csr::NONE;

macro_rules! element {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(pub u32);

        impl Element for $name {
            fn index(self) -> usize {
                self.0 as usize
            }
        }
    };
}

/// A numbered mesh element.
pub trait Element: Copy {
    /// Its number, counted from 0.
    fn index(self) -> usize;
}

element!(
    /// A vertex of a [`HalfedgeMesh`]. Several may share one welded point where the surface is cut.
    Vertex
);
element!(
    /// A face of a [`HalfedgeMesh`]: a triangle, or, numbered after all triangles, the cap of a boundary loop.
    Face
);
element!(
    /// A half-edge of a [`HalfedgeMesh`]; number `3 f + k` leaves corner `k` of triangle `f`.
    Halfedge
);

/// One value for each element of a kind.
#[derive(Debug, Clone, PartialEq)]
pub struct ElementData<E, T> {
    values: Vec<T>,
    element: PhantomData<E>,
}

/// `#V` values, indexed by [`Vertex`].
pub type VertexData<T> = ElementData<Vertex, T>;
/// `#F` values, indexed by [`Face`].
pub type FaceData<T> = ElementData<Face, T>;

impl<E, T> From<Vec<T>> for ElementData<E, T> {
    fn from(values: Vec<T>) -> Self {
        Self { values, element: PhantomData }
    }
}

impl<E, T> ElementData<E, T> {
    /// Number of values.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The values in element order.
    pub fn iter(&self) -> std::slice::Iter<'_, T> {
        self.values.iter()
    }

    /// The values in element order.
    pub fn as_slice(&self) -> &[T] {
        &self.values
    }
}

impl<'a, E, T> IntoIterator for &'a ElementData<E, T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<E: Element, T> Index<E> for ElementData<E, T> {
    type Output = T;

    fn index(&self, element: E) -> &T {
        &self.values[element.index()]
    }
}

impl<E: Element, T> IndexMut<E> for ElementData<E, T> {
    fn index_mut(&mut self, element: E) -> &mut T {
        &mut self.values[element.index()]
    }
}

/// Oriented manifold triangle connectivity. Every half-edge has a twin and a next: boundary loops are capped by
/// boundary faces, whose half-edges run against the triangles beside them.
///
/// Invariants: `twin(twin(h)) == h != twin(h)`; `next` is a permutation whose cycles are the faces; a half-edge and
/// its twin run in opposite directions; the half-edges that leave a vertex form one cycle of `next(twin(h))`.
#[derive(Debug, Clone)]
pub struct HalfedgeMesh {
    /// `#H`, the vertex that each half-edge leaves.
    vertex: Vec<Vertex>,
    /// `#H`.
    twin: Vec<Halfedge>,
    /// Successor of each boundary half-edge; a triangle's follow from their numbers.
    boundary_next: Vec<Halfedge>,
    /// Boundary face of each boundary half-edge.
    boundary_face: Vec<Face>,
    /// One half-edge of each boundary face.
    loops: Vec<Halfedge>,
    /// `#V`, a half-edge that leaves the vertex: the boundary one where there is one.
    outgoing: Vec<Halfedge>,
    triangles: u32,
}

fn next_in_triangle(halfedge: u32) -> u32 {
    if halfedge % 3 == 2 { halfedge - 2 } else { halfedge + 1 }
}

fn previous_in_triangle(halfedge: u32) -> u32 {
    if halfedge.is_multiple_of(3) { halfedge + 2 } else { halfedge - 1 }
}

impl HalfedgeMesh {
    /// Builds the mesh from oriented triangles over points and the twin of each of their half-edges ([`NONE`]: no
    /// twin, so boundary or cut). Returns it with the point of each vertex. The first fan of triangles around point
    /// `p` becomes vertex `p`; further fans become vertices after the last point.
    pub fn from_twins(points: usize, faces: &[[u32; 3]], mut twin: Vec<Halfedge>) -> (Self, VertexData<u32>) {
        let triangles = faces.len() as u32;
        let interior = faces.len() * 3;
        let mut vertex = vec![Vertex(NONE); interior];
        let mut outgoing = vec![Halfedge(NONE); points];
        let mut point_of_vertex: Vec<u32> = (0..points as u32).collect();
        for (corner, &point) in (0..).zip(faces.iter().flatten()) {
            if vertex[corner as usize].0 != NONE {
                continue;
            }
            let fan = if outgoing[point as usize].0 == NONE {
                Vertex(point)
            } else {
                outgoing.push(Halfedge(NONE));
                point_of_vertex.push(point);
                Vertex(outgoing.len() as u32 - 1)
            };
            let mut halfedge = corner;
            let is_closed = loop {
                vertex[halfedge as usize] = fan;
                halfedge = twin[previous_in_triangle(halfedge) as usize].0;
                if halfedge == NONE || halfedge == corner {
                    break halfedge == corner;
                }
            };
            let mut first = corner;
            while !is_closed && twin[first as usize].0 != NONE {
                first = next_in_triangle(twin[first as usize].0);
                vertex[first as usize] = fan;
            }
            outgoing[fan.index()] = Halfedge(first);
        }
        for halfedge in 0..interior {
            if twin[halfedge].0 != NONE {
                continue;
            }
            let boundary = Halfedge(vertex.len() as u32);
            let origin = vertex[next_in_triangle(halfedge as u32) as usize];
            twin[halfedge] = boundary;
            vertex.push(origin);
            twin.push(Halfedge(halfedge as u32));
            outgoing[origin.index()] = boundary;
        }
        let boundary_next: Vec<Halfedge> =
            twin[interior..].iter().map(|inner| outgoing[vertex[inner.index()].index()]).collect();
        let mut boundary_face = vec![Face(NONE); boundary_next.len()];
        let mut loops = Vec::new();
        for start in 0..boundary_next.len() {
            if boundary_face[start].0 != NONE {
                continue;
            }
            let face = Face(triangles + loops.len() as u32);
            loops.push(Halfedge((interior + start) as u32));
            let mut slot = start;
            while boundary_face[slot].0 == NONE {
                boundary_face[slot] = face;
                slot = boundary_next[slot].index() - interior;
            }
        }
        (Self { vertex, twin, boundary_next, boundary_face, loops, outgoing, triangles }, point_of_vertex.into())
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
    pub fn vertex(&self, halfedge: Halfedge) -> Vertex {
        self.vertex[halfedge.index()]
    }

    /// The vertex that the half-edge enters.
    pub fn tip(&self, halfedge: Halfedge) -> Vertex {
        self.vertex(self.twin(halfedge))
    }

    /// The half-edge along the same edge in the opposite direction.
    pub fn twin(&self, halfedge: Halfedge) -> Halfedge {
        self.twin[halfedge.index()]
    }

    /// The following half-edge of the same face, counter-clockwise in a triangle.
    pub fn next(&self, halfedge: Halfedge) -> Halfedge {
        match halfedge.index().checked_sub(self.face_count() * 3) {
            Some(slot) => self.boundary_next[slot],
            None => Halfedge(next_in_triangle(halfedge.0)),
        }
    }

    /// The face on the half-edge's left.
    pub fn face(&self, halfedge: Halfedge) -> Face {
        match halfedge.index().checked_sub(self.face_count() * 3) {
            Some(slot) => self.boundary_face[slot],
            None => Face(halfedge.0 / 3),
        }
    }

    /// Whether the face caps a boundary loop.
    pub fn is_boundary(&self, face: Face) -> bool {
        face.0 >= self.triangles
    }

    /// Whether the vertex lies on a boundary loop.
    pub fn is_boundary_vertex(&self, vertex: Vertex) -> bool {
        self.is_boundary(self.face(self.outgoing[vertex.index()]))
    }

    /// A half-edge that leaves the vertex: the one on the boundary where there is one.
    pub fn halfedge_of_vertex(&self, vertex: Vertex) -> Halfedge {
        self.outgoing[vertex.index()]
    }

    /// A half-edge of the face; of a triangle, the one that leaves its first corner.
    pub fn halfedge_of_face(&self, face: Face) -> Halfedge {
        match face.0.checked_sub(self.triangles) {
            Some(cap) => self.loops[cap as usize],
            None => Halfedge(face.0 * 3),
        }
    }

    /// All vertices.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = Vertex> + use<> {
        (0..self.vertex_count() as u32).map(Vertex)
    }

    /// All triangles.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = Face> + use<> {
        (0..self.triangles).map(Face)
    }

    /// All half-edges, those of boundary faces last.
    pub fn halfedges(&self) -> impl ExactSizeIterator<Item = Halfedge> + use<> {
        (0..self.halfedge_count() as u32).map(Halfedge)
    }

    /// The faces that cap the boundary loops.
    pub fn boundary_loops(&self) -> impl ExactSizeIterator<Item = Face> + use<> {
        (self.triangles..self.triangles + self.loops.len() as u32).map(Face)
    }

    /// The half-edges of a face in order.
    pub fn halfedges_of_face(&self, face: Face) -> impl Iterator<Item = Halfedge> + '_ {
        cycle(self.halfedge_of_face(face), |halfedge| self.next(halfedge))
    }

    /// The half-edges that leave a vertex, clockwise.
    pub fn outgoing(&self, vertex: Vertex) -> impl Iterator<Item = Halfedge> + '_ {
        cycle(self.halfedge_of_vertex(vertex), |halfedge| self.next(self.twin(halfedge)))
    }

    /// Number of connected pieces, those that share only a cut point counted apart.
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
                    let beside = self.face(self.twin(halfedge));
                    if !self.is_boundary(beside) && !std::mem::replace(&mut seen[beside.index()], true) {
                        stack.push(beside);
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

fn cycle(start: Halfedge, step: impl Fn(Halfedge) -> Halfedge) -> impl Iterator<Item = Halfedge> {
    std::iter::successors(Some(start), move |&halfedge| Some(step(halfedge)).filter(|&after| after != start))
}
