//! What keeps light off the scene, as shaders read it: shadow maps and ambient occlusion.

use crate::binding::{fragment_entry, smooth_sampler, texture};
use crate::context::Context;
use crate::shadow::ShadowMaps;
use heatwalk_bake::OCCLUSION_SIZE;

/// The shadow maps and the occlusion grid, and the group that binds them.
pub(crate) struct Lighting {
    pub(crate) layout: wgpu::BindGroupLayout,
    pub(crate) group: wgpu::BindGroup,
    pub(crate) maps: ShadowMaps,
    occlusion: wgpu::Texture,
}

impl Lighting {
    pub(crate) fn new(context: &Context) -> Self {
        let maps = ShadowMaps::new(context);
        let size = OCCLUSION_SIZE as u32;
        let occlusion = context.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("occlusion"),
            size: wgpu::Extent3d { width: size, height: size, depth_or_array_layers: size },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D3,
            format: wgpu::TextureFormat::Rgba8Unorm,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = occlusion.create_view(&wgpu::TextureViewDescriptor::default());
        let occlusion_sampler = smooth_sampler(context, None);
        let shadow_sampler = smooth_sampler(context, Some(wgpu::CompareFunction::LessEqual));
        let depth = texture(wgpu::TextureSampleType::Depth, wgpu::TextureViewDimension::D2);
        let volume = texture(wgpu::TextureSampleType::Float { filterable: true }, wgpu::TextureViewDimension::D3);
        let sampler = wgpu::BindingType::Sampler;
        let layout = context.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("light layout"),
            entries: &[
                fragment_entry(0, depth),
                fragment_entry(1, depth),
                fragment_entry(2, sampler(wgpu::SamplerBindingType::Comparison)),
                fragment_entry(3, volume),
                fragment_entry(4, sampler(wgpu::SamplerBindingType::Filtering)),
            ],
        });
        let resources = [
            wgpu::BindingResource::TextureView(&maps.still),
            wgpu::BindingResource::TextureView(&maps.moving),
            wgpu::BindingResource::Sampler(&shadow_sampler),
            wgpu::BindingResource::TextureView(&view),
            wgpu::BindingResource::Sampler(&occlusion_sampler),
        ];
        let entries: Vec<_> =
            (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
        let group = context.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("light"),
            layout: &layout,
            entries: &entries,
        });
        Self { layout, group, maps, occlusion }
    }

    /// Those of a [`Shade`](heatwalk_bake::Shade).
    pub(crate) fn set_occlusion(&self, context: &Context, texels: &[u8]) {
        let size = OCCLUSION_SIZE as u32;
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * size), rows_per_image: Some(size) };
        context.queue.write_texture(self.occlusion.as_image_copy(), texels, layout, self.occlusion.size());
    }
}
