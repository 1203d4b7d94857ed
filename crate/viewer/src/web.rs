//! The face of the renderer towards JavaScript: converts arrays, numbers and errors, decides nothing.

mod camera;
mod content;
mod inside;
mod materials;
mod numbers;
mod properties;
mod results;

use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::{HtmlCanvasElement, WebGl2RenderingContext};

use self::results::Picture;
use crate::canvas::Canvas;
use crate::context::Backend;
use crate::error::Error;
use crate::renderer::Renderer;

/// A canvas that shows a surface.
#[wasm_bindgen]
pub struct Viewer {
    renderer: Renderer,
    canvas: HtmlCanvasElement,
    /// Nothing is told when the browser takes a WebGL context away; the context itself knows.
    webgl: Option<WebGl2RenderingContext>,
}

#[wasm_bindgen]
impl Viewer {
    /// Opens the graphics interface of this build for a canvas that has no context yet, and builds the pipelines.
    ///
    /// # Errors
    /// Rejects with a plain sentence when it does not work.
    pub async fn create(canvas: HtmlCanvasElement) -> Result<Viewer, JsError> {
        console_error_panic_hook::set_once();
        let (width, height) = (canvas.width(), canvas.height());
        let target = wgpu::SurfaceTarget::Canvas(canvas.clone());
        let (context, drawable) = Canvas::open(&instance(&canvas)?, target, (width, height)).await?;
        let renderer = Renderer::new(context, Some(drawable))?;
        let webgl = match renderer.backend() {
            // Asking again for the kind of context a canvas already has returns that context.
            Backend::WebGl2 => canvas.get_context("webgl2").ok().flatten().map(wasm_bindgen::JsCast::unchecked_into),
            Backend::WebGpu | Backend::Vulkan => None,
        };
        let mut viewer = Self { renderer, canvas, webgl };
        viewer.resize(width, height);
        Ok(viewer)
    }

    /// "WebGPU" or "WebGL2".
    #[must_use]
    pub fn backend(&self) -> String {
        self.renderer.backend().name().to_owned()
    }

    /// Physical pixels.
    pub fn resize(&mut self, width: u32, height: u32) {
        let css_width = self.canvas.client_width();
        // A canvas that is not laid out yet has no width.
        let pixel_ratio = if css_width > 0 { width as f32 / css_width as f32 } else { 1.0 };
        self.renderer.resize(width, height, pixel_ratio);
    }

    /// Draws the scene beside the canvas, `scale` times as large; `clear` leaves the background transparent.
    ///
    /// # Errors
    /// Throws when that is more than the device can draw.
    pub fn capture(&mut self, scale: f32, clear: bool) -> Result<Picture, JsError> {
        Ok(Picture(self.renderer.capture(scale, clear)?))
    }

    /// True if something changed since the last frame or an animation runs.
    #[must_use]
    pub fn needs_frame(&self) -> bool {
        self.is_taken() || self.renderer.needs_frame()
    }

    /// Draws one frame; false when the canvas was lost and the viewer must be created again.
    ///
    /// # Errors
    /// Throws what the device refused since the last frame; the viewer can be used further.
    pub fn render(&mut self, seconds: f64) -> Result<bool, JsError> {
        Ok(!self.is_taken() && self.renderer.render(seconds)?)
    }
}

/// wgpu with the graphics interface of this build.
#[cfg(feature = "webgl2")]
fn instance(canvas: &HtmlCanvasElement) -> Result<wgpu::Instance, Error> {
    heatwalk_webgl::instance(canvas.clone()).map_err(|reason| Error::NoAdapter { reason })
}

#[cfg(not(feature = "webgl2"))]
#[expect(clippy::unnecessary_wraps, reason = "the other interface may be missing")]
fn instance(_: &HtmlCanvasElement) -> Result<wgpu::Instance, Error> {
    Ok(crate::context::instance(wgpu::Backends::BROWSER_WEBGPU))
}

impl Viewer {
    fn is_taken(&self) -> bool {
        self.webgl.as_ref().is_some_and(WebGl2RenderingContext::is_context_lost)
    }
}
