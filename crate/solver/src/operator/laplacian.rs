//! Cotan Laplacian and lumped mass on linear elements.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), section 3.2; Pinkall and Polthier (1993) for the weights.

use std::ops::Range;
use std::sync::Arc;

use crate::operator::elements::Elements;
use heatwalk_sparse::{Pattern, SymmetricMatrix};

/// The operators of one surface. Matrices are lower triangles in compressed columns: of each column the diagonal
/// comes first, then the rows below in ascending order.
#[derive(Debug, Clone)]
pub struct Laplacian {
    /// Cotan stiffness of each stored entry: positive semidefinite (−Δ), rows of the whole matrix sum to 0. No unit.
    pub stiffness: SymmetricMatrix,
    /// `#V`, each vertex's share of the triangles (or of whatever elements) around it: a third of their area; file's unit squared,
    /// non-negative.
    pub mass: Vec<f64>,
}

/// Linear elements of some kind, as linear systems see them: matrices alone.
pub trait Discretization {
    /// Whether large factors are kept in single precision where their entries allow it, for speed.
    const ROUNDS: bool = false;

    /// Stiffness and mass.
    fn laplacian(&self) -> &Laplacian;

    /// The connected component of each vertex (`#V`), counted from 0 in the order of their first vertices.
    fn components(&self) -> &[u32];
}

impl Laplacian {
    pub(crate) fn of_elements(vertices: usize, elements: &Elements) -> Self {
        // Each side of a triangle is an entry first, in the column of its lower vertex; those of an edge are added up
        // in the end. An edge from a vertex to itself stores nothing: its ends have one value.
        let ends = |[a, b, c]: [u32; 3]| [[b, c], [c, a], [a, b]];
        let mut start = vec![0; vertices + 1];
        for [i, j] in elements.faces.iter().flat_map(|&face| ends(face)).filter(|[i, j]| i != j) {
            start[i.min(j) as usize + 1] += 1;
        }
        for vertex in 0..vertices {
            start[vertex + 1] += start[vertex];
        }
        let mut free: Vec<u32> = start.clone();
        let mut sides = vec![(0, 0.0); start[vertices] as usize];
        let mut diagonal = vec![0.0; vertices];
        let mut mass = vec![0.0; vertices];
        for (index, (&face, shape)) in elements.faces.iter().zip(&elements.shapes).enumerate() {
            let share = elements.share(index);
            let area = share * shape.area() / 3.0;
            for ((vertex, [i, j]), cotan) in face.into_iter().zip(ends(face)).zip(shape.cotans()) {
                mass[vertex as usize] += area;
                if i != j {
                    let weight = 0.5 * share * cotan;
                    diagonal[i as usize] += weight;
                    diagonal[j as usize] += weight;
                    let slot = &mut free[i.min(j) as usize];
                    sides[*slot as usize] = (i.max(j), -weight);
                    *slot += 1;
                }
            }
        }
        Self { stiffness: SymmetricMatrix::from_entries(&diagonal, &start, &mut sides), mass }
    }

    /// Number of vertices, the size of the matrices.
    pub fn size(&self) -> usize {
        self.mass.len()
    }

    /// Where the entries of the matrices are.
    pub(crate) fn pattern(&self) -> &Arc<Pattern> {
        self.stiffness.pattern()
    }

    /// Stored entries of one column, as a range into `rows` and `stiffness`.
    pub fn column(&self, vertex: usize) -> Range<usize> {
        self.pattern().column(vertex)
    }

    /// The first of the [`edges`](Self::edges) whose lower vertex is this one, and the entries of all of them.
    pub(crate) fn edges_of_column(&self, vertex: usize) -> (usize, Range<usize>) {
        let column = self.column(vertex);
        // Of each column the diagonal comes first, which is no edge.
        (column.start - vertex, column.start + 1..column.end)
    }

    /// All edges: their vertices, the lower first, and their weights, which are minus the entries off the diagonal.
    pub fn edges(&self) -> impl Iterator<Item = ([u32; 2], f64)> {
        let of = |low: usize| self.edges_from(low).map(move |(high, weight)| ([low as u32, high], weight));
        (0..self.size()).flat_map(of)
    }

    /// Those of a vertex that is the lower one: the higher ones, and the weights.
    #[inline]
    pub fn edges_from(&self, low: usize) -> impl Iterator<Item = (u32, f64)> {
        let (_, entries) = self.edges_of_column(low);
        let weights = &self.stiffness.values()[entries.clone()];
        self.rows()[entries].iter().zip(weights).map(|(&high, &value)| (high, -value))
    }

    /// Which of the [`edges`](Self::edges) joins two vertices; none where they are one, or share no element.
    pub(crate) fn edge(&self, [a, b]: [u32; 2]) -> Option<usize> {
        let (first, entries) = self.edges_of_column(a.min(b) as usize);
        self.rows()[entries].binary_search(&a.max(b)).ok().map(|place| first + place)
    }

    /// Row of each stored entry.
    pub fn rows(&self) -> &[u32] {
        self.pattern().rows()
    }

    /// `L + D`, D being a diagonal (`#V`), with the constrained rows and columns replaced by those of the identity, whose 1 is of the order
    /// of the other diagonal entries. Zeros are stored, so that every such matrix has the same pattern.
    pub(crate) fn combine(
        &self,
        added: impl Fn(usize) -> f64,
        is_constrained: impl Fn(usize) -> bool,
    ) -> SymmetricMatrix {
        let mut values = self.stiffness.values().to_vec();
        let is_constrained: Vec<bool> = (0..self.size()).map(is_constrained).collect();
        for vertex in 0..self.size() {
            let diagonal = self.column(vertex).start;
            values[diagonal] = if is_constrained[vertex] { 1.0 } else { values[diagonal] + added(vertex) };
        }
        if is_constrained.contains(&true) {
            for vertex in 0..self.size() {
                for entry in self.column(vertex).skip(1) {
                    if is_constrained[vertex] || is_constrained[self.rows()[entry] as usize] {
                        values[entry] = 0.0;
                    }
                }
            }
        }
        SymmetricMatrix::new(Arc::clone(self.pattern()), values).expect("the values are those of the pattern")
    }

    /// `(L + D) x` with every vertex free, D being a diagonal (`#V`).
    pub(crate) fn apply(&self, added: impl Fn(usize) -> f64, vector: &[f64]) -> Vec<f64> {
        let mut result: Vec<f64> = vector.iter().enumerate().map(|(vertex, value)| added(vertex) * value).collect();
        self.stiffness.multiply_add(vector, &mut result);
        result
    }
}
