//! Cotan Laplacian, lumped mass, gradient and divergence on linear elements.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), section 3.2; Pinkall and Polthier (1993) for the weights.

use glam::DVec3;

use crate::halfedge::FaceData;
use crate::surface::Surface;
use crate::triangle;

/// The operators of one surface. Matrices are lower triangles in compressed columns: of each column the diagonal
/// comes first, then the rows below in ascending order.
#[derive(Debug, Clone)]
pub struct Laplacian {
    /// `#P + 1`, where each column begins.
    pub column_start: Vec<u32>,
    /// Row of each stored entry.
    pub rows: Vec<u32>,
    /// Cotan stiffness of each stored entry: positive semidefinite (−Δ), rows of the whole matrix sum to 0. No unit.
    pub stiffness: Vec<f64>,
    /// `#P`, a third of the area of the faces around each point; file's unit squared, non-negative.
    pub mass: Vec<f64>,
    /// Per face, for corners 1 and 2, area × gradient of the corner's hat function, written with cotangents and edges
    /// as the paper's divergence is. That of corner 0 is minus their sum.
    hat_gradients: FaceData<[DVec3; 2]>,
}

impl Laplacian {
    /// Assembles the operators.
    pub fn new(surface: &Surface) -> Self {
        let points = surface.point_count();
        let cotans: Vec<[f64; 3]> = surface.mesh.faces().map(|face| triangle::cotans(surface.corners(face))).collect();
        let areas: Vec<f64> = surface.mesh.faces().map(|face| surface.face_area(face)).collect();
        let mut laplacian = Self {
            column_start: Vec::with_capacity(points + 1),
            rows: Vec::with_capacity(surface.mesh.halfedge_count() / 2 + points),
            stiffness: Vec::with_capacity(surface.mesh.halfedge_count() / 2 + points),
            mass: Vec::with_capacity(points),
            hat_gradients: hat_gradients(surface, &cotans),
        };
        laplacian.column_start.push(0);
        let mut below: Vec<(u32, f64)> = Vec::new();
        for point in 0..points as u32 {
            below.clear();
            let mut diagonal = 0.0;
            let mut area = 0.0;
            for (face, k) in surface.corners_of_point(point) {
                let corners = surface.faces[face];
                let index = face.0 as usize;
                let [i, j] = [(k + 1) % 3, (k + 2) % 3];
                for (other, opposite) in [(i, j), (j, i)] {
                    let weight = 0.5 * cotans[index][opposite];
                    diagonal += weight;
                    if corners[other] > point {
                        below.push((corners[other], -weight));
                    }
                }
                area += areas[index];
            }
            laplacian.mass.push(area / 3.0);
            laplacian.rows.push(point);
            laplacian.stiffness.push(diagonal);
            below.sort_unstable_by_key(|entry| entry.0);
            for entries in below.chunk_by(|a, b| a.0 == b.0) {
                laplacian.rows.push(entries[0].0);
                laplacian.stiffness.push(entries.iter().map(|entry| entry.1).sum());
            }
            laplacian.column_start.push(laplacian.rows.len() as u32);
        }
        laplacian
    }

    /// Number of points, the size of the matrices.
    pub fn size(&self) -> usize {
        self.mass.len()
    }

    /// Stored entries of one column, as a range into `rows` and `stiffness`.
    pub fn column(&self, point: usize) -> std::ops::Range<usize> {
        self.column_start[point] as usize..self.column_start[point + 1] as usize
    }

    /// `L + mass_scale · M` with the held rows and columns replaced by those of the identity, whose 1 is of the order
    /// of the other diagonal entries. Zeros are stored, so that every such matrix has the same pattern.
    pub(crate) fn combine(&self, mass_scale: f64, held: impl Fn(usize) -> bool) -> Vec<f64> {
        let mut values = Vec::with_capacity(self.rows.len());
        for point in 0..self.size() {
            let mut column = self.column(point);
            let diagonal = column.next().map_or(0.0, |entry| self.stiffness[entry]);
            let is_held = held(point);
            values.push(if is_held { 1.0 } else { diagonal + mass_scale * self.mass[point] });
            values.extend(
                column.map(
                    |entry| {
                        if is_held || held(self.rows[entry] as usize) { 0.0 } else { self.stiffness[entry] }
                    },
                ),
            );
        }
        values
    }

    /// Integrated divergence, `#P`, of the unit field against the gradient of `heat` (`#P`): X = −∇u / |∇u| on each
    /// face, zero where u is constant. Signed so that `L φ` equals it for ∇φ = X.
    pub(crate) fn divergence_of_descent(&self, surface: &Surface, heat: &[f64]) -> Vec<f64> {
        let mut divergence = vec![0.0; self.size()];
        for (&[a, b, c], &[hat_b, hat_c]) in surface.faces.iter().zip(&self.hat_gradients) {
            let [a, b, c] = [a as usize, b as usize, c as usize];
            let (u, v, w) = (heat[a], heat[b], heat[c]);
            // Heat falls by hundreds of orders of magnitude over the surface; only ratios within the face matter.
            let scale = u.abs().max(v.abs()).max(w.abs());
            if scale == 0.0 {
                continue;
            }
            let u = u / scale;
            let field = -triangle::unit(hat_b * (v / scale - u) + hat_c * (w / scale - u));
            let (at_b, at_c) = (hat_b.dot(field), hat_c.dot(field));
            divergence[a] -= at_b + at_c;
            divergence[b] += at_b;
            divergence[c] += at_c;
        }
        divergence
    }
}

fn hat_gradients(surface: &Surface, cotans: &[[f64; 3]]) -> FaceData<[DVec3; 2]> {
    let gradients = surface.mesh.faces().zip(cotans).map(|(face, cotans)| {
        let edges = triangle::edges(surface.corners(face));
        [1, 2].map(|k| {
            let [i, j] = [(k + 1) % 3, (k + 2) % 3];
            // Edge j runs from corner k to i, edge i from j to k.
            (edges[i] * cotans[i] - edges[j] * cotans[j]) * 0.5
        })
    });
    gradients.collect::<Vec<_>>().into()
}
