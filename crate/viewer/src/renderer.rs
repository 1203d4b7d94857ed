use glam::{DVec3, Vec2, Vec3};

use crate::arrow::Arrows;
use crate::background::Background;
use crate::bounds::Bounds;
use crate::camera::{Camera, Eye, Insets, View};
use crate::capture::Capture;
use crate::contact::{Contact, Floor};
use crate::context::{Backend, Context, NextFrame};
use crate::curve::Curve;
use crate::environment::{Environment, Surroundings};
use crate::error::Error;
use crate::ground::Ground;
use crate::look::Look;
use crate::mesh::{Mesh, MeshArrays};
use crate::occlusion::{Cube, Occlusion};
use crate::pin::Pins;
use crate::pose::Track;
use crate::shadow::{Casters, ShadowView};
use crate::shared::{FrameUniform, Shared};
use crate::surface::{FieldBuffers, RAMP_BYTES, SurfaceRenderer};
use crate::walker::{POSE_NUMBERS, Walkers};
use crate::wire::Wires;

/// A place on the surface under a pixel.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceHit {
    /// Index of the triangle.
    pub triangle: u32,
    /// Barycentric weights of its corners.
    pub weights: Vec3,
    /// World position.
    pub point: Vec3,
    /// Interpolated vertex normal, unit length.
    pub normal: Vec3,
}

/// Draws a scene: a surface with its distance, scenery, pins, a path and its walker.
pub struct Renderer {
    context: Context,
    shared: Shared,
    background: Background,
    ground: Ground,
    surfaces: SurfaceRenderer,
    curve: Curve,
    pins: Pins,
    walkers: Walkers,
    arrows: Arrows,
    wires: Wires,
    camera: Camera,
    environment: Environment,
    look: Look,
    /// The distance at the ramps' end; world units.
    max: f32,
    surface: Option<(Mesh, FieldBuffers)>,
    scenery: Option<Mesh>,
    /// Of surface and scenery together.
    scene: Bounds,
    track: Option<Track>,
    /// The last frame is out of date.
    dirty: bool,
    /// And so are the shadows of what stands still.
    shadows_dirty: bool,
    /// And so is what it keeps off the floor and off itself.
    occlusion_dirty: bool,
}

impl Renderer {
    /// Builds all pipelines.
    ///
    /// # Errors
    /// When the device refuses even the small buffers of pins and walker.
    pub fn new(context: Context) -> Result<Self, Error> {
        let shared = Shared::new(&context);
        let renderer = Self {
            background: Background::new(&context, &shared),
            ground: Ground::new(&context, &shared),
            surfaces: SurfaceRenderer::new(&context, &shared),
            curve: Curve::new(&context, &shared),
            pins: Pins::new(&context, &shared)?,
            walkers: Walkers::new(&context, &shared)?,
            arrows: Arrows::new(&context, &shared)?,
            wires: Wires::new(&context, &shared),
            camera: Camera::new(),
            environment: Environment::default(),
            look: Look::default(),
            max: 1.0,
            surface: None,
            scenery: None,
            scene: Bounds::UNIT,
            track: None,
            dirty: true,
            shadows_dirty: true,
            occlusion_dirty: true,
            shared,
            context,
        };
        renderer.surfaces.set_look(&renderer.context, &renderer.look, renderer.max);
        Ok(renderer)
    }

    /// The graphics interface in use.
    #[must_use]
    pub fn backend(&self) -> Backend {
        self.context.backend()
    }

    /// Canvas size in physical pixels, and how many of them make a CSS pixel.
    pub fn resize(&mut self, width: u32, height: u32, pixel_ratio: f32) {
        self.dirty |= self.context.resize(width, height) || pixel_ratio != self.camera.pixel_ratio();
        self.camera.set_size(width, height, pixel_ratio);
    }

    /// Centres the view on what the insets leave free.
    pub fn set_insets(&mut self, insets: Insets) {
        self.camera.set_insets(insets);
        self.dirty = true;
    }

    /// Replaces the surface; clears field, pins, path, walkers, arrows and edges. The view stays the same relative to the
    /// bounds.
    ///
    /// # Errors
    /// When the arrays do not fit together or the device; the old surface then stays.
    pub fn set_surface(&mut self, arrays: MeshArrays) -> Result<(), Error> {
        let vertex_count = arrays.positions.len();
        self.surface = match Mesh::new(&self.context, arrays)? {
            Some(mesh) => Some((mesh, FieldBuffers::new(&self.context, vertex_count)?)),
            None => None,
        };
        self.pins.set(&self.context, &[], &[], None);
        self.set_path(&[], &[])?;
        self.set_crowd(&[]);
        self.arrows.clear();
        self.wires.clear();
        self.update_bounds();
        Ok(())
    }

    /// Replaces the scenery; without triangles there is none.
    ///
    /// # Errors
    /// When the arrays do not fit together or the device; the old scenery then stays.
    pub fn set_scenery(&mut self, arrays: MeshArrays) -> Result<(), Error> {
        self.scenery = Mesh::new(&self.context, arrays)?;
        self.update_bounds();
        Ok(())
    }

    fn update_bounds(&mut self) {
        let surface = self.surface.as_ref().map_or(Bounds::UNIT, |(mesh, _)| mesh.bounds);
        let all = || Bounds::of_points(self.meshes().flat_map(Mesh::positions));
        let all = if self.scenery.is_some() { all() } else { None };
        self.scene = all.unwrap_or(surface);
        self.camera.set_bounds(surface, self.scene);
        (self.dirty, self.shadows_dirty, self.occlusion_dirty) = (true, true, true);
    }

    fn meshes(&self) -> impl Iterator<Item = &Mesh> + Clone {
        self.surface.iter().map(|(mesh, _)| mesh).chain(&self.scenery)
    }

    /// Finds out anew, if need be, what the scene keeps off the floor and off itself.
    fn occlude(&mut self) {
        if !std::mem::take(&mut self.occlusion_dirty) {
            return;
        }
        if self.meshes().next().is_none() {
            return self.ground.clear();
        }
        let floor = Floor::new(self.scene);
        let mut contact = Contact::new(floor, self.scene);
        let mut occlusion = Occlusion::new(Cube::around(self.scene));
        for mesh in self.meshes() {
            contact.add(mesh.picker.positions(), mesh.picker.triangles());
            occlusion.add(mesh.picker.positions(), mesh.picker.triangles());
        }
        self.ground.set(&self.context, floor, &contact.into_texels());
        self.shared.lighting.set_occlusion(&self.context, &occlusion.into_texels());
    }

    fn radius(&self) -> f32 {
        self.surface.as_ref().map_or(Bounds::UNIT.radius, |(mesh, _)| mesh.bounds.radius)
    }

    /// Replaces the distance: `fill` writes one value a vertex, infinite where unreachable, and the direction in which it
    /// grows, four numbers a vertex, 127 for a unit. `count` values come; none removes the field.
    ///
    /// # Errors
    /// When the count is not the surface's number of vertices.
    pub fn set_field(&mut self, count: usize, max: f32, fill: impl FnOnce(&mut [f32], &mut [i8])) -> Result<(), Error> {
        self.dirty = true;
        let expected = self.surface.as_ref().map_or(0, |(_, field)| field.vertex_count());
        let Some((_, field)) = &mut self.surface else {
            return if count == 0 {
                Ok(())
            } else {
                Err(Error::WrongLength { what: "distances", expected, found: count })
            };
        };
        if count == 0 {
            field.clear();
            return Ok(());
        }
        if count != expected {
            return Err(Error::WrongLength { what: "distances", expected, found: count });
        }
        field.write(&self.context, fill);
        self.max = max;
        self.surfaces.set_look(&self.context, &self.look, self.max);
        Ok(())
    }

    /// How the distance is painted.
    #[must_use]
    pub fn look(&self) -> Look {
        self.look
    }

    /// Paints the distance another way.
    pub fn set_look(&mut self, look: Look) {
        self.look = look;
        self.surfaces.set_look(&self.context, &self.look, self.max);
        self.dirty = true;
    }

    /// Colours over distance / max: 256 RGBA texels of the surface and as many of the stripes, sRGB bytes.
    ///
    /// # Errors
    /// When there are more or fewer.
    pub fn set_ramps(&mut self, texels: &[u8]) -> Result<(), Error> {
        let texels = texels.try_into().map_err(|_| Error::WrongLength {
            what: "ramp texels",
            expected: RAMP_BYTES,
            found: texels.len(),
        })?;
        self.surfaces.set_ramps(&self.context, texels);
        self.dirty = true;
        Ok(())
    }

    /// What lights the scene, facing a camera of this yaw; radians.
    pub fn set_environment(&mut self, surroundings: Surroundings, yaw: f32) {
        self.environment = Environment { surroundings, yaw };
        (self.dirty, self.shadows_dirty) = (true, true);
    }

    /// Colours of the background's upper and lower edge; sRGB, 0..1.
    pub fn set_background(&mut self, top: Vec3, bottom: Vec3) {
        self.background.set_colors(&self.context, top, bottom);
        self.dirty = true;
    }

    /// Replaces the pins; one normal a position.
    ///
    /// # Errors
    /// When their numbers differ.
    pub fn set_pins(&mut self, positions: &[Vec3], normals: &[Vec3], selected: Option<usize>) -> Result<(), Error> {
        same_length("pin normals", positions, normals)?;
        self.pins.set(&self.context, positions, normals, selected);
        self.dirty = true;
        Ok(())
    }

    /// Replaces the path, from start to source; one normal a point, empty for none. The walker leaves.
    ///
    /// # Errors
    /// When their numbers differ.
    pub fn set_path(&mut self, points: &[Vec3], normals: &[Vec3]) -> Result<(), Error> {
        same_length("path normals", points, normals)?;
        self.curve.set_points(&self.context, points);
        self.track = Track::new(points.to_vec(), normals.to_vec());
        self.walkers.hide();
        self.dirty = true;
        Ok(())
    }

    /// Replaces the arrows: one vector a triangle of the surface, of any length; empty for none.
    ///
    /// # Errors
    /// When there are more or fewer.
    pub fn set_arrows(&mut self, vectors: &[Vec3]) -> Result<(), Error> {
        self.dirty = true;
        self.arrows.clear();
        let Some((mesh, _)) = self.surface.as_ref().filter(|_| !vectors.is_empty()) else { return Ok(()) };
        let (expected, found) = (3 * mesh.picker.triangles().len(), 3 * vectors.len());
        if found != expected {
            return Err(Error::WrongLength { what: "arrows", expected, found });
        }
        self.arrows.set(&self.context, &mesh.picker, vectors, mesh.bounds.radius);
        Ok(())
    }

    /// Takes all edges away.
    pub fn clear_edges(&mut self) {
        self.wires.clear();
        self.dirty = true;
    }

    /// Adds edges, two ends each, of one colour; sRGB, 0..1.
    pub fn add_edges(&mut self, ends: &[[Vec3; 2]], color: Vec3) {
        self.wires.add(&self.context, ends, color);
        self.dirty = true;
    }

    /// Stands the walker on the path at an arc length from its start; nothing happens without a path.
    pub fn set_walker(&mut self, arc: f32) {
        let radius = self.radius();
        let Some(track) = &self.track else { return };
        self.walkers.stand(&self.context, track, arc, radius);
        self.dirty = true;
    }

    /// Takes the walker away.
    pub fn hide_walker(&mut self) {
        self.walkers.hide();
        self.dirty = true;
    }

    /// Replaces the crowd: 10 numbers a walker, its position, unit normal, unit heading and the length walked.
    pub fn set_crowd(&mut self, poses: &[[f32; POSE_NUMBERS]]) {
        let radius = self.radius();
        self.walkers.set_crowd(&self.context, poses, radius);
        self.dirty = true;
    }

    /// The camera's current view.
    #[must_use]
    pub fn view(&self) -> View {
        self.camera.view()
    }

    /// Changes the camera.
    pub fn move_camera(&mut self, change: impl FnOnce(&mut Camera)) {
        change(&mut self.camera);
        self.dirty = true;
    }

    /// The nearest place of the surface under a physical pixel; None where there is none or scenery hides it.
    #[must_use]
    pub fn pick(&self, pixel: Vec2) -> Option<SurfaceHit> {
        let ray = self.camera.ray(pixel);
        let (mesh, _) = self.surface.as_ref()?;
        let hit = mesh.picker.cast(ray)?;
        let hidden = self.scenery.as_ref().and_then(|scenery| scenery.picker.cast(ray));
        if hidden.is_some_and(|scenery| scenery.depth < hit.depth) {
            return None;
        }
        let [a, b, c] = mesh.picker.corners(hit.triangle).map(|vertex| mesh.normals[vertex as usize]);
        let normal = hit.weights.x * a + hit.weights.y * b + hit.weights.z * c;
        Some(SurfaceHit {
            triangle: hit.triangle,
            weights: hit.weights,
            point: ray.origin + hit.depth * ray.direction,
            normal: normal.try_normalize().unwrap_or(a),
        })
    }

    /// Physical pixel and depth of a world point; None behind the camera.
    #[must_use]
    pub fn project(&self, point: Vec3) -> Option<Vec3> {
        self.camera.project(point)
    }

    /// True when the last frame is out of date, the camera is on its way, or the device was lost (which only `render`
    /// can tell).
    #[must_use]
    pub fn needs_frame(&self) -> bool {
        self.dirty || self.camera.is_moving() || self.context.is_lost()
    }

    /// Draws one frame; `seconds` since the last one. Returns false when the canvas or the device was lost.
    pub fn render(&mut self, seconds: f64) -> bool {
        self.camera.advance(seconds);
        let frame = match self.context.next_frame() {
            NextFrame::Ready(frame) => frame,
            // The picture stays out of date, so that the page asks again.
            NextFrame::Later => return true,
            NextFrame::Lost => return false,
        };
        self.occlude();
        let encoder = self.prepare(&self.camera, self.context.size());
        self.context.present(frame, encoder, |pass| self.draw(pass, self.camera.eye(), false));
        (self.dirty, self.shadows_dirty) = (false, false);
        true
    }

    /// Draws the same beside the canvas, `scale` times as large. `is_clear` leaves the background out.
    ///
    /// # Errors
    /// [`Error::PictureTooLarge`].
    pub fn capture(&mut self, scale: f32, is_clear: bool) -> Result<Capture, Error> {
        let limit = self.context.device.limits().max_texture_dimension_2d;
        let (width, height) = self.context.size();
        let [width, height] = [width, height].map(|side| ((side as f32 * scale).round() as u32).max(1));
        if width.max(height) > limit {
            return Err(Error::PictureTooLarge { width, height, limit });
        }
        let camera = self.camera.scaled(scale);
        self.occlude();
        let encoder = self.prepare(&camera, (width, height));
        let capture =
            Capture::new(&self.context, (width, height), encoder, |pass| self.draw(pass, camera.eye(), is_clear))?;
        self.shadows_dirty = false;
        // The frame's uniform is now that of the picture.
        self.dirty = true;
        Ok(capture)
    }

    /// Writes the frame's uniform and draws the shadows that have changed.
    fn prepare(&self, camera: &Camera, size: (u32, u32)) -> wgpu::CommandEncoder {
        let shadows = ShadowView::new(self.scene, self.environment.key());
        let moves = self.walkers.are_out() || !self.pins.is_empty();
        let radius = self.radius();
        self.shared.write(
            &self.context,
            &FrameUniform {
                eye: camera.eye(),
                radius,
                size,
                pixel_ratio: camera.pixel_ratio(),
                shadows,
                moving: shadows.cover(self.walkers.balls().chain(self.pins.balls(radius))),
                cube: Cube::around(self.scene),
                environment: self.environment,
            },
        );
        let mut encoder = self.context.encoder();
        if self.shadows_dirty {
            self.ground.set_light(&self.context, self.environment.key_share());
            self.shared.lighting.maps.draw(&mut encoder, Casters::Still, |pass| {
                pass.set_bind_group(0, &self.shared.shadow_group, &[]);
                for mesh in self.meshes() {
                    self.surfaces.draw_shadow(pass, &mesh.buffers);
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

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, eye: Eye, is_clear: bool) {
        pass.set_bind_group(0, &self.shared.camera_group, &[]);
        pass.set_bind_group(1, &self.shared.lighting.group, &[]);
        if !is_clear {
            self.background.draw(pass);
        }
        self.ground.draw(pass, eye.position.y as f32);
        if let Some((mesh, field)) = &self.surface {
            self.surfaces.draw(pass, &mesh.buffers, field);
        }
        if let Some(mesh) = &self.scenery {
            self.surfaces.draw_scenery(pass, &mesh.buffers);
        }
        self.walkers.draw(pass);
        self.pins.draw(pass);
        self.arrows.draw(pass);
        self.curve.draw(pass);
        self.wires.draw(pass);
    }
}

fn same_length(what: &'static str, positions: &[Vec3], normals: &[Vec3]) -> Result<(), Error> {
    if positions.len() == normals.len() {
        return Ok(());
    }
    Err(Error::WrongLength { what, expected: 3 * positions.len(), found: 3 * normals.len() })
}

/// The view from the six numbers that the share link carries: yaw, pitch, distance, target.
#[must_use]
pub fn view_from_numbers(numbers: [f64; 6]) -> View {
    let [yaw, pitch, distance, x, y, z] = numbers;
    View { yaw, pitch, distance, target: DVec3::new(x, y, z) }
}

/// The six numbers of [`view_from_numbers`].
#[must_use]
pub fn numbers_from_view(view: View) -> [f64; 6] {
    [view.yaw, view.pitch, view.distance, view.target.x, view.target.y, view.target.z]
}
