//! Cells of sources.

use std::sync::Arc;

use glam::DVec3;
use heatwalk::{
    CellMap, CellSearch, DistanceSolver, FaceId, Place, SampleCount, Soup, Source, Surface, Walls, WeldRule,
    farthest_samples, go_on, relaxed,
};
use heatwalk_base::parallel;
use heatwalk_bindings::{Failure, Result, transform};
use wasm_bindgen::prelude::*;

use super::distances::FileUnit;
use super::files::{curve_file, picture};
use crate::borders::Borders;
use crate::field::Field;

/// A surface on which cells are found, and the search under way.
#[wasm_bindgen]
pub struct CellSurface {
    solver: DistanceSolver,
    /// In their order.
    kept: Vec<Kept>,
    sources: Vec<Source>,
    search: Option<CellSearch>,
    found: Option<CellMap>,
}

/// A triangle that is a face of the surface.
struct Kept {
    triangle: u32,
    face: FaceId,
    /// Of its corners, which corner of the face each is.
    corners: [usize; 3],
}

impl Kept {
    /// Weights of its corners as those of the face's.
    fn weights(&self, weights: [f64; 3]) -> [f64; 3] {
        let mut of_face = [0.0; 3];
        for (corner, weight) in self.corners.into_iter().zip(weights) {
            of_face[corner] = weight;
        }
        of_face
    }
}

/// The cells of sources.
#[wasm_bindgen]
pub struct Cells {
    field: Field,
    borders: Borders,
}

#[wasm_bindgen]
impl CellSurface {
    /// `positions` are `#V × 3`, `triangles` `#F × 3`; vertices in one place are apart where their numbers differ. Components are joined
    /// by a rule and so many links, as by the solver.
    ///
    /// # Errors
    /// As building a surface has, and for another rule.
    #[wasm_bindgen(constructor)]
    pub fn new(positions: &[f64], triangles: &[u32], rule: &str, links: u32) -> Result<Self> {
        let positions = positions.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
        let soup = Soup::single("surface", positions, triangles.as_chunks().0.to_vec());
        let mut solver = DistanceSolver::new(Surface::build_by(&soup, WeldRule::Exact, parallel::ONE)?);
        let whole = Arc::clone(solver.whole());
        solver.join(&whole, rule.parse()?, links as usize)?;
        solver.set_walls(&Walls { faces: Vec::new(), edges: whole.seams() })?;
        let kept = whole.faces_in_input_order().map(|face| {
            let triangle = whole.triangle_of_face(face).0;
            let inputs = whole.inputs_of_face(face);
            let corner = |vertex: u32| inputs.iter().position(|input| input.0 == vertex).unwrap_or_default();
            Kept { triangle, face, corners: soup.triangles[triangle as usize].map(corner) }
        });
        Ok(Self { kept: kept.collect(), solver, sources: Vec::new(), search: None, found: None })
    }

    /// Begins to search from sources: `#S` triangles, `#S × 3` weights of their corners, and `#S` initial distances.
    ///
    /// # Errors
    /// For a triangle that there is none of, weights out of range, and negative distances.
    pub fn begin(&mut self, triangles: &[u32], weights: &[f64], initial: &[f64]) -> Result<()> {
        let source = |((&triangle, weights), &initial): ((&u32, &[f64]), &f64)| {
            Ok(self.solver.surface().source(self.place(triangle, weights)?, initial)?)
        };
        self.sources = triangles.iter().zip(weights.chunks(3)).zip(initial).map(source).collect::<Result<_>>()?;
        self.search = Some(CellSearch::new(self.solver.exact_geometry(), &self.sources)?);
        Ok(())
    }

    /// Goes on by about `work` windows. Whether all is found.
    ///
    /// # Errors
    /// Where nothing was begun, and where there is no memory.
    pub fn advance(&mut self, work: u32) -> Result<bool> {
        match self.search.take().ok_or_else(not_begun)?.advance(work as usize)? {
            Ok(map) => self.found = Some(map),
            Err(rest) => self.search = Some(rest),
        }
        Ok(self.search.is_none())
    }

    /// The cells of what was found, which is given away. `cells`: of each source the number of its cell, below `count`.
    ///
    /// # Errors
    /// As [`Self::advance`].
    pub fn take(&mut self, cells: &[u32], count: u32) -> Result<Cells> {
        let found = self.found.take().ok_or_else(not_begun)?;
        let surface = self.solver.surface();
        let cell_of = |source: Option<u32>| source.and_then(|source| cells.get(source as usize)).copied();
        let nearest: Vec<Option<u32>> = found.cells.nearest.iter().map(|&source| cell_of(source)).collect();
        let vertices = |kept: &Kept| kept.corners.map(|corner| surface.faces()[kept.face][corner].0);
        let positions = surface.positions().iter().copied().collect();
        let distances = found.cells.distances.iter().copied().collect();
        let field = Field::new(positions, self.kept.iter().map(vertices).collect(), distances)?;
        let in_faces = self.sources.iter().flat_map(|source| source.place().faces(surface));
        let starts: Vec<u32> = in_faces.filter_map(|face| self.number(surface.triangle_of_face(face).0)).collect();
        let mut borders = Borders::trace(&field, (&nearest, count as usize), &starts, |triangle, weights| {
            let kept = &self.kept[triangle as usize];
            found.at(kept.face, kept.weights(weights)).map(cell_of)
        })?;
        for tile in &mut borders.tiles {
            tile.triangle = self.kept[tile.triangle as usize].triangle;
        }
        Ok(Cells { field, borders })
    }
}

#[wasm_bindgen]
impl CellSurface {
    /// So many places, each the vertex that is farthest from those before, of which the first is near a place: four numbers each, a
    /// triangle and the weights of its corners.
    ///
    /// # Errors
    /// For a triangle that there is none of, no place, and where there is no memory.
    pub fn spread(&mut self, triangle: u32, weights: &[f64], count: u32) -> Result<Vec<f64>> {
        let near = self.place(triangle, weights)?;
        let Place::Face { face, weights } = near else { return Err(no_triangle()) };
        let heaviest = (0..3).fold(0, |best, k| if weights[k] > weights[best] { k } else { best });
        let first = self.solver.surface().faces()[face][heaviest];
        let geometry = self.solver.exact_geometry();
        let samples = farthest_samples(geometry, first, SampleCount::Exactly(count as usize), &mut go_on)?;
        Ok(self.numbers(samples.vertices.into_iter().map(Place::Vertex)))
    }

    /// Places moved once to the middles of their cells, as numbers like those of [`Self::spread`].
    ///
    /// # Errors
    /// As [`Self::begin`].
    pub fn relaxed(&mut self, triangles: &[u32], weights: &[f64]) -> Result<Vec<f64>> {
        let places = triangles.iter().zip(weights.chunks(3)).map(|(&triangle, weights)| self.place(triangle, weights));
        let places = places.collect::<Result<Vec<Place>>>()?;
        let moved = relaxed(self.solver.exact_geometry(), &places, 1, &mut go_on)?;
        Ok(self.numbers(moved.into_iter().map(|point| point.place())))
    }
}

impl CellSurface {
    fn place(&self, triangle: u32, weights: &[f64]) -> Result<Place> {
        let kept = &self.kept[self.number(triangle).ok_or_else(no_triangle)? as usize];
        let weights = weights.try_into().map_err(|_| Failure::misuse("a triangle has three weights"))?;
        Ok(Place::Face { face: kept.face, weights: kept.weights(weights) })
    }

    fn numbers(&self, places: impl Iterator<Item = Place>) -> Vec<f64> {
        let surface = self.solver.surface();
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
    fn number(&self, triangle: u32) -> Option<u32> {
        self.kept.binary_search_by_key(&triangle, |kept| kept.triangle).ok().map(|number| number as u32)
    }
}

fn no_triangle() -> Failure {
    Failure::misuse("there is no such triangle")
}

fn not_begun() -> Failure {
    Failure::misuse("no search was begun")
}

#[wasm_bindgen]
impl Cells {
    /// The area of each, in the square of the unit of positions.
    #[must_use]
    pub fn areas(&self) -> Vec<f64> {
        self.borders.areas.clone()
    }

    /// `#T × 2`: the cell of each triangle of the surface divided along the borders, and the triangle that it is part of.
    #[must_use]
    pub fn tiles(&self) -> Vec<u32> {
        self.borders.tiles.iter().flat_map(|tile| [tile.cell, tile.triangle]).collect()
    }

    /// `#T × 3 × 3`: the weights of their corners there.
    #[must_use]
    pub fn corners(&self) -> Vec<f32> {
        self.borders.tiles.iter().flat_map(|tile| tile.corners).flatten().map(|weight| weight as f32).collect()
    }

    /// `#segments × 2 × 3`, ends of the segments of all borders, as they are drawn.
    ///
    /// # Errors
    /// As [`transform`].
    pub fn ends(&self, #[wasm_bindgen(unchecked_param_type = "DrawTransform")] drawn: &JsValue) -> Result<Vec<f32>> {
        Ok(transform(drawn)?.places(self.borders.curves.points_of_segments()))
    }

    /// A file of the borders: "obj", "dxf", "csv" or "glb", or "svg" or "pdf" of what is seen of them from far away, in this direction as
    /// it is drawn where the axis `up` is drawn upward. All lengths are told in this unit.
    ///
    /// # Errors
    /// For another kind of file, no direction, an axis that there is not, or a PDF without a unit.
    pub fn file(
        &self,
        kind: &str,
        toward_eye: &[f64],
        #[wasm_bindgen(unchecked_param_type = "Up")] up: &str,
        unit: FileUnit,
    ) -> Result<Vec<u8>> {
        let FileUnit { scale, unit } = unit;
        let curves = self.borders.curves.scaled(scale);
        if kind != "svg" && kind != "pdf" {
            return curve_file(kind, &curves, unit);
        }
        let positions = self.field.positions().iter().map(|&position| scale * position).collect();
        let field = Field::new(positions, self.field.triangles().to_vec(), self.field.distances().to_vec())?;
        picture(kind, (&curves, &field), (toward_eye, up), unit)
    }
}
