use crate::context::{Backend, Context, request_adapter, request_device};
use crate::error::Error;
use crate::targets::Targets;

/// The canvas that frames go to.
pub struct Canvas {
    surface: wgpu::Surface<'static>,
    configuration: wgpu::SurfaceConfiguration,
    targets: Targets,
}

/// What became of an attempt to get the canvas's next picture.
pub(crate) enum NextFrame {
    Ready(wgpu::SurfaceTexture),
    /// Not now; the next attempt may work.
    Later,
    Lost,
}

impl Canvas {
    /// Opens a device of [`Backend::CANVAS`] for a canvas of so many physical pixels. A canvas that once gave a context
    /// of one kind never gives one of another.
    ///
    /// # Errors
    /// When there is no such device; the sentence says which step failed.
    pub async fn open(
        instance: &wgpu::Instance,
        target: wgpu::SurfaceTarget<'static>,
        (width, height): (u32, u32),
    ) -> Result<(Context, Self), Error> {
        // Without a context for the canvas there is no adapter to ask for.
        let surface =
            instance.create_surface(target).map_err(|error| Error::NoAdapter { reason: error.to_string() })?;
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            compatible_surface: Some(&surface),
            ..Default::default()
        };
        let adapter = request_adapter(instance, &options).await?;
        let (device, queue) = request_device(&adapter).await?;
        let limit = device.limits().max_texture_dimension_2d;
        let mut configuration = surface
            .get_default_config(&adapter, width.clamp(1, limit), height.clamp(1, limit))
            .ok_or_else(|| Error::NoCanvas { reason: "its device cannot present to it".to_owned() })?;
        // Shaders encode sRGB themselves: WebGL canvases have no sRGB views, and some WebGPU drivers lose the encoding
        // when they resolve a multisampled picture into one. This way both backends show the same bytes.
        configuration.format = configuration.format.remove_srgb_suffix();
        let context = Context::new(Backend::CANVAS, device, queue, configuration.format);
        surface.configure(&context.device, &configuration);
        let size = (configuration.width, configuration.height);
        let targets = Targets::new(&context.device, configuration.format, size);
        Ok((context, Self { surface, configuration, targets }))
    }

    /// Makes the drawing as large as the canvas, within the device's limit; physical pixels. Returns false when nothing
    /// changed.
    pub(crate) fn resize(&mut self, context: &Context, width: u32, height: u32) -> bool {
        let (width, height) = context.drawable(width, height);
        if (self.configuration.width, self.configuration.height) == (width, height) {
            return false;
        }
        (self.configuration.width, self.configuration.height) = (width, height);
        self.surface.configure(&context.device, &self.configuration);
        self.targets = Targets::new(&context.device, context.format, (width, height));
        true
    }

    pub(crate) fn next_frame(&self, context: &Context) -> NextFrame {
        if context.is_lost() {
            return NextFrame::Lost;
        }
        match self.surface.get_current_texture() {
            wgpu::CurrentSurfaceTexture::Success(frame) | wgpu::CurrentSurfaceTexture::Suboptimal(frame) => {
                NextFrame::Ready(frame)
            }
            wgpu::CurrentSurfaceTexture::Timeout | wgpu::CurrentSurfaceTexture::Occluded => NextFrame::Later,
            wgpu::CurrentSurfaceTexture::Outdated => {
                self.surface.configure(&context.device, &self.configuration);
                NextFrame::Later
            }
            wgpu::CurrentSurfaceTexture::Lost | wgpu::CurrentSurfaceTexture::Validation => NextFrame::Lost,
        }
    }

    /// Records one pass into the frame and presents it.
    pub(crate) fn present(
        &self,
        context: &Context,
        frame: wgpu::SurfaceTexture,
        mut encoder: wgpu::CommandEncoder,
        record: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) {
        let view =
            frame.texture.create_view(&wgpu::TextureViewDescriptor { label: Some("canvas"), ..Default::default() });
        self.targets.draw(&mut encoder, &view, record);
        context.queue.submit([encoder.finish()]);
        context.queue.present(frame);
    }
}
