//! Cells of sources.

use heatwalk::{CellMap, CellSearch, Place, SampleCount, Source, farthest_samples, go_on, mean, relaxed};
use heatwalk_bindings::{Failure, Result, transform};
use heatwalk_curves::{Borders, Field};
use wasm_bindgen::prelude::*;

use crate::files::{FileUnit, scaled_file};
use crate::surface::{ExactSurface, no_triangle};

/// The search for cells on a surface.
#[wasm_bindgen]
pub struct CellFinder {
    on: ExactSurface,
    sources: Vec<Source>,
    search: Option<CellSearch>,
    found: Option<CellMap>,
}

/// The cells of sources.
#[wasm_bindgen]
pub struct Cells {
    field: Field,
    borders: Borders,
}

#[wasm_bindgen]
impl CellFinder {
    /// On a surface.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(on: &ExactSurface) -> Self {
        Self { on: on.clone(), sources: Vec::new(), search: None, found: None }
    }

    /// Begins to search from sources: `#S` triangles, `#S × 3` weights of their corners, and `#S` initial distances.
    ///
    /// # Errors
    /// For a triangle that there is none of, weights out of range, and negative distances.
    pub fn begin(&mut self, triangles: &[u32], weights: &[f64], initial: &[f64]) -> Result<()> {
        let source = |((&triangle, weights), &initial): ((&u32, &[f64]), &f64)| {
            Ok(self.on.surface().source(self.on.place(triangle, weights)?, initial)?)
        };
        self.sources = triangles.iter().zip(weights.chunks(3)).zip(initial).map(source).collect::<Result<_>>()?;
        self.search = Some(CellSearch::new(self.on.geometry(), &self.sources)?);
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
        let (surface, kept) = (self.on.surface(), self.on.kept());
        let cell_of = |source: Option<u32>| source.and_then(|source| cells.get(source as usize)).copied();
        let nearest: Vec<Option<u32>> = found.cells.nearest.iter().map(|&source| cell_of(source)).collect();
        let field = self.on.field(found.cells.distances.iter().copied().collect())?;
        let in_faces = self.sources.iter().flat_map(|source| source.place().faces(surface));
        let starts: Vec<u32> = in_faces.filter_map(|face| self.on.number(surface.triangle_of_face(face).0)).collect();
        let mut borders = Borders::trace(&field, (&nearest, count as usize), &starts, |triangle, weights| {
            let kept = &kept[triangle as usize];
            found.at(kept.face, kept.weights(weights)).map(cell_of)
        })?;
        for tile in &mut borders.tiles {
            tile.triangle = kept[tile.triangle as usize].triangle;
        }
        Ok(Cells { field, borders })
    }
}

#[wasm_bindgen]
impl ExactSurface {
    /// So many places, each the vertex that is farthest from those before, of which the first is near a place: four numbers each, a
    /// triangle and the weights of its corners.
    ///
    /// # Errors
    /// For a triangle that there is none of, no place, and where there is no memory.
    pub fn spread(&mut self, triangle: u32, weights: &[f64], count: u32) -> Result<Vec<f64>> {
        let near = self.place(triangle, weights)?;
        let Place::Face { face, weights } = near else { return Err(no_triangle()) };
        let heaviest = (0..3).fold(0, |best, k| if weights[k] > weights[best] { k } else { best });
        let first = self.surface().faces()[face][heaviest];
        let geometry = self.geometry();
        let samples = farthest_samples(geometry, first, SampleCount::Exactly(count as usize), &mut go_on)?;
        Ok(self.numbers(samples.vertices.into_iter().map(Place::Vertex)))
    }

    /// The place whose squared distances from places sum to least, as four numbers like those of [`Self::spread`].
    ///
    /// # Errors
    /// As [`CellFinder::begin`], for no place, and for places that no path joins.
    pub fn mean(&self, triangles: &[u32], weights: &[f64]) -> Result<Vec<f64>> {
        let place = |(&triangle, weights): (&u32, &[f64])| Ok((self.place(triangle, weights)?, 1.0));
        let places = triangles.iter().zip(weights.chunks(3)).map(place).collect::<Result<Vec<_>>>()?;
        let found = mean(self.geometry(), &places, &mut go_on)?;
        Ok(self.numbers(std::iter::once(found.place)))
    }

    /// Places moved once to the middles of their cells, as numbers like those of [`Self::spread`].
    ///
    /// # Errors
    /// As [`CellFinder::begin`].
    pub fn relaxed(&mut self, triangles: &[u32], weights: &[f64]) -> Result<Vec<f64>> {
        let places = triangles.iter().zip(weights.chunks(3)).map(|(&triangle, weights)| self.place(triangle, weights));
        let places = places.collect::<Result<Vec<Place>>>()?;
        let moved = relaxed(self.geometry(), &places, 1, &mut go_on)?;
        Ok(self.numbers(moved.into_iter().map(|point| point.place())))
    }
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
        scaled_file(kind, (&self.borders.curves, &self.field), (toward_eye, up), unit)
    }
}
