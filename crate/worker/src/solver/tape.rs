//! Lengths between two places, and areas within closed curves, beside the field and without touching it.

use heatwalk::{FaceId, Path, PathPoint, Place, Source, Surface, SurfacePoint, enclosed, go_on};
use heatwalk_bindings::Result;
use wasm_bindgen::prelude::*;

use super::Solver;
use crate::measuring::{Enclosure, Leg};
use crate::results::straight;

impl Solver {
    fn ends(&self, from: &JsValue, to: &JsValue) -> Result<[SurfacePoint; 2]> {
        let surface = self.solver.surface();
        Ok([self.drawn.point(surface, from)?, self.drawn.point(surface, to)?])
    }

    fn leg(&self, path: &Path) -> Leg {
        let surface = &**self.solver.surface();
        let numbers = self.drawn.triangles();
        let face_of = |point: &PathPoint| {
            let faces = point.location.faces(surface);
            if faces.contains(&point.face) { point.face } else { faces[0] }
        };
        let faces: Vec<_> = path.points.iter().map(face_of).collect();
        let weights =
            path.points.iter().zip(&faces).flat_map(|(point, &face)| point.location.weights_in(surface, face));
        Leg {
            triangles: faces.iter().map(|&face| numbers[face]).collect(),
            weights: weights.collect(),
            length: path.length(),
            straight: straight(path),
            cost: self.solver.cost_of(path),
        }
    }

    /// The path of a leg with these places.
    fn path_of(&self, surface: &Surface, triangles: &[u32], weights: &[f64]) -> Result<Path> {
        let point = |(&triangle, &weights): (&u32, &[f64; 3])| {
            // A triangle that there is none of is for the surface to name.
            let face = self.drawn.face(triangle).unwrap_or(FaceId(triangle));
            let location = surface.point(Place::Face { face, weights })?.place().reduced(surface);
            Ok(PathPoint { position: location.position(surface), location, face })
        };
        let points: Result<Vec<_>> = triangles.iter().zip(weights.as_chunks().0).map(point).collect();
        Ok(Path::new(surface, points?))
    }
}

#[wasm_bindgen]
impl Solver {
    /// Searches the exact path between two places by about `work` windows further; none until it is found. The next call
    /// goes on where it is for the same places on the same ground.
    pub fn measure(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] from: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] to: &JsValue,
        work: u32,
    ) -> Result<Option<Leg>> {
        let [from, to] = self.ends(from, to)?;
        let path = self.solver.search_path(&mut self.measuring, from, &[Source::from(to)], work as usize)?;
        Ok(path.map(|path| self.leg(&path)))
    }

    /// A path between two places that is locally shortest, or of locally least cost where costs differ.
    pub fn estimate(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] from: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] to: &JsValue,
    ) -> Result<Leg> {
        let [from, to] = self.ends(from, to)?;
        let path = self.solver.path_between(from, to, &mut go_on)?;
        Ok(self.leg(&path))
    }

    /// What a closed curve of legs encloses: `triangles` and `weights` of all of them, and how many points each has.
    pub fn enclosed(&self, triangles: &[u32], weights: &[f64], counts: &[u32]) -> Result<Enclosure> {
        let surface = self.solver.surface();
        let (mut triangles, mut weights) = (triangles, weights);
        let mut paths = Vec::with_capacity(counts.len());
        for &count in counts {
            let count = (count as usize).min(triangles.len()).min(weights.len() / 3);
            let (these, rest) = triangles.split_at(count);
            let (shares, others) = weights.split_at(3 * count);
            (triangles, weights) = (rest, others);
            paths.push(self.path_of(surface, these, shares)?);
        }
        Ok(enclosed(surface, &paths)?.into())
    }
}
