//! The surface in the materials of its file.

use glam::Vec4;

use crate::context::Context;
use crate::image::Image;
use crate::material::{BoundMaterial, Material, bind_materials, material_layout};
use crate::mesh::Mesh;
use crate::pipeline::{PipelineRecipe, Place, shader};
use crate::shared::Shared;
use crate::surface::{DISTANCE, FieldBuffers, NORMAL, PER_VERTEX, POSITION, SURFACE_WGSL, SurfaceRenderer, TANGENT};
use crate::vertex::{Unorm16x4, attribute, single};

const TEXCOORDS: wgpu::VertexBufferLayout<'static> = single::<Vec4>(PER_VERTEX, &[attribute::<Vec4>(4)]);
const COLOR: wgpu::VertexBufferLayout<'static> = single::<Unorm16x4>(PER_VERTEX, &[attribute::<Unorm16x4>(5)]);
/// A pipeline for what hides what is behind it, and one for what lets it through.
struct Pair {
    solid: wgpu::RenderPipeline,
    blended: wgpu::RenderPipeline,
}

/// Draws meshes in the materials of a file.
pub(crate) struct ModelRenderer {
    with_field: Pair,
    plain: Pair,
    layout: wgpu::BindGroupLayout,
    /// Those of the file, and after them the default one.
    materials: Vec<BoundMaterial>,
}

/// Which triangles are drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pass {
    /// Those that hide what is behind them.
    Solid,
    /// Those that let it through, which come last.
    Blended,
}

impl ModelRenderer {
    pub(crate) fn new(context: &Context, shared: &Shared, surfaces: &SurfaceRenderer) -> Self {
        let layout = material_layout(context);
        let source = format!("{SURFACE_WGSL}\n{}", include_str!("model.wgsl"));
        let module = shader(context, "model.wgsl", &source);
        let layouts =
            [Some(&shared.frame_layout), Some(&shared.lighting.layout), Some(&surfaces.style_layout), Some(&layout)];
        let pair = |label, vertex, buffers: &[Option<wgpu::VertexBufferLayout<'static>>]| {
            let pipeline = |fragment, place| {
                PipelineRecipe {
                    label,
                    layouts: &layouts,
                    module: &module,
                    vertex,
                    fragment,
                    buffers,
                    topology: wgpu::PrimitiveTopology::TriangleList,
                    place,
                }
                .build(context)
            };
            Pair { solid: pipeline("fs_model", Place::Solid), blended: pipeline("fs_model_blended", Place::Over) }
        };
        let all = [Some(POSITION), Some(NORMAL), Some(DISTANCE), Some(TANGENT), Some(TEXCOORDS), Some(COLOR)];
        let bare = [Some(POSITION), Some(NORMAL), None, None, Some(TEXCOORDS), Some(COLOR)];
        Self {
            with_field: pair("model with field", "vs_model", &all),
            plain: pair("model without field", "vs_model_plain", &bare),
            materials: bind_materials(context, &layout, &[], &[]),
            layout,
        }
    }

    /// Replaces the materials.
    pub(crate) fn set_materials(&mut self, context: &Context, materials: &[Material], images: &[Image]) {
        self.materials = bind_materials(context, &self.layout, materials, images);
    }

    /// Draws a mesh that has materials, with a field where there is one; false for another mesh.
    pub(crate) fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        surfaces: &SurfaceRenderer,
        mesh: &Mesh,
        field: Option<&FieldBuffers>,
        which: Pass,
    ) -> bool {
        let Some(model) = &mesh.model else { return false };
        let pair = if field.is_some_and(|field| field.bind(pass)) { &self.with_field } else { &self.plain };
        pass.set_pipeline(if which == Pass::Blended { &pair.blended } else { &pair.solid });
        pass.set_bind_group(2, &surfaces.group, &[]);
        pass.set_vertex_buffer(4, model.texcoords.slice(..));
        pass.set_vertex_buffer(5, model.colors.slice(..));
        mesh.buffers.bind(pass);
        for run in &model.runs {
            let material = self.materials.get(run.material as usize).or(self.materials.last());
            let Some(material) = material.filter(|found| found.is_blended == (which == Pass::Blended)) else {
                continue;
            };
            pass.set_bind_group(3, &material.group, &[]);
            pass.draw_indexed(3 * run.triangles.start..3 * run.triangles.end, 0, 0..1);
        }
        true
    }
}
