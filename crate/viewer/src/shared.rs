use glam::{Mat4, Vec3, Vec4};

use crate::camera::Eye;
use crate::context::{Context, DEPTH_FORMAT, SAMPLE_COUNT};

/// Declarations that every shader starts with.
pub(crate) const SHARED_WGSL: &str = include_str!("shared.wgsl");

/// Vec4s in the uniform; see `Frame` in shared.wgsl.
const FRAME_VECTORS: usize = 10;

/// What all primitives of one frame have in common.
pub(crate) struct FrameUniform {
    pub(crate) eye: Eye,
    /// Bounding radius of the surface; world units.
    pub(crate) radius: f32,
    pub(crate) size: (u32, u32),
    pub(crate) pixel_ratio: f32,
    /// The walker's foot point and the reach of its shadow.
    pub(crate) shadow: Option<(Vec3, f32)>,
}

impl FrameUniform {
    fn vectors(&self) -> [Vec4; FRAME_VECTORS] {
        let clip_from_world: Mat4 = self.eye.clip_from_world.as_mat4();
        let axes = self.eye.world_from_view.as_mat3();
        let (width, height) = self.size;
        [
            clip_from_world.x_axis,
            clip_from_world.y_axis,
            clip_from_world.z_axis,
            clip_from_world.w_axis,
            axes.x_axis.extend(0.0),
            axes.y_axis.extend(0.0),
            axes.z_axis.extend(0.0),
            self.eye.position.as_vec3().extend(self.radius),
            Vec4::new(width as f32, height as f32, self.pixel_ratio, self.eye.pixel_slope as f32),
            self.shadow.map_or(Vec4::ZERO, |(foot, reach)| foot.extend(reach)),
        ]
    }
}

/// The frame uniform's buffer and bind group (group 0 of every pipeline).
pub(crate) struct Shared {
    pub(crate) layout: wgpu::BindGroupLayout,
    pub(crate) group: wgpu::BindGroup,
    buffer: wgpu::Buffer,
}

impl Shared {
    pub(crate) fn new(context: &Context) -> Self {
        let layout = uniform_layout(context, "frame layout");
        let (buffer, group) = uniform(context, &layout, "frame uniform", FRAME_VECTORS);
        Self { layout, group, buffer }
    }

    pub(crate) fn write(&self, context: &Context, frame: &FrameUniform) {
        context.queue.write_buffer(&self.buffer, 0, bytemuck::cast_slice(&frame.vectors()));
    }
}

/// Layout of a group that is one uniform buffer.
pub(crate) fn uniform_layout(context: &Context, label: &str) -> wgpu::BindGroupLayout {
    context
        .device
        .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &[uniform_entry(0)] })
}

pub(crate) fn uniform_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

/// A uniform buffer of so many Vec4s.
pub(crate) fn uniform_buffer(context: &Context, label: &str, vectors: usize) -> wgpu::Buffer {
    context.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: (vectors * size_of::<Vec4>()) as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

/// A uniform buffer and the group that binds it alone.
pub(crate) fn uniform(
    context: &Context,
    layout: &wgpu::BindGroupLayout,
    label: &str,
    vectors: usize,
) -> (wgpu::Buffer, wgpu::BindGroup) {
    let buffer = uniform_buffer(context, label, vectors);
    let group = context.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some(label),
        layout,
        entries: &[wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }],
    });
    (buffer, group)
}

/// The shader of a primitive behind the shared declarations.
pub(crate) fn shader(context: &Context, label: &str, wgsl: &str) -> wgpu::ShaderModule {
    context.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(format!("{SHARED_WGSL}\n{wgsl}").into()),
    })
}

/// What tells one pipeline from another; the rest is common to all.
pub(crate) struct PipelineRecipe<'a> {
    pub(crate) label: &'a str,
    pub(crate) layouts: &'a [Option<&'a wgpu::BindGroupLayout>],
    pub(crate) module: &'a wgpu::ShaderModule,
    pub(crate) vertex: &'a str,
    pub(crate) fragment: &'a str,
    pub(crate) buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    pub(crate) topology: wgpu::PrimitiveTopology,
    /// False for what lies behind everything.
    pub(crate) depth: bool,
}

impl PipelineRecipe<'_> {
    pub(crate) fn build(&self, context: &Context) -> wgpu::RenderPipeline {
        let layout = context.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.label),
            bind_group_layouts: self.layouts,
            immediate_size: 0,
        });
        let compare = if self.depth { wgpu::CompareFunction::Less } else { wgpu::CompareFunction::Always };
        context.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: self.module,
                entry_point: Some(self.vertex),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: self.buffers,
            },
            primitive: wgpu::PrimitiveState { topology: self.topology, ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(self.depth),
                depth_compare: Some(compare),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: SAMPLE_COUNT, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: self.module,
                entry_point: Some(self.fragment),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(context.format.into())],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// sRGB in 0..1 to linear light (IEC 61966-2-1).
pub(crate) fn linear_from_srgb(color: Vec3) -> Vec3 {
    let channel = |value: f32| if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) };
    Vec3::new(channel(color.x), channel(color.y), channel(color.z))
}
