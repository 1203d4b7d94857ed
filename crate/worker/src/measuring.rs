//! What the page gets of measured legs and of closed curves.

use heatwalk::Enclosed;
use js_sys::{Float64Array, Uint32Array};
use wasm_bindgen::prelude::*;

/// A path between two places, as places of the drawing, so that it can be drawn in any pose.
#[wasm_bindgen(inspectable)]
pub struct Leg {
    pub(crate) triangles: Vec<u32>,
    pub(crate) weights: Vec<f64>,
    pub(crate) length: f64,
    pub(crate) straight: f64,
    pub(crate) cost: f64,
}

#[wasm_bindgen]
impl Leg {
    /// `#P`, drawn triangles that the points lie on: those that the path goes through after each.
    #[wasm_bindgen(getter)]
    pub fn triangles(&self) -> Uint32Array {
        self.triangles.as_slice().into()
    }

    /// `#P × 3`, barycentric weights in them.
    #[wasm_bindgen(getter)]
    pub fn weights(&self) -> Float64Array {
        self.weights.as_slice().into()
    }

    /// In the unit of the file.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Of the straight line between both ends, in the unit of the file.
    #[wasm_bindgen(getter)]
    pub fn straight(&self) -> f64 {
        self.straight
    }

    /// What it costs to walk; the length where all costs are 1.
    #[wasm_bindgen(getter)]
    pub fn cost(&self) -> f64 {
        self.cost
    }
}

/// What a closed curve encloses.
#[wasm_bindgen(inspectable)]
pub struct Enclosure(Enclosed);

impl Enclosure {
    pub(crate) fn of(enclosed: Enclosed) -> Self {
        Self(enclosed)
    }
}

#[wasm_bindgen]
impl Enclosure {
    /// Whether there are two sides; else why not.
    #[wasm_bindgen(getter, unchecked_return_type = "'sides' | 'whole' | 'crossed' | 'sideless'")]
    pub fn kind(&self) -> String {
        match self.0 {
            Enclosed::Sides(_) => "sides",
            Enclosed::Whole => "whole",
            Enclosed::Crossed => "crossed",
            Enclosed::Sideless => "sideless",
        }
        .to_owned()
    }

    /// The area of the smaller side, in the unit of the file squared; 0 where there is none.
    #[wasm_bindgen(getter)]
    pub fn area(&self) -> f64 {
        match self.0 {
            Enclosed::Sides([left, right]) => left.min(right),
            _ => 0.0,
        }
    }
}
