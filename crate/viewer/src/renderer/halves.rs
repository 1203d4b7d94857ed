//! Two fields of the surface, or of a solid, side by side.

use super::Renderer;
use crate::camera::Camera;
use crate::error::Error;
use crate::inside::Filling;
use crate::surface::FieldBuffers;

/// What is drawn left of the split, and right of it where that is something else.
pub(super) struct Sides<T> {
    left: T,
    right: Option<T>,
}

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

    /// The fields of the surface, left and right.
    pub(super) fn fields<'a>(&'a self, field: &'a FieldBuffers) -> Sides<&'a FieldBuffers> {
        Sides { left: field, right: self.other.as_ref() }
    }

    /// What is seen within the solid, left and right.
    pub(super) fn fillings(&self) -> Sides<&Filling> {
        Sides { left: &self.inside.filling, right: self.other.as_ref().map(|_| &self.inside.other) }
    }

    /// Draws each on its side of the split; what there is alone everywhere.
    pub(super) fn in_halves<T>(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        Sides { left, right }: Sides<T>,
        camera: &Camera,
        mut draw: impl FnMut(&mut wgpu::RenderPass<'_>, T),
    ) {
        let Some(right) = right else { return draw(pass, left) };
        let ((width, height), middle) = (camera.size(), camera.column(self.split));
        for (side, from, to) in [(left, 0, middle), (right, middle, width)] {
            if from < to {
                pass.set_scissor_rect(from, 0, to - from, height);
                draw(pass, side);
            }
        }
        pass.set_scissor_rect(0, 0, width, height);
    }
}
