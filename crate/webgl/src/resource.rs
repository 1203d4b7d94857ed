//! Buffers, textures, samplers and groups of them.

use std::ops::Range;
use std::rc::Rc;

use web_sys::{WebGl2RenderingContext as Gl, WebGlBuffer, WebGlRenderbuffer, WebGlSampler, WebGlTexture};
use wgpu::custom::{
    BindGroupInterface, BindGroupLayoutInterface, BufferInterface, BufferMapCallback, BufferMappedRangeInterface,
    DispatchBufferMappedRange, DispatchTextureView, PipelineLayoutInterface, SamplerInterface,
    SurfaceOutputDetailInterface, TextureInterface, TextureViewInterface,
};

use crate::context::Context;
use crate::convert::{self, Format};

/// What only an object of another device would be.
pub(crate) const OWN: &str = "objects belong to the device that uses them";

/// A buffer; a clone is the same one.
#[derive(Clone, Debug)]
pub(crate) struct Buffer(Rc<BufferStore>);

#[derive(Debug)]
struct BufferStore {
    context: Context,
    raw: Option<WebGlBuffer>,
    /// What it is bound to when it is filled: WebGL2 keeps indices apart from everything else.
    target: u32,
}

impl Buffer {
    pub(crate) fn new(context: &Context, descriptor: &wgpu::BufferDescriptor<'_>) -> Self {
        let (target, usage) = if descriptor.usage.contains(wgpu::BufferUsages::MAP_READ) {
            (Gl::PIXEL_PACK_BUFFER, Gl::STREAM_READ)
        } else if descriptor.usage.contains(wgpu::BufferUsages::INDEX) {
            (Gl::ELEMENT_ARRAY_BUFFER, Gl::DYNAMIC_DRAW)
        } else {
            (Gl::ARRAY_BUFFER, Gl::DYNAMIC_DRAW)
        };
        let raw = context.create_buffer();
        context.bind_buffer(target, raw.as_ref());
        context.buffer_data_with_f64(target, descriptor.size as f64, usage);
        context.bind_buffer(target, None);
        Self(Rc::new(BufferStore { context: context.clone(), raw, target }))
    }

    pub(crate) fn raw(&self) -> Option<&WebGlBuffer> {
        self.0.raw.as_ref()
    }

    pub(crate) fn write(&self, offset: u64, bytes: &[u8]) {
        let BufferStore { context, raw, target } = &*self.0;
        context.bind_buffer(*target, raw.as_ref());
        context.buffer_sub_data_with_f64_and_u8_array(*target, offset as f64, bytes);
        context.bind_buffer(*target, None);
    }
}

impl Drop for BufferStore {
    fn drop(&mut self) {
        self.context.delete_buffer(self.raw.as_ref());
    }
}

impl BufferInterface for Buffer {
    fn map_async(&self, _: wgpu::MapMode, _: Range<u64>, callback: BufferMapCallback) {
        let context = &self.0.context;
        let sync = context.fence_sync(Gl::SYNC_GPU_COMMANDS_COMPLETE, 0);
        // A fence that is not sent is never passed.
        context.flush();
        context.waiting.borrow_mut().push((sync, callback));
    }

    fn get_mapped_range(&self, range: Range<u64>) -> Result<DispatchBufferMappedRange, wgpu::MapRangeError> {
        let BufferStore { context, raw, target } = &*self.0;
        let mut bytes = vec![0; (range.end - range.start) as usize];
        if *target == Gl::PIXEL_PACK_BUFFER {
            context.bind_buffer(*target, raw.as_ref());
            context.get_buffer_sub_data_with_f64_and_u8_array(*target, range.start as f64, &mut bytes);
            context.bind_buffer(*target, None);
        }
        let mapped = MappedRange { buffer: self.clone(), start: range.start, bytes, is_written: false };
        Ok(DispatchBufferMappedRange::custom(mapped))
    }

    fn unmap(&self) {}

    fn destroy(&self) {
        unimplemented!("buffers that end before they are dropped")
    }
}

/// A copy of a part of a buffer, which goes back where it was written.
#[derive(Debug)]
struct MappedRange {
    buffer: Buffer,
    start: u64,
    bytes: Vec<u8>,
    is_written: bool,
}

impl Drop for MappedRange {
    fn drop(&mut self) {
        if self.is_written {
            self.buffer.write(self.start, &self.bytes);
        }
    }
}

#[allow(unsafe_code, reason = "wgpu's trait has unsafe methods; these are safe")]
impl BufferMappedRangeInterface for MappedRange {
    fn len(&self) -> usize {
        self.bytes.len()
    }

    unsafe fn read_slice(&self) -> &[u8] {
        &self.bytes
    }

    unsafe fn write_slice(&mut self) -> wgpu::WriteOnly<'_, [u8]> {
        self.is_written = true;
        wgpu::WriteOnly::from_mut(&mut self.bytes)
    }
}

/// A texture, or what is drawn into and never read by a shader; a clone is the same one.
#[derive(Clone, Debug)]
pub(crate) struct Texture(Rc<TextureStore>);

#[derive(Debug)]
struct TextureStore {
    context: Context,
    image: Image,
    format: wgpu::TextureFormat,
    level_count: u32,
    width: i32,
    height: i32,
}

#[derive(Debug)]
enum Image {
    Renderbuffer(Option<WebGlRenderbuffer>),
    Texture { raw: Option<WebGlTexture>, target: u32 },
}

impl Texture {
    pub(crate) fn new(context: &Context, descriptor: &wgpu::TextureDescriptor<'_>) -> Self {
        let Format { internal, .. } = convert::format(descriptor.format);
        let wgpu::Extent3d { width, height, depth_or_array_layers } = descriptor.size;
        let (width, height, depth) = (width as i32, height as i32, depth_or_array_layers as i32);
        let image = if descriptor.usage == wgpu::TextureUsages::RENDER_ATTACHMENT {
            let raw = context.create_renderbuffer();
            let samples = if descriptor.sample_count > 1 { descriptor.sample_count as i32 } else { 0 };
            context.bind_renderbuffer(Gl::RENDERBUFFER, raw.as_ref());
            context.renderbuffer_storage_multisample(Gl::RENDERBUFFER, samples, internal, width, height);
            Image::Renderbuffer(raw)
        } else {
            let raw = context.create_texture();
            let is_solid = descriptor.dimension == wgpu::TextureDimension::D3;
            let target = if is_solid { Gl::TEXTURE_3D } else { Gl::TEXTURE_2D };
            let levels = descriptor.mip_level_count as i32;
            context.bind_texture(target, raw.as_ref());
            if is_solid {
                context.tex_storage_3d(target, levels, internal, width, height, depth);
            } else {
                context.tex_storage_2d(target, levels, internal, width, height);
            }
            Image::Texture { raw, target }
        };
        let (format, level_count) = (descriptor.format, descriptor.mip_level_count);
        Self(Rc::new(TextureStore { context: context.clone(), image, format, level_count, width, height }))
    }

    pub(crate) fn format(&self) -> Format {
        convert::format(self.0.format)
    }

    /// Pixels across and down.
    pub(crate) fn size(&self) -> (i32, i32) {
        (self.0.width, self.0.height)
    }

    /// Binds it to the unit that is active, to be filled; gives the target.
    pub(crate) fn bind(&self) -> u32 {
        let Image::Texture { raw, target } = &self.0.image else {
            unimplemented!("uses of what is only drawn into");
        };
        self.0.context.bind_texture(*target, raw.as_ref());
        *target
    }

    /// The first level, or another one.
    pub(crate) fn view(&self, levels: Range<u32>) -> TextureView {
        TextureView { texture: self.clone(), levels }
    }
}

impl Drop for TextureStore {
    fn drop(&mut self) {
        match &self.image {
            Image::Renderbuffer(raw) => self.context.delete_renderbuffer(raw.as_ref()),
            Image::Texture { raw, .. } => self.context.delete_texture(raw.as_ref()),
        }
    }
}

impl TextureInterface for Texture {
    fn create_view(&self, descriptor: &wgpu::TextureViewDescriptor<'_>) -> DispatchTextureView {
        let base = descriptor.base_mip_level;
        let count = descriptor.mip_level_count.unwrap_or(self.0.level_count - base);
        DispatchTextureView::custom(self.view(base..base + count))
    }

    fn destroy(&self) {
        unimplemented!("textures that end before they are dropped")
    }
}

/// Levels of a texture.
#[derive(Clone, Debug)]
pub(crate) struct TextureView {
    pub(crate) texture: Texture,
    levels: Range<u32>,
}

impl TextureView {
    /// Binds it to the unit that is active, to be read by a shader.
    pub(crate) fn bind(&self) {
        let target = self.texture.bind();
        let context = &self.texture.0.context;
        context.tex_parameteri(target, Gl::TEXTURE_BASE_LEVEL, self.levels.start as i32);
        context.tex_parameteri(target, Gl::TEXTURE_MAX_LEVEL, self.levels.end as i32 - 1);
    }

    /// Pixels across and down of the first of them.
    pub(crate) fn size(&self) -> (i32, i32) {
        let (width, height) = self.texture.size();
        (1.max(width >> self.levels.start), 1.max(height >> self.levels.start))
    }

    /// Makes it a part of the framebuffer that is bound to a target.
    pub(crate) fn attach(&self, framebuffer: u32, attachment: u32) {
        let TextureStore { context, image, .. } = &*self.texture.0;
        match image {
            Image::Renderbuffer(raw) => {
                context.framebuffer_renderbuffer(framebuffer, attachment, Gl::RENDERBUFFER, raw.as_ref());
            }
            Image::Texture { raw, target } => {
                let level = self.levels.start as i32;
                context.framebuffer_texture_2d(framebuffer, attachment, *target, raw.as_ref(), level);
            }
        }
    }
}

impl TextureViewInterface for TextureView {}

/// A picture for the canvas.
#[derive(Debug)]
pub(crate) struct Frame(pub(crate) Texture);

impl SurfaceOutputDetailInterface for Frame {
    fn texture_discard(&self) {}

    fn texture_release(&self) {}
}

/// How textures are read; a clone is the same one.
#[derive(Clone, Debug)]
pub(crate) struct Sampler(Rc<SamplerStore>);

#[derive(Debug)]
struct SamplerStore {
    context: Context,
    raw: Option<WebGlSampler>,
}

impl Sampler {
    pub(crate) fn new(context: &Context, descriptor: &wgpu::SamplerDescriptor<'_>) -> Self {
        let raw = context.create_sampler();
        if let Some(raw) = &raw {
            let set = |name, value: u32| context.sampler_parameteri(raw, name, value as i32);
            set(Gl::TEXTURE_MIN_FILTER, convert::minify(descriptor.min_filter, descriptor.mipmap_filter));
            set(Gl::TEXTURE_MAG_FILTER, convert::magnify(descriptor.mag_filter));
            set(Gl::TEXTURE_WRAP_S, convert::wrap(descriptor.address_mode_u));
            set(Gl::TEXTURE_WRAP_T, convert::wrap(descriptor.address_mode_v));
            set(Gl::TEXTURE_WRAP_R, convert::wrap(descriptor.address_mode_w));
            context.sampler_parameterf(raw, Gl::TEXTURE_MIN_LOD, descriptor.lod_min_clamp);
            context.sampler_parameterf(raw, Gl::TEXTURE_MAX_LOD, descriptor.lod_max_clamp);
            if let Some(function) = descriptor.compare {
                set(Gl::TEXTURE_COMPARE_MODE, Gl::COMPARE_REF_TO_TEXTURE);
                set(Gl::TEXTURE_COMPARE_FUNC, convert::compare(function));
            }
        }
        Self(Rc::new(SamplerStore { context: context.clone(), raw }))
    }

    pub(crate) fn raw(&self) -> Option<&WebGlSampler> {
        self.0.raw.as_ref()
    }
}

impl Drop for SamplerStore {
    fn drop(&mut self) {
        self.context.delete_sampler(self.raw.as_ref());
    }
}

impl SamplerInterface for Sampler {}

/// Shaders name the places of what they use: see [`crate::program`].
#[derive(Debug)]
pub(crate) struct Layout;

impl BindGroupLayoutInterface for Layout {}
impl PipelineLayoutInterface for Layout {}

/// What is bound together, by binding; a clone is the same one.
#[derive(Clone, Debug)]
pub(crate) struct BindGroup(Rc<Vec<(u32, Bound)>>);

#[derive(Debug)]
pub(crate) enum Bound {
    Buffer(Buffer),
    Sampler(Sampler),
    View(TextureView),
}

impl BindGroup {
    pub(crate) fn new(descriptor: &wgpu::BindGroupDescriptor<'_>) -> Self {
        let bound = |resource: &wgpu::BindingResource<'_>| match resource {
            wgpu::BindingResource::Buffer(binding) => {
                Bound::Buffer(binding.buffer.as_custom::<Buffer>().expect(OWN).clone())
            }
            wgpu::BindingResource::Sampler(sampler) => {
                Bound::Sampler(sampler.as_custom::<Sampler>().expect(OWN).clone())
            }
            wgpu::BindingResource::TextureView(view) => {
                Bound::View(view.as_custom::<TextureView>().expect(OWN).clone())
            }
            _ => unimplemented!("arrays of resources"),
        };
        let entries = descriptor.entries.iter().map(|entry| (entry.binding, bound(&entry.resource)));
        Self(Rc::new(entries.collect()))
    }

    pub(crate) fn get(&self, binding: u32) -> Option<&Bound> {
        self.0.iter().find(|(other, _)| *other == binding).map(|(_, bound)| bound)
    }
}

impl BindGroupInterface for BindGroup {}
