//! The surface that distances are computed on: welded points, clean oriented triangles, half-edges.
//!
//! A *point* is a welded position and one degree of freedom. Where the triangles are not an oriented manifold (an edge
//! of three faces, a Möbius strip) the half-edge mesh is cut, and several of its vertices share one point; heat,
//! distance and paths live on points and do not see the cut.

use glam::DVec3;

use crate::csr::{Csr, NONE};
use crate::edges::Edges;
use crate::error::Result;
use crate::halfedge::{Face, FaceData, Halfedge, HalfedgeMesh, Vertex, VertexData};
use crate::memory;
use crate::soup::Soup;
use crate::triangle;
use crate::union_find::UnionFind;
use crate::weld::weld;

/// Bytes that welding, edges and half-edges take at once, a triangle of the soup: about as many as are kept.
const BYTES_PER_TRIANGLE: u64 = 128;

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
    /// Which half-edges lie on the same edge.
    pub edges: Edges,
    inputs_of_point: Csr,
    corners_of_point: Csr,
}

impl Surface {
    /// Welds, cleans and orients a soup.
    ///
    /// # Errors
    /// [`IndexOutOfRange`](crate::Error::IndexOutOfRange); [`NotFinite`](crate::Error::NotFinite) for a used vertex;
    /// [`Empty`](crate::Error::Empty) where no triangle of non-zero area is left; [`OutOfMemory`](crate::Error::OutOfMemory).
    pub fn build(soup: &Soup) -> Result<Self> {
        memory::require(BYTES_PER_TRIANGLE * soup.triangles.len() as u64, "building the surface")?;
        let welded = weld(soup)?;
        let (positions, mut faces) = (welded.positions, welded.faces);
        let (mut edges, mut corners_of_point) = (welded.edges, welded.corners_of_point);
        let points = positions.len();
        let mut inputs_of_face: Vec<[u32; 3]> =
            welded.triangle_of_face.iter().map(|&triangle| soup.triangles[triangle as usize]).collect();

        let turned = edges.faces_to_turn(&faces);
        if !turned.is_empty() {
            let mut is_turned = vec![false; faces.len()];
            for &face in &turned {
                faces[face as usize].swap(1, 2);
                inputs_of_face[face as usize].swap(1, 2);
                is_turned[face as usize] = true;
            }
            edges = edges.turned(|face| is_turned[face as usize]);
            for corner in corners_of_point.items_mut() {
                let k = *corner % 3;
                if k > 0 && is_turned[*corner as usize / 3] {
                    *corner = *corner - k + (3 - k);
                }
            }
        }
        let (mesh, point_of_vertex) = HalfedgeMesh::from_twins(points, &faces, edges.twins(&faces));

        let mut is_boundary_point = vec![false; points];
        let mut is_oriented_manifold = true;
        for outer in (3 * faces.len() as u32..mesh.halfedge_count() as u32).map(Halfedge) {
            if edges.is_single(mesh.twin(outer).0) {
                for vertex in [mesh.vertex(outer), mesh.tip(outer)] {
                    is_boundary_point[point_of_vertex[vertex] as usize] = true;
                }
            } else {
                is_oriented_manifold = false;
            }
        }
        let is_true_boundary = |halfedge: Halfedge| edges.is_single(mesh.twin(halfedge).0);
        let boundary_loops =
            mesh.boundary_loops().filter(|&cap| mesh.halfedges_of_face(cap).any(is_true_boundary)).count();

        let (component_of_point, components) = components(&faces, points);
        let (mean_edge, edge_count) = mean_edge(&edges, &faces, &positions);
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
            non_manifold_edges: edges.lasts().filter(|&last| edges.is_branching(last)).count(),
            components,
            boundary_loops,
            euler_characteristic: points as i64 - edge_count as i64 + faces.len() as i64,
        };
        let mut face_of_triangle = vec![None; soup.triangles.len()];
        for (face, &triangle) in welded.triangle_of_face.iter().enumerate() {
            face_of_triangle[triangle as usize] = Some(Face(face as u32));
        }
        let inputs_of_point = Csr::group(points, welded.point_of_input.iter().copied());
        Ok(Self {
            mean_edge,
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
            edges,
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
    pub fn neighbours(&self, point: u32) -> impl Iterator<Item = u32> + '_ {
        self.corners_of_point(point).flat_map(|(face, k)| {
            let corners = self.faces[face];
            [corners[(k + 1) % 3], corners[(k + 2) % 3]]
        })
    }

    /// The faces that have both points, over all copies: one on a boundary, more than two where not manifold.
    pub fn faces_of_edge(&self, a: u32, b: u32) -> impl Iterator<Item = Face> + '_ {
        self.corners_of_point(a).map(|(face, _)| face).filter(move |&face| self.faces[face].contains(&b))
    }

    /// The same connectivity in another place: `#P` positions. Reports and the mean edge stay.
    pub fn with_positions(&self, positions: Vec<DVec3>) -> Self {
        Self { positions, ..self.clone() }
    }

    /// Greatest distance of a point from the centre of the box around all of them, in the file's unit.
    pub fn bounding_radius(&self) -> f64 {
        let first = self.positions[0];
        let box_of = |(low, high): (DVec3, DVec3), &position| (low.min(position), high.max(position));
        let (low, high) = self.positions.iter().fold((first, first), box_of);
        let centre = (low + high) * 0.5;
        self.positions.iter().map(|&position| triangle::length(position - centre)).fold(0.0, f64::max)
    }

    /// Position of a point.
    pub fn position(&self, point: u32) -> DVec3 {
        self.positions[point as usize]
    }

    /// Positions of a face's corners.
    pub fn corners(&self, face: Face) -> [DVec3; 3] {
        self.faces[face].map(|point| self.positions[point as usize])
    }

    /// `3 #F`, length of the side that leaves each corner.
    pub fn side_lengths(&self) -> Vec<f64> {
        let mut lengths = Vec::with_capacity(3 * self.face_count());
        for face in self.mesh.faces() {
            let [p, q, r] = self.corners(face);
            lengths.extend([q - p, r - q, p - r].map(triangle::length));
        }
        lengths
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
fn components(faces: &[[u32; 3]], points: usize) -> (Vec<u32>, usize) {
    let mut pieces = UnionFind::new(points);
    for &[a, b, c] in faces {
        pieces.join(a, b);
        pieces.join(b, c);
    }
    let mut component: Vec<u32> = Vec::with_capacity(points);
    let mut count = 0;
    for point in 0..points as u32 {
        let least = pieces.least(point);
        component.push(if least == point { count } else { component[least as usize] });
        count += u32::from(least == point);
    }
    (component, count as usize)
}

/// Mean length of edges, and their number. A cut edge counts once, wherever the cut may run.
fn mean_edge(edges: &Edges, faces: &[[u32; 3]], positions: &[DVec3]) -> (f64, usize) {
    let (mut sum, mut count) = (0.0, 0);
    for halfedge in edges.lasts() {
        let (face, k) = (faces[halfedge as usize / 3], halfedge as usize % 3);
        sum += triangle::length(positions[face[(k + 1) % 3] as usize] - positions[face[k] as usize]);
        count += 1;
    }
    (sum / count as f64, count)
}
