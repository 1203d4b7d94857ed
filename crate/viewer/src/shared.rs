use glam::{Mat4, Vec2, Vec3, Vec4};

use crate::camera::Eye;
use crate::context::{Context, DEPTH_FORMAT, SAMPLE_COUNT};
use crate::environment::{ENVIRONMENT_VECTORS, Environment};
use crate::light::Lighting;
use crate::occlusion::Cube;
use crate::shadow::ShadowView;

/// Declarations that every shader starts with.
pub(crate) const SHARED_WGSL: &str = include_str!("shared.wgsl");

/// Vec4s in the uniform; see `Frame` in shared.wgsl.
const FRAME_VECTORS: usize = 15 + ENVIRONMENT_VECTORS;

/// What all primitives of one frame have in common.
pub(crate) struct FrameUniform {
    pub(crate) eye: Eye,
    /// Bounding radius of the surface; world units.
    pub(crate) radius: f32,
    pub(crate) size: (u32, u32),
    pub(crate) pixel_ratio: f32,
    pub(crate) shadows: ShadowView,
    /// Least and greatest x and y, in the maps' clip space, of shadows of what moves; least above greatest for none.
    pub(crate) moving: [Vec2; 2],
    /// Of the occlusion grid.
    pub(crate) cube: Cube,
    pub(crate) environment: Environment,
}

impl FrameUniform {
    fn vectors(&self, clip_from_world: Mat4) -> [Vec4; FRAME_VECTORS] {
        let [low, high] = self.moving;
        let axes = self.eye.world_from_view.as_mat3();
        let (width, height) = self.size;
        let mut vectors = [Vec4::ZERO; FRAME_VECTORS];
        vectors[..4].copy_from_slice(&columns(clip_from_world));
        vectors[4..11].copy_from_slice(&[
            axes.x_axis.extend(0.0),
            axes.y_axis.extend(self.shadows.texel),
            axes.z_axis.extend(0.0),
            self.eye.position.as_vec3().extend(self.radius),
            Vec4::new(width as f32, height as f32, self.pixel_ratio, self.eye.pixel_slope as f32),
            Vec4::new(low.x, low.y, high.x, high.y),
            self.cube.low.extend(self.cube.side),
        ]);
        vectors[11..15].copy_from_slice(&columns(self.shadows.clip_from_world));
        vectors[15..].copy_from_slice(&self.environment.vectors());
        vectors
    }
}

fn columns(matrix: Mat4) -> [Vec4; 4] {
    [matrix.x_axis, matrix.y_axis, matrix.z_axis, matrix.w_axis]
}

/// What all pipelines share: the frame's uniform as the camera sees it and as the key light does (group 0), and what keeps
/// light off (group 1).
pub(crate) struct Shared {
    pub(crate) frame_layout: wgpu::BindGroupLayout,
    pub(crate) camera_group: wgpu::BindGroup,
    pub(crate) shadow_group: wgpu::BindGroup,
    pub(crate) lighting: Lighting,
    camera: wgpu::Buffer,
    shadow: wgpu::Buffer,
}

impl Shared {
    pub(crate) fn new(context: &Context) -> Self {
        let frame_layout = uniform_layout(context, "frame layout");
        let (camera, camera_group) = uniform(context, &frame_layout, "frame uniform", FRAME_VECTORS);
        let (shadow, shadow_group) = uniform(context, &frame_layout, "shadow uniform", FRAME_VECTORS);
        let lighting = Lighting::new(context);
        Self { frame_layout, camera_group, shadow_group, lighting, camera, shadow }
    }

    pub(crate) fn write(&self, context: &Context, frame: &FrameUniform) {
        let write = |buffer, clip_from_world| {
            context.queue.write_buffer(buffer, 0, bytemuck::cast_slice(&frame.vectors(clip_from_world)));
        };
        write(&self.camera, frame.eye.clip_from_world.as_mat4());
        write(&self.shadow, frame.shadows.clip_from_world);
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

/// A texture or sampler that fragment shaders read.
pub(crate) fn fragment_entry(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::FRAGMENT, ty, count: None }
}

/// A plain texture, read between its texels.
pub(crate) const FILTERED_TEXTURE: wgpu::BindingType =
    texture(wgpu::TextureSampleType::Float { filterable: true }, wgpu::TextureViewDimension::D2);

pub(crate) const fn texture(
    sample_type: wgpu::TextureSampleType,
    view_dimension: wgpu::TextureViewDimension,
) -> wgpu::BindingType {
    wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false }
}

/// Reads textures between their texels; with `compare`, depths.
pub(crate) fn smooth_sampler(context: &Context, compare: Option<wgpu::CompareFunction>) -> wgpu::Sampler {
    context.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("smooth sampler"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        compare,
        ..Default::default()
    })
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
#[derive(Clone)]
pub(crate) struct PipelineRecipe<'a> {
    pub(crate) label: &'a str,
    pub(crate) layouts: &'a [Option<&'a wgpu::BindGroupLayout>],
    pub(crate) module: &'a wgpu::ShaderModule,
    pub(crate) vertex: &'a str,
    pub(crate) fragment: &'a str,
    pub(crate) buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    pub(crate) topology: wgpu::PrimitiveTopology,
    pub(crate) place: Place,
}

/// How what a pipeline draws goes together with what is there.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Place {
    /// Behind everything.
    Behind,
    /// Over what is behind, premultiplied; hides nothing.
    Over,
    /// Hides what is farther away.
    Solid,
}

impl PipelineRecipe<'_> {
    pub(crate) fn build(&self, context: &Context) -> wgpu::RenderPipeline {
        let blend = (self.place == Place::Over).then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING);
        let target = wgpu::ColorTargetState { format: context.format, blend, write_mask: wgpu::ColorWrites::ALL };
        let fragment = wgpu::FragmentState {
            module: self.module,
            entry_point: Some(self.fragment),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(target)],
        };
        self.create(context, SAMPLE_COUNT, Some(fragment))
    }

    /// Of what casts a shadow: depth alone, into a shadow map.
    pub(crate) fn build_shadow(&self, context: &Context) -> wgpu::RenderPipeline {
        self.create(context, 1, None)
    }

    fn create(
        &self,
        context: &Context,
        sample_count: u32,
        fragment: Option<wgpu::FragmentState<'_>>,
    ) -> wgpu::RenderPipeline {
        let layout = context.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.label),
            bind_group_layouts: self.layouts,
            immediate_size: 0,
        });
        let compare = match self.place {
            Place::Behind => wgpu::CompareFunction::Always,
            Place::Over | Place::Solid => wgpu::CompareFunction::Less,
        };
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
                depth_write_enabled: Some(self.place == Place::Solid),
                depth_compare: Some(compare),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: sample_count, ..Default::default() },
            fragment,
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
