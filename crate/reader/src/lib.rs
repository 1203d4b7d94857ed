//! Reads files of surfaces in the page's worker. What was read goes to the solver's module as bytes, which is built without readers:
//! they would be a third of its bytes, and the first picture needs none.

#![cfg(target_arch = "wasm32")]

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk::Up;
use heatwalk_bindings::{Resource, Result, resources};
use heatwalk_model::io::{self, Budget};
use wasm_bindgen::prelude::*;

/// What a file holds.
#[wasm_bindgen]
pub struct ReadMesh {
    packed: Vec<u8>,
    up: Option<Up>,
    is_cloud: bool,
}

#[wasm_bindgen]
impl ReadMesh {
    /// Reads a mesh, or points, which are joined to one. `resource` gives the bytes of a file that it refers to.
    pub fn read(name: &str, bytes: &[u8], resource: &Resource) -> Result<Self> {
        let budget = &Budget::of_file(bytes.len());
        let resource = resources(resource);
        let within = |uri: &str| budget.admit(resource(uri)?).ok();
        #[cfg(feature = "unpack")]
        let file = io::Unpacked::of(budget, name, bytes, io::names_mesh)?;
        #[cfg(feature = "unpack")]
        let (name, bytes) = (file.name(), file.bytes());
        #[cfg(feature = "unpack")]
        let within = |uri: &str| if file.is_of_archive() { file.resource(uri) } else { within(uri) };
        let mut model = heatwalk_cloud::read_within(budget, name, bytes, &within)?;
        let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
        let is_cloud = heatwalk_cloud::join(stem, &mut model, NonZeroUsize::MIN)?.is_some();
        let up = io::upward(name, bytes).map(|up| if up == DVec3::Z { Up::Z } else { Up::Y });
        Ok(Self { packed: model.packed(), up, is_cloud })
    }

    /// What points up by the rules of its format; undefined where that says nothing.
    #[wasm_bindgen(getter, unchecked_return_type = "Up | undefined")]
    pub fn up(&self) -> Option<String> {
        self.up.map(|up| up.to_string())
    }

    /// Whether it was points without faces.
    #[wasm_bindgen(getter)]
    pub fn is_cloud(&self) -> bool {
        self.is_cloud
    }

    /// All of it, for the solver's module; to be taken once.
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.packed)
    }
}
