//! Between the drawn vertices that the page knows and the points that the solver knows.

use glam::DVec3;
use heatwalk::Face;
use heatwalk::{Source, Surface, SurfacePoint};
use heatwalk_scene::{DrawMesh as Mesh, DrawTransform, draw_mesh};
use js_sys::{Array, Reflect};
use wasm_bindgen::prelude::*;

use crate::results::DrawMesh;

/// Edges bent by more than this are drawn sharp: above a smooth model's largest bend, under a box's.
const CREASE_ANGLE: f64 = std::f64::consts::PI * 0.25;

/// A surface as it is drawn.
pub struct Drawn {
    mesh: Mesh,
    pub transform: DrawTransform,
}

impl Drawn {
    pub fn new(surface: &Surface, transform: DrawTransform) -> Self {
        Self { mesh: draw_mesh(surface, CREASE_ANGLE, &transform), transform }
    }

    pub fn mesh(&self) -> DrawMesh {
        let Mesh { positions, normals, triangles, .. } = self.mesh.clone();
        DrawMesh { positions, normals, triangles }
    }

    pub fn input_vertices(&self) -> Vec<u32> {
        self.mesh.input_of_drawn.clone()
    }

    /// Values of points as values of drawn vertices.
    pub fn spread(&self, values: &[f64]) -> Vec<f32> {
        self.mesh.point_of_drawn.iter().map(|&point| values[point as usize] as f32).collect()
    }

    /// Unit vectors of points as four bytes a drawn vertex, the last one 0.
    pub fn spread_directions(&self, directions: &[DVec3]) -> Vec<i8> {
        let bytes = |direction: DVec3| (127.0 * direction).as_i8vec3().extend(0).to_array();
        self.mesh.point_of_drawn.iter().flat_map(|&point| bytes(directions[point as usize])).collect()
    }

    /// Reads `{ vertex }` (of the input) or `{ face, weights }`. The weights follow the corners of the drawn triangle,
    /// which are those of the surface's face.
    pub fn point(&self, surface: &Surface, place: &JsValue) -> Result<SurfacePoint, JsError> {
        if let Some(vertex) = number(place, "vertex") {
            let vertex = vertex as usize;
            let point = surface.point_of_input.get(vertex).copied().flatten();
            let absent =
                || heatwalk::surface::Error::BadVertex { vertex, problem: "is on no triangle of the surface".into() };
            return Ok(SurfacePoint::Vertex(point.ok_or_else(absent)?));
        }
        let face =
            number(place, "face").ok_or_else(|| JsError::new("a place is a vertex or a face with three weights"))?;
        let list = Reflect::get(place, &"weights".into()).map(|weights| Array::from(&weights)).unwrap_or_default();
        let weights = [0, 1, 2].map(|corner| list.get(corner).as_f64().unwrap_or(f64::NAN));
        Ok(SurfacePoint::Face { face: Face(face as u32), weights })
    }

    /// Reads a place and its `offset`, the value that distances start from there; 0 when absent.
    pub fn source(&self, surface: &Surface, place: &JsValue) -> Result<Source, JsError> {
        Ok(Source { point: self.point(surface, place)?, offset: number(place, "offset").unwrap_or(0.0) })
    }
}

fn number(object: &JsValue, key: &str) -> Option<f64> {
    Reflect::get(object, &key.into()).ok().and_then(|value| value.as_f64())
}
