//! Vertices for drawing: smooth normals, split at creases and where the file has seams.

use glam::DVec3;

use heatwalk::Surface;
use heatwalk::surface::triangle;
use heatwalk::{FaceData, FaceId, HalfedgeId, InputVertex, VertexId};

use crate::transform::DrawTransform;

/// Flat arrays ready for a graphics card.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DrawMesh {
    /// `#D × 3`, as the transform places them.
    pub positions: Vec<f32>,
    /// `#D × 3`, unit length: face normals around the vertex, weighted by angle, up to the creases.
    pub normals: Vec<f32>,
    /// `#F × 3` drawn vertices, in the orientation of the surface's faces and in the order of the input's.
    pub triangles: Vec<u32>,
    /// `#D`, the welded vertex of each drawn vertex.
    pub vertex_of_drawn: Vec<VertexId>,
    /// `#D`, the input vertex of each drawn vertex, with its texture coordinates.
    pub input_of_drawn: Vec<InputVertex>,
}

/// Makes the vertices to draw. An edge is a crease where the normals of its faces differ by more than `crease_angle`
/// (radians, 0 to π), and where the surface is cut or ends.
pub fn draw_mesh(surface: &Surface, crease_angle: f64, transform: &DrawTransform) -> DrawMesh {
    let face_normals: FaceData<DVec3> = surface.mesh().faces().map(|face| surface.face_normal(face)).collect();
    let corners = surface.face_count() * 3;
    let mut sectors = Sectors { parent: (0..corners as u32).collect() };
    let least_cosine = crease_angle.cos();
    for halfedge in (0..corners as u32).map(HalfedgeId) {
        let twin = surface.mesh().twin(halfedge);
        if twin < halfedge || surface.mesh().is_boundary(surface.mesh().face(twin)) {
            continue;
        }
        let [left, right] = [halfedge, twin].map(|side| face_normals[surface.mesh().face(side)]);
        if left.dot(right) >= least_cosine {
            // A half-edge is also the corner that it leaves.
            sectors.join(halfedge.0, surface.mesh().next(twin).0);
            sectors.join(twin.0, surface.mesh().next(halfedge).0);
        }
    }
    let weighted_normal = |corner: HalfedgeId| {
        let mut positions = surface.corners(corner.triangle());
        positions.rotate_left(corner.corner());
        face_normals[corner.triangle()] * triangle::angle(positions)
    };
    let mut drawn_corners = vec![0; corners];
    // Creases and seams are few as a rule.
    let vertices = surface.vertex_count();
    let mut drawing = DrawMesh {
        positions: Vec::with_capacity(3 * vertices),
        normals: Vec::with_capacity(3 * vertices),
        triangles: Vec::with_capacity(corners),
        vertex_of_drawn: Vec::with_capacity(vertices),
        input_of_drawn: Vec::with_capacity(vertices),
    };
    let mut around: Vec<(u32, InputVertex, HalfedgeId)> = Vec::new();
    for vertex in surface.vertices() {
        around.clear();
        around.extend(surface.corners_of_vertex(vertex).map(|(face, k)| {
            let corner = face.halfedge(k);
            (sectors.root(corner.0), surface.inputs_of_face(face)[k], corner)
        }));
        around.sort_unstable();
        for sector in around.chunk_by(|a, b| a.0 == b.0) {
            let smooth = triangle::unit(sector.iter().map(|&(_, _, corner)| weighted_normal(corner)).sum());
            for group in sector.chunk_by(|a, b| a.1 == b.1) {
                let (_, input, corner) = group[0];
                let drawn = drawing.vertex_of_drawn.len() as u32;
                let normal = if smooth == DVec3::ZERO { face_normals[corner.triangle()] } else { smooth };
                drawing.positions.extend(transform.place(surface.position(vertex)).to_array());
                drawing.normals.extend(normal.as_vec3().to_array());
                drawing.vertex_of_drawn.push(vertex);
                drawing.input_of_drawn.push(input);
                for &(_, _, corner) in group {
                    drawn_corners[corner.0 as usize] = drawn;
                }
            }
        }
    }
    let corners_of = |face: FaceId| [0, 1, 2].map(|k| drawn_corners[face.halfedge(k).0 as usize]);
    drawing.triangles.extend(surface.faces_in_input_order().flat_map(corners_of));
    drawing
}

/// Disjoint sets of corners that share a normal.
struct Sectors {
    parent: Vec<u32>,
}

impl Sectors {
    fn root(&mut self, mut corner: u32) -> u32 {
        while self.parent[corner as usize] != corner {
            let above = self.parent[corner as usize];
            self.parent[corner as usize] = self.parent[above as usize];
            corner = above;
        }
        corner
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b) as usize] = a.min(b);
    }
}
