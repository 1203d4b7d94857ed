//! What the page gets: objects whose properties, made plain by `toJSON`, are the messages of the page's protocol. Each array
//! is copied once, into a buffer of JavaScript's.

use glam::Vec3;
use heatwalk::surface::appearance::Run;
use heatwalk::{Costs, Path, PathPoint, Surface};
use heatwalk_bake::{Bounds, Hierarchy};
use heatwalk_scene::DrawTransform;
use js_sys::{Float32Array, Uint8Array, Uint16Array, Uint32Array};
use wasm_bindgen::prelude::*;

/// What was left out of a file, or taken otherwise than it is written.
#[wasm_bindgen(inspectable)]
pub struct Warning {
    warning: heatwalk::Warning,
}

impl Warning {
    pub(crate) fn new(warning: &heatwalk::Warning) -> Self {
        Self { warning: warning.clone() }
    }
}

#[wasm_bindgen]
impl Warning {
    /// Its kind, in kebab case.
    #[wasm_bindgen(getter)]
    pub fn code(&self) -> String {
        self.warning.code.name().to_owned()
    }

    /// Of how many things.
    #[wasm_bindgen(getter)]
    pub fn count(&self) -> u32 {
        self.warning.count as u32
    }

    /// Where the first of them is.
    #[wasm_bindgen(getter)]
    pub fn place(&self) -> String {
        self.warning.place.clone()
    }
}

/// Triangles to draw, with vertices split where the normal jumps, and their bounding volume hierarchy.
#[wasm_bindgen(inspectable)]
#[derive(Default)]
pub struct DrawMesh {
    mesh: heatwalk_scene::DrawMesh,
    hierarchy: Hierarchy,
}

impl DrawMesh {
    pub(crate) fn new(mesh: heatwalk_scene::DrawMesh) -> Self {
        let hierarchy = Hierarchy::new(bytemuck::cast_slice(&mesh.positions), bytemuck::cast_slice(&mesh.triangles));
        Self { mesh, hierarchy }
    }

    /// Of the triangles as they are drawn.
    pub(crate) fn bounds(&self) -> Bounds {
        let positions: &[Vec3] = bytemuck::cast_slice(&self.mesh.positions);
        Bounds::of_points(positions.iter()).unwrap_or(Bounds::UNIT)
    }

    /// What the triangles keep off the light around them.
    pub(crate) fn shade(&self) -> Shade {
        let positions: &[Vec3] = bytemuck::cast_slice(&self.mesh.positions);
        Shade(heatwalk_bake::Shade::new(
            self.bounds(),
            [(positions, bytemuck::cast_slice(&self.mesh.triangles))].into_iter(),
        ))
    }
}

#[wasm_bindgen]
impl DrawMesh {
    /// `#D × 3`, as they are drawn.
    #[wasm_bindgen(getter)]
    pub fn positions(&self) -> Float32Array {
        self.mesh.positions.as_slice().into()
    }

    /// `#D × 3`, unit length.
    #[wasm_bindgen(getter)]
    pub fn normals(&self) -> Float32Array {
        self.mesh.normals.as_slice().into()
    }

    /// `#F × 3`, indices of drawn vertices, counter-clockwise seen from outside.
    #[wasm_bindgen(getter)]
    pub fn triangles(&self) -> Uint32Array {
        self.mesh.triangles.as_slice().into()
    }

    /// `#D × 4`, two sets of texture coordinates; empty where the file has none.
    #[wasm_bindgen(getter)]
    pub fn texcoords(&self) -> Float32Array {
        self.mesh.texcoords.as_slice().into()
    }

    /// `#D × 4`, linear RGBA, 65535 for 1; empty where the file has none.
    #[wasm_bindgen(getter)]
    pub fn colors(&self) -> Uint16Array {
        self.mesh.colors.as_slice().into()
    }

    /// Three numbers a run of triangles of one material: its first triangle, the one after its last, and the material's
    /// index, the largest number for the default one. Empty where the file has no materials.
    #[wasm_bindgen(getter)]
    pub fn runs(&self) -> Uint32Array {
        let numbers = |run: &Run| {
            let material = run.material.map_or(u32::MAX, |material| material as u32);
            [run.triangles.start as u32, run.triangles.end as u32, material]
        };
        self.mesh.runs.iter().flat_map(numbers).collect::<Vec<u32>>().as_slice().into()
    }

    /// `#F`, triangles in the order of the hierarchy's leaves.
    #[wasm_bindgen(getter)]
    pub fn order(&self) -> Uint32Array {
        self.hierarchy.order().into()
    }

    /// Least and greatest corner of each of the hierarchy's boxes, from the root to the leaves.
    #[wasm_bindgen(getter)]
    pub fn boxes(&self) -> Float32Array {
        bytemuck::cast_slice::<_, f32>(self.hierarchy.boxes()).into()
    }
}

/// Drawn vertices in a pose.
#[wasm_bindgen(inspectable)]
pub struct DrawPose(heatwalk_scene::DrawPose);

impl DrawPose {
    pub(crate) fn new(pose: heatwalk_scene::DrawPose) -> Self {
        Self(pose)
    }
}

#[wasm_bindgen]
impl DrawPose {
    /// `#D × 3`, as they are drawn.
    #[wasm_bindgen(getter)]
    pub fn positions(&self) -> Float32Array {
        self.0.positions.as_slice().into()
    }

    /// `#D × 3`, unit length.
    #[wasm_bindgen(getter)]
    pub fn normals(&self) -> Float32Array {
        self.0.normals.as_slice().into()
    }
}

/// What a surface keeps off the light around it: texels of the viewer's.
#[wasm_bindgen(inspectable)]
pub struct Shade(heatwalk_bake::Shade);

#[wasm_bindgen]
impl Shade {
    /// Darkness of the floor.
    #[wasm_bindgen(getter)]
    pub fn contact(&self) -> Uint8Array {
        self.0.contact().into()
    }

    /// Ambient occlusion around the surface.
    #[wasm_bindgen(getter)]
    pub fn occlusion(&self) -> Uint8Array {
        self.0.occlusion().into()
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

#[wasm_bindgen]
impl BuildReport {
    /// How far the farthest vertex was from the one that it was merged into, in the file's unit.
    #[wasm_bindgen(getter, js_name = crackWidth)]
    pub fn crack_width(&self) -> f64 {
        self.0.crack_width
    }
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
    /// Vertices that were merged into one across a crack.
    crack_vertices as crackVertices,
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
    drawn_length: f32,
    cost: f64,
    segment_costs: Vec<f32>,
}

impl SurfacePath {
    /// A path as it is `shown`: the path itself, or that carried to another pose.
    pub(crate) fn of(
        surface: &Surface,
        path: &Path,
        shown: &Path,
        costs: Option<&Costs>,
        transform: &DrawTransform,
    ) -> Self {
        let points = transform.places(shown.points.iter().map(|point| point.position));
        let normals =
            shown.normals.iter().flat_map(|&normal| transform.direction(normal).as_vec3().to_array()).collect();
        let segment = |ends: &[PathPoint]| {
            let segment = Path::new(surface, ends.to_vec());
            let length = segment.length();
            costs.filter(|_| length > 0.0).map_or(1.0, |costs| (costs.of_path(surface, &segment) / length) as f32)
        };
        let length = path.length();
        Self {
            points,
            normals,
            length,
            drawn_length: transform.length(shown.length()),
            cost: costs.map_or(length, |costs| costs.of_path(surface, path)),
            segment_costs: if costs.is_some() { path.points.windows(2).map(segment).collect() } else { Vec::new() },
        }
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

    /// Its length in the file's unit, in the pose that distances are measured in.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// What walking it costs: its length, each segment times what a unit of it costs.
    #[wasm_bindgen(getter)]
    pub fn cost(&self) -> f64 {
        self.cost
    }

    /// `#P − 1`, what a unit of each segment costs; empty where all cost 1.
    #[wasm_bindgen(getter, js_name = segmentCosts)]
    pub fn segment_costs(&self) -> Float32Array {
        self.segment_costs.as_slice().into()
    }

    /// Length of the line through the points.
    #[wasm_bindgen(getter, js_name = drawnLength)]
    pub fn drawn_length(&self) -> f32 {
        self.drawn_length
    }
}
