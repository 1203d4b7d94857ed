//! Linear elements on tetrahedra: stiffness 1/6 Σ l cot θ, lumped mass, gradients and divergence.
//!
//! With a cost w in each tetrahedron, the metric is w² g. In three dimensions its volumes are w³ times as large and its squared
//! gradients w⁻² times, so that the stiffness is w times that of g, and the mass w³ times.
//!
//! The corners of a flat tetrahedron are nearly in a plane, where a linear function has three degrees of freedom: its stiffness, which
//! has no bound as its height falls, ties the fourth value to the others. Heat that falls exponentially is not linear over edges as long
//! as √t, and along a row of flat tetrahedra it can alternate in sign instead of falling, so that it arrives before its wave. Such a
//! tetrahedron has next to no volume, and need not conduct across: stiffness there is bounded by the shortest edge.

use glam::{DMat3, DVec3};
use heatwalk::operator::Laplacian;
use heatwalk::sparse::SymmetricMatrix;

use crate::march::Medium;
use crate::mesh::{EDGES, FACES, TetId, TetMesh, six_volumes};

/// In no direction does a tetrahedron conduct as if the squared slopes of its four barycentric coordinates, times the square of its
/// shortest edge, had a greater sum. That is 2 in a regular one and at most 3.4 in those of a cube cut into six. A bound of 4 would change
/// a seventh of the tetrahedra in a jittered cube.
const MOST_STEEPNESS: f64 = 6.25;

/// Of the weights of edges, tetrahedron by tetrahedron, at most this share by size may be negative for the field of the logarithm:
/// obtuse ones let heat through against its fall, and their edges do not tell how it falls.
const NEGATIVE_SHARE: f64 = 0.155;

/// The shape of one tetrahedron.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Element {
    /// Gradients of the barycentric coordinates of corners 1 to 3; that of corner 0 is minus their sum.
    gradients: [DVec3; 3],
    /// Its volume.
    volume: f64,
    /// Across it where it is flat, of a length whose square is the share of a flow in this direction that is kept back.
    across: DVec3,
}

/// Operators of a mesh.
#[derive(Debug)]
pub(super) struct Elements {
    laplacian: Laplacian,
    components: Vec<u32>,
    is_monotone: bool,
}

impl Elements {
    /// Of the tetrahedra of a mesh that are no walls. Vertices that only walls have are components of their own.
    pub(super) fn new(mesh: &TetMesh, medium: &Medium) -> Self {
        let vertices = mesh.vertex_count();
        let open = || (0..mesh.tetrahedron_count() as u32).filter(|&tetrahedron| medium.cost(tetrahedron).is_finite());
        let ends = |tetrahedron: u32| {
            let corners = mesh.tetrahedra()[tetrahedron as usize];
            EDGES.map(|ends| ends.map(|corner| corners[corner]))
        };
        let mut start = vec![0_u32; vertices + 1];
        for [a, b] in open().flat_map(ends) {
            start[a.min(b) as usize + 1] += 1;
        }
        for vertex in 0..vertices {
            start[vertex + 1] += start[vertex];
        }
        let mut free: Vec<u32> = start.clone();
        let mut entries = vec![(0, 0.0); start[vertices] as usize];
        let (mut diagonal, mut mass) = (vec![0.0; vertices], vec![0.0; vertices]);
        let (mut negative, mut whole) = (0.0, 0.0);
        for tetrahedron in open() {
            let shape = Element::of(mesh.corners(TetId(tetrahedron)));
            let cost = medium.cost(tetrahedron);
            for vertex in mesh.tetrahedra()[tetrahedron as usize] {
                mass[vertex as usize] += cost.powi(3) * shape.volume / 4.0;
            }
            let gradients = shape.all_gradients();
            let flows = gradients.map(|gradient| cost * shape.volume * shape.conducted(gradient));
            for (ends, [a, b]) in EDGES.into_iter().zip(ends(tetrahedron)) {
                // −V ∇λ·∇λ' is l cot θ / 6 of the edge opposite.
                let weight = -gradients[ends[0]].dot(flows[ends[1]]);
                negative += (-weight).max(0.0);
                whole += weight.abs();
                diagonal[a as usize] += weight;
                diagonal[b as usize] += weight;
                let place = &mut free[a.min(b) as usize];
                entries[*place as usize] = (a.max(b), -weight);
                *place += 1;
            }
        }
        // A vertex inside of walls has an equation of its own.
        for (diagonal, mass) in diagonal.iter_mut().zip(&mass) {
            if *mass == 0.0 {
                *diagonal = 1.0;
            }
        }
        let stiffness = SymmetricMatrix::from_entries(&diagonal, &start, &mut entries);
        Self {
            laplacian: Laplacian { stiffness, mass },
            components: components(mesh, medium),
            is_monotone: negative <= NEGATIVE_SHARE * whole,
        }
    }

    pub(super) fn laplacian(&self) -> &Laplacian {
        &self.laplacian
    }

    /// As [`Discretization::components`](heatwalk::operator::Discretization::components).
    pub(super) fn components(&self) -> &[u32] {
        &self.components
    }

    /// Whether tetrahedra are obtuse in few places only, so that heat falls along edges.
    pub(super) fn is_monotone(&self) -> bool {
        self.is_monotone
    }
}

impl Element {
    /// Gradients are the inward normals of the faces opposite, over the heights.
    #[inline]
    pub(super) fn of(corners: [DVec3; 4]) -> Self {
        let six = six_volumes(corners);
        let gradient = |corner: usize| {
            let [a, b, c] = FACES[corner].map(|corner| corners[corner]);
            -(b - a).cross(c - a) / six
        };
        let mut element =
            Self { gradients: [gradient(1), gradient(2), gradient(3)], volume: six / 6.0, across: DVec3::ZERO };
        let shortest =
            EDGES.map(|[a, b]| corners[a].distance_squared(corners[b])).into_iter().fold(f64::INFINITY, f64::min);
        element.across = element.bounded(MOST_STEEPNESS / shortest);
        element
    }

    /// In the steepest direction, what has to be kept back so that the sum of the squared slopes is at most `most`.
    #[inline]
    fn bounded(&self, most: f64) -> DVec3 {
        let gradients = self.all_gradients();
        let outer = |by: DVec3| DMat3::from_cols(by.x * by, by.y * by, by.z * by);
        // In a direction d the sum of the squared slopes is d·Sd, relative to `most`.
        let slopes = gradients.map(outer).into_iter().sum::<DMat3>() / most;
        let norm_squared: f64 = [slopes.x_axis, slopes.y_axis, slopes.z_axis].map(DVec3::length_squared).iter().sum();
        // The Frobenius norm bounds it, and spares most tetrahedra the rest.
        if norm_squared <= 1.0 {
            return DVec3::ZERO;
        }
        // Where a tetrahedron is flat, its largest face is nearly in its plane, so that two steps of the power method are enough.
        let steepest =
            |one: DVec3, other: DVec3| if other.length_squared() > one.length_squared() { other } else { one };
        let direction = (slopes * (slopes * gradients.into_iter().fold(DVec3::ZERO, steepest))).normalize();
        let steepness = direction.dot(slopes * direction);
        (1.0 - 1.0 / steepness).max(0.0).sqrt() * direction
    }

    /// What flows where a function has this gradient.
    #[inline]
    fn conducted(&self, gradient: DVec3) -> DVec3 {
        gradient - self.across.dot(gradient) * self.across
    }

    /// The integrated divergence at its corners of a field that has `vector` in it: summed over elements, `L φ` equals it where the
    /// field is ∇φ.
    #[inline]
    pub(super) fn divergence(&self, vector: DVec3) -> [f64; 4] {
        let flux = self.volume * self.conducted(vector);
        let [b, c, d] = self.gradients.map(|gradient| gradient.dot(flux));
        [-(b + c + d), b, c, d]
    }

    fn all_gradients(&self) -> [DVec3; 4] {
        let [b, c, d] = self.gradients;
        [-(b + c + d), b, c, d]
    }

    /// The gradient of a function given at its corners.
    #[inline]
    pub(super) fn gradient(&self, [a, b, c, d]: [f64; 4]) -> DVec3 {
        self.gradients[0] * (b - a) + self.gradients[1] * (c - a) + self.gradients[2] * (d - a)
    }
}

/// The gradient in a tetrahedron of a function given at its corners.
pub(crate) fn gradient_in(corners: [DVec3; 4], values: [f64; 4]) -> DVec3 {
    Element::of(corners).gradient(values)
}

/// Component of each vertex by the tetrahedra that are no walls, counted from 0 in the order of their first vertices.
fn components(mesh: &TetMesh, medium: &Medium) -> Vec<u32> {
    if !medium.has_walls() {
        return mesh.components().to_vec();
    }
    let open = (0..mesh.tetrahedron_count() as u32).filter(|&tetrahedron| medium.cost(tetrahedron).is_finite());
    crate::mesh::components(mesh.vertex_count(), open.map(|tetrahedron| mesh.tetrahedra()[tetrahedron as usize])).0
}
