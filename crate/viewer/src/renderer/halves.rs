//! Two fields of the surface side by side.

use super::Renderer;
use crate::camera::Camera;
use crate::error::Error;
use crate::surface::FieldBuffers;

impl Renderer {
    /// Shows another field of the same surface on the right of the split, in the same style, and in colors up to the same value, the
    /// largest of the field on the left: to be set after that one. `count` values come, which `fill` writes as for
    /// [`Self::set_field`]; none: there is one field again.
    ///
    /// # Errors
    /// When the count is not the surface's number of vertices, or of corners where values come by these; what is shown then stays.
    pub fn set_other_field(
        &mut self,
        count: usize,
        is_by_corner: bool,
        fill: impl FnOnce(&mut [f32], &mut [i8]),
    ) -> Result<(), Error> {
        let Some((_, field)) = &self.surface else { return Ok(()) };
        let expected = field.value_count(is_by_corner);
        if count == 0 {
            self.other = None;
        } else if count != expected {
            return Err(Error::WrongLength { what: "distances to compare", expected, found: count });
        } else {
            let other = match self.other.take() {
                Some(other) => other,
                None => field.alike(&self.context)?,
            };
            self.other.insert(other).write(&self.context, self.max, is_by_corner, fill);
        }
        self.dirty = true;
        Ok(())
    }

    /// Where the right of the two fields begins: so far right of the middle of what the insets leave free, a share of the view's width.
    pub fn set_split(&mut self, split: f32) {
        self.split = if split.is_finite() { split } else { 0.0 };
        self.dirty |= self.other.is_some();
    }

    /// Draws the surface with its field; where there are two of them, each on its side of the split.
    pub(super) fn in_halves(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        field: &FieldBuffers,
        camera: &Camera,
        mut draw: impl FnMut(&mut wgpu::RenderPass<'_>, &FieldBuffers),
    ) {
        let Some(other) = &self.other else { return draw(pass, field) };
        let ((width, height), middle) = (camera.size(), camera.column(self.split));
        for (field, from, to) in [(field, 0, middle), (other, middle, width)] {
            if from < to {
                pass.set_scissor_rect(from, 0, to - from, height);
                draw(pass, field);
            }
        }
        pass.set_scissor_rect(0, 0, width, height);
    }
}
