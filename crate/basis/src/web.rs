//! The interface to JavaScript.

use wasm_bindgen::prelude::*;

use crate::image;

/// A decoded image.
#[wasm_bindgen(js_name = BasisImage)]
pub struct Image(image::Image);

#[wasm_bindgen(js_class = BasisImage)]
impl Image {
    /// Decodes a KTX 2.0 file: the largest level with at most `wanted` texels either way, else the smallest.
    ///
    /// # Errors
    /// Where the file is damaged, no image of glTF, or too large.
    pub fn decode(file: &[u8], wanted: u32) -> Result<Self, JsError> {
        Ok(Self(image::decode(file, wanted)?))
    }

    /// Texels in a row.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.0.width
    }

    /// Rows.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.0.height
    }

    /// `height × width × 4`: red, green, blue and alpha, from the top row down; to be taken once.
    pub fn take_texels(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.0.texels)
    }
}
