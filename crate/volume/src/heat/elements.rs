//! Linear elements on tetrahedra: stiffness 1/6 Σ l cot θ, lumped mass, gradients and divergence.
//!
//! With a cost w in each tetrahedron, the metric is w² g. In three dimensions its volumes are w³ times as large and its squared
//! gradients w⁻² times, so that the stiffness is w times that of g, and the mass w³ times.

use glam::DVec3;
use heatwalk::operator::Discretization;
use heatwalk::operator::laplacian::Laplacian;
use heatwalk::sparse::SymmetricMatrix;

use crate::march::Medium;
use crate::mesh::{EDGES, FACES, TetId, TetMesh, six_volumes};

/// The shape of one tetrahedron.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Element {
    /// Gradients of the barycentric coordinates of corners 1 to 3; that of corner 0 is minus their sum.
    gradients: [DVec3; 3],
    /// Its volume.
    volume: f64,
}

/// Operators of a mesh.
#[derive(Debug)]
pub(crate) struct Elements {
    laplacian: Laplacian,
    components: Vec<u32>,
}

impl Discretization for Elements {
    const ROUNDS: bool = true;

    fn laplacian(&self) -> &Laplacian {
        &self.laplacian
    }

    fn components(&self) -> &[u32] {
        &self.components
    }
}

impl Elements {
    /// Of the tetrahedra of a mesh that are no walls. Vertices that only walls have are components of their own.
    pub(crate) fn new(mesh: &TetMesh, medium: &Medium) -> Self {
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
        for tetrahedron in open() {
            let shape = Element::of(mesh.corners(TetId(tetrahedron)));
            let cost = medium.cost(tetrahedron);
            for vertex in mesh.tetrahedra()[tetrahedron as usize] {
                mass[vertex as usize] += cost.powi(3) * shape.volume / 4.0;
            }
            let gradients = shape.all_gradients();
            for (ends, [a, b]) in EDGES.into_iter().zip(ends(tetrahedron)) {
                // −V ∇λ·∇λ' is l cot θ / 6 of the edge opposite.
                let weight = -cost * shape.volume * gradients[ends[0]].dot(gradients[ends[1]]);
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
        Self { laplacian: Laplacian { stiffness, mass }, components: components(mesh, medium) }
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
        Self { gradients: [gradient(1), gradient(2), gradient(3)], volume: six / 6.0 }
    }

    /// The integrated divergence at its corners of a field that has `vector` in it: summed over elements, `L φ` equals it where the
    /// field is ∇φ.
    #[inline]
    pub(super) fn divergence(&self, vector: DVec3) -> [f64; 4] {
        let flux = self.volume * vector;
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
