//! Makes shapes in the page's worker. What was made goes to the solver's module as bytes, as what was read does: the first picture
//! is of no shape.

#![cfg(target_arch = "wasm32")]

use heatwalk_bindings::Result;
use heatwalk_shapes as shapes;
use wasm_bindgen::prelude::*;

/// All of a shape, for the solver's module.
#[wasm_bindgen]
pub fn make(name: &str) -> Result<Vec<u8>> {
    Ok(shapes::by_name(name)?.packed())
}
