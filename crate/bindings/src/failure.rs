//! Failures as JavaScript sees them: errors with a sentence, and with the solver's code as their name.

use heatwalk::UnknownChoice;
use js_sys::Error;
use wasm_bindgen::{JsValue, throw_val};

/// Name of the error of a call that memory did not suffice for.
pub const OUT_OF_MEMORY: &str = "out-of-memory";

/// Name of the error of a call whose factors do not fit into memory, found out before they are made.
pub const TOO_LARGE: &str = "too-large";

/// Name of the error of a call whose mesh does not fit into memory, found out before it is built.
pub const MESH_TOO_LARGE: &str = "mesh-too-large";

/// Name of the error of a call whose mesh fits into memory, but not with so many windows.
pub const TOO_MANY_WINDOWS: &str = "too-many-windows";

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

    /// An error of this kind, in kebab case.
    pub fn of(code: &str, sentence: &str) -> Self {
        let thrown = Error::new(sentence);
        thrown.set_name(code);
        Self(thrown)
    }

    /// An error with its code, and what a user of the page can do about it.
    fn coded(sentence: &str, code: &str) -> Self {
        let remedy = match code {
            OUT_OF_MEMORY | MESH_TOO_LARGE => {
                "; use a mesh with fewer triangles, or the native program on a larger machine"
            }
            TOO_LARGE => ", or the native program on a larger machine",
            TOO_MANY_WINDOWS => ", or use the native program on a larger machine",
            "missing-resource" => "; open both together, or the folder that holds them",
            _ => "",
        };
        Self::of(code, &format!("{sentence}{remedy}"))
    }
}

impl From<UnknownChoice> for Failure {
    fn from(unknown: UnknownChoice) -> Self {
        heatwalk::Error::from(unknown).into()
    }
}

macro_rules! coded {
    ($($error:ty),*) => {
        $(impl From<$error> for Failure {
            fn from(error: $error) -> Self {
                Self::coded(&error.to_string(), error.code())
            }
        })*
    };
}

coded!(heatwalk::Error, heatwalk::surface::Error, heatwalk_model::Error);
#[cfg(feature = "cloud")]
coded!(heatwalk_cloud::Error);
/// Which of them it is the page knows from what it asked.
#[cfg(feature = "curves")]
impl From<heatwalk_curves::Error> for Failure {
    fn from(error: heatwalk_curves::Error) -> Self {
        Self::misuse(&error.to_string())
    }
}
#[cfg(feature = "volume")]
coded!(heatwalk_volume::Error, heatwalk_volume::fill::Error, heatwalk_volume::io::Error);

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
