//! A frame, from what is shown to the canvas or to a picture.

use std::borrow::Cow;

use glam::Vec3;
use heatwalk_bake::{Cube, Floor, Shade};

use super::Renderer;
use crate::camera::{Camera, Eye};
use crate::canvas::NextFrame;
use crate::capture::Capture;
use crate::cut::Part;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::model::Pass;
use crate::shadow::{Casters, ShadowView};
use crate::shared::Frame;
use crate::surface::FieldBuffers;

impl Renderer {
    /// True when the last frame is out of date, the camera moves, or the device was lost or refused a step (which
    /// only `render` can tell).
    #[must_use]
    pub fn needs_frame(&self) -> bool {
        self.dirty || self.camera.is_moving() || self.context.has_news()
    }

    /// Draws one frame onto the canvas; `seconds` since the last one. Returns false when there is no canvas, or it or the
    /// device was lost.
    ///
    /// # Errors
    /// What the device refused since the last frame. It may be this frame or an earlier call; the next frame may work.
    pub fn render(&mut self, seconds: f64) -> Result<bool, Error> {
        self.camera.advance(seconds);
        let Some(canvas) = &self.canvas else { return Ok(false) };
        let frame = match canvas.next_frame(&self.context) {
            NextFrame::Ready(frame) => frame,
            // The picture stays out of date, so that the page asks again.
            NextFrame::Later => return Ok(true),
            NextFrame::Lost => return Ok(false),
        };
        self.occlude();
        self.sort_blended(self.camera.eye());
        let encoder = self.prepare(&self.camera);
        if let Some(canvas) = &self.canvas {
            canvas.present(&self.context, frame, encoder, |pass| self.draw(pass, &self.camera, false));
        }
        (self.dirty, self.shadows_dirty) = (false, false);
        self.context.take_error().map_or(Ok(true), Err)
    }

    /// Draws the same beside the canvas, `scale` times as large. `is_clear` leaves the background out.
    ///
    /// # Errors
    /// [`Error::PictureTooLarge`].
    pub fn capture(&mut self, scale: f32, is_clear: bool) -> Result<Capture, Error> {
        let limit = self.context.device.limits().max_texture_dimension_2d;
        let camera = self.camera.scaled(scale);
        let (width, height) = camera.size();
        if width.max(height) > limit {
            return Err(Error::PictureTooLarge { width, height, limit });
        }
        self.occlude();
        self.sort_blended(camera.eye());
        let encoder = self.prepare(&camera);
        let capture = Capture::new(&self.context, (width, height), encoder, |pass| self.draw(pass, &camera, is_clear));
        self.shadows_dirty = false;
        // The frame's uniform is now that of the picture.
        self.dirty = true;
        Ok(capture)
    }

    /// Writes the frame's uniform and draws the shadows that have changed.
    fn prepare(&self, camera: &Camera) -> wgpu::CommandEncoder {
        let shadows = ShadowView::new(self.drawn(), self.environment.key());
        let moves = self.walkers.are_out() || !self.pins.is_empty();
        let radius = self.radius();
        self.shared.write(
            &self.context,
            &Frame {
                eye: camera.eye(),
                radius,
                pixel_ratio: camera.pixel_ratio(),
                shadows,
                moving: shadows.cover(self.walkers.balls().chain(self.pins.balls(radius))),
                cube: Cube::around(self.scene),
                environment: self.environment,
                punctual: &self.lights,
                cut: self.inside.cut,
                is_capped: self.inside.filling.section.is_some(),
            },
        );
        let mut encoder = self.context.encoder();
        if self.shadows_dirty {
            // Lights of a file cast no shadows.
            let key_share = if self.lights.is_empty() { self.environment.key_share() } else { 0.0 };
            self.ground.set_light(&self.context, key_share);
            self.shared.lighting.maps.draw(&mut encoder, Casters::Still, |pass| {
                pass.set_bind_group(0, &self.shared.shadow_group, &[]);
                match (&self.inside.cuts, self.seen_surface()) {
                    (Some(cuts), Some((mesh, _))) if !self.is_whole(mesh) => cuts.draw_shadow(pass, &mesh.buffers),
                    (_, Some((mesh, _))) => self.surfaces.draw_shadow(pass, &mesh.buffers),
                    (_, None) => {}
                }
                let others = self.scenery.iter().map(|mesh| &mesh.buffers);
                for buffers in others.chain(self.inside.filling.section.iter().map(|section| &section.buffers)) {
                    self.surfaces.draw_shadow(pass, buffers);
                }
            });
        }
        if moves {
            self.shared.lighting.maps.draw(&mut encoder, Casters::Moving, |pass| {
                pass.set_bind_group(0, &self.shared.shadow_group, &[]);
                self.walkers.draw_shadow(pass);
                self.pins.draw_shadow(pass);
            });
        }
        encoder
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, camera: &Camera, is_clear: bool) {
        let eye = camera.eye();
        pass.set_bind_group(0, &self.shared.camera_group, &[]);
        pass.set_bind_group(1, &self.shared.lighting.group, &[]);
        if !is_clear {
            self.background.draw(pass);
        }
        self.ground.draw(pass, eye.position.y as f32);
        if let Some((mesh, field)) = self.seen_surface() {
            self.in_halves(pass, self.fields(field), camera, |pass, field| {
                if !self.draw_model(pass, mesh, Some(field), Pass::Solid)
                    && !self.draw_cut(pass, mesh, field, Part::Body)
                {
                    self.surfaces.draw(pass, &mesh.buffers, field);
                }
            });
        }
        if let Some(sections) = &self.inside.sections {
            self.in_halves(pass, self.fillings(), camera, |pass, filling| {
                if let Some(section) = &filling.section {
                    sections.draw(pass, section, &self.surfaces);
                }
            });
        }
        for mesh in &self.scenery {
            if !self.draw_model(pass, mesh, None, Pass::Solid) {
                self.surfaces.draw_scenery(pass, &mesh.buffers);
            }
        }
        self.walkers.draw(pass);
        self.pins.draw(pass);
        if let Some((mesh, field)) = self.seen_surface() {
            self.in_halves(pass, self.fields(field), camera, |pass, field| {
                self.draw_cut(pass, mesh, field, Part::Rim);
            });
        }
        if let (Some(patches), Some(models)) = (&self.patches, &self.models) {
            let drawn = (&patches.buffers, &patches.model, &*patches.materials);
            models.draw_buffers(pass, drawn, None, Pass::Blended, (&self.context, &self.shared, &self.surfaces));
        }
        let surface = self.seen_surface().into_iter().map(|(mesh, field)| (mesh, Some(field)));
        let mut meshes: Vec<_> = surface.chain(self.scenery.iter().map(|mesh| (mesh, None))).collect();
        let depth = |mesh: &Mesh| line_of_sight(eye).dot(mesh.bounds.center);
        meshes.sort_by(|(one, _), (other, _)| depth(other).total_cmp(&depth(one)));
        for (mesh, field) in meshes {
            match field {
                Some(field) => self.in_halves(pass, self.fields(field), camera, |pass, field| {
                    self.draw_model(pass, mesh, Some(field), Pass::Blended);
                }),
                None => {
                    self.draw_model(pass, mesh, None, Pass::Blended);
                }
            }
        }
        if !self.inside.hides_surface {
            self.arrows.draw(pass);
        }
        self.arrows.draw_inner(pass);
        self.curve.draw(pass);
        self.wires.draw(pass);
        if let Some(films) = &self.inside.films {
            self.in_halves(pass, self.fillings(), camera, |pass, filling| {
                if let Some(shells) = &filling.shells {
                    films.draw(pass, shells, &self.surfaces);
                }
            });
        }
    }

    /// Draws a part of the surface cut open; false where it is whole.
    fn draw_cut(&self, pass: &mut wgpu::RenderPass<'_>, mesh: &Mesh, field: &FieldBuffers, which: Part) -> bool {
        let cuts = self.inside.cuts.as_ref().filter(|_| !self.is_whole(mesh));
        let device = (&self.context, &self.shared, &self.surfaces);
        cuts.inspect(|cuts| cuts.draw(pass, &mesh.buffers, field, which, device)).is_some()
    }

    /// Whether a mesh is drawn without a cut: there is none, or the mesh is drawn in the materials of its file.
    fn is_whole(&self, mesh: &Mesh) -> bool {
        self.inside.cut.is_none() || (mesh.model.is_some() && self.style.has_materials_of_file)
    }

    /// Draws a mesh in the materials of its file; false where it has none or the style does not want them.
    fn draw_model(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        mesh: &Mesh,
        field: Option<&FieldBuffers>,
        which: Pass,
    ) -> bool {
        let models = self.models.as_ref().filter(|_| self.style.has_materials_of_file);
        let device = (&self.context, &self.shared, &self.surfaces);
        models.is_some_and(|models| models.draw(pass, mesh, field, which, device))
    }

    /// Puts the triangles that let light through in order for an eye.
    fn sort_blended(&mut self, eye: Eye) {
        for filling in [&mut self.inside.filling, &mut self.inside.other] {
            if let Some(shells) = &mut filling.shells {
                shells.sort(&self.context, line_of_sight(eye));
            }
        }
        let Some(models) = self.models.as_ref().filter(|_| self.style.has_materials_of_file) else { return };
        let surface = self.surface.iter_mut().map(|(mesh, _)| mesh);
        for mesh in surface.chain(&mut self.scenery) {
            models.sort(&self.context, mesh, line_of_sight(eye));
        }
    }

    /// Finds out anew, if need be, what the scene keeps off the floor and off itself.
    fn occlude(&mut self) {
        if !std::mem::take(&mut self.occlusion_dirty) {
            return;
        }
        if self.meshes().next().is_none() {
            return self.ground.clear();
        }
        let made = || {
            let triangles = self.meshes().map(|mesh| (mesh.picker.positions(), mesh.picker.triangles()));
            Cow::Owned(Shade::new(self.scene, triangles))
        };
        let shade = self.shade.as_ref().filter(|_| self.scenery.is_empty()).map_or_else(made, Cow::Borrowed);
        self.ground.set(&self.context, Floor::new(self.scene), shade.contact());
        self.shared.lighting.set_occlusion(&self.context, shade.occlusion());
    }
}

/// Along the axis of the camera, away from it.
fn line_of_sight(eye: Eye) -> Vec3 {
    -eye.world_from_view.z_axis.as_vec3()
}
