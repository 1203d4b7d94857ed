//! Cotan Laplacian and lumped mass on linear elements.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), section 3.2; Pinkall and Polthier (1993) for the weights.

use std::sync::Arc;

use crate::csr::Csr;
use crate::linear::Pattern;
use crate::operator::Operator;
use crate::operator::elements::Elements;
use crate::surface::Surface;

/// The operators of one surface. Matrices are lower triangles in compressed columns: of each column the diagonal
/// comes first, then the rows below in ascending order.
#[derive(Debug, Clone)]
pub struct Laplacian {
    pub(crate) pattern: Arc<Pattern>,
    /// Cotan stiffness of each stored entry: positive semidefinite (−Δ), rows of the whole matrix sum to 0. No unit.
    pub stiffness: Vec<f64>,
    /// `#P`, a third of the area of the triangles around each point; file's unit squared, non-negative.
    pub mass: Vec<f64>,
}

impl Laplacian {
    /// Assembles the operators on the triangles that `operator` chooses.
    pub fn new(surface: &Surface, operator: Operator) -> Self {
        Self::of_elements(surface.point_count(), &operator.elements(surface))
    }

    pub(crate) fn of_elements(points: usize, elements: &Elements) -> Self {
        let corners_of_point = Csr::group(points, elements.faces.iter().flatten().copied());
        let cotans: Vec<[f64; 3]> = elements.shapes.iter().map(|shape| shape.cotans()).collect();
        let capacity = elements.faces.len() * 3 / 2 + 2 * points;
        let mut pattern = Pattern { column_start: Vec::with_capacity(points + 1), rows: Vec::with_capacity(capacity) };
        let mut stiffness = Vec::with_capacity(capacity);
        let mut mass = Vec::with_capacity(points);
        pattern.column_start.push(0);
        let mut below: Vec<(u32, f64)> = Vec::new();
        for point in 0..points as u32 {
            below.clear();
            let mut diagonal = 0.0;
            let mut area = 0.0;
            for &corner in corners_of_point.row(point) {
                let (face, k) = (corner as usize / 3, corner as usize % 3);
                let corners = elements.faces[face];
                let [i, j] = [(k + 1) % 3, (k + 2) % 3];
                for (other, opposite) in [(i, j), (j, i)] {
                    // An edge from a point to itself stores nothing: its ends have one value.
                    if corners[other] != point {
                        let weight = 0.5 * elements.share * cotans[face][opposite];
                        diagonal += weight;
                        if corners[other] > point {
                            below.push((corners[other], -weight));
                        }
                    }
                }
                area += elements.shapes[face].area();
            }
            mass.push(elements.share * area / 3.0);
            pattern.rows.push(point);
            stiffness.push(diagonal);
            below.sort_unstable_by_key(|entry| entry.0);
            for entries in below.chunk_by(|a, b| a.0 == b.0) {
                pattern.rows.push(entries[0].0);
                stiffness.push(entries.iter().map(|entry| entry.1).sum());
            }
            pattern.column_start.push(pattern.rows.len() as u32);
        }
        Self { pattern: Arc::new(pattern), stiffness, mass }
    }

    /// Number of points, the size of the matrices.
    pub fn size(&self) -> usize {
        self.mass.len()
    }

    /// Stored entries of one column, as a range into `rows` and `stiffness`.
    pub fn column(&self, point: usize) -> std::ops::Range<usize> {
        self.pattern.column(point)
    }

    /// Row of each stored entry.
    pub fn rows(&self) -> &[u32] {
        &self.pattern.rows
    }

    /// `L + mass_scale · M` with the held rows and columns replaced by those of the identity, whose 1 is of the order
    /// of the other diagonal entries. Zeros are stored, so that every such matrix has the same pattern.
    pub(crate) fn combine(&self, mass_scale: f64, held: impl Fn(usize) -> bool) -> Vec<f64> {
        let mut values = Vec::with_capacity(self.stiffness.len());
        for point in 0..self.size() {
            let mut column = self.column(point);
            let diagonal = column.next().map_or(0.0, |entry| self.stiffness[entry]);
            let is_held = held(point);
            values.push(if is_held { 1.0 } else { diagonal + mass_scale * self.mass[point] });
            values.extend(
                column.map(
                    |entry| {
                        if is_held || held(self.rows()[entry] as usize) { 0.0 } else { self.stiffness[entry] }
                    },
                ),
            );
        }
        values
    }

    /// `(L + mass_scale · M) x` with every point free.
    pub(crate) fn apply(&self, mass_scale: f64, vector: &[f64]) -> Vec<f64> {
        let mut result: Vec<f64> =
            vector.iter().zip(&self.mass).map(|(value, mass)| mass_scale * mass * value).collect();
        self.pattern.multiply_add(&self.stiffness, vector, &mut result);
        result
    }
}
