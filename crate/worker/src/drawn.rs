//! Between the drawn vertices that the page knows and the welded vertices that the solver knows.

use glam::DVec3;
use heatwalk::{FaceData, FaceId, InputVertex, Place, Source, Surface, SurfacePoint, VertexData, VertexId};
use heatwalk_bindings::{Failure, Result, number, numbers};
use heatwalk_model::{Appearance, Model};
use heatwalk_scene::{DrawTransform, Posing, draw_mesh};
use wasm_bindgen::prelude::*;

use crate::results::DrawMesh;

/// Edges bent by more than this are drawn sharp: above a smooth model's largest bend, under a box's.
const CREASE_ANGLE: f64 = std::f64::consts::PI * 0.25;

/// What [`Drawn::point`] and [`Drawn::source`] read.
#[wasm_bindgen(typescript_custom_section)]
const PLACES: &str = "
/** A place on the surface: an input vertex, or a face of the drawing with three weights that sum to 1. */
export type SurfacePoint = { vertex: number } | { face: number; weights: [number, number, number] };

/** A place that distance is measured from. */
export type Source = SurfacePoint & {
  /** The initial distance here, 0 or more, in the unit of the file; 0 when absent. */
  offset?: number;
};
";

/// A surface as it is drawn.
pub struct Drawn {
    /// `#D`, the welded vertex of each drawn vertex; or `#F × 3`, of each corner of the drawn triangles.
    vertices: Vec<VertexId>,
    /// Whether values are those of corners.
    pub is_by_corner: bool,
    /// `#D`, the input vertex of each drawn vertex.
    inputs: Vec<InputVertex>,
    /// `#F`, the face of each drawn triangle.
    faces: Vec<FaceId>,
    pub transform: DrawTransform,
}

impl Drawn {
    /// With the triangles themselves, which only the page needs, and with what moves them, for a model that moves.
    pub fn new(
        surface: &Surface,
        appearance: &Appearance,
        moving: Option<&Model>,
        transform: DrawTransform,
    ) -> (Self, DrawMesh, Option<Posing>) {
        let faces = surface.faces_in_input_order().collect();
        let mut mesh = draw_mesh(surface, appearance, CREASE_ANGLE, &transform);
        let posing = moving.and_then(|model| Posing::new(model, &mesh));
        let (vertices, inputs) = (std::mem::take(&mut mesh.vertex_of_drawn), std::mem::take(&mut mesh.input_of_drawn));
        (Self { vertices, is_by_corner: false, inputs, faces, transform }, DrawMesh::new(mesh), posing)
    }

    /// The same with values of corners, of a surface that walls have parted.
    pub fn by_corner(drawn: &Self, walled: &Surface) -> Self {
        let Self { inputs, faces, transform, .. } = drawn;
        let vertices = faces.iter().flat_map(|&face| walled.faces()[face]).collect();
        Self { vertices, is_by_corner: true, inputs: inputs.clone(), faces: faces.clone(), transform: *transform }
    }

    /// The face of a drawn triangle.
    pub fn face(&self, triangle: u32) -> Option<FaceId> {
        self.faces.get(triangle as usize).copied()
    }

    /// `#F`, the face of each drawn triangle.
    pub fn faces(&self) -> &[FaceId] {
        &self.faces
    }

    /// `#F`, the drawn triangle of each face.
    pub fn triangles(&self) -> FaceData<u32> {
        let mut triangles: FaceData<u32> = vec![0; self.faces.len()].into();
        for (triangle, &face) in (0..).zip(&self.faces) {
            triangles[face] = triangle;
        }
        triangles
    }

    /// The direction in the file that is drawn upward.
    pub fn up(&self) -> DVec3 {
        DVec3::from_array(DVec3::AXES.map(|axis| self.transform.direction(axis).y))
    }

    pub fn input_vertices(&self) -> Vec<u32> {
        self.inputs.iter().map(|vertex| vertex.0).collect()
    }

    /// Values of vertices as values of drawn vertices.
    pub fn spread(&self, values: &VertexData<f64>) -> Vec<f32> {
        self.vertices.iter().map(|&vertex| values[vertex] as f32).collect()
    }

    /// Unit vectors of vertices, as they are drawn, as four bytes a drawn vertex, the last one 0.
    pub fn spread_directions(&self, directions: &VertexData<DVec3>) -> Vec<i8> {
        // By way of whole numbers of 32 bits, for which wasm32 has an instruction.
        let bytes =
            |direction| (127.0 * self.transform.direction(direction)).as_ivec3().as_i8vec3().extend(0).to_array();
        let bytes: Vec<[i8; 4]> = self.vertices.iter().map(|&vertex| bytes(directions[vertex])).collect();
        bytes.into_flattened()
    }

    /// Vectors of faces as vectors of drawn triangles, turned as they are drawn, three numbers each.
    pub fn spread_vectors(&self, vectors: &FaceData<DVec3>) -> Vec<f32> {
        self.transform.directions(self.faces.iter().map(|&face| vectors[face]))
    }

    /// Reads `{ vertex }` (of the input) or `{ face, weights }`. The weights follow the corners of the drawn triangle,
    /// which are those of the surface's face.
    pub fn point(&self, surface: &Surface, place: &JsValue) -> Result<SurfacePoint> {
        if let Some(vertex) = number(place, "vertex") {
            return Ok(surface.point(InputVertex(vertex as u32))?);
        }
        let face =
            number(place, "face").ok_or_else(|| Failure::misuse("a place is a vertex or a face with three weights"))?;
        let given = numbers(place, "weights");
        let weights = [0, 1, 2].map(|corner| given.get(corner).copied().unwrap_or(f64::NAN));
        // A face that there is none of is for the surface to name.
        let face = self.faces.get(face as usize).copied().unwrap_or(FaceId(face as u32));
        Ok(surface.point(Place::Face { face, weights })?)
    }

    /// Reads a place and its `offset`, the value that distances start from there; 0 when absent.
    pub fn source(&self, surface: &Surface, place: &JsValue) -> Result<Source> {
        Ok(surface.source(self.point(surface, place)?, number(place, "offset").unwrap_or(0.0))?)
    }
}
