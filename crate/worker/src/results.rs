//! What the page gets of triangles and paths.

use glam::Vec3;
use heatwalk::{Costs, Path, PathPoint, Surface};
use heatwalk_bake::{BoundingSphere, Hierarchy};
use heatwalk_bindings::{DrawPath, Message};
use heatwalk_model::appearance::Run;
use heatwalk_scene::DrawTransform;
use js_sys::{Float32Array, Uint8Array, Uint32Array};

/// Triangles to draw, with vertices split where the normal jumps, and their bounding volume hierarchy.
#[derive(Default, Message)]
pub struct DrawMesh {
    /// `#D × 3`, as they are drawn.
    pub positions: Vec<f32>,
    /// `#D × 3`, unit length.
    pub normals: Vec<f32>,
    /// `#F × 3`, indices of drawn vertices, counter-clockwise seen from outside.
    pub triangles: Vec<u32>,
    /// `#D × 4`, two sets of texture coordinates; empty where the file has none.
    pub texcoords: Vec<f32>,
    /// `#D × 4`, linear RGBA, 65535 for 1; empty where the file has none.
    pub colors: Vec<u16>,
    /// Three numbers a run of triangles of one material: its first triangle, the one after its last, and the material's
    /// index, the largest number for the default one. Empty where the file has no materials.
    pub runs: Vec<u32>,
    /// `#F`, triangles in the order of the hierarchy's leaves.
    pub order: Uint32Array,
    /// Least and greatest corner of each of the hierarchy's boxes, from the root to the leaves.
    pub boxes: Float32Array,
}

impl DrawMesh {
    pub(crate) fn new(mesh: heatwalk_scene::DrawMesh) -> Self {
        let hierarchy = Hierarchy::new(bytemuck::cast_slice(&mesh.positions), bytemuck::cast_slice(&mesh.triangles));
        let numbers = |run: &Run| {
            let material = run.material.map_or(u32::MAX, |material| material as u32);
            [run.triangles.start as u32, run.triangles.end as u32, material]
        };
        Self {
            runs: mesh.runs.iter().flat_map(numbers).collect(),
            positions: mesh.positions,
            normals: mesh.normals,
            triangles: mesh.triangles,
            texcoords: mesh.texcoords,
            colors: mesh.colors,
            order: hierarchy.order().into(),
            boxes: bytemuck::cast_slice::<_, f32>(hierarchy.boxes()).into(),
        }
    }

    fn places(&self) -> &[Vec3] {
        bytemuck::cast_slice(&self.positions)
    }

    /// Of the triangles as they are drawn.
    pub(crate) fn bounds(&self) -> BoundingSphere {
        BoundingSphere::of_points(self.places().iter()).unwrap_or(BoundingSphere::UNIT)
    }

    /// What the triangles keep off the light around them.
    pub(crate) fn shade(&self) -> Shade {
        let triangles = bytemuck::cast_slice(&self.triangles);
        let shade = heatwalk_bake::Shade::new(self.bounds(), [(self.places(), triangles)].into_iter());
        Shade { contact: shade.contact().into(), occlusion: shade.occlusion().into() }
    }
}

/// Drawn vertices in a pose.
#[derive(Message)]
pub struct DrawPose {
    /// `#D × 3`, as they are drawn.
    pub positions: Vec<f32>,
    /// `#D × 3`, unit length.
    pub normals: Vec<f32>,
}

impl From<heatwalk_scene::DrawPose> for DrawPose {
    fn from(heatwalk_scene::DrawPose { positions, normals }: heatwalk_scene::DrawPose) -> Self {
        Self { positions, normals }
    }
}

/// What a surface keeps off the light around it: texels of the viewer's.
#[derive(Message)]
pub struct Shade {
    /// Darkness of the floor.
    pub contact: Uint8Array,
    /// Ambient occlusion around the surface.
    pub occlusion: Uint8Array,
}

macro_rules! report {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {
        /// What was done to make a surface of the triangles, in counts.
        #[derive(Message)]
        pub struct BuildReport { $($(#[$doc])* pub $name: f64),* }

        impl From<&heatwalk::BuildReport> for BuildReport {
            fn from(report: &heatwalk::BuildReport) -> Self {
                Self { $($name: report.$name as f64),* }
            }
        }
    };
}

report! {
    /// How far the farthest vertex was from the one that it was merged into, in the file's unit.
    crack_width,
    /// Vertices of the input.
    input_vertices,
    /// Vertices after welding.
    vertices,
    /// Faces kept.
    faces,
    /// Polygons of the file that these are cut from; a triangle is one.
    polygons,
    /// Input vertices that were merged into another.
    welded_vertices,
    /// Vertices that were merged into one across a crack.
    crack_vertices,
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
    /// Euler characteristic V − E + F.
    euler_characteristic,
}

/// A path as it is `shown`: the path itself, or that carried to another pose.
pub(crate) fn draw_path(
    surface: &Surface,
    path: &Path,
    shown: &Path,
    costs: Option<&Costs>,
    transform: &DrawTransform,
) -> DrawPath {
    let segment = |ends: &[PathPoint]| {
        let segment = Path::new(surface, ends.to_vec());
        let length = segment.length();
        costs.filter(|_| length > 0.0).map_or(1.0, |costs| (costs.of_path(surface, &segment) / length) as f32)
    };
    let length = path.length();
    DrawPath {
        points: transform.places(shown.points.iter().map(|point| point.position)),
        places: shown.points.iter().flat_map(|point| point.position.to_array()).collect(),
        normals: transform.directions(shown.normals.iter().copied()),
        length,
        straight: straight(path),
        cost: costs.map_or(length, |costs| costs.of_path(surface, path)),
        segment_costs: if costs.is_some() { path.points.windows(2).map(segment).collect() } else { Vec::new() },
        drawn_length: transform.length(shown.length()),
    }
}

/// How far the ends of a path are apart.
pub(crate) fn straight(path: &Path) -> f64 {
    match (path.points.first(), path.points.last()) {
        (Some(first), Some(last)) => first.position.distance(last.position),
        _ => 0.0,
    }
}
