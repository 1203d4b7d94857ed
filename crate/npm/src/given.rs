//! What is given as plain objects.

use std::str::FromStr;

use heatwalk_bindings::{Failure, Result};
use js_sys::{Array, Object, Reflect};
use wasm_bindgen::JsValue;

/// The properties of an object that are not undefined.
pub fn entries(object: &Object) -> impl Iterator<Item = (String, JsValue)> {
    let entry = |entry: JsValue| {
        let entry = Array::from(&entry);
        (entry.get(0).as_string().unwrap_or_default(), entry.get(1))
    };
    Object::entries(object).to_vec().into_iter().map(entry).filter(|(_, value)| !value.is_undefined())
}

/// A property, if it is there.
pub fn property(object: &Object, name: &str) -> Option<JsValue> {
    Reflect::get(object, &name.into()).ok().filter(|value| !value.is_undefined())
}

/// A word, or a number in place of one.
pub fn parsed<T: FromStr>(name: &str, value: &JsValue) -> Result<T>
where
    Failure: From<T::Err>,
{
    let text = value.as_string().or_else(|| value.as_f64().map(|number| number.to_string()));
    let refused = || Failure::of("bad-parameter", &format!("{name} is {value:?}; give a string or a number"));
    Ok(text.ok_or_else(refused)?.parse::<T>()?)
}

/// A whole number, 0 or more.
pub fn count(name: &str, value: &JsValue) -> Result<usize> {
    let count = value.as_f64().filter(|count| (0.0..9e15).contains(count) && count.fract() == 0.0);
    let refused = || Failure::of("bad-parameter", &format!("{name} is {value:?}; give a whole number, 0 or more"));
    count.map(|count| count as usize).ok_or_else(refused)
}

/// A list or an array of numbers.
pub fn numbers(value: &JsValue) -> Vec<f64> {
    Array::from(value).iter().map(|value| value.as_f64().unwrap_or(f64::NAN)).collect()
}
