//! What JavaScript gets back.

use wasm_bindgen::prelude::wasm_bindgen;

use crate::capture::Capture;
use crate::renderer::SurfaceHit;

/// A place on the surface or the section.
#[wasm_bindgen]
pub struct Hit(pub(super) SurfaceHit);

#[wasm_bindgen]
impl Hit {
    /// Whether it is on the section.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn is_on_section(&self) -> bool {
        self.0.is_on_section
    }

    /// Index of the triangle, of the surface or of the section.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn triangle(&self) -> u32 {
        self.0.triangle
    }

    /// Barycentric weights of its corners.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn weights(&self) -> Vec<f32> {
        self.0.weights.to_array().to_vec()
    }

    /// World position.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn point(&self) -> Vec<f32> {
        self.0.point.to_array().to_vec()
    }

    /// Unit normal.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn normal(&self) -> Vec<f32> {
        self.0.normal.to_array().to_vec()
    }
}

/// A picture that the graphics device draws.
#[wasm_bindgen]
pub struct Picture(pub(super) Capture);

#[wasm_bindgen]
impl Picture {
    /// Pixels across.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn width(&self) -> u32 {
        self.0.size().0
    }

    /// Pixels down.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn height(&self) -> u32 {
        self.0.size().1
    }

    /// To be asked until it is true.
    #[must_use]
    pub fn is_ready(&self) -> bool {
        self.0.is_ready()
    }

    /// RGBA, sRGB bytes from the top row, when ready; frees the picture.
    #[must_use]
    pub fn into_pixels(self) -> Vec<u8> {
        self.0.into_pixels()
    }
}
