//! Errors as JavaScript sees them, told apart by their name.

use js_sys::Error;
use wasm_bindgen::{JsValue, throw_val};

/// What memory did not suffice for; `OUT_OF_MEMORY` of the page's protocol.
const OUT_OF_MEMORY: &str = "OutOfMemory";

/// As a trap is named.
const TRAP: &str = "RuntimeError";

/// The solver's error, to be thrown, with what a user of the page can do about it.
pub fn thrown(error: &heatwalk::Error) -> JsValue {
    let remedy = match error.code() {
        "out-of-memory" => "; use a mesh with fewer triangles, or the native program on a larger machine",
        "too-large" => ", or the native program on a larger machine",
        "missing-resource" => "; open both together",
        _ => "",
    };
    let thrown = Error::new(&format!("{error}{remedy}"));
    if matches!(error.code(), "out-of-memory" | "too-large") {
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
