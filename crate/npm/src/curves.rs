//! Distance from curves, and isolines.

use std::sync::Arc;

use heatwalk::exact::ExactGeometry;
use heatwalk::{Curve, FaceId, Progress, Sign, curve_distance, signed_curve_distance};
use heatwalk_bindings::{Failure, Message, Result, reporter};
use heatwalk_curves::{Field, Isolines, Levels};
use js_sys::{Float64Array, Function, Object};
use wasm_bindgen::prelude::*;

use crate::given::{count, numbers, property};
use crate::mesh::{Mesh, triangles};
use crate::vectors::coordinates;

/// An isoline of values at vertices.
#[derive(Message)]
pub struct ToldIsoline {
    /// The value.
    pub value: f64,
    /// Its curves.
    #[typescript("IsolineCurve[]")]
    pub curves: JsValue,
    /// Of all its curves.
    pub length: f64,
    /// The area of what is below the value.
    pub enclosed_area: f64,
}

/// A curve of an isoline: larger values are on its left.
#[derive(Message)]
pub struct IsolineCurve {
    /// Three coordinates of each point.
    pub points: Vec<f64>,
    /// The face of each segment.
    pub faces: Vec<u32>,
    /// Whether it returns to its first point.
    pub is_closed: bool,
    /// In the unit of positions.
    pub length: f64,
}

#[wasm_bindgen]
impl Mesh {
    /// The exact distance of each vertex from curves: each an array of places and whether it is closed, in turn; all boundaries where there is no
    /// array. It has a sign where `sign` tells how that is found.
    pub fn curve_distance(
        &self,
        curves: Option<Vec<Float64Array>>,
        are_closed: &[u8],
        sign: Option<String>,
        progress: &Function,
    ) -> Result<Vec<f64>> {
        let (geometry, progress) = (self.geometry(), &mut reporter(progress));
        let curves = self.curves(&geometry, curves, are_closed, progress)?;
        let values = match sign {
            None => curve_distance(&geometry, &curves, progress)?,
            Some(sign) => signed_curve_distance(&geometry, &curves, sign.parse::<Sign>()?, progress)?.values,
        };
        Ok(self.to_inputs(&values, f64::INFINITY))
    }

    /// Isolines of values at vertices: of `levels`, of `count` levels or at multiples of `spacing`.
    pub fn isolines(&self, values: &[f64], options: &Object) -> Result<Vec<ToldIsoline>> {
        let surface = self.surface();
        let (given, vertices) = (values.len(), self.soup().positions.len());
        if given != vertices {
            let sentence = format!("there are {given} values and {vertices} vertices; give one for each");
            return Err(Failure::of("bad-shape", &sentence));
        }
        let field = Field::new(
            surface.positions().iter().copied().collect(),
            surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect(),
            surface.vertices().map(|vertex| values[surface.inputs_of_vertex(vertex)[0].0 as usize]).collect(),
        )
        .map_err(refused)?;
        let given = ["levels", "count", "spacing"].map(|name| property(options, name));
        let levels = match &given {
            [Some(levels), None, None] => Levels::at(&numbers(levels)),
            [None, Some(wanted), None] => Levels::counted(count("count", wanted)?, field.largest()),
            [None, None, Some(spacing)] => Levels::spaced(spacing.as_f64().unwrap_or(f64::NAN), field.largest()),
            _ => return Err(Failure::of("no-level", "give one of levels, count and spacing")),
        };
        let curve = |curve: &heatwalk_curves::Curve| {
            JsValue::from(IsolineCurve {
                points: coordinates(curve.points.iter().copied()),
                faces: triangles(surface, curve.triangles.iter().map(|&face| FaceId(face))),
                is_closed: curve.is_closed,
                length: curve.length,
            })
        };
        let found = Isolines::trace(&field, &levels.map_err(refused)?).isolines;
        let told = found.iter().map(|isoline| ToldIsoline {
            value: isoline.value,
            curves: isoline.curves.iter().map(curve).collect::<js_sys::Array>().into(),
            length: isoline.length,
            enclosed_area: isoline.enclosed_area,
        });
        Ok(told.collect())
    }
}

impl Mesh {
    fn curves(
        &self,
        geometry: &Arc<ExactGeometry>,
        curves: Option<Vec<Float64Array>>,
        are_closed: &[u8],
        progress: Progress<'_>,
    ) -> Result<Vec<Curve>> {
        let Some(curves) = curves else {
            let none = || Failure::of("no-boundary", "the surface has no boundary; give places for the curve");
            return Ok(vec![Curve::boundary(geometry.surface()).ok_or_else(none)?]);
        };
        let curve = |(places, &is_closed): (Float64Array, &u8)| {
            let points = self.points(&places.to_vec())?;
            Ok(Curve::through(geometry, &points, is_closed != 0, progress)?)
        };
        curves.into_iter().zip(are_closed).map(curve).collect()
    }
}

#[allow(clippy::needless_pass_by_value, reason = "as `map_err` gives it")]
fn refused(error: heatwalk_curves::Error) -> Failure {
    Failure::of("bad-isolines", &error.to_string())
}
