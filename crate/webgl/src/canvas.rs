//! What stands between a canvas and a device: wgpu's instance, adapter and surface.

use std::cell::RefCell;
use std::future::ready;
use std::pin::Pin;

use wasm_bindgen::{JsCast, JsValue};
use web_sys::{HtmlCanvasElement, WebGl2RenderingContext as Gl};
use wgpu::custom::{
    AdapterInterface, DispatchAdapter, DispatchDevice, DispatchQueue, DispatchSurface, DispatchSurfaceOutputDetail,
    DispatchTexture, EnumerateAdapterFuture, InstanceInterface, RequestAdapterFuture, RequestDeviceFuture,
    SurfaceInterface,
};

use crate::command::missing;
use crate::context::Context;
use crate::device::{Device, Queue};
use crate::resource::{Frame, Texture};

/// What plain bytes are shown as they are.
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// wgpu for a canvas. Every surface of the instance is this canvas, whatever it is asked for.
///
/// # Errors
/// Where the browser gives the canvas no WebGL2 context; a sentence.
pub fn instance(canvas: HtmlCanvasElement) -> Result<wgpu::Instance, String> {
    let options = js_sys::Object::new();
    // Pictures are multisampled before they get to the canvas.
    let set = js_sys::Reflect::set(&options, &"antialias".into(), &JsValue::FALSE);
    let context = set.and_then(|_| canvas.get_context_with_context_options("webgl2", &options));
    match context.map(|context| context.map(JsCast::dyn_into::<Gl>)) {
        Ok(Some(Ok(gl))) => Ok(wgpu::Instance::from_custom(Instance { canvas, context: Context::new(gl) })),
        Ok(_) => Err("canvas.getContext() returned null; webgl2 not available or canvas already in use".to_owned()),
        Err(error) => Err(format!("canvas.getContext() threw {error:?}")),
    }
}

#[derive(Debug)]
struct Instance {
    canvas: HtmlCanvasElement,
    context: Context,
}

#[allow(unsafe_code, reason = "wgpu's trait has unsafe methods; these are safe")]
impl InstanceInterface for Instance {
    fn new(_: wgpu::InstanceDescriptor) -> Self {
        unimplemented!("an instance without a canvas")
    }

    unsafe fn create_surface(&self, _: wgpu::SurfaceTargetUnsafe) -> Result<DispatchSurface, wgpu::CreateSurfaceError> {
        let (canvas, context) = (self.canvas.clone(), self.context.clone());
        Ok(DispatchSurface::custom(Surface { canvas, context, texture: RefCell::default() }))
    }

    fn request_adapter(&self, _: &wgpu::RequestAdapterOptions<'_, '_>) -> Pin<Box<dyn RequestAdapterFuture>> {
        Box::pin(ready(Ok(DispatchAdapter::custom(Adapter(self.context.clone())))))
    }

    missing! { shared
        poll_all_devices(bool) -> bool;
        enumerate_adapters(wgpu::Backends) -> Pin<Box<dyn EnumerateAdapterFuture>>;
    }
}

#[derive(Debug)]
struct Adapter(Context);

impl AdapterInterface for Adapter {
    fn request_device(&self, descriptor: &wgpu::DeviceDescriptor<'_>) -> Pin<Box<dyn RequestDeviceFuture>> {
        let (context, limits) = (self.0.clone(), descriptor.required_limits.clone());
        let device = DispatchDevice::custom(Device { context, limits });
        Box::pin(ready(Ok((device, DispatchQueue::custom(Queue(self.0.clone()))))))
    }

    fn limits(&self) -> wgpu::Limits {
        self.0.limits()
    }

    missing! { shared
        is_surface_supported(&DispatchSurface) -> bool;
        features() -> wgpu::Features;
        downlevel_capabilities() -> wgpu::DownlevelCapabilities;
        get_info() -> wgpu::AdapterInfo;
        get_texture_format_features(wgpu::TextureFormat) -> wgpu::TextureFormatFeatures;
        get_presentation_timestamp() -> wgpu::PresentationTimestamp;
        cooperative_matrix_properties() -> Vec<wgpu::wgt::CooperativeMatrixProperties>;
    }
}

#[derive(Debug)]
struct Surface {
    canvas: HtmlCanvasElement,
    context: Context,
    texture: RefCell<Option<Texture>>,
}

impl SurfaceInterface for Surface {
    fn get_capabilities(&self, _: &DispatchAdapter) -> wgpu::SurfaceCapabilities {
        let (formats, present_modes) = (vec![FORMAT], vec![wgpu::PresentMode::Fifo]);
        wgpu::SurfaceCapabilities { formats, present_modes, ..wgpu::SurfaceCapabilities::default() }
    }

    fn configure(&self, _: &DispatchDevice, configuration: &wgpu::SurfaceConfiguration) {
        let (width, height) = (configuration.width, configuration.height);
        self.canvas.set_width(width);
        self.canvas.set_height(height);
        let texture = Texture::new(
            &self.context,
            &wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: configuration.format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            },
        );
        self.texture.replace(Some(texture));
    }

    fn get_current_texture(&self) -> (Option<DispatchTexture>, wgpu::SurfaceStatus, DispatchSurfaceOutputDetail) {
        let texture = self.texture.borrow().clone().expect("a surface is configured first");
        let frame = DispatchSurfaceOutputDetail::custom(Frame(texture.clone()));
        (Some(DispatchTexture::custom(texture)), wgpu::SurfaceStatus::Good, frame)
    }
}
