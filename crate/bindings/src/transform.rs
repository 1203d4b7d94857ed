//! How what is drawn comes from the file.

use glam::DVec3;
use heatwalk::Choice;
use heatwalk_message::Message;
use js_sys::{Array, Reflect};
use wasm_bindgen::JsValue;

use crate::{Failure, Result, number, numbers};

/// From the file's unit to what is drawn: drawn = (position − center) · scale, turned so that `up` is drawn along Y. What is
/// drawn is near the origin and within ±1, whatever the file's unit, since graphics cards calculate in single precision.
#[derive(Message)]
pub struct DrawTransform {
    /// What is drawn at the origin, in the file's unit.
    #[typescript("[number, number, number]")]
    pub center: Array,
    /// Drawn length of the file's unit.
    pub scale: f64,
    /// The axis of the file that points up.
    #[typescript("Up")]
    pub up: &'static str,
}

impl From<heatwalk_scene::DrawTransform> for DrawTransform {
    fn from(transform: heatwalk_scene::DrawTransform) -> Self {
        let [x, y, z] = transform.center.to_array().map(JsValue::from);
        Self { center: Array::of3(&x, &y, &z), scale: transform.scale, up: transform.up.name() }
    }
}

/// Reads one that was given.
///
/// # Errors
/// For a center that is not three numbers, no scale, or an axis that there is not.
pub fn transform(given: &JsValue) -> Result<heatwalk_scene::DrawTransform> {
    let wrong = || Failure::misuse("what is drawn has a center of three numbers, a scale and an axis");
    let center = numbers(given, "center").try_into().map_err(|_| wrong())?;
    let up = Reflect::get(given, &"up".into()).ok().and_then(|up| up.as_string()).ok_or_else(wrong)?;
    Ok(heatwalk_scene::DrawTransform {
        center: DVec3::from_array(center),
        scale: number(given, "scale").ok_or_else(wrong)?,
        up: up.parse()?,
    })
}
