use glam::Vec3;

use crate::binding::{FILTERED_TEXTURE, fragment_entry, sampled_group, uniform_entry, written_texture};
use crate::buffer::mesh_buffer;
use crate::context::Context;
use crate::error::Error;
use crate::pipeline::{PipelineRecipe, Place};
use crate::shader::shader_module;
use crate::shared::Shared;
use crate::style::{RAMP_SIZE, Style, StyleUniform};
use crate::tint::{TINT, TINT_SLOT, TintBuffer};
use crate::uniform::Uniform;
use crate::vertex::{Snorm8x4, attribute, single};

/// Bytes of the ramp of the surface and that of the stripes: RGBA.
pub const RAMP_BYTES: usize = 2 * 4 * RAMP_SIZE;
/// Stands for "unreachable" in a vertex buffer, whose values are shares of the largest one: interpolating an infinity gives
/// NaN on some devices.
pub(crate) const UNREACHABLE: f32 = 2.0;

pub(crate) const POSITION: wgpu::VertexBufferLayout<'static> = single::<Vec3>(PER_VERTEX, &[attribute::<Vec3>(0)]);
pub(crate) const NORMAL: wgpu::VertexBufferLayout<'static> = single::<Vec3>(PER_VERTEX, &[attribute::<Vec3>(1)]);
pub(crate) const DISTANCE: wgpu::VertexBufferLayout<'static> = single::<f32>(PER_VERTEX, &[attribute::<f32>(2)]);
pub(crate) const TANGENT: wgpu::VertexBufferLayout<'static> =
    single::<Snorm8x4>(PER_VERTEX, &[attribute::<Snorm8x4>(3)]);
pub(crate) const PER_VERTEX: wgpu::VertexStepMode = wgpu::VertexStepMode::Vertex;

/// The vertex shader of a mesh, with or without a field, bare or tinted, and its buffers.
pub(crate) fn vertices(
    has_field: bool,
    is_tinted: bool,
) -> (&'static str, [Option<wgpu::VertexBufferLayout<'static>>; TINT_SLOT as usize + 1]) {
    let [distance, tangent] = [DISTANCE, TANGENT].map(|buffer| has_field.then_some(buffer));
    let vertex = match (has_field, is_tinted) {
        (true, false) => "vs_field",
        (true, true) => "vs_field_tinted",
        (false, false) => "vs_plain",
        (false, true) => "vs_plain_tinted",
    };
    (vertex, [Some(POSITION), Some(NORMAL), distance, tangent, None, None, is_tinted.then_some(TINT)])
}

/// A triangle mesh on the device.
pub(crate) struct MeshBuffers {
    positions: wgpu::Buffer,
    normals: wgpu::Buffer,
    triangles: wgpu::Buffer,
    index_count: u32,
    /// Where it is drawn with one vertex a corner.
    pub(crate) tints: Option<TintBuffer>,
}

impl MeshBuffers {
    /// Uploads `#V × 3` positions and normals and `#F × 3` indices.
    ///
    /// # Errors
    /// When one of the arrays is larger than the device allows.
    pub(crate) fn new(
        context: &Context,
        positions: &[Vec3],
        normals: &[Vec3],
        triangles: &[[u32; 3]],
    ) -> Result<Self, Error> {
        let vertex = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        Ok(Self {
            positions: mesh_buffer(context, "vertex positions", bytemuck::cast_slice(positions), vertex)?,
            normals: mesh_buffer(context, "vertex normals", bytemuck::cast_slice(normals), vertex)?,
            triangles: mesh_buffer(
                context,
                "triangle indices",
                bytemuck::cast_slice(triangles),
                wgpu::BufferUsages::INDEX,
            )?,
            index_count: 3 * triangles.len() as u32,
            tints: None,
        })
    }

    /// Uploads as many positions and normals again.
    pub(crate) fn pose(&self, context: &Context, positions: &[Vec3], normals: &[Vec3]) {
        context.queue.write_buffer(&self.positions, 0, bytemuck::cast_slice(positions));
        context.queue.write_buffer(&self.normals, 0, bytemuck::cast_slice(normals));
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.bind(pass);
        pass.draw_indexed(0..self.index_count, 0, 0..1);
    }

    /// Binds positions, normals and triangles, and tints where there are any.
    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(tints) = &self.tints {
            tints.bind(pass);
        }
        pass.set_vertex_buffer(1, self.normals.slice(..));
        self.bind_positions(pass);
    }

    fn bind_positions(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.positions.slice(..));
        pass.set_index_buffer(self.triangles.slice(..), wgpu::IndexFormat::Uint32);
    }

    pub(crate) fn draw_positions(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.bind_positions(pass);
        pass.draw_indexed(0..self.index_count, 0, 0..1);
    }
}

/// The distance field, one value and one direction a vertex, rewritten with every solve.
pub(crate) struct FieldBuffers {
    distances: wgpu::Buffer,
    tangents: wgpu::Buffer,
    /// What goes to the device; kept, so that a new field allocates nothing.
    values: Vec<f32>,
    directions: Vec<Snorm8x4>,
    /// False until a field was written.
    has_field: bool,
    /// Where the mesh is drawn with one vertex a corner: the vertex of each, and values of vertices as they come.
    corners: Vec<u32>,
    given: (Vec<f32>, Vec<Snorm8x4>),
}

impl FieldBuffers {
    pub(crate) fn new(context: &Context, vertex_count: usize) -> Result<Self, Error> {
        let values = vec![UNREACHABLE; vertex_count];
        let directions = vec![[0; 4]; vertex_count];
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        let distances = mesh_buffer(context, "vertex distances", bytemuck::cast_slice(&values), usage)?;
        let tangents = mesh_buffer(context, "vertex tangents", bytemuck::cast_slice(&directions), usage)?;
        let (corners, given) = Default::default();
        Ok(Self { distances, tangents, values, directions, has_field: false, corners, given })
    }

    /// For a mesh that is drawn with one vertex a corner: `corners` are vertices of so many.
    pub(crate) fn of_corners(context: &Context, corners: Vec<u32>, vertex_count: usize) -> Result<Self, Error> {
        let given = (vec![0.0; vertex_count], vec![[0; 4]; vertex_count]);
        Ok(Self { given, ..Self::new(context, corners.len())? }.with_corners(corners))
    }

    fn with_corners(self, corners: Vec<u32>) -> Self {
        Self { corners, ..self }
    }

    /// Binds distances and directions; false where no field was written.
    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass<'_>) -> bool {
        if self.has_field {
            pass.set_vertex_buffer(2, self.distances.slice(..));
            pass.set_vertex_buffer(3, self.tangents.slice(..));
        }
        self.has_field
    }

    /// How many values come: one a vertex, or one a corner of each triangle where the mesh is drawn so.
    pub(crate) fn value_count(&self, is_by_corner: bool) -> usize {
        match (self.corners.is_empty(), is_by_corner) {
            (true, true) => 0,
            (true, false) => self.values.len(),
            (false, true) => self.corners.len(),
            (false, false) => self.given.0.len(),
        }
    }

    /// For another field of the same mesh.
    pub(crate) fn alike(&self, context: &Context) -> Result<Self, Error> {
        if self.corners.is_empty() {
            Self::new(context, self.values.len())
        } else {
            Self::of_corners(context, self.corners.clone(), self.given.0.len())
        }
    }

    pub(crate) fn clear(&mut self) {
        self.has_field = false;
    }

    /// Lets `fill` write one value a vertex, or a corner, (infinite or NaN = unreachable) and the direction in which it grows (127 for a
    /// unit, the fourth number unused), and uploads them, the values over `max`: the shader's arithmetic does not depend on
    /// their unit.
    pub(crate) fn write(
        &mut self,
        context: &Context,
        max: f64,
        is_by_corner: bool,
        fill: impl FnOnce(&mut [f32], &mut [i8]),
    ) {
        if self.corners.is_empty() || is_by_corner {
            fill(&mut self.values, bytemuck::cast_slice_mut(&mut self.directions));
        } else {
            let (values, directions) = &mut self.given;
            fill(values, bytemuck::cast_slice_mut(directions));
            let corners = self.corners.iter().map(|&vertex| vertex as usize);
            for ((vertex, value), direction) in corners.zip(&mut self.values).zip(&mut self.directions) {
                (*value, *direction) = (values[vertex], directions[vertex]);
            }
        }
        for value in &mut self.values {
            *value = if value.is_finite() { (f64::from(*value) / max) as f32 } else { UNREACHABLE };
        }
        context.queue.write_buffer(&self.distances, 0, bytemuck::cast_slice(&self.values));
        context.queue.write_buffer(&self.tangents, 0, bytemuck::cast_slice(&self.directions));
        self.has_field = true;
    }
}

/// Draws the surface and the scenery.
pub(crate) struct SurfaceRenderer {
    /// Bare and tinted.
    field: [wgpu::RenderPipeline; 2],
    plain: [wgpu::RenderPipeline; 2],
    scenery: wgpu::RenderPipeline,
    shadow: wgpu::RenderPipeline,
    /// Style and ramps.
    pub(crate) group: wgpu::BindGroup,
    pub(crate) style_layout: wgpu::BindGroupLayout,
    style: Uniform<StyleUniform>,
    ramps: wgpu::Texture,
}

impl SurfaceRenderer {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Self {
        let layout = style_layout(context);
        let style: Uniform<StyleUniform> = Uniform::new(context, "style uniform");
        let ramps = written_texture(context, "ramps", [RAMP_SIZE as u32, 2], wgpu::TextureFormat::Rgba8UnormSrgb);
        let group = sampled_group(context, "style", &layout, &style.buffer, &ramps);
        let module = shader_module!(context, "surface");
        let layouts = [Some(&shared.frame_layout), Some(&shared.lighting.layout), Some(&layout)];
        let recipe = PipelineRecipe {
            label: "surface shadow",
            layouts: &layouts,
            module: &module,
            vertex: "vs_shadow",
            fragment: "",
            buffers: &[Some(POSITION)],
            topology: wgpu::PrimitiveTopology::TriangleList,
            place: Place::Solid,
        };
        let surface = |label, fragment, has_field, is_tinted| {
            let (vertex, buffers) = vertices(has_field, is_tinted);
            PipelineRecipe { label, vertex, fragment, buffers: &buffers, ..recipe.clone() }.build(context)
        };
        let renderer = Self {
            field: [
                surface("surface with field", "fs_field", true, false),
                surface("tinted surface with field", "fs_field", true, true),
            ],
            plain: [
                surface("surface without field", "fs_plain", false, false),
                surface("tinted surface without field", "fs_plain", false, true),
            ],
            scenery: surface("scenery", "fs_scenery", false, false),
            shadow: PipelineRecipe { layouts: &[Some(&shared.frame_layout)], ..recipe.clone() }.build_shadow(context),
            group,
            style_layout: layout,
            style,
            ramps,
        };
        renderer.set_ramps(context, &[236; RAMP_BYTES]);
        renderer
    }

    /// Colours over value / max, of the surface and then of the stripes; sRGB bytes, RGBA.
    pub(crate) fn set_ramps(&self, context: &Context, texels: &[u8; RAMP_BYTES]) {
        let row = Some(4 * RAMP_SIZE as u32);
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: row, rows_per_image: None };
        context.queue.write_texture(self.ramps.as_image_copy(), texels, layout, self.ramps.size());
    }

    /// `max` is the largest value of the field.
    pub(crate) fn set_style(&self, context: &Context, style: &Style, max: f64) {
        self.style.write(context, &style.uniform(max));
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshBuffers, field: &FieldBuffers) {
        pass.set_bind_group(2, &self.group, &[]);
        let pipelines = if field.bind(pass) { &self.field } else { &self.plain };
        pass.set_pipeline(&pipelines[usize::from(mesh.tints.is_some())]);
        mesh.draw(pass);
    }

    pub(crate) fn draw_scenery(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshBuffers) {
        pass.set_bind_group(2, &self.group, &[]);
        pass.set_pipeline(&self.scenery);
        mesh.draw(pass);
    }

    pub(crate) fn draw_shadow(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshBuffers) {
        pass.set_pipeline(&self.shadow);
        mesh.draw_positions(pass);
    }
}

fn style_layout(context: &Context) -> wgpu::BindGroupLayout {
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    context.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("style layout"),
        entries: &[uniform_entry(0), fragment_entry(1, FILTERED_TEXTURE), fragment_entry(2, sampler)],
    })
}
