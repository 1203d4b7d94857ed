//! The surface in the materials of its file.

use std::cell::OnceCell;

use glam::{Vec3, Vec4};

use crate::appearance::{MeshRun, ModelBuffers};
use crate::blended::{Order, back_to_front};
use crate::context::Context;
use crate::image::{Image, ImageLoader};
use crate::material::{BoundMaterial, Material, bind_materials, material_layout};
use crate::mesh::Mesh;
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::surface::{DISTANCE, FieldBuffers, MeshBuffers, NORMAL, PER_VERTEX, POSITION, SurfaceRenderer, TANGENT};
use crate::tint::TINT;
use crate::vertex::{Unorm16x4, attribute, single};

const TEXCOORDS: wgpu::VertexBufferLayout<'static> = single::<Vec4>(PER_VERTEX, &[attribute::<Vec4>(4)]);
const COLOR: wgpu::VertexBufferLayout<'static> = single::<Unorm16x4>(PER_VERTEX, &[attribute::<Unorm16x4>(5)]);

/// Which triangles are drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pass {
    /// Those that hide what is behind them.
    Solid,
    /// Those that let it through, which come last.
    Blended,
}

/// Draws meshes in the materials of a file.
pub(crate) struct ModelRenderer {
    module: wgpu::ShaderModule,
    /// Without a field, and with one; solid, and blended; bare, and tinted. Each takes long to build, and few files need all.
    pipelines: [[[OnceCell<wgpu::RenderPipeline>; 2]; 2]; 2],
    layout: wgpu::BindGroupLayout,
    loader: ImageLoader,
    /// Those of the file, and after them the default one.
    materials: Vec<BoundMaterial>,
}

impl ModelRenderer {
    pub(crate) fn new(context: &Context) -> Self {
        let layout = material_layout(context);
        let loader = ImageLoader::new(context);
        Self {
            module: shader_module!(context, "model"),
            pipelines: Default::default(),
            materials: bind_materials(context, &loader, &layout, &[], &[]),
            loader,
            layout,
        }
    }

    /// Replaces the materials.
    pub(crate) fn set_materials(&mut self, context: &Context, materials: &[Material], images: &[Image]) {
        self.materials = self.bind(context, materials, images);
    }

    /// Draws a mesh that has materials, with a field where there is one; false for another mesh.
    pub(crate) fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        mesh: &Mesh,
        field: Option<&FieldBuffers>,
        which: Pass,
        (context, shared, surfaces): (&Context, &Shared, &SurfaceRenderer),
    ) -> bool {
        let Some(model) = &mesh.model else { return false };
        self.draw_buffers(pass, (&mesh.buffers, model, &self.materials), field, which, (context, shared, surfaces));
        true
    }

    /// The same of what a mesh has on the device, in these materials.
    pub(crate) fn draw_buffers(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        (buffers, model, materials): (&MeshBuffers, &ModelBuffers, &[BoundMaterial]),
        field: Option<&FieldBuffers>,
        which: Pass,
        (context, shared, surfaces): (&Context, &Shared, &SurfaceRenderer),
    ) {
        let of_run = |run: &MeshRun| materials.get(run.material as usize).or(materials.last());
        let of_pass = |run: &&MeshRun| of_run(run).is_some_and(|found| found.is_blended == (which == Pass::Blended));
        if !model.runs.iter().any(|run| of_pass(&run)) {
            return;
        }
        let has_field = field.is_some_and(|field| field.bind(pass));
        let is_tinted = buffers.tints.is_some();
        let build = || self.build(context, shared, surfaces, (has_field, is_tinted), which);
        let pipelines = &self.pipelines[usize::from(has_field)][which as usize];
        pass.set_pipeline(pipelines[usize::from(is_tinted)].get_or_init(build));
        pass.set_bind_group(2, &surfaces.group, &[]);
        pass.set_vertex_buffer(4, model.texcoords.slice(..));
        pass.set_vertex_buffer(5, model.colors.slice(..));
        buffers.bind(pass);
        let mut runs = &model.runs;
        if let (Pass::Blended, Some(draws), Some(triangles)) =
            (which, &model.blended.draws, model.blended.triangles.get())
        {
            pass.set_index_buffer(triangles.slice(..), wgpu::IndexFormat::Uint32);
            runs = draws;
        }
        for run in runs.iter().filter(of_pass) {
            pass.set_bind_group(3, of_run(run).map(|material| &material.group), &[]);
            pass.draw_indexed(3 * run.triangles.start..3 * run.triangles.end, 0, 0..1);
        }
    }

    /// Materials that are drawn in beside those of the file.
    pub(crate) fn bind(&self, context: &Context, materials: &[Material], images: &[Image]) -> Vec<BoundMaterial> {
        bind_materials(context, &self.loader, &self.layout, materials, images)
    }

    /// Puts the blended triangles of a mesh in order for a line of sight.
    pub(crate) fn sort(&self, context: &Context, mesh: &mut Mesh, ahead: Vec3) {
        let Some(model) = mesh.model.as_mut().filter(|model| model.blended.ahead != Some(ahead)) else { return };
        let is_blended = |run: &&MeshRun| self.material(run).is_some_and(|material| material.is_blended);
        let runs: Vec<MeshRun> = model.runs.iter().filter(is_blended).cloned().collect();
        let order = back_to_front(mesh.picker.positions(), mesh.picker.triangles(), &runs, ahead);
        let order = order.filter(|order| !order.draws.is_empty());
        let blended = &mut model.blended;
        blended.ahead = Some(ahead);
        blended.draws = order.map(|Order { triangles, draws }| {
            let corners: Vec<[u32; 3]> = triangles.iter().map(|&triangle| mesh.picker.corners(triangle)).collect();
            blended.triangles.write(context, bytemuck::cast_slice(&corners));
            draws
        });
    }

    fn material(&self, run: &MeshRun) -> Option<&BoundMaterial> {
        self.materials.get(run.material as usize).or(self.materials.last())
    }

    fn build(
        &self,
        context: &Context,
        shared: &Shared,
        surfaces: &SurfaceRenderer,
        (has_field, is_tinted): (bool, bool),
        which: Pass,
    ) -> wgpu::RenderPipeline {
        let [distance, tangent] = [DISTANCE, TANGENT].map(|buffer| has_field.then_some(buffer));
        let (fragment, place) = match which {
            Pass::Solid => ("fs_model", Place::Solid),
            Pass::Blended => ("fs_model_blended", Place::Over),
        };
        PipelineRecipe {
            label: "model",
            layouts: &[
                Some(&shared.frame_layout),
                Some(&shared.lighting.layout),
                Some(&surfaces.style_layout),
                Some(&self.layout),
            ],
            module: &self.module,
            vertex: match (has_field, is_tinted) {
                (true, false) => "vs_model",
                (true, true) => "vs_model_tinted",
                (false, false) => "vs_model_plain",
                (false, true) => "vs_model_plain_tinted",
            },
            fragment,
            buffers: &[
                Some(POSITION),
                Some(NORMAL),
                distance,
                tangent,
                Some(TEXCOORDS),
                Some(COLOR),
                is_tinted.then_some(TINT),
            ],
            topology: wgpu::PrimitiveTopology::TriangleList,
            place,
        }
        .build(context)
    }
}
