//! Images of a file as textures with all their levels.

use crate::binding::{FILTERED_TEXTURE, fragment_entry, smooth_sampler};
use crate::context::Context;
use crate::shader::shader_module;

/// An image that was decoded; alpha is not multiplied in.
pub enum Image {
    /// One that the file names and that could not be decoded: white.
    Missing,
    /// RGBA rows from the top.
    Pixels {
        /// Texels across.
        width: u32,
        /// `height · width · 4` bytes.
        rgba: Vec<u8>,
    },
    /// One that the browser has decoded.
    #[cfg(target_arch = "wasm32")]
    Bitmap(web_sys::ImageBitmap),
}

impl Image {
    fn size(&self) -> (u32, u32) {
        match self {
            Self::Missing => (1, 1),
            Self::Pixels { width, rgba } => (*width, rgba.len() as u32 / 4 / (*width).max(1)),
            #[cfg(target_arch = "wasm32")]
            Self::Bitmap(bitmap) => (bitmap.width(), bitmap.height()),
        }
    }

    fn upload(&self, context: &Context, texture: &wgpu::Texture) {
        match self {
            Self::Missing => write(context, texture, &[255; 4]),
            Self::Pixels { rgba, .. } => write(context, texture, rgba),
            #[cfg(target_arch = "wasm32")]
            Self::Bitmap(bitmap) => context.queue.copy_external_image_to_texture(
                &wgpu::CopyExternalImageSourceInfo {
                    source: wgpu::ExternalImageSource::ImageBitmap(bitmap.clone()),
                    origin: wgpu::Origin2d::ZERO,
                    flip_y: false,
                },
                texture.as_image_copy().to_tagged(wgpu::PredefinedColorSpace::Srgb, false),
                texture.size(),
            ),
        }
    }
}

fn write(context: &Context, texture: &wgpu::Texture, rgba: &[u8]) {
    let row = Some(4 * texture.width());
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: row, rows_per_image: None };
    context.queue.write_texture(texture.as_image_copy(), rgba, layout, texture.size());
}

/// Makes textures of images.
pub(crate) struct ImageLoader {
    layout: wgpu::BindGroupLayout,
    sampler: wgpu::Sampler,
    /// For colors in sRGB, and for plain numbers.
    pipelines: [(wgpu::TextureFormat, wgpu::RenderPipeline); 2],
}

impl ImageLoader {
    pub(crate) fn new(context: &Context) -> Self {
        let sampling = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
        let layout = context.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("texture level layout"),
            entries: &[fragment_entry(0, FILTERED_TEXTURE), fragment_entry(1, sampling)],
        });
        let module = shader_module!(context, "mipmap");
        let pipeline_layout = context.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("texture level"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = |format: wgpu::TextureFormat| {
            context.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some("texture level"),
                layout: Some(&pipeline_layout),
                vertex: wgpu::VertexState {
                    module: &module,
                    entry_point: Some("vs_level"),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    buffers: &[],
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: None,
                multisample: wgpu::MultisampleState::default(),
                fragment: Some(wgpu::FragmentState {
                    module: &module,
                    entry_point: Some("fs_level"),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    targets: &[Some(format.into())],
                }),
                multiview_mask: None,
                cache: None,
            })
        };
        let formats = [wgpu::TextureFormat::Rgba8UnormSrgb, wgpu::TextureFormat::Rgba8Unorm];
        let pipelines = formats.map(|format| (format, pipeline(format)));
        Self { layout, sampler: smooth_sampler(context, None), pipelines }
    }

    /// A texture with all its levels. White where the image is larger than the device allows, or has no texel.
    pub(crate) fn texture(&self, context: &Context, image: &Image, is_srgb: bool) -> wgpu::Texture {
        let (width, height) = image.size();
        let limit = context.device.limits().max_texture_dimension_2d;
        let fits = (1..=limit).contains(&width) && (1..=limit).contains(&height);
        let (image, width, height) = if fits { (image, width, height) } else { (&Image::Missing, 1, 1) };
        let (format, pipeline) = &self.pipelines[usize::from(!is_srgb)];
        let texture = context.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("image"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: width.max(height).ilog2() + 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: *format,
            usage: wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_DST
                | wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        image.upload(context, &texture);
        self.fill_levels(context, &texture, pipeline);
        texture
    }

    /// Makes each coarser level of the one before.
    fn fill_levels(&self, context: &Context, texture: &wgpu::Texture, pipeline: &wgpu::RenderPipeline) {
        let level = |index: u32| {
            texture.create_view(&wgpu::TextureViewDescriptor {
                label: Some("texture level"),
                base_mip_level: index,
                mip_level_count: Some(1),
                ..Default::default()
            })
        };
        let mut encoder = context.encoder();
        for index in 1..texture.mip_level_count() {
            let group = context.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("texture level"),
                layout: &self.layout,
                entries: &[
                    wgpu::BindGroupEntry {
                        binding: 0,
                        resource: wgpu::BindingResource::TextureView(&level(index - 1)),
                    },
                    wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&self.sampler) },
                ],
            });
            let target = level(index);
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("texture level"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &target,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations::default(),
                })],
                ..Default::default()
            });
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.draw(0..3, 0..1);
        }
        context.queue.submit([encoder.finish()]);
    }
}
