//! A surface with exact distances, whose triangles keep their numbers.

use std::sync::Arc;

use glam::DVec3;
use heatwalk::exact::ExactGeometry;
use heatwalk::{DistanceSolver, FaceId, Place, Soup, Surface, Walls, WeldRule};
use heatwalk_base::parallel;
use heatwalk_bindings::{Failure, Result};
use heatwalk_curves::Field;
use wasm_bindgen::prelude::*;

/// A surface on which exact distances are found. A copy has the same triangles, ready to be searched.
#[wasm_bindgen]
#[derive(Clone)]
pub struct ExactSurface {
    geometry: Arc<ExactGeometry>,
    /// In their order.
    kept: Arc<[Kept]>,
}

/// A triangle that is a face of the surface.
pub(super) struct Kept {
    pub triangle: u32,
    pub face: FaceId,
    /// Of its corners, which corner of the face each is.
    pub corners: [usize; 3],
}

impl Kept {
    /// Weights of its corners as those of the face's.
    pub fn weights(&self, weights: [f64; 3]) -> [f64; 3] {
        let mut of_face = [0.0; 3];
        for (corner, weight) in self.corners.into_iter().zip(weights) {
            of_face[corner] = weight;
        }
        of_face
    }
}

#[wasm_bindgen]
impl ExactSurface {
    /// `positions` are `#V × 3`, `triangles` `#F × 3`; vertices in one place are apart where their numbers differ. Components are joined
    /// by a rule and so many links, as by the solver.
    ///
    /// # Errors
    /// As building a surface has, and for another rule.
    #[wasm_bindgen(constructor)]
    pub fn new(positions: &[f64], triangles: &[u32], rule: &str, links: u32) -> Result<Self> {
        let positions = positions.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
        Self::of(&Soup::single("surface", positions, triangles.as_chunks().0.to_vec()), rule, links)
    }
}

impl ExactSurface {
    /// Of the triangles of a soup.
    pub(super) fn of(soup: &Soup, rule: &str, links: u32) -> Result<Self> {
        let mut solver = DistanceSolver::new(Surface::build_by(soup, WeldRule::Exact, parallel::ONE)?);
        let whole = Arc::clone(solver.whole());
        solver.join(&whole, rule.parse()?, links as usize)?;
        solver.set_walls(&Walls { faces: Vec::new(), edges: whole.seams() })?;
        let kept = whole.faces_in_input_order().map(|face| {
            let triangle = whole.triangle_of_face(face).0;
            let inputs = whole.inputs_of_face(face);
            let corner = |vertex: u32| inputs.iter().position(|input| input.0 == vertex).unwrap_or_default();
            Kept { triangle, face, corners: soup.triangles[triangle as usize].map(corner) }
        });
        Ok(Self { kept: kept.collect(), geometry: Arc::clone(solver.exact_geometry()) })
    }

    pub(super) fn surface(&self) -> &Surface {
        self.geometry.surface()
    }

    pub(super) fn geometry(&self) -> &Arc<ExactGeometry> {
        &self.geometry
    }

    /// What is kept, in the order of the triangles.
    pub(super) fn kept(&self) -> &[Kept] {
        &self.kept
    }

    /// The field of values of the surface's vertices, on what is kept.
    ///
    /// # Errors
    /// As [`Field::new`].
    pub(super) fn field(&self, values: Vec<f64>) -> Result<Field> {
        let surface = self.surface();
        let vertices = |kept: &Kept| kept.corners.map(|corner| surface.faces()[kept.face][corner].0);
        Ok(Field::new(surface.positions().iter().copied().collect(), self.kept.iter().map(vertices).collect(), values)?)
    }

    /// The place of a triangle with three weights of its corners.
    ///
    /// # Errors
    /// Where there is no such triangle, or not three weights.
    pub(super) fn place(&self, triangle: u32, weights: &[f64]) -> Result<Place> {
        let kept = &self.kept[self.number(triangle).ok_or_else(no_triangle)? as usize];
        let weights = weights.try_into().map_err(|_| Failure::misuse("a triangle has three weights"))?;
        Ok(Place::Face { face: kept.face, weights: kept.weights(weights) })
    }

    /// Places of triangles with three weights each, one after another.
    ///
    /// # Errors
    /// As [`Self::place`].
    pub(super) fn places(&self, triangles: &[u32], weights: &[f64]) -> Result<Vec<Place>> {
        triangles.iter().zip(weights.chunks(3)).map(|(&triangle, weights)| self.place(triangle, weights)).collect()
    }

    /// Places as four numbers each, a triangle and the weights of its corners.
    pub(super) fn numbers(&self, places: impl Iterator<Item = Place>) -> Vec<f64> {
        let surface = self.surface();
        let of_place = |place: Place| {
            let face = place.faces(surface)[0];
            let triangle = surface.triangle_of_face(face).0;
            let weights = place.weights_in(surface, face);
            let corners = self.number(triangle).map_or([0, 1, 2], |number| self.kept[number as usize].corners);
            let [a, b, c] = corners.map(|corner| weights[corner]);
            [f64::from(triangle), a, b, c]
        };
        places.flat_map(of_place).collect()
    }

    /// Which of those kept a triangle is.
    pub(super) fn number(&self, triangle: u32) -> Option<u32> {
        self.kept.binary_search_by_key(&triangle, |kept| kept.triangle).ok().map(|number| number as u32)
    }
}

pub(super) fn no_triangle() -> Failure {
    Failure::misuse("there is no such triangle")
}
