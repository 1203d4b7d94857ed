//! Signed distance from curves, its isolines, and files of these.

use std::sync::Arc;

use heatwalk::exact::ExactGeometry;
use heatwalk::{Curve, Place, Sign, SignedDistance, go_on, signed_curve_distance};
use heatwalk_bindings::{Failure, Result, transform};
use heatwalk_curves::{Field, Isolines, Levels, MOST_ROUNDS, Places, Refined, is_continuous};
use heatwalk_surface::triangle;
use wasm_bindgen::prelude::*;

use crate::files::{FileUnit, scaled_file};
use crate::surface::{ExactSurface, Kept};
use heatwalk_curves::clip::{WHOLE, below, fan};

/// Triangles that are searched for isolines that follow the distance itself, at most, all searches together.
const SEARCHED: usize = 1_000_000;

/// The exact distance from curves, with the side as its sign, and its isolines.
#[wasm_bindgen]
pub struct CurveDistance {
    geometry: Arc<ExactGeometry>,
    curves: Vec<Curve>,
    /// With another sign where `turn` is −1.
    signed: SignedDistance,
    /// −1 where what is left of the curves is the larger part, and is outside therefore.
    turn: f64,
    /// `#V`.
    values: Vec<f64>,
    on: ExactSurface,
    field: Field,
    isolines: Option<Isolines>,
}

#[wasm_bindgen]
impl ExactSurface {
    /// Distance from curves: so many places each (`counts`), whether each is closed, and of each place a triangle and three weights of its
    /// corners. From place to place curves follow shortest paths. Inside, which has negative values, is what is on the left of the curves
    /// or, where that is larger, on the right.
    ///
    /// # Errors
    /// For a curve of less than two places, places that no path joins, a triangle that there is none of, and where there is no memory.
    pub fn curve_distance(
        &self,
        counts: &[u32],
        closed: &[u8],
        triangles: &[u32],
        weights: &[f64],
    ) -> Result<CurveDistance> {
        let (geometry, surface) = (self.geometry(), self.surface());
        let mut places = self.places(triangles, weights)?.into_iter();
        let mut curves = Vec::with_capacity(counts.len());
        for (&count, &closed) in counts.iter().zip(closed) {
            let places: Vec<Place> = places.by_ref().take(count as usize).collect();
            curves.push(Curve::through(geometry, &places, closed != 0, &mut go_on)?);
        }
        let signed = signed_curve_distance(geometry, &curves, Sign::Auto, &mut go_on)?;
        let values = &signed.values;
        // A part without an end has no inside.
        let mut areas = [0.0; 2];
        for kept in self.kept() {
            let [a, b, c] = surface.faces()[kept.face].map(|vertex| values[vertex]);
            let area = triangle::length(triangle::area_vector(surface.corners(kept.face)));
            areas[usize::from(a + b + c > 0.0)] += area;
        }
        let turn = if areas[0] > areas[1] { -1.0 } else { 1.0 };
        let values: Vec<f64> = values.iter().map(|&value| turned(value, turn)).collect();
        let field = self.continuous(&values)?;
        let (geometry, on) = (Arc::clone(geometry), self.clone());
        Ok(CurveDistance { geometry, curves, signed, turn, values, on, field, isolines: None })
    }
}

/// What is not reached stays infinite.
fn turned(value: f64, turn: f64) -> f64 {
    if value.is_finite() { turn * value } else { f64::INFINITY }
}

impl ExactSurface {
    /// The field of signed values, without the triangles on which these jump.
    fn continuous(&self, values: &[f64]) -> Result<Field> {
        let whole = self.field(values.to_vec())?;
        let goes_on = |&&corners: &&[u32; 3]| {
            let corners = corners.map(|vertex| vertex as usize);
            is_continuous(corners.map(|vertex| whole.positions()[vertex]), corners.map(|vertex| values[vertex]))
        };
        let triangles = whole.triangles().iter().filter(goes_on).copied().collect();
        Ok(Field::new(whole.positions().to_vec(), triangles, values.to_vec())?)
    }
}

#[wasm_bindgen]
impl CurveDistance {
    /// `#F × 3`: the values at the corners of so many triangles; infinite where none is reached.
    #[must_use]
    pub fn values(&self, triangles: u32) -> Vec<f32> {
        let mut values = vec![f32::INFINITY; 3 * triangles as usize];
        for (kept, of) in self.on.kept().iter().zip(self.whole()) {
            for k in 0..3 {
                values[3 * kept.triangle as usize + k] = of[k] as f32;
            }
        }
        values
    }

    /// The smallest of the values, and the largest.
    #[must_use]
    pub fn range(&self) -> Vec<f64> {
        let finite = || self.values.iter().copied().filter(|value| value.is_finite());
        vec![finite().fold(0.0, f64::min), finite().fold(0.0, f64::max)]
    }

    /// `#T × 2`: 0 inside and 1 outside, of each triangle of the surface divided where the values are 0, and the triangle that it is part of.
    #[must_use]
    pub fn tiles(&self) -> Vec<u32> {
        self.parts().flat_map(|(side, triangle, _)| [side, triangle]).collect()
    }

    /// `#T × 3 × 3`: the weights of their corners there.
    #[must_use]
    pub fn corners(&self) -> Vec<f32> {
        self.parts().flat_map(|(_, _, corners)| corners).flatten().map(|weight| weight as f32).collect()
    }

    /// Traces isolines at the multiples of a spacing on both sides. They follow the distance itself as far as a number of searches find it. Whether they do.
    ///
    /// # Errors
    /// For a spacing by which there are too many, and where there is no memory.
    pub fn trace(&mut self, spacing: f64) -> Result<bool> {
        let [least, most] = [self.range()[0], self.range()[1]];
        let multiples = |end: f64| (0..).map(|step| f64::from(step) * spacing).take_while(move |&value| value < end);
        let count = (most - least) / spacing;
        // As many are refused in one sentence, whichever side they are on.
        let levels = if count.is_finite() && count < 1e5 {
            let values: Vec<f64> = multiples(most).chain(multiples(-least).skip(1).map(|value| -value)).collect();
            Levels::at(&values)?
        } else {
            Levels::spaced(spacing, most - least)?
        };
        let faces: Vec<_> = self.faces();
        let rounds = (SEARCHED / self.on.surface().face_count().max(1)).clamp(1, MOST_ROUNDS);
        let ask = |places: &Places| -> Result<Option<Vec<f64>>> {
            let place = |(&triangle, &weights): (&u32, &[f64; 3])| {
                let kept = &self.on.kept()[faces[triangle as usize]];
                Place::Face { face: kept.face, weights: kept.weights(weights) }
            };
            let places: Vec<Place> = places.triangles.iter().zip(&places.weights).map(place).collect();
            let at = self.signed.at(&self.geometry, &self.curves, &places, &mut go_on)?;
            Ok(Some(at.into_iter().map(|value| turned(value, self.turn)).collect()))
        };
        let Refined { field, is_true } = self.on.continuous(&self.values)?.refined(&levels, rounds, ask)?;
        self.isolines = Some(Isolines::trace(&field, &levels));
        self.field = field;
        Ok(is_true)
    }

    /// `#segments × 2 × 3`, ends of the segments of all isolines, as they are drawn.
    ///
    /// # Errors
    /// As [`transform`], and where none were traced.
    pub fn ends(&self, #[wasm_bindgen(unchecked_param_type = "DrawTransform")] drawn: &JsValue) -> Result<Vec<f32>> {
        Ok(transform(drawn)?.places(self.traced()?.points_of_segments()))
    }

    /// A file of the isolines, as `Cells.file` writes borders.
    ///
    /// # Errors
    /// As that has, and where none were traced.
    pub fn file(
        &self,
        kind: &str,
        toward_eye: &[f64],
        #[wasm_bindgen(unchecked_param_type = "Up")] up: &str,
        unit: FileUnit,
    ) -> Result<Vec<u8>> {
        scaled_file(kind, (self.traced()?, &self.field), (toward_eye, up), unit)
    }
}

impl CurveDistance {
    fn traced(&self) -> Result<&Isolines> {
        self.isolines.as_ref().ok_or_else(|| Failure::misuse("no isolines were traced"))
    }

    /// The values at the corners of each triangle that is kept.
    fn whole(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        let surface = self.on.surface();
        let vertices = |kept: &Kept| kept.corners.map(|k| surface.faces()[kept.face][k]);
        self.on.kept().iter().map(vertices).map(|corners| corners.map(|vertex| self.values[vertex.0 as usize]))
    }

    /// Which of those kept the triangles of the field are.
    fn faces(&self) -> Vec<usize> {
        let surface = self.on.surface();
        let goes_on = |(index, values): (usize, [f64; 3])| {
            let kept = &self.on.kept()[index];
            let corners = kept.corners.map(|k| surface.corners(kept.face)[k]);
            is_continuous(corners, values).then_some(index)
        };
        self.whole().enumerate().filter_map(goes_on).collect()
    }

    /// Triangles, or parts of them, on one side: that side, the triangle and the weights of its corners.
    fn parts(&self) -> impl Iterator<Item = (u32, u32, [[f64; 3]; 3])> + '_ {
        self.on.kept().iter().zip(self.whole()).flat_map(|(kept, values)| {
            let is_reached = values.iter().all(|value| value.is_finite());
            let side = |side: u32, sign: f64| {
                let part = if is_reached { below(&WHOLE, values.map(|value| sign * value)) } else { Vec::new() };
                fan(&part).map(|corners| (side, kept.triangle, corners)).collect::<Vec<_>>()
            };
            // What lies on the curve is on both sides, and once outside.
            let has_inside = values.iter().any(|&value| value < 0.0);
            let has_outside = values.iter().any(|&value| value > 0.0) || !has_inside;
            let inside = if has_inside { side(0, 1.0) } else { Vec::new() };
            inside.into_iter().chain(if has_outside { side(1, -1.0) } else { Vec::new() })
        })
    }
}
