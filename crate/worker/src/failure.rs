//! Failures as JavaScript sees them: errors with a sentence, told apart by their name.

use js_sys::Error;
use wasm_bindgen::{JsValue, throw_val};

/// Name of the error of a call that memory did not suffice for.
pub const OUT_OF_MEMORY: &str = "OutOfMemory";

/// Name of the error of a call that ended the module, as that of a trap: the module must not be called again.
pub const TRAP: &str = "RuntimeError";

/// What a call throws.
pub struct Failure(Error);

/// What a call returns.
pub type Result<T> = std::result::Result<T, Failure>;

impl Failure {
    /// A call that does not keep to the interface.
    pub fn misuse(sentence: &str) -> Self {
        Self(Error::new(sentence))
    }

    /// The solver's error, with what a user of the page can do about it.
    fn of(error: &heatwalk::Error) -> Self {
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
        Self(thrown)
    }
}

/// Whatever the solver can fail with.
impl<E> From<E> for Failure
where
    heatwalk::Error: From<E>,
{
    fn from(error: E) -> Self {
        Self::of(&error.into())
    }
}

impl From<Failure> for JsValue {
    fn from(Failure(error): Failure) -> Self {
        error.into()
    }
}

/// Ends the module.
pub fn end(message: &str) -> ! {
    let trap = Error::new(message);
    trap.set_name(TRAP);
    throw_val(trap.into())
}
