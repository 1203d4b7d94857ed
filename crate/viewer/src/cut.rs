//! The surface cut open by planes.

use std::cell::OnceCell;

use crate::context::Context;
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::surface::{FieldBuffers, MeshBuffers, POSITION, SurfaceRenderer, vertices};

/// What is drawn of a cut surface.
#[derive(Clone, Copy)]
pub(crate) enum Part {
    /// Pixels that no plane runs through.
    Body,
    /// Those that one does.
    Rim,
}

/// Draws the surface where it is cut open. It has pipelines of its own, so that another surface does not pay for it.
pub(crate) struct CutRenderer {
    module: wgpu::ShaderModule,
    /// Body and rim; without a field, and with one; bare, and tinted. Few surfaces need all.
    pipelines: [[[OnceCell<wgpu::RenderPipeline>; 2]; 2]; 2],
    shadow: wgpu::RenderPipeline,
}

impl CutRenderer {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Self {
        let module = shader_module!(context, "cut");
        let shadow = PipelineRecipe {
            label: "shadow of a cut surface",
            layouts: &[Some(&shared.frame_layout)],
            module: &module,
            vertex: "vs_shadow_cut",
            fragment: "fs_shadow_cut",
            buffers: &[Some(POSITION)],
            topology: wgpu::PrimitiveTopology::TriangleList,
            place: Place::Solid,
        }
        .build_holed_shadow(context);
        Self { module, pipelines: Default::default(), shadow }
    }

    /// Draws what is left of the surface but for its rim, or the rim, which comes after all that may be behind it.
    pub(crate) fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        mesh: &MeshBuffers,
        field: &FieldBuffers,
        which: Part,
        device: (&Context, &Shared, &SurfaceRenderer),
    ) {
        pass.set_bind_group(2, &device.2.group, &[]);
        let (has_field, is_tinted) = (field.bind(pass), mesh.tints.is_some());
        let pipelines = &self.pipelines[which as usize][usize::from(has_field)];
        let build = || self.build(which, (has_field, is_tinted), device);
        pass.set_pipeline(pipelines[usize::from(is_tinted)].get_or_init(build));
        mesh.draw(pass);
    }

    fn build(
        &self,
        which: Part,
        (has_field, is_tinted): (bool, bool),
        (context, shared, surfaces): (&Context, &Shared, &SurfaceRenderer),
    ) -> wgpu::RenderPipeline {
        let (vertex, buffers) = vertices(has_field, is_tinted);
        let (fragment, place) = match (which, has_field) {
            (Part::Body, true) => ("fs_field_cut", Place::Solid),
            (Part::Body, false) => ("fs_plain_cut", Place::Solid),
            (Part::Rim, true) => ("fs_field_rim", Place::Fading),
            (Part::Rim, false) => ("fs_plain_rim", Place::Fading),
        };
        PipelineRecipe {
            label: "cut surface",
            layouts: &[Some(&shared.frame_layout), Some(&shared.lighting.layout), Some(&surfaces.style_layout)],
            module: &self.module,
            vertex,
            fragment,
            buffers: &buffers,
            topology: wgpu::PrimitiveTopology::TriangleList,
            place,
        }
        .build(context)
    }

    pub(crate) fn draw_shadow(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshBuffers) {
        pass.set_pipeline(&self.shadow);
        mesh.draw_positions(pass);
    }
}
