//! Connection Laplacian: that of tangent vectors.
//!
//! Sharp, Soliman, Crane, "The vector heat method" (2019).

use heatwalk_sparse::{SymmetricMatrix, c64};
use heatwalk_surface::HalfedgeId;

use crate::operator::frames::Frames;
use crate::operator::metric::Operators;

/// The operators of tangent vectors, which are complex numbers in the planes of [`Frames`]. Matrices have the pattern of those
/// of functions, so that one elimination order serves both.
#[derive(Debug, Clone)]
pub struct ConnectionLaplacian {
    /// Hermitian (−Δ): `zᴴ L z` is the sum over edges of their cotan weight times the square of `z` at one end less that carried there
    /// from the other. Positive semidefinite where no weight is negative, and flat surfaces have vectors whose image is 0.
    pub stiffness: SymmetricMatrix<c64>,
    /// `#V`, each vertex's share of the triangles around it, in the file's unit squared.
    pub mass: Vec<f64>,
}

impl ConnectionLaplacian {
    /// On the triangles of the frames, with the weights and the pattern of `operators`.
    ///
    /// # Panics
    /// Where the operators are not [those](Operators::of_triangulation) of the frames' triangulation.
    pub fn new(frames: &Frames, operators: &Operators) -> Self {
        let (elements, laplacian) = (&operators.elements, operators.laplacian());
        assert_eq!(elements.faces.len(), frames.triangulation().face_count(), "operators are of the same triangles");
        let mut values = vec![c64::new(0.0, 0.0); laplacian.pattern().nonzeros()];
        for (face, shape) in elements.shapes.iter().enumerate() {
            let cotans = shape.cotans();
            for k in 0..3 {
                let side = HalfedgeId((3 * face + k) as u32);
                let [start, end] = frames.triangulation().ends(side).map(|vertex| vertex.0);
                let (weight, transport) = (0.5 * cotans[(k + 2) % 3], frames.transport(side));
                for vertex in [start, end] {
                    values[laplacian.column(vertex as usize).start] += weight;
                }
                match laplacian.edge([start, end]) {
                    // The lower vertex is the column of an entry.
                    Some(edge) => {
                        let upward = if start < end { transport } else { transport.conj() };
                        values[edge + start.min(end) as usize + 1] -= weight * upward;
                    }
                    None => values[laplacian.column(start as usize).start] -= 2.0 * weight * transport.re,
                }
            }
        }
        let stiffness = SymmetricMatrix::new(laplacian.pattern().clone(), values).expect("values of the pattern");
        Self { stiffness, mass: laplacian.mass.clone() }
    }

    /// `M / t + L`, of one implicit step of time t, in the file's unit squared.
    pub fn heat_matrix(&self, time: f64) -> SymmetricMatrix<c64> {
        let (pattern, mut values) = self.stiffness.clone().into_parts();
        for (vertex, mass) in self.mass.iter().enumerate() {
            values[pattern.column(vertex).start] += mass / time;
        }
        SymmetricMatrix::new(pattern, values).expect("values of the pattern")
    }
}
