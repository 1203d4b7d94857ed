//! What is shown of the inside of a solid.

use glam::Vec3;

use crate::context::Context;
use crate::cut::CutRenderer;
use crate::planes::Cut;
use crate::section::{Section, SectionRenderer};
use crate::shell::{ShellRenderer, Shells};

/// The cut and what is seen through it. Most meshes are not solids: nothing is built before it is shown.
#[derive(Default)]
pub(crate) struct Inside {
    pub(crate) cut: Cut,
    pub(crate) cuts: Option<CutRenderer>,
    pub(crate) filling: Filling,
    /// Seen right of the split, where the surface has another field there.
    pub(crate) other: Filling,
    pub(crate) sections: Option<SectionRenderer>,
    /// Something else stands in the place of the surface.
    pub(crate) hides_surface: bool,
    pub(crate) films: Option<ShellRenderer>,
    /// Greatest distance of the section from the middle of the scene; 0 where there is none.
    pub(crate) reach: f32,
    /// Of the shells.
    pub(crate) opacity: f32,
    ramp_row: usize,
}

/// What is seen of one field within the solid.
#[derive(Default)]
pub(crate) struct Filling {
    pub(crate) section: Option<Section>,
    pub(crate) shells: Option<Shells>,
}

impl Inside {
    /// Takes all away.
    pub(crate) fn clear(&mut self) {
        self.cut = Cut::default();
        (self.filling, self.other) = (Filling::default(), Filling::default());
        self.hides_surface = false;
    }

    /// `max`: the largest value of the field from now on.
    pub(crate) fn scale(&self, context: &Context, max: f64) {
        for Filling { section, shells } in [&self.filling, &self.other] {
            if let Some(section) = section {
                section.scale(context, max);
            }
            if let Some(shells) = shells {
                shells.scale(context, max);
            }
        }
    }

    /// `center`: the middle of the scene from now on.
    pub(crate) fn measure(&mut self, center: Vec3) {
        self.reach = self.filling.section.as_ref().map_or(0.0, |section| section.reach(center));
    }

    /// Which of the ramps shells are coloured by.
    pub(crate) fn set_ramp_row(&mut self, context: &Context, row: usize) {
        self.ramp_row = row;
        self.write_film(context);
    }

    /// Tells the shells' opacity and ramp.
    pub(crate) fn write_film(&self, context: &Context) {
        if let Some(films) = &self.films {
            films.set_film(context, self.opacity, self.ramp_row);
        }
    }
}
