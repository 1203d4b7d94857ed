//! Curves along paths: loops around handles and through places, and Bézier curves.

use heatwalk::{Error, Path, bezier, geodesic_loop, go_on, handle_loops};
use heatwalk_bindings::{Result, transform};
use heatwalk_curves::{Curve, Field, Isoline, Isolines, Kind, PathKind};
use wasm_bindgen::prelude::*;

use crate::files::{FileUnit, scaled_file};
use crate::surface::ExactSurface;

/// Curves of paths on a surface.
#[wasm_bindgen]
pub struct Paths {
    field: Field,
    curves: Isolines,
}

#[wasm_bindgen]
impl ExactSurface {
    /// Closed geodesics around handles and through them, the shortest first; none where there is no handle.
    ///
    /// # Errors
    /// Where there is no memory.
    pub fn handle_loops(&self) -> Result<Paths> {
        let loops = handle_loops(self.surface(), &mut go_on)?;
        self.paths(PathKind::HandleLoops, &loops)
    }

    /// A closed curve through places in their order, as `heatwalk::geodesic_loop` finds it: of each place a triangle, and three weights of its
    /// corners. None where it shrinks to a point.
    ///
    /// # Errors
    /// As [`geodesic_loop`] has else; for a triangle that there is none of.
    pub fn loop_through(&self, triangles: &[u32], weights: &[f64]) -> Result<Paths> {
        match geodesic_loop(self.geometry(), &self.places(triangles, weights)?, &mut go_on) {
            Err(Error::Contractible) => self.paths(PathKind::Loop, &[]),
            found => self.paths(PathKind::Loop, &[found?]),
        }
    }

    /// The Bézier curve that places control, given in the same way.
    ///
    /// # Errors
    /// As [`bezier`] has; for a triangle that there is none of.
    pub fn bezier(&self, triangles: &[u32], weights: &[f64]) -> Result<Paths> {
        let found = bezier(self.geometry(), &self.places(triangles, weights)?, &mut go_on)?;
        self.paths(PathKind::Bezier, &[found.path])
    }
}

impl ExactSurface {
    /// Paths as curves; those that are closed have their first point at the end too.
    fn paths(&self, kind: PathKind, paths: &[Path]) -> Result<Paths> {
        let are_closed = kind != PathKind::Bezier;
        let triangle = |face| self.number(self.surface().triangle_of_face(face).0).unwrap_or_default();
        let isoline = |path: &Path| {
            let ends = path.points.len() - 1;
            let points = &path.points[..if are_closed { ends } else { ends + 1 }];
            let curve = Curve {
                points: points.iter().map(|point| point.position).collect(),
                triangles: path.points[..ends].iter().map(|point| triangle(point.face)).collect(),
                is_closed: are_closed,
                length: path.length(),
            };
            Isoline { value: path.length(), curves: vec![curve], length: path.length(), enclosed_area: 0.0 }
        };
        let curves = Isolines { kind: Kind::Paths(kind), isolines: paths.iter().map(isoline).collect() };
        Ok(Paths { field: self.field(vec![0.0; self.surface().vertex_count()])?, curves })
    }
}

#[wasm_bindgen]
impl Paths {
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
