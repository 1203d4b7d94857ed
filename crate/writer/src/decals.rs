//! Decals.

use glam::{DVec2, DVec3};
use heatwalk::{LogMapSearch, Soup, Up};
use heatwalk_bindings::{Failure, Result};
use heatwalk_curves::{Division, Field, Patch, decal};
use wasm_bindgen::prelude::*;

use crate::files::in_file;
use crate::surface::{ExactSurface, no_triangle};

/// Edges longer than this share of an image are divided: between their ends the map need not be linear.
const LONGEST: f64 = 0.125;
/// Triangles at most that a surface is divided into for that.
const MOST_PARTS: usize = 40_000;

/// A surface that images are laid on, and the search around the place of one.
#[wasm_bindgen]
pub struct DecalSurface {
    on: ExactSurface,
    surface: Field,
    /// Of large triangles.
    division: Option<Division>,
    /// Of what was divided, at most.
    longest: f64,
    search: Option<(LogMapSearch, u32)>,
}

/// An image on a surface.
#[wasm_bindgen]
pub struct Decal {
    patches: Vec<Patch>,
}

#[wasm_bindgen]
impl DecalSurface {
    /// Of a surface of these triangles (see [`ExactSurface::new`]), for images whose half sides are at least `least`.
    ///
    /// # Errors
    /// As building a surface has, and for another rule.
    #[wasm_bindgen(constructor)]
    pub fn new(
        on: &ExactSurface,
        positions: &[f64],
        triangles: &[u32],
        rule: &str,
        links: u32,
        least: f64,
    ) -> Result<Self> {
        let surface = |on: &ExactSurface| on.field(vec![0.0; on.surface().vertex_count()]);
        let longest = 2.0 * least * LONGEST;
        let whole = surface(on)?;
        if whole.longest_edge(|_| true) <= longest {
            return Ok(Self { surface: whole, on: on.clone(), division: None, longest: 0.0, search: None });
        }
        let positions: Vec<DVec3> = positions.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
        let division = Division::of(&positions, triangles.as_chunks().0, longest, MOST_PARTS);
        let soup = Soup::single("surface", division.positions.clone(), division.triangles.clone());
        let on = ExactSurface::of(&soup, rule, links)?;
        Ok(Self { surface: surface(&on)?, on, division: Some(division), longest, search: None })
    }

    /// Whether its triangles are small enough for an image of these half sides.
    #[must_use]
    pub fn suits(&self, least: f64) -> bool {
        self.longest <= 4.0 * least * LONGEST
    }

    /// Begins to search around a place: a triangle, and three weights of its corners.
    ///
    /// # Errors
    /// For a triangle that there is none of, and for a place without a tangent plane.
    pub fn begin(&mut self, triangle: u32, weights: &[f64]) -> Result<()> {
        self.search = None;
        let weights = weights.try_into().map_err(|_| Failure::misuse("a triangle has three weights"))?;
        let (part, weights) = match &self.division {
            Some(division) => division.part_at(triangle, weights).ok_or_else(no_triangle)?,
            None => (triangle, weights),
        };
        let place = self.on.place(part, &weights)?;
        let search = LogMapSearch::new(self.on.geometry(), self.on.surface().point(place)?)?;
        self.search = Some((search, self.on.number(part).ok_or_else(no_triangle)?));
        Ok(())
    }

    /// Goes on to the corners of an image with these half sides, by about `work` windows. Whether it has come there.
    ///
    /// # Errors
    /// Where nothing was begun, and where there is no memory.
    pub fn advance(&mut self, half_width: f64, half_height: f64, work: u32) -> Result<bool> {
        let (search, _) = self.search.as_mut().ok_or_else(not_begun)?;
        let reach = half_width.hypot(half_height);
        if !search.advance(reach, work as usize)? {
            return Ok(false);
        }
        // Triangles that the image ends in have corners beyond it.
        let distances = search.distances().as_slice();
        let beyond = self.surface.longest_edge(|vertex| distances[vertex as usize] <= reach);
        Ok(search.advance(reach + beyond, work as usize)?)
    }

    /// What an image of these half sides covers, whose right is in this direction, as it is drawn where the axis `up` is drawn upward.
    ///
    /// # Errors
    /// As [`Self::advance`], and for a direction that is square to the surface.
    pub fn lay(
        &self,
        half_width: f64,
        half_height: f64,
        right: &[f64],
        #[wasm_bindgen(unchecked_param_type = "Up")] up: &str,
    ) -> Result<Decal> {
        let (search, start) = self.search.as_ref().ok_or_else(not_begun)?;
        let up: Up = up.parse()?;
        let right = right.try_into().map(DVec3::from_array);
        let right = right.map_err(|_| Failure::misuse("a direction is three numbers"))?;
        let map = search.map(Some(in_file(up, right)))?;
        let coordinates: Vec<DVec2> = map.coordinates.iter().copied().collect();
        let mut patches = decal(&self.surface, &coordinates, *start, DVec2::new(half_width, half_height));
        for patch in &mut patches {
            patch.triangle = self.on.kept()[patch.triangle as usize].triangle;
            if let Some(division) = &self.division {
                let places = patch.corners.map(|weights| division.place_in(patch.triangle, weights));
                patch.triangle = places[0].0;
                patch.corners = places.map(|(_, weights)| weights);
            }
        }
        Ok(Decal { patches })
    }
}

#[wasm_bindgen]
impl Decal {
    /// `#T`: the triangle of the surface that each part is of.
    #[must_use]
    pub fn triangles(&self) -> Vec<u32> {
        self.patches.iter().map(|patch| patch.triangle).collect()
    }

    /// `#T × 3 × 3`: the weights of its corners at those of the part.
    #[must_use]
    pub fn corners(&self) -> Vec<f32> {
        self.patches.iter().flat_map(|patch| patch.corners).flatten().map(|weight| weight as f32).collect()
    }

    /// `#T × 3 × 2`: where these are in the image, from 0 to 1 to the right and from 0 to 1 down.
    #[must_use]
    pub fn image(&self) -> Vec<f32> {
        self.patches.iter().flat_map(|patch| patch.image).flat_map(|place| place.as_vec2().to_array()).collect()
    }
}

fn not_begun() -> Failure {
    Failure::misuse("no search was begun")
}
