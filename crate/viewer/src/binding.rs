//! Entries of bind groups that several primitives need.

use crate::context::Context;

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
