//! The triangles around a tetrahedral mesh.

use glam::DVec3;
use heatwalk::{Soup, VertexId};

use crate::mesh::{FACES, NONE, TetId, TetMesh};

/// The boundary of a mesh, counter-clockwise seen from outside.
#[derive(Debug, Clone)]
pub struct Boundary {
    /// Its vertices and triangles, a soup of one part.
    pub soup: Soup,
    /// The vertex of the mesh that each vertex of the soup is.
    pub vertices: Vec<VertexId>,
    /// The tetrahedron that each triangle of the soup is a face of.
    pub tetrahedra: Vec<TetId>,
}

impl TetMesh {
    /// The triangles with one tetrahedron.
    pub fn boundary(&self) -> Boundary {
        let mut triangles: Vec<[u32; 3]> = Vec::with_capacity(self.report.boundary_faces);
        let mut tetrahedra = Vec::with_capacity(self.report.boundary_faces);
        for (index, (corners, neighbors)) in self.tetrahedra.iter().zip(&self.neighbors).enumerate() {
            for (face, _) in FACES.iter().zip(neighbors).filter(|&(_, &neighbor)| neighbor == NONE) {
                triangles.push(face.map(|corner| corners[corner]));
                tetrahedra.push(TetId(index as u32));
            }
        }
        let mut number = vec![NONE; self.vertex_count()];
        for &vertex in triangles.iter().flatten() {
            number[vertex as usize] = 0;
        }
        let mut vertices = Vec::new();
        for (vertex, number) in number.iter_mut().enumerate().filter(|(_, number)| **number != NONE) {
            *number = vertices.len() as u32;
            vertices.push(VertexId(vertex as u32));
        }
        let positions: Vec<DVec3> = vertices.iter().map(|&vertex| self.position(vertex)).collect();
        for corner in triangles.iter_mut().flatten() {
            *corner = number[*corner as usize];
        }
        Boundary { soup: Soup::single("boundary", positions, triangles), vertices, tetrahedra }
    }

    /// Whether each vertex (`#V`) is on the boundary.
    pub fn is_on_boundary(&self) -> Vec<bool> {
        let mut is_on_boundary = vec![false; self.vertex_count()];
        for (corners, neighbors) in self.tetrahedra.iter().zip(&self.neighbors) {
            for (face, _) in FACES.iter().zip(neighbors).filter(|&(_, &neighbor)| neighbor == NONE) {
                for &corner in face {
                    is_on_boundary[corners[corner] as usize] = true;
                }
            }
        }
        is_on_boundary
    }
}
