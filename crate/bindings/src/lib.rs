//! What the wasm modules of the page's worker share: failures as JavaScript sees them, and the options of the solver in the page's
//! words.

#![cfg(target_arch = "wasm32")]

mod failure;
mod parameters;

use js_sys::Reflect;
use wasm_bindgen::JsValue;

pub use failure::{Failure, Result, end};
pub use parameters::parameters;

/// A property of an object that is a number.
pub fn number(object: &JsValue, key: &str) -> Option<f64> {
    Reflect::get(object, &key.into()).ok().and_then(|value| value.as_f64())
}
