use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::error::Error;

/// Samples a pixel; four is what every WebGL2 and WebGPU device offers.
pub(crate) const SAMPLE_COUNT: u32 = 4;
/// Guaranteed to be a multisampled attachment on both backends.
pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// The graphics interface in use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backend {
    /// The browser's WebGPU.
    WebGpu,
    /// WebGL2, which every browser of the last years has.
    WebGl2,
}

impl Backend {
    /// The name as people write it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::WebGpu => "WebGPU",
            Self::WebGl2 => "WebGL2",
        }
    }
}

/// Device, queue and the canvas they draw to.
pub struct Context {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    /// The canvas's format: plain bytes, which the shaders fill with sRGB.
    pub(crate) format: wgpu::TextureFormat,
    surface: wgpu::Surface<'static>,
    configuration: wgpu::SurfaceConfiguration,
    targets: Targets,
    backend: Backend,
    lost: Arc<AtomicBool>,
}

/// Multisampled attachments of a picture's size.
pub(crate) struct Targets {
    color: wgpu::TextureView,
    depth: wgpu::TextureView,
}

impl Targets {
    pub(crate) fn new(device: &wgpu::Device, format: wgpu::TextureFormat, (width, height): (u32, u32)) -> Self {
        let attachment = |label, format| {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some(label),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: SAMPLE_COUNT,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor { label: Some(label), ..Default::default() })
        };
        Self { color: attachment("multisampled color", format), depth: attachment("multisampled depth", DEPTH_FORMAT) }
    }

    /// Records one pass and resolves it into a view.
    pub(crate) fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        resolved: &wgpu::TextureView,
        record: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("frame"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.color,
                depth_slice: None,
                resolve_target: Some(resolved),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(1.0), store: wgpu::StoreOp::Discard }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        record(&mut pass);
    }
}

/// What became of an attempt to get the canvas's next picture.
pub(crate) enum NextFrame {
    Ready(wgpu::SurfaceTexture),
    /// Not now; the next attempt may work.
    Later,
    Lost,
}

impl Context {
    /// Opens a device for a canvas of so many physical pixels: WebGPU where it really gives a device, else WebGL2.
    ///
    /// # Errors
    /// When neither backend works; the sentence says which step failed.
    pub async fn new(
        target: wgpu::SurfaceTarget<'static>,
        (width, height): (u32, u32),
        force_webgl: bool,
    ) -> Result<Self, Error> {
        let webgpu = if force_webgl { None } else { open_webgpu().await };
        let (backend, surface, adapter, device, queue) = match webgpu {
            Some((instance, adapter, device, queue)) => {
                let surface = create_surface(&instance, target)?;
                (Backend::WebGpu, surface, adapter, device, queue)
            }
            None => {
                let instance = instance(wgpu::Backends::GL);
                // Without a WebGL2 context for the canvas there is no adapter to ask for.
                let surface =
                    instance.create_surface(target).map_err(|error| Error::NoAdapter { reason: error.to_string() })?;
                let adapter = request_adapter(&instance, Some(&surface)).await?;
                let (device, queue) = request_device(&adapter).await?;
                (Backend::WebGl2, surface, adapter, device, queue)
            }
        };

        let lost = Arc::new(AtomicBool::new(false));
        device.set_device_lost_callback({
            let lost = Arc::clone(&lost);
            move |_, _| lost.store(true, Ordering::Relaxed)
        });
        device.on_uncaptured_error(Arc::new({
            let lost = Arc::clone(&lost);
            move |error| match error {
                // The page frees its memory and starts again, as after a lost device.
                wgpu::Error::OutOfMemory { .. } => lost.store(true, Ordering::Relaxed),
                error => panic!("the renderer broke a rule of the graphics interface: {error}"),
            }
        }));

        let limit = device.limits().max_texture_dimension_2d;
        let (width, height) = (width.clamp(1, limit), height.clamp(1, limit));
        let mut configuration = surface
            .get_default_config(&adapter, width, height)
            .ok_or_else(|| Error::NoCanvas { reason: "its device cannot present to it".to_owned() })?;
        // Shaders encode sRGB themselves: WebGL canvases have no sRGB views, and some WebGPU drivers lose the encoding
        // when they resolve a multisampled picture into one. This way both backends show the same bytes.
        let format = configuration.format.remove_srgb_suffix();
        configuration.format = format;
        surface.configure(&device, &configuration);
        let targets = Targets::new(&device, format, (width, height));
        Ok(Self { device, queue, format, surface, configuration, targets, backend, lost })
    }

    /// The graphics interface in use.
    #[must_use]
    pub fn backend(&self) -> Backend {
        self.backend
    }

    /// Size of the drawing; physical pixels.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        (self.configuration.width, self.configuration.height)
    }

    /// Makes the drawing as large as the canvas, within the device's limit. Returns false when nothing changed.
    pub fn resize(&mut self, width: u32, height: u32) -> bool {
        let limit = self.device.limits().max_texture_dimension_2d;
        let (width, height) = (width.clamp(1, limit), height.clamp(1, limit));
        if self.size() == (width, height) {
            return false;
        }
        self.configuration.width = width;
        self.configuration.height = height;
        self.surface.configure(&self.device, &self.configuration);
        self.targets = Targets::new(&self.device, self.format, (width, height));
        true
    }

    /// True once the device is gone for good.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.lost.load(Ordering::Relaxed)
    }

    pub(crate) fn next_frame(&self) -> NextFrame {
        if self.is_lost() {
            return NextFrame::Lost;
        }
        match self.surface.get_current_texture() {
            wgpu::CurrentSurfaceTexture::Success(frame) | wgpu::CurrentSurfaceTexture::Suboptimal(frame) => {
                NextFrame::Ready(frame)
            }
            wgpu::CurrentSurfaceTexture::Timeout | wgpu::CurrentSurfaceTexture::Occluded => NextFrame::Later,
            wgpu::CurrentSurfaceTexture::Outdated => {
                self.surface.configure(&self.device, &self.configuration);
                NextFrame::Later
            }
            wgpu::CurrentSurfaceTexture::Lost | wgpu::CurrentSurfaceTexture::Validation => NextFrame::Lost,
        }
    }

    pub(crate) fn encoder(&self) -> wgpu::CommandEncoder {
        self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("frame encoder") })
    }

    /// Records one pass into the frame and presents it.
    pub(crate) fn present(
        &self,
        frame: wgpu::SurfaceTexture,
        mut encoder: wgpu::CommandEncoder,
        record: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) {
        let view =
            frame.texture.create_view(&wgpu::TextureViewDescriptor { label: Some("canvas"), ..Default::default() });
        self.targets.draw(&mut encoder, &view, record);
        self.queue.submit([encoder.finish()]);
        self.queue.present(frame);
    }
}

fn instance(backends: wgpu::Backends) -> wgpu::Instance {
    wgpu::Instance::new(wgpu::InstanceDescriptor { backends, ..wgpu::InstanceDescriptor::new_without_display_handle() })
}

/// A WebGPU device, or None where the browser has none that works. Asks before the canvas is touched: a canvas that
/// once gave a WebGPU context never gives a WebGL2 one.
async fn open_webgpu() -> Option<(wgpu::Instance, wgpu::Adapter, wgpu::Device, wgpu::Queue)> {
    if !wgpu::util::is_browser_webgpu_supported().await {
        return None;
    }
    let instance = instance(wgpu::Backends::BROWSER_WEBGPU);
    let adapter = request_adapter(&instance, None).await.ok()?;
    let (device, queue) = request_device(&adapter).await.ok()?;
    Some((instance, adapter, device, queue))
}

fn create_surface(
    instance: &wgpu::Instance,
    target: wgpu::SurfaceTarget<'static>,
) -> Result<wgpu::Surface<'static>, Error> {
    instance.create_surface(target).map_err(|error| Error::NoCanvas { reason: error.to_string() })
}

async fn request_adapter(
    instance: &wgpu::Instance,
    compatible_surface: Option<&wgpu::Surface<'_>>,
) -> Result<wgpu::Adapter, Error> {
    instance
        .request_adapter(&wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            compatible_surface,
            ..Default::default()
        })
        .await
        .map_err(|error| Error::NoAdapter { reason: error.to_string() })
}

async fn request_device(adapter: &wgpu::Adapter) -> Result<(wgpu::Device, wgpu::Queue), Error> {
    let offered = adapter.limits();
    let required_limits = wgpu::Limits {
        max_buffer_size: offered.max_buffer_size,
        ..wgpu::Limits::downlevel_webgl2_defaults().using_resolution(offered)
    };
    adapter
        .request_device(&wgpu::DeviceDescriptor {
            label: Some("heatwalk device"),
            required_limits,
            ..Default::default()
        })
        .await
        .map_err(|error| Error::NoDevice { reason: error.to_string() })
}
