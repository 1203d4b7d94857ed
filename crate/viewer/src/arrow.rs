use glam::Vec3;

use crate::buffer::Instances;
use crate::context::Context;
use crate::error::Error;
use crate::pipeline::{PipelineRecipe, Place, shader};
use crate::shared::Shared;
use crate::solid::{Detail, Solid, SolidBuffers};
use crate::vertex::vertex_layout;
use heatwalk_bake::Picker;

/// Arrows at most: more would hide the surface, and each other.
const MOST: usize = 4_000;
/// Length of an arrow, as a share of the side of the square that it has for itself, and in bounding radii at most.
const LENGTH: f32 = 0.7;
const LONGEST: f32 = 0.05;

/// World space.
#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Arrow {
    middle: Vec3,
    vector: Vec3,
}

const ARROW: wgpu::VertexBufferLayout<'static> = vertex_layout!(Arrow, per Instance: 3 => middle, 4 => vector);

/// Draws a vector field, an arrow a triangle.
pub(crate) struct Arrows {
    pipeline: wgpu::RenderPipeline,
    solid: SolidBuffers,
    instances: Instances<Arrow>,
}

impl Arrows {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Result<Self, Error> {
        let mut solid = Solid::new(Detail::COARSE);
        // A dart: blunt behind, pointed ahead.
        solid.turned(Vec3::NEG_Y * 0.5, Vec3::Y, &[(0.0, 0.001), (0.0, 0.17), (0.06, 0.17), (1.0, 0.004)], [0.0; 2]);
        let pipeline = PipelineRecipe {
            label: "arrow",
            layouts: &[Some(&shared.frame_layout), Some(&shared.lighting.layout)],
            module: &shader(context, "arrow.wgsl", include_str!("arrow.wgsl")),
            vertex: "vs_arrow",
            fragment: "fs_arrow",
            buffers: &[Some(SolidBuffers::LAYOUT), Some(ARROW)],
            topology: wgpu::PrimitiveTopology::TriangleList,
            place: Place::Solid,
        }
        .build(context);
        Ok(Self { pipeline, solid: solid.upload(context)?, instances: Instances::new("arrows") })
    }

    /// One vector a triangle; those of no length have no arrow. On a fine mesh some triangles go without, evenly over the
    /// surface. `radius` is the surface's bounding radius.
    pub(crate) fn set(&mut self, context: &Context, picker: &Picker, vectors: &[Vec3], radius: f32) {
        let step = vectors.len().div_ceil(MOST).max(1);
        let arrows = picker.in_leaf_order().iter().step_by(step).filter_map(|&triangle| {
            let direction = vectors[triangle as usize].try_normalize()?;
            let [a, b, c] = picker.corners(triangle).map(|vertex| picker.positions()[vertex as usize]);
            let side = (0.5 * (b - a).cross(c - a).length() * step as f32).sqrt();
            let vector = (LENGTH * side).min(LONGEST * radius) * direction;
            Some(Arrow { middle: (a + b + c) / 3.0, vector })
        });
        self.instances.set(context, arrows);
    }

    pub(crate) fn clear(&mut self) {
        self.instances.clear();
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(count) = self.instances.bind(pass, 1) else { return };
        pass.set_pipeline(&self.pipeline);
        self.solid.draw(pass, count);
    }
}
