//! What the page gets back: numbers and flat arrays. Each array is copied once, into a buffer of JavaScript's.

use heatwalk::{BuildReport, Path};
use heatwalk_scene::DrawTransform;
use wasm_bindgen::prelude::*;

/// Triangles to draw.
#[wasm_bindgen]
#[derive(Default)]
pub struct DrawMesh {
    pub(crate) positions: Vec<f32>,
    pub(crate) normals: Vec<f32>,
    pub(crate) triangles: Vec<u32>,
}

#[wasm_bindgen]
impl DrawMesh {
    /// `#D × 3`, as they are drawn. Can be taken once.
    pub fn take_positions(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.positions)
    }

    /// `#D × 3`, unit length. Can be taken once.
    pub fn take_normals(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.normals)
    }

    /// `#F × 3`. Can be taken once.
    pub fn take_triangles(&mut self) -> Vec<u32> {
        std::mem::take(&mut self.triangles)
    }
}

/// The counts of a build.
#[wasm_bindgen]
pub struct Report(BuildReport);

impl Report {
    pub(crate) fn of(report: &BuildReport) -> Self {
        Self(report.clone())
    }
}

macro_rules! counts {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {
        #[wasm_bindgen]
        impl Report {
            $($(#[$doc])* #[wasm_bindgen(getter)] pub fn $name(&self) -> f64 { self.0.$name as f64 })*
        }
    };
}

counts! {
    /// Vertices of the input.
    input_vertices,
    /// Vertices after welding.
    vertices,
    /// Faces kept.
    faces,
    /// Input vertices that were merged into another.
    welded_vertices,
    /// Input vertices that no kept face uses.
    unreferenced_vertices,
    /// Faces dropped because they have no area.
    degenerate_faces,
    /// Faces dropped because they repeat another.
    duplicate_faces,
    /// Faces flipped to agree with their neighbours.
    flipped_faces,
    /// Edges with more than two faces.
    non_manifold_edges,
    /// Connected components.
    components,
    /// Boundary loops.
    boundary_loops,
    /// V − E + F.
    euler_characteristic,
}

/// A path on the surface, from its start to the source.
#[wasm_bindgen]
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
    /// `#P × 3`, as they are drawn. Can be taken once.
    pub fn take_points(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.points)
    }

    /// `#P × 3`, unit length. Can be taken once.
    pub fn take_normals(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.normals)
    }

    /// Its length in the file's unit.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> f64 {
        self.length
    }
}
