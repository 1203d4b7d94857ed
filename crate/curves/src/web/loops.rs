//! Loops around handles.

use heatwalk::{Path, go_on, handle_loops};
use heatwalk_bindings::{Result, transform};
use wasm_bindgen::prelude::*;

use super::files::{FileUnit, scaled_file};
use super::surface::ExactSurface;
use crate::field::Field;
use crate::isolines::{Curve, Isoline, Isolines, Kind};

/// Closed curves on a surface.
#[wasm_bindgen]
pub struct Loops {
    field: Field,
    curves: Isolines,
}

#[wasm_bindgen]
impl ExactSurface {
    /// Closed geodesics around handles and through them, the shortest first; none where there is no handle.
    ///
    /// # Errors
    /// Where there is no memory.
    pub fn handle_loops(&self) -> Result<Loops> {
        let loops = handle_loops(self.surface(), &mut go_on)?;
        let isoline = |path: &Path| {
            // The last point is the first one.
            let around = &path.points[..path.points.len() - 1];
            let triangle = |face| self.number(self.surface().triangle_of_face(face).0).unwrap_or_default();
            let curve = Curve {
                points: around.iter().map(|point| point.position).collect(),
                triangles: around.iter().map(|point| triangle(point.face)).collect(),
                is_closed: true,
                length: path.length(),
            };
            Isoline { value: path.length(), curves: vec![curve], length: path.length(), enclosed_area: 0.0 }
        };
        let curves = Isolines { kind: Kind::Loops, isolines: loops.iter().map(isoline).collect() };
        Ok(Loops { field: self.field(vec![0.0; self.surface().vertex_count()])?, curves })
    }
}

#[wasm_bindgen]
impl Loops {
    /// The length of each, in the unit of positions.
    #[must_use]
    pub fn lengths(&self) -> Vec<f64> {
        self.curves.isolines.iter().map(|isoline| isoline.length).collect()
    }

    /// `#segments × 2 × 3`, ends of the segments of all of them, as they are drawn.
    ///
    /// # Errors
    /// As [`transform`].
    pub fn ends(&self, #[wasm_bindgen(unchecked_param_type = "DrawTransform")] drawn: &JsValue) -> Result<Vec<f32>> {
        Ok(transform(drawn)?.places(self.curves.points_of_segments()))
    }

    /// A file of them, as `Cells.file` writes borders.
    ///
    /// # Errors
    /// As that has.
    pub fn file(
        &self,
        kind: &str,
        toward_eye: &[f64],
        #[wasm_bindgen(unchecked_param_type = "Up")] up: &str,
        unit: FileUnit,
    ) -> Result<Vec<u8>> {
        scaled_file(kind, (&self.curves, &self.field), (toward_eye, up), unit)
    }
}
