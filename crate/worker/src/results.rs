//! What the page gets: objects whose properties, made plain by `toJSON`, are the messages of the page's protocol. Each array
//! is copied once, into a buffer of JavaScript's.

use heatwalk::Path;
use heatwalk_scene::DrawTransform;
use js_sys::{Float32Array, Uint32Array};
use wasm_bindgen::prelude::*;

/// Triangles to draw, with vertices split where the normal jumps.
#[wasm_bindgen(inspectable)]
#[derive(Default)]
pub struct DrawMesh {
    pub(crate) positions: Vec<f32>,
    pub(crate) normals: Vec<f32>,
    pub(crate) triangles: Vec<u32>,
}

#[wasm_bindgen]
impl DrawMesh {
    /// `#D × 3`, as they are drawn.
    #[wasm_bindgen(getter)]
    pub fn positions(&self) -> Float32Array {
        self.positions.as_slice().into()
    }

    /// `#D × 3`, unit length.
    #[wasm_bindgen(getter)]
    pub fn normals(&self) -> Float32Array {
        self.normals.as_slice().into()
    }

    /// `#F × 3`, indices of drawn vertices, counter-clockwise seen from outside.
    #[wasm_bindgen(getter)]
    pub fn triangles(&self) -> Uint32Array {
        self.triangles.as_slice().into()
    }
}

/// What was done to make a surface of the triangles, in counts.
#[wasm_bindgen(inspectable)]
pub struct BuildReport(heatwalk::BuildReport);

impl BuildReport {
    pub(crate) fn of(report: &heatwalk::BuildReport) -> Self {
        Self(report.clone())
    }
}

macro_rules! counts {
    ($($(#[$doc:meta])* $name:ident as $called:ident),* $(,)?) => {
        #[wasm_bindgen]
        impl BuildReport {
            $($(#[$doc])* #[wasm_bindgen(getter, js_name = $called)] pub fn $name(&self) -> f64 { self.0.$name as f64 })*
        }
    };
}

counts! {
    /// Vertices of the input.
    input_vertices as inputVertices,
    /// Vertices after welding.
    vertices as vertices,
    /// Faces kept.
    faces as faces,
    /// Input vertices that were merged into another.
    welded_vertices as weldedVertices,
    /// Input vertices that no kept face uses.
    unreferenced_vertices as unreferencedVertices,
    /// Faces dropped because they have no area.
    degenerate_faces as degenerateFaces,
    /// Faces dropped because they repeat another.
    duplicate_faces as duplicateFaces,
    /// Faces flipped to agree with their neighbours.
    flipped_faces as flippedFaces,
    /// Edges with more than two faces.
    non_manifold_edges as nonManifoldEdges,
    /// Connected components.
    components as components,
    /// Boundary loops.
    boundary_loops as boundaryLoops,
    /// Euler characteristic V − E + F.
    euler_characteristic as eulerCharacteristic,
}

/// A path on the surface, from its start to the source.
#[wasm_bindgen(inspectable)]
pub struct SurfacePath {
    points: Vec<f32>,
    normals: Vec<f32>,
    length: f64,
}

impl SurfacePath {
    pub(crate) fn of(path: &Path, transform: &DrawTransform) -> Self {
        let points = transform.places(path.points.iter().map(|point| point.position));
        let normals = path.normals.iter().flat_map(|normal| normal.as_vec3().to_array()).collect();
        Self { points, normals, length: path.length() }
    }
}

#[wasm_bindgen]
impl SurfacePath {
    /// `#P × 3`, from the start to the source, as they are drawn.
    #[wasm_bindgen(getter)]
    pub fn points(&self) -> Float32Array {
        self.points.as_slice().into()
    }

    /// `#P × 3`, unit surface normals at the points.
    #[wasm_bindgen(getter)]
    pub fn normals(&self) -> Float32Array {
        self.normals.as_slice().into()
    }

    /// Its length in the file's unit.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> f64 {
        self.length
    }
}
