use glam::{Vec3, Vec4};

use crate::buffer::mesh_buffer;
use crate::context::Context;
use crate::error::Error;
use crate::shared::{PipelineRecipe, Shared, linear_from_srgb, shader, uniform_buffer, uniform_entry};

/// Texels of the colour ramp.
pub const RAMP_SIZE: usize = 256;
/// Stands for "unreachable" in a vertex buffer: interpolating an infinity gives NaN on some devices.
const UNREACHABLE: f32 = -1.0;

const POSITION: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<Vec3>() as u64,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3],
};
const NORMAL: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<Vec3>() as u64,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![1 => Float32x3],
};
const DISTANCE: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: size_of::<f32>() as u64,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![2 => Float32],
};

/// A triangle mesh on the device.
pub(crate) struct MeshBuffers {
    positions: wgpu::Buffer,
    normals: wgpu::Buffer,
    triangles: wgpu::Buffer,
    index_count: u32,
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
        let vertex = wgpu::BufferUsages::VERTEX;
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
        })
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.positions.slice(..));
        pass.set_vertex_buffer(1, self.normals.slice(..));
        pass.set_index_buffer(self.triangles.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.index_count, 0, 0..1);
    }
}

/// One distance a vertex, rewritten with every solve.
pub(crate) struct DistanceBuffer {
    buffer: wgpu::Buffer,
    /// What goes to the device; kept, so that a new field allocates nothing.
    values: Vec<f32>,
    /// False until a field was written.
    has_field: bool,
}

impl DistanceBuffer {
    pub(crate) fn new(context: &Context, vertex_count: usize) -> Result<Self, Error> {
        let values = vec![UNREACHABLE; vertex_count];
        let usage = wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST;
        let buffer = mesh_buffer(context, "vertex distances", bytemuck::cast_slice(&values), usage)?;
        Ok(Self { buffer, values, has_field: false })
    }

    pub(crate) fn vertex_count(&self) -> usize {
        self.values.len()
    }

    pub(crate) fn clear(&mut self) {
        self.has_field = false;
    }

    /// Lets `fill` write one distance a vertex (infinite or NaN = unreachable) and uploads them.
    pub(crate) fn write(&mut self, context: &Context, fill: impl FnOnce(&mut [f32])) {
        fill(&mut self.values);
        for value in &mut self.values {
            if !value.is_finite() {
                *value = UNREACHABLE;
            }
        }
        context.queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(&self.values));
        self.has_field = true;
    }
}

/// How the distance is painted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Look {
    /// World units.
    pub(crate) period: f32,
    /// Share of the period that the stripe covers, 0..1.
    pub(crate) width: f32,
    /// sRGB, 0..1.
    pub(crate) stripe: Vec3,
    /// The distance at the ramp's end; world units.
    pub(crate) max: f32,
}

impl Look {
    fn vectors(&self) -> [Vec4; 2] {
        let reciprocal = |value: f32| if value > 0.0 { value.recip() } else { 0.0 };
        let width = if self.period > 0.0 { self.width.clamp(0.0, 1.0) } else { 0.0 };
        [
            linear_from_srgb(self.stripe).extend(width),
            Vec4::new(reciprocal(self.period), reciprocal(self.max), 0.0, 0.0),
        ]
    }
}

/// Draws the surface and the scenery.
pub(crate) struct SurfaceRenderer {
    field: wgpu::RenderPipeline,
    plain: wgpu::RenderPipeline,
    scenery: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    look: wgpu::Buffer,
    ramp: wgpu::Texture,
}

impl SurfaceRenderer {
    pub(crate) fn new(context: &Context, shared: &Shared) -> Self {
        let layout = look_layout(context);
        let look = uniform_buffer(context, "look uniform", 2);
        let ramp = context.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("ramp"),
            size: wgpu::Extent3d { width: RAMP_SIZE as u32, height: 1, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba8UnormSrgb,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let sampler = context.device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("ramp sampler"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        });
        let view = ramp.create_view(&wgpu::TextureViewDescriptor { label: Some("ramp"), ..Default::default() });
        let group = context.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("look"),
            layout: &layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: look.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&view) },
                wgpu::BindGroupEntry { binding: 2, resource: wgpu::BindingResource::Sampler(&sampler) },
            ],
        });
        let module = shader(context, "surface.wgsl", include_str!("surface.wgsl"));
        let layouts = [Some(&shared.layout), Some(&layout)];
        let pipeline = |label, vertex, fragment, buffers| {
            PipelineRecipe {
                label,
                layouts: &layouts,
                module: &module,
                vertex,
                fragment,
                buffers,
                topology: wgpu::PrimitiveTopology::TriangleList,
                depth: true,
            }
            .build(context)
        };
        let bare = [Some(POSITION), Some(NORMAL)];
        let with_distance = [Some(POSITION), Some(NORMAL), Some(DISTANCE)];
        let renderer = Self {
            field: pipeline("surface with field", "vs_field", "fs_field", &with_distance),
            plain: pipeline("surface without field", "vs_plain", "fs_plain", &bare),
            scenery: pipeline("scenery", "vs_plain", "fs_scenery", &bare),
            group,
            look,
            ramp,
        };
        renderer.set_ramp(context, &[236; 4 * RAMP_SIZE]);
        renderer
    }

    /// Colours over distance / max; sRGB bytes, RGBA.
    pub(crate) fn set_ramp(&self, context: &Context, texels: &[u8; 4 * RAMP_SIZE]) {
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * RAMP_SIZE as u32), rows_per_image: None };
        context.queue.write_texture(self.ramp.as_image_copy(), texels, layout, self.ramp.size());
    }

    pub(crate) fn set_look(&self, context: &Context, look: &Look) {
        context.queue.write_buffer(&self.look, 0, bytemuck::cast_slice(&look.vectors()));
    }

    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshBuffers, distance: &DistanceBuffer) {
        pass.set_bind_group(1, &self.group, &[]);
        if distance.has_field {
            pass.set_pipeline(&self.field);
            pass.set_vertex_buffer(2, distance.buffer.slice(..));
        } else {
            pass.set_pipeline(&self.plain);
        }
        mesh.draw(pass);
    }

    pub(crate) fn draw_scenery(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &MeshBuffers) {
        pass.set_bind_group(1, &self.group, &[]);
        pass.set_pipeline(&self.scenery);
        mesh.draw(pass);
    }
}

fn look_layout(context: &Context) -> wgpu::BindGroupLayout {
    let fragment_entry =
        |binding, ty| wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::FRAGMENT, ty, count: None };
    context.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("look layout"),
        entries: &[
            uniform_entry(0),
            fragment_entry(
                1,
                wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: true },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
            ),
            fragment_entry(2, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)),
        ],
    })
}
