use glam::{Vec3, Vec4};

use crate::context::Context;
use crate::shared::{PipelineRecipe, Place, Shared, shader, uniform, uniform_layout};

/// The gradient behind the surface.
pub(crate) struct Background {
    pipeline: wgpu::RenderPipeline,
    buffer: wgpu::Buffer,
    group: wgpu::BindGroup,
}

impl Background {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Self {
        let layout = uniform_layout(context, "background layout");
        let (buffer, group) = uniform(context, &layout, "background uniform", 2);
        let pipeline = PipelineRecipe {
            label: "background",
            layouts: &[Some(&shared.frame_layout), None, Some(&layout)],
            module: &shader(context, "background.wgsl", include_str!("background.wgsl")),
            vertex: "vs_background",
            fragment: "fs_background",
            buffers: &[],
            topology: wgpu::PrimitiveTopology::TriangleList,
            place: Place::Behind,
        }
        .build(context);
        let background = Self { pipeline, buffer, group };
        background.set_colors(context, Vec3::new(0.96, 0.97, 0.98), Vec3::new(0.80, 0.83, 0.86));
        background
    }

    /// Colours of the upper and lower edge; sRGB, 0..1.
    pub(crate) fn set_colors(&self, context: &Context, top: Vec3, bottom: Vec3) {
        let colors: [Vec4; 2] = [top, bottom].map(|color| color.extend(1.0));
        context.queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(&colors));
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
