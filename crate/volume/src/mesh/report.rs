//! What building a mesh tells.

/// What building found and did.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshReport {
    /// Vertices of the input.
    pub input_vertices: usize,
    /// Tetrahedra of the input.
    pub input_tetrahedra: usize,
    /// Vertices of the mesh.
    pub vertices: usize,
    /// Tetrahedra of the mesh.
    pub tetrahedra: usize,
    /// Connected components.
    pub components: usize,
    /// Vertices of the input that no tetrahedron uses; left out.
    pub unreferenced_vertices: usize,
    /// Tetrahedra without volume; left out. What they alone join across faces is joined by edges and vertices only.
    pub flat_tetrahedra: usize,
    /// Tetrahedra of the same vertices as one before; left out.
    pub duplicate_tetrahedra: usize,
    /// Tetrahedra whose corners were in the other orientation; turned.
    pub inverted_tetrahedra: usize,
    /// Triangles with one tetrahedron.
    pub boundary_faces: usize,
    /// Volume of all tetrahedra, in the file's unit cubed.
    pub volume: f64,
}
