//! A distance field as the page gets it, and what is known of how exact it is.

use heatwalk::{Distance, RelativeError};
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;

/// A distance field, one value a drawn vertex.
#[wasm_bindgen]
pub struct Field {
    values: Vec<f32>,
    max: f64,
    unreachable: u32,
    exact_below: f64,
    exact_share: f64,
    time_factor: f64,
    error: Option<RelativeError>,
}

impl Field {
    pub(crate) fn of(drawn: &Drawn, distance: &Distance, time_factor: f64, error: Option<RelativeError>) -> Self {
        let (mut max, mut reachable, mut exact) = (0.0_f64, 0, 0);
        for &value in &distance.values {
            if value.is_finite() {
                max = max.max(value);
                reachable += 1;
                exact += usize::from(value < distance.exact_below);
            }
        }
        Self {
            values: drawn.spread(&distance.values),
            max,
            unreachable: (distance.values.len() - reachable) as u32,
            exact_below: distance.exact_below,
            exact_share: exact as f64 / reachable.max(1) as f64,
            time_factor,
            error,
        }
    }
}

#[wasm_bindgen]
impl Field {
    /// `#D`, infinite where no source is in reach. Can be taken once.
    pub fn take_values(&mut self) -> Vec<f32> {
        std::mem::take(&mut self.values)
    }

    /// Largest finite distance.
    #[wasm_bindgen(getter)]
    pub fn max(&self) -> f64 {
        self.max
    }

    /// Welded vertices that no source reaches.
    #[wasm_bindgen(getter)]
    pub fn unreachable(&self) -> u32 {
        self.unreachable
    }

    /// Values below this are exact; infinite when all are.
    #[wasm_bindgen(getter)]
    pub fn exact_below(&self) -> f64 {
        self.exact_below
    }

    /// Share of the reachable welded vertices whose value is exact.
    #[wasm_bindgen(getter)]
    pub fn exact_share(&self) -> f64 {
        self.exact_share
    }

    /// m in t = m h², as asked for or chosen.
    #[wasm_bindgen(getter)]
    pub fn time_factor(&self) -> f64 {
        self.time_factor
    }

    /// Mean relative error of the field before it was refined; present once it is exact.
    #[wasm_bindgen(getter)]
    pub fn mean_error(&self) -> Option<f64> {
        self.error.map(|error| error.mean)
    }

    /// Largest relative error of the field before it was refined; present once it is exact.
    #[wasm_bindgen(getter)]
    pub fn max_error(&self) -> Option<f64> {
        self.error.map(|error| error.max)
    }
}
