//! Directions at places, carried over the surface and as axes of a log map.

use glam::DVec3;
use heatwalk::{LogMapSearch, Place, go_on, transport};
use heatwalk_bindings::{Failure, Result, transform};
use heatwalk_surface::triangle;
use wasm_bindgen::prelude::*;

use crate::files::in_file;
use crate::surface::ExactSurface;

#[wasm_bindgen]
impl ExactSurface {
    /// `#F × 3`: unit vectors of the triangles, as they are drawn, to which directions at places are carried along shortest paths, each from
    /// the nearest place; zero where none comes. Of each place a triangle, three weights of its corners and the direction as it is drawn.
    ///
    /// # Errors
    /// As [`transport`] has; for a triangle that there is none of; as [`transform`] has.
    pub fn carried(
        &self,
        triangles: &[u32],
        weights: &[f64],
        directions: &[f64],
        #[wasm_bindgen(unchecked_param_type = "DrawTransform")] drawn: &JsValue,
    ) -> Result<Vec<f32>> {
        let drawn = transform(drawn)?;
        let surface = self.surface();
        let places = self.places(triangles, weights)?;
        let directions =
            directions.as_chunks().0.iter().map(|&direction| in_file(drawn.up, DVec3::from_array(direction)));
        let vectors: Vec<(Place, DVec3)> = places.into_iter().zip(directions).collect();
        let carried = transport(self.geometry(), &vectors, &mut go_on)?;
        let last = self.kept().last().map_or(0, |kept| kept.triangle as usize + 1);
        let mut of_triangles = vec![DVec3::ZERO; last];
        for kept in self.kept() {
            let known = surface.faces()[kept.face]
                .map(|vertex| carried[vertex])
                .into_iter()
                .filter(|vector| vector.is_finite());
            let normal = surface.face_normal(kept.face);
            let sum: DVec3 = known.map(triangle::unit).sum();
            let along = sum - sum.dot(normal) * normal;
            if triangle::length(along) > 0.0 {
                of_triangles[kept.triangle as usize] = triangle::unit(along);
            }
        }
        Ok(drawn.directions(of_triangles))
    }

    /// `#V × 2`, u and v of the log map of a place, by the vertices that the surface was made of; not numbers where it is not known. u is along a
    /// direction as it is drawn where the axis `up` is drawn upward.
    ///
    /// # Errors
    /// As [`LogMapSearch::new`] has, and for a direction that is none, or square to the surface.
    pub fn log_map(
        &self,
        triangle: u32,
        weights: &[f64],
        direction: &[f64],
        #[wasm_bindgen(unchecked_param_type = "Up")] up: &str,
    ) -> Result<Vec<f64>> {
        let direction = direction.try_into().map(DVec3::from_array);
        let direction = direction.map_err(|_| Failure::misuse("a direction is three numbers"))?;
        let mut search = LogMapSearch::new(self.geometry(), self.surface().point(self.place(triangle, weights)?)?)?;
        while !search.advance(f64::INFINITY, usize::MAX)? {}
        let map = search.map(Some(in_file(up.parse()?, direction)))?;
        let part =
            |k: usize| self.surface().to_inputs(&map.coordinates.iter().map(|place| place[k]).collect(), f64::NAN);
        let [u, v] = [part(0), part(1)];
        Ok(u.into_iter().zip(v).flat_map(|(u, v)| [u, v]).collect())
    }
}
