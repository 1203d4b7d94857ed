use glam::Vec3;

use crate::buffer::Instances;
use crate::color::linear_from_srgb;
use crate::context::Context;
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::vertex::vertex_layout;

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct Segment {
    /// World space.
    start: Vec3,
    end: Vec3,
    /// Linear light.
    color: Vec3,
    /// CSS pixels.
    half_width: f32,
}

const SEGMENT: wgpu::VertexBufferLayout<'static> =
    vertex_layout!(Segment, per Instance: 0 => start, 1 => end, 2 => color, 3 => half_width);

/// Draws edges as thin lines.
pub(crate) struct Wires {
    pipeline: wgpu::RenderPipeline,
    segments: Instances<Segment>,
}

impl Wires {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Self {
        let pipeline = PipelineRecipe {
            label: "wire",
            layouts: &[Some(&shared.frame_layout)],
            module: &shader_module!(context, "wire"),
            vertex: "vs_wire",
            fragment: "fs_wire",
            buffers: &[Some(SEGMENT)],
            topology: wgpu::PrimitiveTopology::TriangleStrip,
            place: Place::Over,
        }
        .build(context);
        Self { pipeline, segments: Instances::new("edges") }
    }

    /// Adds segments, two ends each, of one colour (sRGB, 0..1) and so wide; CSS pixels.
    pub(crate) fn add(&mut self, context: &Context, ends: &[[Vec3; 2]], color: Vec3, width: f32) {
        let color = linear_from_srgb(color);
        let segment = |&[start, end]: &[Vec3; 2]| Segment { start, end, color, half_width: 0.5 * width };
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
