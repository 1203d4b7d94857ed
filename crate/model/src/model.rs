//! A model: a soup with how it looks, moves, is seen and is lit.

use std::borrow::Cow;
use std::sync::Arc;

use heatwalk_surface::{Result, Selection, Soup};

use crate::appearance::Appearance;
use crate::camera::Camera;
use crate::light::Light;
use crate::motion::{Motion, Pose};

/// What a file holds.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Model {
    /// Its triangles.
    pub soup: Soup,
    /// How they look.
    pub appearance: Arc<Appearance>,
    /// How they move.
    pub motion: Arc<Motion>,
    /// Whence the file wants them to be seen.
    pub cameras: Vec<Camera>,
    /// By what the file wants them to be lit.
    pub lights: Vec<Light>,
}

impl From<Soup> for Model {
    fn from(soup: Soup) -> Self {
        Self { soup, ..Self::default() }
    }
}

impl Model {
    /// As [`Soup::chosen`].
    ///
    /// # Errors
    /// As [`Soup::chosen`].
    pub fn chosen(&self, parts: &[usize]) -> Result<Self> {
        Ok(Self { soup: self.soup.chosen(parts)?, ..self.clone() })
    }

    /// As [`Soup::select`].
    ///
    /// # Errors
    /// As [`Soup::select`].
    pub fn select(&self, parts: &[usize]) -> Result<Self> {
        let selection = self.soup.selection(parts)?;
        Ok(self.take(selection))
    }

    /// Without the triangles that are no part of the surface; all vertices stay.
    #[must_use]
    pub fn surface_alone(&self) -> Cow<'_, Self> {
        if self.soup.inactive.is_empty() { Cow::Borrowed(self) } else { Cow::Owned(self.take(self.soup.active())) }
    }

    /// Other triangles over its vertices, as [`Soup::with_triangles`]; without materials and without motion.
    ///
    /// # Errors
    /// As [`Soup::with_triangles`].
    pub fn with_triangles(&self, name: &str, triangles: Vec<[u32; 3]>) -> Result<Self> {
        let soup = self.soup.with_triangles(name, triangles)?;
        Ok(Self { cameras: self.cameras.clone(), lights: self.lights.clone(), ..soup.into() })
    }

    /// Where its vertices are.
    pub fn pose(&self) -> Pose {
        Pose { positions: self.soup.positions.clone(), normals: self.appearance.normals.clone() }
    }

    /// The model in the pose that it has so many seconds after the beginning of a clip, at whose end it stops; with normals of that
    /// pose, and without motion.
    ///
    /// # Errors
    /// As [`Motion::apply`].
    pub fn posed(&self, clip: usize, seconds: f64) -> Result<Self> {
        let mut pose = self.pose();
        self.motion.apply(clip, seconds, &mut pose)?;
        let Pose { positions, normals } = pose;
        let appearance = Arc::new(Appearance { normals, ..Appearance::clone(&self.appearance) });
        let soup = Soup { positions, ..self.soup.clone() };
        Ok(Self { soup, appearance, motion: Arc::default(), ..self.clone() })
    }

    fn take(&self, selection: Selection) -> Self {
        let is_kept = selection.is_kept().iter().enumerate();
        let vertices = is_kept.filter(|&(_, &is_kept)| is_kept).map(|(vertex, _)| vertex);
        Self {
            appearance: Arc::new(self.appearance.select(selection.triangles(), selection.is_kept())),
            motion: Arc::new(self.motion.select(vertices)),
            cameras: self.cameras.clone(),
            lights: self.lights.clone(),
            soup: self.soup.take(selection),
        }
    }

    /// All of it as bytes, which [`Self::unpacked`] takes.
    ///
    /// # Panics
    /// Never: what a model is made of can be written.
    #[cfg(feature = "packed")]
    pub fn packed(&self) -> Vec<u8> {
        postcard::to_allocvec(self).expect("a model can be written")
    }

    /// The model whose bytes [`Self::packed`] gave; None for other bytes.
    #[cfg(feature = "packed")]
    pub fn unpacked(bytes: &[u8]) -> Option<Self> {
        postcard::from_bytes(bytes).ok()
    }
}
