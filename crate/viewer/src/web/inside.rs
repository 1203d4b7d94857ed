//! What is shown of the inside of a solid.

use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use super::Viewer;
use super::numbers::{
    DrawnSection, DrawnTriangles, inner_triangles, planes as planes_of, points, section as section_of,
};

#[wasm_bindgen]
impl Viewer {
    /// Cuts the surface open by none, one or two planes, four numbers each: a unit normal and the offset along it. What is
    /// beyond all of them (normal · place > offset) is neither drawn nor picked. `set_surface` clears it.
    ///
    /// # Errors
    /// Throws when there are more planes, numbers are left over, or one is not finite; the cut then stays as it is.
    pub fn set_cut(&mut self, planes: &[f32]) -> Result<(), JsError> {
        Ok(self.renderer.set_cut(&planes_of(planes)?)?)
    }

    /// Replaces the section that closes the cut, drawn with the pattern of the surface. `hides_surface`: it stands in the place
    /// of the surface, which is neither drawn nor picked. `set_surface` clears both.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together, are too large for the device or hold no finite places; what is shown
    /// stays.
    pub fn set_section(&mut self, section: Option<DrawnSection>, hides_surface: bool) -> Result<(), JsError> {
        let section = section.map(|section| section_of(&section)).transpose()?;
        Ok(self.renderer.set_section(section, hides_surface)?)
    }

    /// Replaces the shells, which let light through and are seen where the surface is cut open or hidden. `opacity`: of one that
    /// is seen straight on, 0..1. `set_surface` clears them.
    ///
    /// # Errors
    /// As `set_section`.
    pub fn set_shells(&mut self, shells: Option<DrawnTriangles>, opacity: f32) -> Result<(), JsError> {
        let shells = shells.map(|shells| inner_triangles(&shells)).transpose()?;
        Ok(self.renderer.set_shells(shells, opacity)?)
    }

    /// Replaces section and shells right of the split, where the surface has another field there; see `set_other_field`.
    /// `set_surface` clears both.
    ///
    /// # Errors
    /// As `set_section`.
    pub fn set_other_inside(
        &mut self,
        section: Option<DrawnSection>,
        shells: Option<DrawnTriangles>,
    ) -> Result<(), JsError> {
        let section = section.map(|section| section_of(&section)).transpose()?;
        let shells = shells.map(|shells| inner_triangles(&shells)).transpose()?;
        Ok(self.renderer.set_other_inside(section, shells)?)
    }

    /// Replaces the arrows inside: `#A × 3` places and as many vectors, of any length; empty = none. Where places are close,
    /// some go without an arrow. `set_surface` clears them.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together or hold no finite numbers; the old arrows then stay.
    pub fn set_inner_arrows(&mut self, positions: &[f32], vectors: &[f32]) -> Result<(), JsError> {
        let (places, vectors) = (points("places of inner arrows", positions)?, points("inner arrows", vectors)?);
        Ok(self.renderer.set_inner_arrows(&places, &vectors)?)
    }
}
