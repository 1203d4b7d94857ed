//! What the wasm modules of the page's worker share: what they answer, failures as JavaScript sees them, and the options
//! of the solver in the page's words.

#![cfg(target_arch = "wasm32")]

// What the derived code calls it, here too.
extern crate self as heatwalk_bindings;

mod failure;
mod message;
mod parameters;
mod transform;

use std::ops::ControlFlow;

use heatwalk::Stage;
use js_sys::{Array, Function, Reflect, Uint8Array};
use wasm_bindgen::prelude::*;

pub use failure::{Failure, Result, end};
pub use heatwalk_message::Message;
pub use message::{DrawPath, Field, FieldError, object};
pub use parameters::parameters;
pub use transform::{DrawTransform, transform};

/// The types of arguments that have no type in Rust: names and options are those of the generated contract.
#[wasm_bindgen(typescript_custom_section)]
const ARGUMENTS: &str = "
import type { EdgeKind, FaceField, Parameters, PathKind, Stage, Up } from '../contract';

/** Told before each stage, with the fraction that is done, 0 to 1. */
export type Progress = (stage: Stage, fraction: number) => void;

/** The bytes of the file that a mesh refers to by this relative URI, percent-decoded; undefined where it was not given. */
export type Resource = (uri: string) => Uint8Array | undefined;
";

#[wasm_bindgen]
extern "C" {
    /// A function of JavaScript's that gives the bytes of a file, or undefined where it was not given.
    #[wasm_bindgen(extends = Function, typescript_type = "Resource")]
    pub type Resource;
}

/// A panic ends with its message as a `RuntimeError`, so that a bare trap is one thing only: memory that was refused.
#[wasm_bindgen(start)]
pub fn start() {
    std::panic::set_hook(Box::new(|panic| end(&panic.to_string())));
}

/// The files that a mesh refers to.
pub fn resources(function: &Resource) -> impl Fn(&str) -> Option<Vec<u8>> {
    move |uri| {
        let found = function.call1(&JsValue::NULL, &uri.into()).ok()?;
        Some(found.dyn_into::<Uint8Array>().ok()?.to_vec())
    }
}

/// Passes the stages of factoring on to the page. What the page does with them is no reason to stop.
pub fn reporter(progress: &Function) -> impl FnMut(Stage, f64) -> ControlFlow<()> {
    move |stage, fraction| {
        let _ = progress.call2(&JsValue::NULL, &stage.to_string().into(), &fraction.into());
        ControlFlow::Continue(())
    }
}

/// log10 of heat over its maximum, −∞ where there is none.
pub fn logarithms(heat: &[f64]) -> impl Iterator<Item = f64> {
    let max = heat.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    heat.iter().map(move |&value| (value.max(0.0) / max).log10())
}

/// A property of an object that is a number.
pub fn number(object: &JsValue, key: &str) -> Option<f64> {
    Reflect::get(object, &key.into()).ok().and_then(|value| value.as_f64())
}

/// A property of an object that is a list of numbers.
pub fn numbers(object: &JsValue, key: &str) -> Vec<f64> {
    let list = Reflect::get(object, &key.into()).map(|list| Array::from(&list)).unwrap_or_default();
    list.iter().map(|value| value.as_f64().unwrap_or(f64::NAN)).collect()
}
