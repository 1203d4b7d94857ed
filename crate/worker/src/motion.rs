//! What moves: the animations of a file, and scenery.

use heatwalk::Surface;
use heatwalk_bindings::{Message, Result};
use heatwalk_model::{Model, motion};
use heatwalk_scene::{DrawTransform, Posing};
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;
use crate::results::{DrawMesh, DrawPose};

/// An animation of the file.
#[derive(Message)]
pub struct Clip {
    /// Its name in the file, or a made one.
    pub name: String,
    /// How long it lasts.
    pub seconds: f64,
    /// How many of its channels are not read.
    pub left_out: usize,
}

impl Clip {
    pub(crate) fn new(clip: &motion::Clip) -> Self {
        Self { name: clip.name.clone(), seconds: clip.duration(), left_out: clip.left_out }
    }
}

/// A moment of an animation, its number given: none is the pose of the file.
pub fn moment(clip: Option<u32>, seconds: f64) -> Option<(usize, f64)> {
    clip.map(|clip| (clip as usize, seconds))
}

/// Triangles that nobody walks on.
#[wasm_bindgen]
pub struct Scenery {
    mesh: DrawMesh,
    posing: Option<Posing>,
    transform: DrawTransform,
}

impl Scenery {
    pub(crate) fn new(surface: &Surface, model: &Model, transform: DrawTransform) -> Self {
        let (_, mesh, posing) = Drawn::new(surface, &model.appearance, Some(model), transform);
        Self { mesh, posing, transform }
    }

    pub(crate) fn empty() -> Self {
        Self { mesh: DrawMesh::default(), posing: None, transform: DrawTransform::IDENTITY }
    }
}

#[wasm_bindgen]
impl Scenery {
    /// Takes its triangles, which only the page needs.
    pub fn take_mesh(&mut self) -> DrawMesh {
        std::mem::take(&mut self.mesh)
    }

    /// Whether an animation moves it.
    pub fn moves(&self) -> bool {
        self.posing.is_some()
    }

    /// Where it is so many seconds after the beginning of an animation, or without one in its file; none where it does not move.
    pub fn pose(&mut self, clip: Option<u32>, seconds: f64) -> Result<Option<DrawPose>> {
        let Some(posing) = &mut self.posing else { return Ok(None) };
        posing.take(moment(clip, seconds))?;
        Ok(Some(posing.draw(&self.transform).into()))
    }
}
