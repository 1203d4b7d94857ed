//! A distance field as the page gets it, and what is known of how exact it is.

use heatwalk::{Distance, RelativeError, Solution};
use js_sys::Float32Array;
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;

/// How a field was found before any of it was refined.
#[derive(Clone, Copy)]
pub enum Origin {
    /// By heat that has flowed for t = m h², with this m.
    Heat { time_factor: f64 },
    /// By so many windows of each half-edge; 0: carried by vertices alone.
    Windows(u16),
}

/// The field solved last.
pub struct Solved {
    pub solution: Solution,
    pub origin: Origin,
}

impl Solved {
    pub fn distance(&self) -> &Distance {
        &self.solution.answer().distance
    }
}

/// A distance field.
#[wasm_bindgen(inspectable)]
pub struct Field {
    values: Vec<f32>,
    is_by_corner: bool,
    max: f64,
    unreachable: u32,
    exact_below: f64,
    exact_share: f64,
    origin: Origin,
    error: Option<RelativeError>,
}

impl Field {
    /// `in_walls`: how many vertices cannot be reached by anything.
    pub(crate) fn of(drawn: &Drawn, solved: &Solved, in_walls: usize) -> Self {
        let distance = solved.distance();
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
            is_by_corner: drawn.is_by_corner,
            max,
            unreachable: (distance.values.len() - reachable).saturating_sub(in_walls) as u32,
            exact_below: distance.exact_below,
            exact_share: exact as f64 / reachable.max(1) as f64,
            origin: solved.origin,
            error: solved.solution.error(),
        }
    }
}

#[wasm_bindgen]
impl Field {
    /// One value a drawn vertex of the surface, or a corner of a drawn triangle (see `byCorner`); Infinity where no source can be reached.
    #[wasm_bindgen(getter)]
    pub fn distance(&self) -> Float32Array {
        self.values.as_slice().into()
    }

    /// Whether values are those of corners, `#F × 3`: walls part vertices.
    #[wasm_bindgen(getter, js_name = byCorner)]
    pub fn is_by_corner(&self) -> bool {
        self.is_by_corner
    }

    /// Largest finite distance.
    #[wasm_bindgen(getter, js_name = maxDistance)]
    pub fn max(&self) -> f64 {
        self.max
    }

    /// Welded vertices that no source reaches, those in walls apart.
    #[wasm_bindgen(getter, js_name = unreachableVertices)]
    pub fn unreachable(&self) -> u32 {
        self.unreachable
    }

    /// Values below this are exact polyhedral distances; Infinity when all are.
    #[wasm_bindgen(getter, js_name = exactBelow)]
    pub fn exact_below(&self) -> f64 {
        self.exact_below
    }

    /// Share of the reachable welded vertices whose value is exact, 0 to 1.
    #[wasm_bindgen(getter, js_name = exactShare)]
    pub fn exact_share(&self) -> f64 {
        self.exact_share
    }

    /// m in t = m h², as asked for or chosen; undefined where the field was found by windows.
    #[wasm_bindgen(getter, js_name = timeFactor)]
    pub fn time_factor(&self) -> Option<f64> {
        match self.origin {
            Origin::Heat { time_factor } => Some(time_factor),
            Origin::Windows(_) => None,
        }
    }

    /// Windows of each half-edge that the field was found by, 0 where vertices alone carried it; undefined where that was heat.
    #[wasm_bindgen(getter)]
    pub fn windows(&self) -> Option<u16> {
        match self.origin {
            Origin::Heat { .. } => None,
            Origin::Windows(count) => Some(count),
        }
    }

    /// Mean relative error of the field before it was refined; undefined until all of it is exact.
    #[wasm_bindgen(getter, js_name = meanError)]
    pub fn mean_error(&self) -> Option<f64> {
        self.error.map(|error| error.mean)
    }

    /// Largest relative error of the field before it was refined; undefined until all of it is exact.
    #[wasm_bindgen(getter, js_name = maxError)]
    pub fn max_error(&self) -> Option<f64> {
        self.error.map(|error| error.max)
    }
}
