//! Sets what is shown of the inside of a solid.

use glam::{Vec3, Vec4};

use super::Renderer;
use crate::check;
use crate::cut::CutRenderer;
use crate::error::Error;
use crate::inner::InnerTriangles;
use crate::inside::Filling;
use crate::planes::Cut;
use crate::section::{Section, SectionArrays, SectionRenderer};
use crate::shell::{ShellRenderer, Shells};

impl Renderer {
    /// Cuts the surface open by none, one or two planes: a unit normal and the offset along it each, world space. What is
    /// beyond all of them is neither drawn nor picked, and casts no shadow; edges and arrows of the surface end there too. A
    /// surface in the materials of its file is drawn whole.
    ///
    /// # Errors
    /// When there are more planes, or a number is not finite; the cut then stays as it is.
    pub fn set_cut(&mut self, planes: &[Vec4]) -> Result<(), Error> {
        let cut = Cut::new(planes)?;
        if cut == self.inside.cut {
            return Ok(());
        }
        self.inside.cut = cut;
        if !cut.is_none() {
            self.inside.cuts.get_or_insert_with(|| CutRenderer::new(&self.context, &self.shared));
        }
        (self.dirty, self.shadows_dirty) = (true, true);
        Ok(())
    }

    /// Replaces the section that closes the cut, drawn with the pattern of the surface as if it lay open. `hides_surface`: it
    /// stands in the place of the surface, which is neither drawn nor picked, and casts no shadow.
    ///
    /// # Errors
    /// When the arrays do not fit together, or the device, or are no finite places; the old section then stays.
    pub fn set_section(&mut self, section: Option<SectionArrays>, hides_surface: bool) -> Result<(), Error> {
        self.inside.filling.section = self.built_section(section)?;
        self.inside.hides_surface = hides_surface;
        self.adopt_bounds();
        (self.dirty, self.shadows_dirty) = (true, true);
        Ok(())
    }

    /// Replaces the shells, iso-surfaces that let light through, seen where the surface is cut open or hidden. `opacity`: of
    /// one that is seen straight on, 0..1.
    ///
    /// # Errors
    /// When the arrays do not fit together, or the device, or are no finite places; the old shells then stay.
    pub fn set_shells(&mut self, shells: Option<InnerTriangles>, opacity: f32) -> Result<(), Error> {
        self.inside.filling.shells = self.built_shells(shells)?;
        self.inside.opacity = opacity;
        self.inside.write_film(&self.context);
        self.dirty = true;
        Ok(())
    }

    /// Replaces section and shells right of the split, where the surface has [another field](Self::set_other_field): both of the same cut
    /// and drawn in the same way, so that only values differ.
    ///
    /// # Errors
    /// As [`Self::set_section`]; what is shown then stays.
    pub fn set_other_inside(
        &mut self,
        section: Option<SectionArrays>,
        shells: Option<InnerTriangles>,
    ) -> Result<(), Error> {
        self.inside.other = Filling { section: self.built_section(section)?, shells: self.built_shells(shells)? };
        self.dirty = true;
        Ok(())
    }

    /// A section on the device, and what draws it.
    fn built_section(&mut self, section: Option<SectionArrays>) -> Result<Option<Section>, Error> {
        let make = |arrays| Section::new(&self.context, arrays, self.max);
        let section = section.map(make).transpose()?.flatten();
        if section.is_some() {
            let make = || SectionRenderer::new(&self.context, &self.shared, &self.surfaces);
            self.inside.sections.get_or_insert_with(make);
        }
        Ok(section)
    }

    /// Shells on the device, and what draws them.
    fn built_shells(&mut self, shells: Option<InnerTriangles>) -> Result<Option<Shells>, Error> {
        let make = |mesh| Shells::new(&self.context, mesh, self.max);
        let shells = shells.map(make).transpose()?.flatten();
        if shells.is_some() && self.inside.films.is_none() {
            self.inside.films = Some(ShellRenderer::new(&self.context, &self.shared, &self.surfaces));
            self.inside.write_film(&self.context);
        }
        Ok(shells)
    }

    /// Replaces the arrows inside: one vector a place, of any length. Where places are close, some go without an arrow.
    ///
    /// # Errors
    /// When their numbers differ or one is not finite; the old arrows then stay.
    pub fn set_inner_arrows(&mut self, places: &[Vec3], vectors: &[Vec3]) -> Result<(), Error> {
        check::same_length("inner arrows", places, vectors)?;
        check::places("places of inner arrows", places)?;
        check::vectors("inner arrows", vectors)?;
        let radius = self.radius();
        self.arrows.set_inner((&self.context, &self.shared), places, vectors, radius);
        self.dirty = true;
        Ok(())
    }
}
