//! Reads files of surfaces in the page's worker. What was read goes to the solver's module as bytes, which is built without readers:
//! they would be a third of its bytes, and the first picture needs none.

#![cfg(target_arch = "wasm32")]

use glam::DVec3;
use heatwalk::Up;
use heatwalk_bindings::{Resource, Result, resources};
use heatwalk_model::io;
use wasm_bindgen::prelude::*;

/// What a file holds.
#[wasm_bindgen]
pub struct ReadMesh {
    packed: Vec<u8>,
    up: Option<Up>,
}

#[wasm_bindgen]
impl ReadMesh {
    /// Reads a mesh. `resource` gives the bytes of a file that it refers to.
    pub fn read(name: &str, bytes: &[u8], resource: &Resource) -> Result<Self> {
        let model = io::read(name, bytes, &resources(resource))?;
        let up = io::upward(name, bytes).map(|up| if up == DVec3::Z { Up::Z } else { Up::Y });
        Ok(Self { packed: model.packed(), up })
    }

    /// What points up by the rules of its format; undefined where that says nothing.
    #[wasm_bindgen(getter, unchecked_return_type = "Up | undefined")]
    pub fn up(&self) -> Option<String> {
        self.up.map(|up| up.to_string())
    }

    /// All of it, for the solver's module; to be taken once.
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.packed)
    }
}
