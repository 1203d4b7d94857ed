//! Isolines, and what is made of them.

use glam::DVec3;
use heatwalk_bindings::{Failure, Message, Result, transform};
use heatwalk_curves::{Field, Isoline, Isolines, Kind, Levels, MOST_ROUNDS, Places, Refined, Sheet, Strips, write};
use js_sys::{Float64Array, Function, Uint32Array};
use wasm_bindgen::prelude::*;

use crate::files::{curve_file, picture, unit_of, without_unit};

/// Isolines of a field, and all that is made of them.
#[wasm_bindgen]
pub struct Curves {
    field: Field,
    levels: Levels,
    isolines: Isolines,
    is_true: bool,
    /// Of the last file, what strips that it has not are between.
    left_out: Vec<[Option<f64>; 2]>,
    flat_spacing: Option<f64>,
}

/// An isoline, in the unit of the file.
#[derive(Message)]
pub struct IsolineRow {
    /// The distance that it is at.
    pub value: f64,
    /// How long it is.
    pub length: f64,
    /// What area is nearer.
    pub area: f64,
    /// How many curves it has.
    pub curves: usize,
    /// How many of them are closed.
    pub closed: usize,
}

#[wasm_bindgen]
impl Curves {
    /// Traces isolines: `positions` are `#V × 3`, `triangles` `#F × 3`, `distances` `#V`. They are at these `values` or, where there
    /// are none, at the multiples of a `spacing`. Where distances are exact, `ask` gives those at other places, which are triangles
    /// and three weights each, or nothing where they are not known: isolines follow them then.
    ///
    /// # Errors
    /// As [`Field::new`] and [`Levels`], and what `ask` throws.
    #[wasm_bindgen(constructor)]
    pub fn new(
        positions: &[f64],
        triangles: &[u32],
        distances: Vec<f64>,
        values: &[f64],
        spacing: f64,
        #[wasm_bindgen(
            unchecked_param_type = "((triangles: Uint32Array, weights: Float64Array) => Float64Array | undefined) | undefined"
        )]
        ask: &JsValue,
    ) -> Result<Self> {
        let positions = positions.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
        let field = Field::new(positions, triangles.as_chunks().0.to_vec(), distances)?;
        let levels = match values {
            [] => Levels::spaced(spacing, field.largest())?,
            values => Levels::at(values)?,
        };
        let Refined { field, is_true } = match ask.dyn_ref::<Function>() {
            Some(ask) => field.refined(&levels, MOST_ROUNDS, |places| distances_at(ask, places))?,
            None => Refined { field, is_true: false },
        };
        let isolines = Isolines::trace(&field, &levels);
        Ok(Self { field, levels, isolines, is_true, left_out: Vec::new(), flat_spacing: None })
    }

    /// The same, called a girth in files.
    #[must_use]
    pub fn into_girth(mut self) -> Self {
        self.isolines.kind = Kind::Girth;
        self
    }

    /// Whether lengths are right to about a thousandth: isolines follow the distance itself, and are no chords of triangles.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn is_true(&self) -> bool {
        self.is_true
    }

    /// The isolines, by value.
    #[must_use]
    pub fn rows(&self) -> Vec<IsolineRow> {
        let row = |isoline: &Isoline| IsolineRow {
            value: isoline.value,
            length: isoline.length,
            area: isoline.enclosed_area,
            curves: isoline.curves.len(),
            closed: isoline.curves.iter().filter(|curve| curve.is_closed).count(),
        };
        self.isolines.isolines.iter().map(row).collect()
    }

    /// `#segments × 2 × 3`, ends of all segments, as they are drawn.
    ///
    /// # Errors
    /// For a center that is not three numbers, or an axis that there is not.
    pub fn ends(&self, #[wasm_bindgen(unchecked_param_type = "DrawTransform")] drawn: &JsValue) -> Result<Vec<f32>> {
        Ok(transform(drawn)?.places(self.isolines.points_of_segments()))
    }

    /// A file of the curves: "obj", "dxf", "csv" or "glb"; "strips.obj", of the surface cut along them; "unrolled.svg",
    /// "unrolled.dxf" or "unrolled.pdf", of its strips in the plane. `unit`: the symbol of that of all lengths; empty where there is none.
    ///
    /// # Errors
    /// Where all strips are curved, for a PDF without a unit, or for another kind of file.
    pub fn file(&mut self, kind: &str, unit: &str) -> Result<Vec<u8>> {
        let unit = unit_of(unit);
        let strips = || Strips::cut(&self.field, &self.levels);
        self.left_out.clear();
        self.flat_spacing = None;
        Ok(match kind {
            "strips.obj" => write::strips_obj(&strips()?, unit),
            "unrolled.svg" | "unrolled.dxf" | "unrolled.pdf" => {
                let strips = strips()?;
                let sheet = Sheet::unroll(&self.field, &strips)?;
                self.left_out = sheet.strips_left_out().into_iter().map(|strip| strips.bounds(strip)).collect();
                self.flat_spacing = sheet.flat_spacing(&self.field, &strips);
                match kind {
                    "unrolled.svg" => write::sheet_svg(&sheet, &strips, unit),
                    "unrolled.dxf" => write::sheet_dxf(&sheet, &strips, unit),
                    _ => write::sheet_pdf(&sheet, unit.ok_or_else(without_unit)?),
                }
            }
            _ => curve_file(kind, &self.isolines, unit)?,
        })
    }

    /// The strips that the last file leaves out since they are curved: two distances that each lies between, negative for no bound.
    #[must_use]
    pub fn left_out(&self) -> Vec<f64> {
        self.left_out.iter().flat_map(|bounds| bounds.map(|bound| bound.unwrap_or(-1.0))).collect()
    }

    /// A spacing by which it would leave out none, where there is one.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn flat_spacing(&self) -> Option<f64> {
        self.flat_spacing
    }

    /// "svg" or "pdf" of what is seen of them from far away, in this direction as it is drawn where the axis `up` is drawn upward.
    ///
    /// # Errors
    /// For no direction, an axis that there is not, or a PDF without a unit.
    pub fn picture(
        &self,
        kind: &str,
        toward_eye: &[f64],
        #[wasm_bindgen(unchecked_param_type = "Up")] up: &str,
        unit: &str,
    ) -> Result<Vec<u8>> {
        picture(kind, (&self.isolines, &self.field), (toward_eye, up), unit_of(unit))
    }
}

/// The distances at places, as JavaScript gives them; none where it gives none.
fn distances_at(ask: &Function, places: &Places) -> Result<Option<Vec<f64>>> {
    let triangles = Uint32Array::from(places.triangles.as_slice());
    let weights = Float64Array::from(places.weights.as_flattened());
    let answer = ask.call2(&JsValue::NULL, &triangles.into(), &weights.into());
    let answer = answer.map_err(|_| Failure::misuse("distances at places could not be had"))?;
    Ok(answer.dyn_ref::<Float64Array>().map(Float64Array::to_vec))
}
