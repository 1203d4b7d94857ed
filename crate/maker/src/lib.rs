//! Makes shapes in the page's worker. What was made goes to the solver's module as bytes, as what was read does: the first picture
//! is of no shape.

#![cfg(target_arch = "wasm32")]

use heatwalk_bindings::Result;
use heatwalk_shapes as shapes;
use wasm_bindgen::prelude::*;

/// A panic ends with its message as a `RuntimeError`, so that a bare trap is one thing only: memory that was refused.
#[wasm_bindgen(start)]
pub fn start() {
    std::panic::set_hook(Box::new(|panic| heatwalk_bindings::end(&panic.to_string())));
}

/// All of a shape, for the solver's module.
#[wasm_bindgen]
pub fn make(name: &str) -> Result<Vec<u8>> {
    Ok(shapes::by_name(name)?.packed())
}
