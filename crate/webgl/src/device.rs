//! The device, which makes things, and its queue, which fills them and plays what was recorded.

use std::pin::Pin;
use std::sync::Arc;

use web_sys::WebGl2RenderingContext as Gl;
use wgpu::custom::{
    BoxDeviceLostCallback, BoxSubmittedWorkDoneCallback, DeviceInterface, DispatchBindGroup, DispatchBindGroupLayout,
    DispatchBlas, DispatchBuffer, DispatchCommandBuffer, DispatchCommandEncoder, DispatchComputePipeline,
    DispatchExternalTexture, DispatchPipelineCache, DispatchPipelineLayout, DispatchQuerySet, DispatchQueueWriteBuffer,
    DispatchRenderBundleEncoder, DispatchRenderPipeline, DispatchSampler, DispatchShaderModule,
    DispatchSurfaceOutputDetail, DispatchTexture, DispatchTlas, PopErrorScopeFuture, QueueInterface,
};

use crate::command::{CommandBuffer, CommandEncoder, missing};
use crate::context::Context;
use crate::convert::Format;
use crate::player::{Player, present};
use crate::program::{Pipeline, ShaderModule};
use crate::resource::{BindGroup, Buffer, Frame, Layout, OWN, Sampler, Texture};

#[derive(Debug)]
pub(crate) struct Device {
    pub(crate) context: Context,
    pub(crate) limits: wgpu::Limits,
}

#[allow(unsafe_code, reason = "wgpu's trait has unsafe methods; these are safe")]
impl DeviceInterface for Device {
    fn limits(&self) -> wgpu::Limits {
        self.limits.clone()
    }

    unsafe fn create_shader_module_passthrough(
        &self,
        descriptor: &wgpu::ShaderModuleDescriptorPassthrough<'_>,
    ) -> DispatchShaderModule {
        let text = descriptor.glsl.as_deref().expect("the shader is GLSL");
        DispatchShaderModule::custom(ShaderModule(text.to_owned()))
    }

    fn create_bind_group_layout(&self, _: &wgpu::BindGroupLayoutDescriptor<'_>) -> DispatchBindGroupLayout {
        DispatchBindGroupLayout::custom(Layout)
    }

    fn create_bind_group(&self, descriptor: &wgpu::BindGroupDescriptor<'_>) -> DispatchBindGroup {
        DispatchBindGroup::custom(BindGroup::new(descriptor))
    }

    fn create_pipeline_layout(&self, _: &wgpu::PipelineLayoutDescriptor<'_>) -> DispatchPipelineLayout {
        DispatchPipelineLayout::custom(Layout)
    }

    fn create_render_pipeline(&self, descriptor: &wgpu::RenderPipelineDescriptor<'_>) -> DispatchRenderPipeline {
        DispatchRenderPipeline::custom(Pipeline::new(&self.context, descriptor))
    }

    fn create_buffer(&self, descriptor: &wgpu::BufferDescriptor<'_>) -> DispatchBuffer {
        DispatchBuffer::custom(Buffer::new(&self.context, descriptor))
    }

    fn create_texture(&self, descriptor: &wgpu::TextureDescriptor<'_>) -> DispatchTexture {
        DispatchTexture::custom(Texture::new(&self.context, descriptor))
    }

    fn create_sampler(&self, descriptor: &wgpu::SamplerDescriptor<'_>) -> DispatchSampler {
        DispatchSampler::custom(Sampler::new(&self.context, descriptor))
    }

    fn create_command_encoder(&self, _: &wgpu::CommandEncoderDescriptor<'_>) -> DispatchCommandEncoder {
        DispatchCommandEncoder::custom(CommandEncoder::default())
    }

    /// The canvas tells that its context is lost, and whoever has the canvas asks it.
    fn set_device_lost_callback(&self, _: BoxDeviceLostCallback) {}

    fn on_uncaptured_error(&self, handler: Arc<dyn wgpu::UncapturedErrorHandler>) {
        self.context.on_error.replace(Some(handler));
    }

    fn poll(&self, _: wgpu::wgt::PollType<u64>) -> Result<wgpu::PollStatus, wgpu::PollError> {
        self.context.poll();
        Ok(wgpu::PollStatus::Poll)
    }

    fn create_blas(
        &self,
        _: &wgpu::CreateBlasDescriptor<'_>,
        _: wgpu::BlasGeometrySizeDescriptors,
    ) -> (Option<u64>, DispatchBlas) {
        unimplemented!("acceleration structures")
    }

    unsafe fn create_pipeline_cache(&self, _: &wgpu::PipelineCacheDescriptor<'_>) -> DispatchPipelineCache {
        unimplemented!("caches of pipelines")
    }

    unsafe fn start_graphics_debugger_capture(&self) {}

    unsafe fn stop_graphics_debugger_capture(&self) {}

    missing! { shared
        features() -> wgpu::Features;
        adapter_info() -> wgpu::AdapterInfo;
        create_shader_module(wgpu::ShaderModuleDescriptor<'_>, wgpu::ShaderRuntimeChecks) -> DispatchShaderModule;
        create_mesh_pipeline(&wgpu::MeshPipelineDescriptor<'_>) -> DispatchRenderPipeline;
        create_compute_pipeline(&wgpu::ComputePipelineDescriptor<'_>) -> DispatchComputePipeline;
        create_external_texture(&wgpu::ExternalTextureDescriptor<'_>, &[&wgpu::TextureView]) -> DispatchExternalTexture;
        create_tlas(&wgpu::CreateTlasDescriptor<'_>) -> DispatchTlas;
        create_query_set(&wgpu::QuerySetDescriptor<'_>) -> DispatchQuerySet;
        create_render_bundle_encoder(&wgpu::RenderBundleEncoderDescriptor<'_>) -> DispatchRenderBundleEncoder;
        push_error_scope(wgpu::ErrorFilter) -> u32;
        pop_error_scope(u32) -> Pin<Box<dyn PopErrorScopeFuture>>;
        get_internal_counters() -> wgpu::InternalCounters;
        generate_allocator_report() -> Option<wgpu::AllocatorReport>;
        destroy();
    }
}

#[derive(Debug)]
pub(crate) struct Queue(pub(crate) Context);

impl Queue {
    fn check(&self, done: Result<(), wasm_bindgen::JsValue>) {
        if let Err(error) = done {
            self.0.report(format!("{error:?}"));
        }
    }
}

impl QueueInterface for Queue {
    fn write_buffer(&self, buffer: &DispatchBuffer, offset: u64, bytes: &[u8]) {
        buffer.as_custom::<Buffer>().expect(OWN).write(offset, bytes);
    }

    fn write_texture(
        &self,
        destination: wgpu::TexelCopyTextureInfo<'_>,
        bytes: &[u8],
        layout: wgpu::TexelCopyBufferLayout,
        size: wgpu::Extent3d,
    ) {
        let texture = destination.texture.as_custom::<Texture>().expect(OWN);
        let Format { external, kind, bytes: texel, .. } = texture.format();
        let (width, height, depth) = (size.width as i32, size.height as i32, size.depth_or_array_layers as i32);
        assert_eq!(layout.bytes_per_row, Some(size.width * texel), "rows follow each other without a gap");
        let (target, level) = (texture.bind(), destination.mip_level as i32);
        self.check(if target == Gl::TEXTURE_3D {
            self.0.tex_sub_image_3d_with_opt_u8_array(
                target,
                level,
                0,
                0,
                0,
                width,
                height,
                depth,
                external,
                kind,
                Some(bytes),
            )
        } else {
            self.0.tex_sub_image_2d_with_i32_and_i32_and_u32_and_type_and_opt_u8_array(
                target,
                level,
                0,
                0,
                width,
                height,
                external,
                kind,
                Some(bytes),
            )
        });
    }

    fn copy_external_image_to_texture(
        &self,
        source: &wgpu::CopyExternalImageSourceInfo,
        destination: wgpu::CopyExternalImageDestInfo<&wgpu::Texture>,
        size: wgpu::Extent3d,
    ) {
        let wgpu::ExternalImageSource::ImageBitmap(bitmap) = &source.source else {
            unimplemented!("images that are no bitmaps");
        };
        let texture = destination.texture.as_custom::<Texture>().expect(OWN);
        let Format { external, kind, .. } = texture.format();
        let (target, level) = (texture.bind(), destination.mip_level as i32);
        let (width, height) = (size.width as i32, size.height as i32);
        self.check(self.0.tex_sub_image_2d_with_i32_and_i32_and_u32_and_type_and_image_bitmap(
            target, level, 0, 0, width, height, external, kind, bitmap,
        ));
    }

    fn submit(&self, buffers: &mut dyn Iterator<Item = DispatchCommandBuffer>) -> u64 {
        for buffer in buffers {
            let CommandBuffer(commands) = buffer.as_custom().expect(OWN);
            let mut player = Player::new(&self.0);
            commands.iter().for_each(|command| player.play(command));
        }
        // Nobody waits for one of several submissions.
        0
    }

    fn present(&self, frame: &DispatchSurfaceOutputDetail) {
        let Frame(texture) = frame.as_custom().expect(OWN);
        present(&self.0, texture);
    }

    missing! { shared
        create_staging_buffer(wgpu::BufferSize) -> Option<DispatchQueueWriteBuffer>;
        validate_write_buffer(&DispatchBuffer, u64, wgpu::BufferSize) -> Option<()>;
        write_staging_buffer(&DispatchBuffer, u64, &DispatchQueueWriteBuffer);
        get_timestamp_period() -> f32;
        on_submitted_work_done(BoxSubmittedWorkDoneCallback);
        compact_blas(&DispatchBlas) -> (Option<u64>, DispatchBlas);
    }
}
