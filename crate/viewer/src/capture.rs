//! Pictures of the scene to keep: drawn beside the canvas, in any size, and read back.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::context::Context;
use crate::targets::Targets;

/// A picture that the device draws.
pub struct Capture {
    device: wgpu::Device,
    buffer: wgpu::Buffer,
    width: u32,
    height: u32,
    /// Bytes of a row in the buffer.
    stride: u32,
    is_blue_first: bool,
    is_ready: Arc<AtomicBool>,
}

impl Capture {
    /// Draws a picture of so many pixels, which the device must have a texture for, with `record`, after what `encoder`
    /// holds.
    pub(crate) fn new(
        context: &Context,
        (width, height): (u32, u32),
        mut encoder: wgpu::CommandEncoder,
        record: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) -> Self {
        let stride = (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let texture = context.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("capture"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: context.format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor { label: Some("capture"), ..Default::default() });
        Targets::new(&context.device, context.format, (width, height)).draw(&mut encoder, &view, record);
        let buffer = context.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("captured pixels"),
            size: u64::from(stride) * u64::from(height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(stride), rows_per_image: None };
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo { buffer: &buffer, layout },
            texture.size(),
        );
        context.queue.submit([encoder.finish()]);
        let is_ready = Arc::new(AtomicBool::new(false));
        buffer.slice(..).map_async(wgpu::MapMode::Read, {
            let is_ready = Arc::clone(&is_ready);
            move |result| is_ready.store(result.is_ok(), Ordering::Relaxed)
        });
        let is_blue_first = context.format == wgpu::TextureFormat::Bgra8Unorm;
        Self { device: context.device.clone(), buffer, width, height, stride, is_blue_first, is_ready }
    }

    /// Pixels across and down.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// Whether the pixels have come; to be asked until they have.
    #[must_use]
    pub fn is_ready(&self) -> bool {
        // A device that fails here never gets ready, and the page gives up waiting.
        let _ = self.device.poll(wgpu::PollType::Poll);
        self.is_ready.load(Ordering::Relaxed)
    }

    /// RGBA, sRGB bytes row by row from the top, colours not multiplied by alpha. Once, when ready.
    #[must_use]
    pub fn into_pixels(self) -> Vec<u8> {
        let mapped = self.buffer.slice(..).get_mapped_range().expect("a picture is read once, when ready");
        let mut pixels = Vec::with_capacity(4 * self.width as usize * self.height as usize);
        for row in mapped.chunks_exact(self.stride as usize) {
            pixels.extend_from_slice(&row[..4 * self.width as usize]);
        }
        for pixel in pixels.as_chunks_mut::<4>().0 {
            if self.is_blue_first {
                pixel.swap(0, 2);
            }
            let alpha = u16::from(pixel[3]);
            if alpha > 0 && alpha < 255 {
                for color in &mut pixel[..3] {
                    *color = (u16::from(*color) * 255 / alpha).min(255) as u8;
                }
            }
        }
        pixels
    }
}
