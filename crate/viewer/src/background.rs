use encase::ShaderType;
use glam::Vec3;

use crate::binding::uniform_layout;
use crate::context::Context;
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::uniform::Uniform;

/// `Background` of background.wgsl.
#[derive(ShaderType)]
struct BackgroundUniform {
    top: Vec3,
    bottom: Vec3,
}

/// The gradient behind the surface.
pub(crate) struct Background {
    pipeline: wgpu::RenderPipeline,
    colors: Uniform<BackgroundUniform>,
    group: wgpu::BindGroup,
}

impl Background {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Self {
        let layout = uniform_layout(context, "background layout");
        let colors = Uniform::new(context, "background uniform");
        let group = colors.group(context, &layout, "background");
        let pipeline = PipelineRecipe {
            label: "background",
            layouts: &[Some(&shared.frame_layout), None, Some(&layout)],
            module: &shader_module!(context, "background"),
            vertex: "vs_background",
            fragment: "fs_background",
            buffers: &[],
            topology: wgpu::PrimitiveTopology::TriangleList,
            place: Place::Behind,
        }
        .build(context);
        let background = Self { pipeline, colors, group };
        background.set_colors(context, Vec3::new(0.96, 0.97, 0.98), Vec3::new(0.80, 0.83, 0.86));
        background
    }

    /// Colours of the upper and lower edge; sRGB, 0..1.
    pub(crate) fn set_colors(&self, context: &Context, top: Vec3, bottom: Vec3) {
        self.colors.write(context, &BackgroundUniform { top, bottom });
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(2, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
