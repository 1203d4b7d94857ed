//! Properties of objects of JavaScript's.

/// What can be read of an object, by the names and types of its properties: `wrap_u as wrapU: String` where JavaScript has
/// another name.
macro_rules! properties {
    ($object:ident { $($name:ident $(as $property:ident)?: $type:ty),+ $(,)? }) => {
        #[wasm_bindgen]
        extern "C" {
            $(
                #[wasm_bindgen(method, getter, structural $(, js_name = $property)?)]
                fn $name(this: &$object) -> $type;
            )+
        }
    };
}
pub(super) use properties;
