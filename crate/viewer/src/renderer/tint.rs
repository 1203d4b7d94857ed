//! What is drawn for the ground: tints of faces, and the outline of a brush.

use glam::{Vec3, Vec4};

use super::Renderer;
use crate::appearance::MeshAppearance;
use crate::error::Error;
use crate::style::Style;
use crate::surface::FieldBuffers;

impl Renderer {
    /// Tints the faces of the surface: linear RGBA, an alpha of 255 for walls. The first time, `appearance` gives that which the
    /// surface was set with, and the fields have to be set anew.
    ///
    /// # Errors
    /// When there is not one tint a face, or the device refuses the buffers; what is shown then stays.
    pub fn set_tints(
        &mut self,
        faces: &[[u8; 4]],
        appearance: impl FnOnce() -> Result<MeshAppearance, Error>,
    ) -> Result<(), Error> {
        let Some((mesh, field)) = &mut self.surface else { return Ok(()) };
        let expected = mesh.picker.triangles().len();
        if faces.len() != expected {
            return Err(Error::WrongLength { what: "tints", expected: 4 * expected, found: 4 * faces.len() });
        }
        if mesh.buffers.tints.is_none() {
            let appearance = appearance()?;
            appearance.check(mesh.normals.len(), expected)?;
            let corners = mesh.picker.triangles().as_flattened().to_vec();
            let parted = FieldBuffers::of_corners(&self.context, corners, mesh.normals.len())?;
            mesh.part_corners(&self.context, appearance)?;
            *field = parted;
            self.other = None;
        }
        if let Some(tints) = &mut mesh.buffers.tints {
            tints.write(&self.context, faces);
        }
        self.dirty = true;
        Ok(())
    }

    /// Shows the outline of a brush on the surface, of a radius about a place; none for a radius of 0.
    pub fn set_brush(&mut self, center: Vec3, radius: f32) {
        let brush = center.extend(radius);
        let brush = if brush.is_finite() { brush } else { Vec4::ZERO };
        if brush != self.style.brush {
            self.set_style(Style { brush, ..self.style });
        }
    }
}
