//! The surface that distances are computed on: welded points, clean oriented triangles, half-edges.
//!
//! A *point* is a welded position and one degree of freedom. Where the triangles are not an oriented manifold (an edge
//! of three faces, a Möbius strip) the half-edge mesh is cut, and several of its vertices share one point; heat,
//! distance and paths live on points and do not see the cut.

use glam::DVec3;

use crate::csr::{Csr, NONE};
use crate::error::Result;
use crate::halfedge::{Face, FaceData, Halfedge, HalfedgeMesh, Vertex, VertexData};
use crate::pairing::{Pairing, for_each_edge};
use crate::soup::Soup;
use crate::triangle;
use crate::weld::weld;

/// What was found and done while a [`Surface`] was built.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct BuildReport {
    /// Vertices of the soup.
    pub input_vertices: usize,
    /// Points, the degrees of freedom.
    pub vertices: usize,
    /// Faces kept.
    pub faces: usize,
    /// Soup vertices that became one with an earlier one.
    pub welded_vertices: usize,
    /// Soup vertices that no kept face uses.
    pub unreferenced_vertices: usize,
    /// Triangles dropped for a repeated corner or no area.
    pub degenerate_faces: usize,
    /// Triangles dropped because an earlier one has the same three points.
    pub duplicate_faces: usize,
    /// Faces whose orientation was reversed to agree with their neighbours.
    pub turned_faces: usize,
    /// Edges of three faces or more.
    pub non_manifold_edges: usize,
    /// Connected pieces; touching in one point is enough.
    pub components: usize,
    /// Loops of edges that have one face only.
    pub boundary_loops: usize,
    /// Points − edges + faces.
    pub euler_characteristic: i64,
}

/// A welded triangle surface with its connectivity. Build it with [`Surface::build`].
#[derive(Debug, Clone)]
pub struct Surface {
    /// Half-edges; its face `f` is `faces[f]`, in the same orientation and order of corners.
    pub mesh: HalfedgeMesh,
    /// `#V`, the point of each mesh vertex. Vertex `i` is point `i` for every `i < #P`.
    pub point_of_vertex: VertexData<u32>,
    /// `#P × 3`, in order of the first soup vertex there, in the file's unit.
    pub positions: Vec<DVec3>,
    /// `#F × 3` points, kept triangles in the soup's order.
    pub faces: FaceData<[u32; 3]>,
    /// Per soup vertex its point; `None` where no kept face uses it.
    pub point_of_input: Vec<Option<u32>>,
    /// Per soup triangle its face; `None` where it was dropped.
    pub face_of_triangle: Vec<Option<Face>>,
    /// Per face its soup triangle.
    pub triangle_of_face: FaceData<u32>,
    /// `#F × 3` soup vertices, in the order of `faces`.
    pub inputs_of_face: FaceData<[u32; 3]>,
    /// Per point its connected piece, counted from 0.
    pub component_of_point: Vec<u32>,
    /// Per point whether an edge with one face only ends there. Cuts are not boundary.
    pub is_boundary_point: Vec<bool>,
    /// Whether no edge had to be cut: every edge has one face, or two that agree in orientation.
    pub is_oriented_manifold: bool,
    /// Mean length of the edges, in the file's unit.
    pub mean_edge: f64,
    /// What was found and done.
    pub report: BuildReport,
    inputs_of_point: Csr,
    corners_of_point: Csr,
}

impl Surface {
    /// Welds, cleans and orients a soup.
    ///
    /// # Errors
    /// [`IndexOutOfRange`](crate::Error::IndexOutOfRange); [`NotFinite`](crate::Error::NotFinite) for a used vertex;
    /// [`Empty`](crate::Error::Empty) where no triangle of non-zero area is left.
    pub fn build(soup: &Soup) -> Result<Self> {
        let welded = weld(soup)?;
        let (positions, mut faces) = (welded.positions, welded.faces);
        let points = positions.len();
        let mut inputs_of_face: Vec<[u32; 3]> =
            welded.triangle_of_face.iter().map(|&triangle| soup.triangles[triangle as usize]).collect();

        let mut corners_of_point = Csr::group(points, faces.iter().flatten().copied());
        let mut pairing = Pairing::new(&faces, &corners_of_point);
        let turned = pairing.faces_to_turn(&faces);
        for &face in &turned {
            faces[face as usize].swap(1, 2);
            inputs_of_face[face as usize].swap(1, 2);
        }
        if !turned.is_empty() {
            corners_of_point = Csr::group(points, faces.iter().flatten().copied());
            pairing = Pairing::new(&faces, &corners_of_point);
        }
        let (mesh, point_of_vertex) = HalfedgeMesh::from_pairs(points, &faces, &pairing.twins(&faces));

        let mut is_boundary_point = vec![false; points];
        for (halfedge, _) in pairing.single.iter().enumerate().filter(|&(_, &single)| single) {
            let face = faces[halfedge / 3];
            is_boundary_point[face[halfedge % 3] as usize] = true;
            is_boundary_point[face[(halfedge + 1) % 3] as usize] = true;
        }
        let is_true_boundary = |halfedge: Halfedge| pairing.single[mesh.twin(halfedge).0 as usize];
        let cut_or_boundary =
            (0..faces.len() * 3).filter(|&slot| mesh.twin(Halfedge(slot as u32)).0 as usize >= faces.len() * 3);
        let is_oriented_manifold = cut_or_boundary.into_iter().all(|slot| pairing.single[slot]);
        let boundary_loops =
            mesh.boundary_loops().filter(|&cap| mesh.halfedges_of_face(cap).any(is_true_boundary)).count();

        let (component_of_point, components) = components(&faces, &corners_of_point, points);
        let unreferenced = welded.point_of_input.iter().filter(|&&point| point == NONE).count();
        let report = BuildReport {
            input_vertices: soup.positions.len(),
            vertices: points,
            faces: faces.len(),
            welded_vertices: soup.positions.len() - unreferenced - points,
            unreferenced_vertices: unreferenced,
            degenerate_faces: welded.degenerate_faces,
            duplicate_faces: welded.duplicate_faces,
            turned_faces: turned.len(),
            non_manifold_edges: pairing.non_manifold_edges,
            components,
            boundary_loops,
            euler_characteristic: points as i64 - pairing.edges.len() as i64 + faces.len() as i64,
        };
        let mut face_of_triangle = vec![None; soup.triangles.len()];
        for (face, &triangle) in welded.triangle_of_face.iter().enumerate() {
            face_of_triangle[triangle as usize] = Some(Face(face as u32));
        }
        let inputs_of_point = Csr::group(points, welded.point_of_input.iter().copied());
        Ok(Self {
            mean_edge: mean_edge(&pairing.edges, &faces, &positions),
            is_oriented_manifold,
            mesh,
            point_of_vertex,
            positions,
            faces: faces.into(),
            point_of_input: welded.point_of_input.iter().map(|&p| Some(p).filter(|&p| p != NONE)).collect(),
            face_of_triangle,
            triangle_of_face: welded.triangle_of_face.into(),
            inputs_of_face: inputs_of_face.into(),
            component_of_point,
            is_boundary_point,
            report,
            inputs_of_point,
            corners_of_point,
        })
    }

    /// Number of points.
    pub fn point_count(&self) -> usize {
        self.positions.len()
    }

    /// Number of faces.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// The soup vertices welded into a point, ascending.
    pub fn inputs_of_point(&self, point: u32) -> &[u32] {
        self.inputs_of_point.row(point)
    }

    /// The faces around a point, over all copies of it, each with the corner (0 to 2) that lies there.
    pub fn corners_of_point(&self, point: u32) -> impl Iterator<Item = (Face, usize)> + '_ {
        self.corners_of_point.row(point).iter().map(|corner| (Face(corner / 3), *corner as usize % 3))
    }

    /// The points joined to a point by an edge; each as often as a face has that edge.
    pub(crate) fn neighbours(&self, point: u32) -> impl Iterator<Item = u32> + '_ {
        self.corners_of_point(point).flat_map(|(face, k)| {
            let corners = self.faces[face];
            [corners[(k + 1) % 3], corners[(k + 2) % 3]]
        })
    }

    /// The faces that have both points, over all copies: one on a boundary, more than two where not manifold.
    pub(crate) fn faces_of_edge(&self, a: u32, b: u32) -> impl Iterator<Item = Face> + '_ {
        self.corners_of_point(a).map(|(face, _)| face).filter(move |&face| self.faces[face].contains(&b))
    }

    /// Visits each edge with its lower point and all half-edges `3 f + k` along it, of either direction.
    pub(crate) fn for_each_edge(&self, visit: impl FnMut(u32, &[u32])) {
        for_each_edge(self.faces.as_slice(), &self.corners_of_point, visit);
    }

    /// The same connectivity in another place: `#P` positions. Reports and the mean edge stay.
    pub(crate) fn with_positions(&self, positions: Vec<DVec3>) -> Self {
        Self { positions, ..self.clone() }
    }

    /// Position of a point.
    pub fn position(&self, point: u32) -> DVec3 {
        self.positions[point as usize]
    }

    /// Positions of a face's corners.
    pub fn corners(&self, face: Face) -> [DVec3; 3] {
        self.faces[face].map(|point| self.positions[point as usize])
    }

    /// Points at the ends of a half-edge.
    pub fn ends(&self, halfedge: Halfedge) -> [u32; 2] {
        [self.mesh.vertex(halfedge), self.mesh.tip(halfedge)].map(|vertex: Vertex| self.point_of_vertex[vertex])
    }

    /// Unit normal of a face, counter-clockwise corners seen from its tip.
    pub fn face_normal(&self, face: Face) -> DVec3 {
        triangle::unit(triangle::area_vector(self.corners(face)))
    }

    /// Area of a face.
    pub fn face_area(&self, face: Face) -> f64 {
        0.5 * triangle::length(triangle::area_vector(self.corners(face)))
    }

    /// Unit normal at a point: the mean of the face normals around it, weighted by angle.
    pub fn point_normal(&self, point: u32) -> DVec3 {
        let weighted = self.corners_of_point(point).map(|(face, k)| {
            let mut corners = self.corners(face);
            corners.rotate_left(k);
            self.face_normal(face) * triangle::angle(corners)
        });
        triangle::unit(weighted.sum())
    }
}

/// Connected piece of each point, and their number.
fn components(faces: &[[u32; 3]], corners_of_point: &Csr, points: usize) -> (Vec<u32>, usize) {
    let mut component = vec![NONE; points];
    let mut stack = Vec::new();
    let mut count = 0;
    for start in 0..points as u32 {
        if component[start as usize] != NONE {
            continue;
        }
        component[start as usize] = count;
        stack.push(start);
        while let Some(point) = stack.pop() {
            for &corner in corners_of_point.row(point) {
                for other in faces[corner as usize / 3] {
                    if component[other as usize] == NONE {
                        component[other as usize] = count;
                        stack.push(other);
                    }
                }
            }
        }
        count += 1;
    }
    (component, count as usize)
}

/// Mean length of edges, each given by one half-edge. A cut edge counts once, wherever the cut may run.
fn mean_edge(edges: &[u32], faces: &[[u32; 3]], positions: &[DVec3]) -> f64 {
    let length = |halfedge: u32| {
        let (face, k) = (faces[halfedge as usize / 3], halfedge as usize % 3);
        triangle::length(positions[face[(k + 1) % 3] as usize] - positions[face[k] as usize])
    };
    edges.iter().map(|&halfedge| length(halfedge)).sum::<f64>() / edges.len() as f64
}
