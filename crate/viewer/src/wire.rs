use glam::Vec3;

use crate::buffer::Instances;
use crate::context::Context;
use crate::shared::{PipelineRecipe, Place, Shared, linear_from_srgb, shader};

/// Two ends and a colour.
type Instance = [f32; 9];

const INSTANCE: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<Instance>() as u64,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x3],
};

/// Draws edges as thin lines.
pub(crate) struct Wires {
    pipeline: wgpu::RenderPipeline,
    segments: Instances<Instance>,
}

impl Wires {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Self {
        let pipeline = PipelineRecipe {
            label: "wire",
            layouts: &[Some(&shared.frame_layout)],
            module: &shader(context, "wire.wgsl", include_str!("wire.wgsl")),
            vertex: "vs_wire",
            fragment: "fs_wire",
            buffers: &[Some(INSTANCE)],
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            place: Place::Over,
        }
        .build(context);
        Self { pipeline, segments: Instances::new("edges") }
    }

    /// Adds segments, two ends each, of one colour; sRGB, 0..1.
    pub(crate) fn add(&mut self, context: &Context, ends: &[[Vec3; 2]], color: Vec3) {
        let color = linear_from_srgb(color);
        let segment = |[a, b]: &[Vec3; 2]| [a.x, a.y, a.z, b.x, b.y, b.z, color.x, color.y, color.z];
        self.segments.extend(context, ends.iter().map(segment));
    }

    pub(crate) fn clear(&mut self) {
        self.segments.clear();
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let Some(count) = self.segments.bind(pass, 0) else { return };
        pass.set_pipeline(&self.pipeline);
        pass.draw(0..4, 0..count);
    }
}
