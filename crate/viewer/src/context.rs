use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

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
    /// Outside a browser.
    Vulkan,
}

impl Backend {
    /// What a canvas is drawn on: WebGPU with the feature `webgpu`, else WebGL2. A build has one of the two, because each
    /// brings much code along.
    pub const CANVAS: Self = if cfg!(feature = "webgpu") { Self::WebGpu } else { Self::WebGl2 };

    /// The name as people write it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::WebGpu => "WebGPU",
            Self::WebGl2 => "WebGL2",
            Self::Vulkan => "Vulkan",
        }
    }
}

/// Device and queue, and what the device told; a clone is the same device.
#[derive(Clone)]
pub struct Context {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    /// Of pictures: plain bytes, which the shaders fill with sRGB.
    pub(crate) format: wgpu::TextureFormat,
    backend: Backend,
    news: Arc<News>,
}

/// What a device tells outside of any call.
#[derive(Default)]
struct News {
    is_lost: AtomicBool,
    /// The first since it was last taken: what follows is mostly its consequence.
    error: Mutex<Option<Error>>,
}

impl News {
    fn tell(&self, error: Error) {
        self.error.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
    }
}

impl Context {
    /// Opens a device that draws pictures without a canvas; `software` for the one that the processor imitates.
    ///
    /// # Errors
    /// When there is no such device.
    pub async fn offscreen(software: bool) -> Result<Self, Error> {
        let instance = instance(wgpu::Backends::all());
        let options = wgpu::RequestAdapterOptions { force_fallback_adapter: software, ..Default::default() };
        let (device, queue) = request_device(&request_adapter(&instance, &options).await?).await?;
        Ok(Self::new(Backend::Vulkan, device, queue, wgpu::TextureFormat::Rgba8Unorm))
    }

    pub(crate) fn new(backend: Backend, device: wgpu::Device, queue: wgpu::Queue, format: wgpu::TextureFormat) -> Self {
        let news = Arc::new(News::default());
        device.set_device_lost_callback({
            let news = Arc::clone(&news);
            move |_, _| news.is_lost.store(true, Ordering::Relaxed)
        });
        device.on_uncaptured_error(Arc::new({
            let news = Arc::clone(&news);
            move |error| {
                news.tell(match error {
                    wgpu::Error::OutOfMemory { .. } => Error::OutOfMemory,
                    error => Error::Refused { reason: error.to_string() },
                });
            }
        }));
        Self { device, queue, format, backend, news }
    }

    /// The graphics interface in use.
    #[must_use]
    pub fn backend(&self) -> Backend {
        self.backend
    }

    /// A size in physical pixels, within the device's limits.
    pub(crate) fn drawable(&self, width: u32, height: u32) -> (u32, u32) {
        let limit = self.device.limits().max_texture_dimension_2d;
        (width.clamp(1, limit), height.clamp(1, limit))
    }

    /// True once the device is gone for good.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.news.is_lost.load(Ordering::Relaxed)
    }

    /// What the device refused first since this was last asked.
    #[must_use]
    pub fn take_error(&self) -> Option<Error> {
        self.news.error.lock().unwrap_or_else(PoisonError::into_inner).take()
    }

    /// Whether the device was lost or refused something that was not taken yet.
    pub(crate) fn has_news(&self) -> bool {
        self.is_lost() || self.news.error.lock().unwrap_or_else(PoisonError::into_inner).is_some()
    }

    pub(crate) fn encoder(&self) -> wgpu::CommandEncoder {
        self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("frame encoder") })
    }
}

pub(crate) fn instance(backends: wgpu::Backends) -> wgpu::Instance {
    wgpu::Instance::new(wgpu::InstanceDescriptor { backends, ..wgpu::InstanceDescriptor::new_without_display_handle() })
}

pub(crate) async fn request_adapter(
    instance: &wgpu::Instance,
    options: &wgpu::RequestAdapterOptions<'_, '_>,
) -> Result<wgpu::Adapter, Error> {
    instance.request_adapter(options).await.map_err(|error| Error::NoAdapter { reason: error.to_string() })
}

pub(crate) async fn request_device(adapter: &wgpu::Adapter) -> Result<(wgpu::Device, wgpu::Queue), Error> {
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
