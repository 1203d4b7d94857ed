//! Vertices for drawing: smooth normals, split at creases and where the file has seams.

use std::f64::consts::PI;

use glam::{DVec3, Vec3};
use heatwalk_base::sort;
use heatwalk_base::union_find::UnionFind;
use heatwalk_model::appearance::Run;

use heatwalk::surface::triangle;
use heatwalk::{FaceData, FaceId, HalfedgeId, InputVertex, Surface, VertexData, VertexId};
use heatwalk_model::Appearance;

use crate::transform::DrawTransform;

/// Flat arrays ready for a graphics card.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct DrawMesh {
    /// `#D × 3`, as the transform places them.
    pub positions: Vec<f32>,
    /// `#D × 3`, unit length, as the transform turns them: those of the file, or else face normals around the vertex, weighted by
    /// angle, up to the creases.
    pub normals: Vec<f32>,
    /// `#F × 3` drawn vertices, in the orientation of the surface's faces and in the order of the input's.
    pub triangles: Vec<u32>,
    /// `#D`, the welded vertex of each drawn vertex.
    pub vertex_of_drawn: Vec<VertexId>,
    /// `#D`, the input vertex of each drawn vertex, with its texture coordinates.
    pub input_of_drawn: Vec<InputVertex>,
    /// `#D`, of each drawn vertex the first one that shares its smooth normal: itself, or one that only the file has parted it
    /// from.
    pub first_of_sector: Vec<u32>,
    /// `#D × 4`, two sets of texture coordinates; empty where the file has none.
    pub texcoords: Vec<f32>,
    /// `#D × 4`, linear RGBA, 65535 for 1; empty where the file has none.
    pub colors: Vec<u16>,
    /// Consecutive triangles of one material; empty where the file has none.
    pub runs: Vec<Run>,
}

/// Makes the vertices to draw, with the `appearance` of the soup that the surface was built from. Without normals of the file, an edge is a crease where the normals of its faces differ by more
/// than `crease_angle` (radians, 0 to π), and where the surface is cut or ends.
pub fn draw_mesh(surface: &Surface, appearance: &Appearance, crease_angle: f64, transform: &DrawTransform) -> DrawMesh {
    let shading = Shading::new(surface, appearance, crease_angle.cos());
    let vertices = surface.vertex_count();
    let mut drawing = DrawMesh {
        positions: Vec::with_capacity(3 * vertices),
        normals: Vec::with_capacity(3 * vertices),
        triangles: Vec::with_capacity(3 * surface.face_count()),
        vertex_of_drawn: Vec::with_capacity(vertices),
        first_of_sector: Vec::with_capacity(vertices),
        input_of_drawn: Vec::with_capacity(vertices),
        ..DrawMesh::default()
    };
    let mut first_drawn: VertexData<u32> = vec![0; vertices].into();
    // Corners of vertices that are drawn more than once, with their drawn vertex.
    let mut split: Vec<(HalfedgeId, u32)> = Vec::new();
    // Of the attributes of each drawn vertex.
    let mut rows: Vec<u32> = Vec::with_capacity(vertices);
    for vertex in surface.vertices() {
        let position = transform.place(surface.position(vertex)).to_array();
        let mut draw = |normal: DVec3, row: u32, first: Option<u32>| {
            let drawn = drawing.vertex_of_drawn.len() as u32;
            drawing.first_of_sector.push(first.unwrap_or(drawn));
            drawing.positions.extend(position);
            let normal = shading.normal_of_file(row, normal).unwrap_or(normal);
            drawing.normals.extend(transform.direction(normal).as_vec3().to_array());
            drawing.vertex_of_drawn.push(vertex);
            drawing.input_of_drawn.push(appearance.vertex_of_row(row));
            rows.push(row);
            drawn
        };
        let inputs = surface.inputs_of_vertex(vertex);
        if shading.is_smooth[vertex] && inputs.len() == 1 && !shading.is_seam(inputs[0]) {
            let corner = surface.corners_of_vertex(vertex).next();
            let normal = shading.smooth_normal(shading.sums[vertex], corner.map_or(FaceId(0), |(face, _)| face));
            first_drawn[vertex] = draw(normal, inputs[0].0, None);
            continue;
        }
        for sector in shading.sectors(surface, vertex).chunk_by(|a, b| a.0 == b.0) {
            let sum = sector.iter().map(|&(_, _, corner)| shading.weighted_normal(surface, corner)).sum();
            let mut first = None;
            for group in sector.chunk_by(|a, b| a.1 == b.1) {
                let (_, row, corner) = group[0];
                let drawn = draw(shading.smooth_normal(sum, corner.triangle()), row, first);
                first.get_or_insert(drawn);
                split.extend(group.iter().map(|&(_, _, corner)| (corner, drawn)));
            }
        }
    }
    let faces = surface.faces().iter().flatten();
    let mut drawn_corners: Vec<u32> = faces.map(|&vertex| first_drawn[vertex]).collect();
    for (corner, drawn) in split {
        drawn_corners[corner.0 as usize] = drawn;
    }
    let (corners, _) = drawn_corners.as_chunks::<3>();
    drawing.triangles.extend(surface.faces_in_input_order().flat_map(|face| corners[face.0 as usize]));
    if !appearance.texcoords.is_empty() {
        drawing.texcoords = rows.iter().flat_map(|&row| appearance.texcoords[row as usize]).collect();
    }
    if !appearance.colors.is_empty() {
        drawing.colors = rows.iter().flat_map(|&row| appearance.colors[row as usize]).collect();
    }
    let triangles = surface.faces_in_input_order().map(|face| surface.triangle_of_face(face).0 as usize);
    drawing.runs = appearance.runs_of(triangles);
    drawing
}

/// What normals of drawn vertices are made of.
struct Shading<'a> {
    appearance: &'a Appearance,
    /// Of each input vertex; empty where none has several rows of attributes.
    is_seam: Vec<bool>,
    face_normals: FaceData<DVec3>,
    /// Of the face normals around each vertex, weighted by angle.
    sums: VertexData<DVec3>,
    /// Whether the faces around a vertex are one fan without a crease.
    is_smooth: VertexData<bool>,
    least_cosine: f64,
}

impl<'a> Shading<'a> {
    /// `least_cosine`: of the normals on both sides of an edge that is no crease.
    fn new(surface: &Surface, appearance: &'a Appearance, least_cosine: f64) -> Self {
        let mesh = surface.mesh();
        let mut face_normals = Vec::with_capacity(surface.face_count());
        let mut sums: VertexData<DVec3> = vec![DVec3::ZERO; surface.vertex_count()].into();
        for (face, &vertices) in surface.faces().enumerate() {
            let normal = surface.face_normal(face);
            let corners = surface.corners(face);
            let [p, q, r] = corners;
            let angles = [triangle::angle([p, q, r]), triangle::angle([q, r, p])];
            let third = (PI - angles[0] - angles[1]).max(0.0);
            for (vertex, angle) in vertices.into_iter().zip([angles[0], angles[1], third]) {
                sums[vertex] += normal * angle;
            }
            face_normals.push(normal);
        }
        let mut shading = Self {
            appearance,
            is_seam: seams(appearance, surface.report().input_vertices),
            face_normals: face_normals.into(),
            sums,
            is_smooth: vec![true; surface.vertex_count()].into(),
            least_cosine,
        };
        for halfedge in (0..3 * surface.face_count() as u32).map(HalfedgeId) {
            if mesh.twin(halfedge) > halfedge && !shading.is_smooth_edge(surface, halfedge) {
                for vertex in surface.ends(halfedge) {
                    shading.is_smooth[vertex] = false;
                }
            }
        }
        for copy in mesh.vertices().skip(surface.vertex_count()) {
            shading.is_smooth[surface.vertex_of_cut(copy)] = false;
        }
        shading
    }

    /// Whether two faces meet at a half-edge, without a crease.
    fn is_smooth_edge(&self, surface: &Surface, halfedge: HalfedgeId) -> bool {
        let mesh = surface.mesh();
        let across = mesh.face(mesh.twin(halfedge));
        let [left, right] = [halfedge.triangle(), across];
        !mesh.is_boundary(across) && self.face_normals[left].dot(self.face_normals[right]) >= self.least_cosine
    }

    /// The corners of a vertex, each with the least one that no crease parts it from and with its row of attributes; sorted.
    fn sectors(&self, surface: &Surface, vertex: VertexId) -> Vec<(u32, u32, HalfedgeId)> {
        let mut corners: Vec<HalfedgeId> =
            surface.corners_of_vertex(vertex).map(|(face, k)| face.halfedge(k)).collect();
        sort::sort(&mut corners);
        let sets = UnionFind::new(corners.len());
        for (index, &corner) in (0..).zip(&corners) {
            // A half-edge is also the corner that it leaves.
            if self.is_smooth_edge(surface, corner) {
                let mesh = surface.mesh();
                let across = corners.binary_search(&mesh.next(mesh.twin(corner)));
                across.into_iter().for_each(|other| sets.join(index, other as u32));
            }
        }
        let sector = |(index, &corner): (u32, &HalfedgeId)| {
            let face = corner.triangle();
            let input = surface.inputs_of_face(face)[corner.corner()];
            let row = self.appearance.row(surface.triangle_of_face(face), input) as u32;
            // The file has split its vertices where its normals jump.
            let least = if self.has_normal(row) { 0 } else { sets.least(index) };
            (least, row, corner)
        };
        let mut sectors: Vec<_> = (0..).zip(&corners).map(sector).collect();
        sort::sort(&mut sectors);
        sectors
    }

    fn is_seam(&self, vertex: InputVertex) -> bool {
        self.is_seam.get(vertex.0 as usize).is_some_and(|&is_seam| is_seam)
    }

    fn has_normal(&self, row: u32) -> bool {
        self.appearance.normals.get(row as usize).is_some_and(|&normal| normal != Vec3::ZERO)
    }

    /// The file's normal of a row, on the side of that of its triangles: where these were turned round, or the
    /// file is wrong, it would be dark.
    fn normal_of_file(&self, row: u32, of_triangles: DVec3) -> Option<DVec3> {
        let normal = self.appearance.normals.get(row as usize)?.as_dvec3();
        let side = if normal.dot(of_triangles) < 0.0 { -1.0 } else { 1.0 };
        self.has_normal(row).then_some(side * normal)
    }

    /// The normal of a corner's face, weighted by the corner's angle.
    fn weighted_normal(&self, surface: &Surface, corner: HalfedgeId) -> DVec3 {
        let mut positions = surface.corners(corner.triangle());
        positions.rotate_left(corner.corner());
        self.face_normals[corner.triangle()] * triangle::angle(positions)
    }

    /// The unit normal along a sum, that of a face where it is nothing.
    fn smooth_normal(&self, sum: DVec3, face: FaceId) -> DVec3 {
        let normal = triangle::unit(sum);
        if normal == DVec3::ZERO { self.face_normals[face] } else { normal }
    }
}

/// Of each input vertex whether it has several rows of attributes; empty where none has.
fn seams(appearance: &Appearance, vertices: usize) -> Vec<bool> {
    let Some(copies) = appearance.seams.vertices.get(vertices..) else { return Vec::new() };
    let mut is_seam = vec![false; vertices];
    copies.iter().for_each(|&vertex| is_seam[vertex as usize] = true);
    is_seam
}
