//! What a simplifier is given of a mesh, and what comes back.

use glam::DVec3;
use heatwalk_bindings::Result;
use heatwalk_model::Model;
use wasm_bindgen::prelude::*;

/// The triangles of some parts, whose vertices are within ±1: simplifiers calculate in single precision.
#[wasm_bindgen]
pub struct Outline {
    model: Model,
    center: DVec3,
    scale: f64,
}

impl Outline {
    pub(crate) fn new(model: Model) -> Self {
        let bounds = || model.soup.positions.iter().copied().filter(|position| position.is_finite());
        let low = bounds().reduce(DVec3::min).unwrap_or_default();
        let high = bounds().reduce(DVec3::max).unwrap_or_default();
        // Half of each first: the sum of two large numbers may be none.
        let (center, reach) = (0.5 * low + 0.5 * high, (0.5 * high - 0.5 * low).max_element());
        Self { model, center, scale: if reach >= f64::MIN_POSITIVE { reach } else { 1.0 } }
    }

    /// Other triangles, `#F × 3`, over the same vertices: one part, in no materials.
    pub(crate) fn with_triangles(&self, name: &str, triangles: &[u32]) -> Result<Model> {
        Ok(self.model.with_triangles(name, triangles.as_chunks().0.to_vec())?)
    }
}

#[wasm_bindgen]
impl Outline {
    /// `#V × 3`, in the file's unit over `scale`; one that is not finite is in the middle.
    pub fn positions(&self) -> Vec<f32> {
        let place = |position: &DVec3| ((*position - self.center) / self.scale).as_vec3();
        let places = self.model.soup.positions.iter().map(place);
        places.flat_map(|place| if place.is_finite() { place.to_array() } else { [0.0; 3] }).collect()
    }

    /// `#F × 3`.
    pub fn triangles(&self) -> Vec<u32> {
        self.model.soup.triangles.as_flattened().to_vec()
    }

    /// Length of what is 1 here, in the file's unit.
    pub fn scale(&self) -> f64 {
        self.scale
    }
}
