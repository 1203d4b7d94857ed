//! The interface to JavaScript.

use glam::{DMat4, DVec2, DVec3};
use wasm_bindgen::prelude::*;

use crate::error::Error;
use crate::field::Field;
use crate::isolines::{Isoline, Isolines};
use crate::levels::Levels;
use crate::sheet::Sheet;
use crate::strips::Strips;
use crate::write;

/// Isolines of a field, and all that is made of them.
#[wasm_bindgen]
pub struct Curves {
    field: Field,
    levels: Levels,
    isolines: Isolines,
}

impl From<Error> for JsValue {
    fn from(error: Error) -> Self {
        JsError::new(&error.to_string()).into()
    }
}

#[wasm_bindgen]
impl Curves {
    /// Traces isolines: `positions` are `#V × 3`, `triangles` `#F × 3`, `distances` `#V`. They are at these `values` or, where there
    /// are none, at the multiples of a `spacing`.
    ///
    /// # Errors
    /// As [`Field::new`] and [`Levels`].
    #[wasm_bindgen(constructor)]
    pub fn new(
        positions: &[f64],
        triangles: &[u32],
        distances: Vec<f64>,
        values: &[f64],
        spacing: f64,
    ) -> Result<Self, Error> {
        let positions = positions.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
        let field = Field::new(positions, triangles.as_chunks().0.to_vec(), distances)?;
        let levels = match values {
            [] => Levels::spaced(spacing, field.largest())?,
            values => Levels::at(values)?,
        };
        let isolines = Isolines::trace(&field, &levels);
        Ok(Self { field, levels, isolines })
    }

    /// `#isolines × 5`: value, length, enclosed area, how many curves, and how many of them are closed.
    pub fn table(&self) -> Vec<f64> {
        let row = |isoline: &Isoline| {
            let closed = isoline.curves.iter().filter(|curve| curve.is_closed).count();
            [isoline.value, isoline.length, isoline.enclosed_area, isoline.curves.len() as f64, closed as f64]
        };
        self.isolines.isolines.iter().flat_map(row).collect()
    }

    /// `#segments × 2 × 3`, ends of all segments, in the field's unit.
    pub fn ends(&self) -> Vec<f64> {
        let curves = self.isolines.isolines.iter().flat_map(|isoline| &isoline.curves);
        let segments = curves.flat_map(|curve| curve.segments().collect::<Vec<_>>());
        segments.flat_map(|ends| ends.map(|end| end.to_array())).flatten().collect()
    }

    /// A file of the curves: "obj", "dxf", "csv" or "glb"; "strips.obj", of the surface cut along them; "unrolled.svg" or
    /// "unrolled.dxf", of its strips in the plane.
    ///
    /// # Errors
    /// Where a strip is curved, or for another kind of file.
    pub fn file(&self, kind: &str) -> Result<Vec<u8>, JsValue> {
        let strips = || Strips::cut(&self.field, &self.levels);
        Ok(match kind {
            "obj" => write::obj(&self.isolines),
            "dxf" => write::dxf(&self.isolines),
            "csv" => write::csv(&self.isolines),
            "glb" => write::glb(&self.isolines),
            "strips.obj" => write::strips_obj(&strips()?),
            "unrolled.svg" | "unrolled.dxf" => {
                let strips = strips()?;
                let sheet = Sheet::unroll(&strips)?;
                if kind == "unrolled.svg" { write::sheet_svg(&sheet, &strips) } else { write::sheet_dxf(&sheet, &strips) }
            }
            _ => return Err(JsError::new("there is no such file of curves").into()),
        })
    }

    /// An SVG of what is seen of them by a matrix from the field's unit to clip space, by columns, in a picture of so many pixels.
    ///
    /// # Errors
    /// For a matrix that is not 16 numbers.
    pub fn svg(&self, clip_from_field: &[f64], width: f64, height: f64) -> Result<Vec<u8>, JsError> {
        let columns = clip_from_field.try_into().map_err(|_| JsError::new("a matrix is 16 numbers"))?;
        let view = write::View { clip_from_field: DMat4::from_cols_array(columns), size: DVec2::new(width, height) };
        Ok(write::svg(&self.isolines, &self.field, &view))
    }
}
