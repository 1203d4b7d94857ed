//! Errors as JavaScript sees them, told apart by their name.

use js_sys::Error;
use wasm_bindgen::{JsValue, throw_val};

/// What memory did not suffice for; `OUT_OF_MEMORY` of the page's protocol.
const OUT_OF_MEMORY: &str = "OutOfMemory";

/// As a trap is named.
const TRAP: &str = "RuntimeError";

/// The solver's error, to be thrown.
pub fn thrown(error: &heatwalk::Error) -> JsValue {
    let thrown = Error::new(&error.to_string());
    if matches!(error, heatwalk::Error::TooLarge { .. } | heatwalk::Error::OutOfMemory { .. }) {
        thrown.set_name(OUT_OF_MEMORY);
    }
    thrown.into()
}

/// Ends the module, which must not be called again.
pub fn end(message: &str) -> ! {
    let trap = Error::new(message);
    trap.set_name(TRAP);
    throw_val(trap.into())
}
