//! Seeing inside of a mesh: what a cut leaves of it, tetrahedra pulled apart, and surfaces of equal distance.

mod caps;
mod cells;
mod crossing;
mod cut;
mod levels;
mod shells;

use glam::DVec3;

use crate::distance::VolumeDistance;
use crate::error::{Error, Result};
use crate::mesh::{MeshId, TetId, TetMesh};

pub use cut::{Cut, Faces, Plane};
pub use shells::Shells;

/// Triangles inside of a mesh, each in one tetrahedron.
#[derive(Debug, Clone)]
pub struct Section {
    mesh: MeshId,
    /// Of each vertex where it is, in the file's unit.
    pub positions: Vec<DVec3>,
    /// Of each vertex the unit normal of its triangles, to the side that they are seen from.
    pub normals: Vec<DVec3>,
    /// Vertices of each triangle, counter-clockwise seen from where the normal points.
    pub triangles: Vec<[u32; 3]>,
    /// Of each vertex the tetrahedron that its triangles are in.
    pub tetrahedra: Vec<TetId>,
    /// Of each vertex its barycentric weights in that tetrahedron: 0 or more, of sum 1 up to rounding.
    pub weights: Vec<[f64; 4]>,
}

impl Section {
    fn empty(mesh: &TetMesh) -> Self {
        Self {
            mesh: mesh.id(),
            positions: Vec::new(),
            normals: Vec::new(),
            triangles: Vec::new(),
            tetrahedra: Vec::new(),
            weights: Vec::new(),
        }
    }

    /// Makes room for so many triangles with vertices of their own.
    fn reserve(&mut self, triangles: usize) {
        self.positions.reserve_exact(3 * triangles);
        self.normals.reserve_exact(3 * triangles);
        self.triangles.reserve_exact(triangles);
        self.tetrahedra.reserve_exact(3 * triangles);
        self.weights.reserve_exact(3 * triangles);
    }

    fn push(&mut self, position: DVec3, normal: DVec3, tetrahedron: TetId, weights: [f64; 4]) {
        self.positions.push(position);
        self.normals.push(normal);
        self.tetrahedra.push(tetrahedron);
        self.weights.push(weights);
    }

    /// What is seen where a mesh is cut: [`Self::of_cut`] or [`Self::of_tetrahedra`].
    pub fn of(mesh: &TetMesh, cut: &Cut, faces: Faces) -> Self {
        match faces {
            Faces::Smooth => Self::of_cut(mesh, cut),
            Faces::Tetrahedra => Self::of_tetrahedra(mesh, cut),
        }
    }

    /// The linear interpolation of values of the mesh's vertices (`#V`) at each vertex of the section; infinity where a corner of
    /// positive weight is infinite.
    ///
    /// # Errors
    /// [`Error::ForeignMesh`] for another mesh than that of the section; [`Error::ValueCount`].
    pub fn interpolate(&self, mesh: &TetMesh, values: &[f64]) -> Result<Vec<f64>> {
        self.require(mesh)?;
        if values.len() != mesh.vertex_count() {
            return Err(Error::ValueCount { values: values.len(), vertices: mesh.vertex_count() });
        }
        let value = |(tetrahedron, weights): (&TetId, &[f64; 4])| {
            let corners = mesh.tetrahedra()[tetrahedron.index()].iter().zip(weights);
            // 0 times infinity is not a number.
            let weighted = corners.filter(|&(_, &weight)| weight > 0.0);
            weighted.map(|(&vertex, &weight)| weight * values[vertex as usize]).sum()
        };
        Ok(self.tetrahedra.iter().zip(&self.weights).map(value).collect())
    }

    /// The gradient of a distance in the tetrahedron of each vertex of the section, away from the sources; zero where a corner of the
    /// tetrahedron is at infinity.
    ///
    /// # Errors
    /// [`Error::ForeignMesh`].
    pub fn gradients(&self, mesh: &TetMesh, distance: &VolumeDistance) -> Result<Vec<DVec3>> {
        self.require(mesh)?;
        distance.require(mesh)?;
        let mut gradients: Vec<DVec3> = Vec::with_capacity(self.tetrahedra.len());
        for (vertex, tetrahedron) in self.tetrahedra.iter().enumerate() {
            // Vertices of one tetrahedron follow one another.
            let is_again = vertex > 0 && self.tetrahedra[vertex - 1] == *tetrahedron;
            let gradient = if is_again { gradients[vertex - 1] } else { distance.gradient_in(mesh, tetrahedron.0) };
            gradients.push(gradient);
        }
        Ok(gradients)
    }

    fn require(&self, mesh: &TetMesh) -> Result<()> {
        if self.mesh == mesh.id() { Ok(()) } else { Err(Error::ForeignMesh { what: "section" }) }
    }
}
