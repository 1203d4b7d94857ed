//! What is shown.

use glam::Vec3;
use heatwalk_bake::{BoundingSphere, Shade};

use super::Renderer;
use crate::check;
use crate::environment::{Environment, Surroundings};
use crate::error::Error;
use crate::image::Image;
use crate::material::Material;
use crate::mesh::{Mesh, MeshArrays, MeshPose};
use crate::model::ModelRenderer;
use crate::patch::{PatchArrays, Patches};
use crate::pose::{CrowdPose, Track};
use crate::punctual::PunctualLight;
use crate::shell::ramp_row;
use crate::style::Style;
use crate::surface::{FieldBuffers, RAMP_BYTES};

impl Renderer {
    /// Replaces the surface; clears field, patches, pins, path, walker, crowd, arrows, edges, cut, section and shells. The view stays the
    /// same relative to the bounds. `shade`: that of the surface alone, where it is known.
    ///
    /// # Errors
    /// When the arrays do not fit together, or the device, or are no finite places; the old surface then stays.
    pub fn set_surface(&mut self, arrays: MeshArrays, shade: Option<Shade>) -> Result<(), Error> {
        let vertex_count = arrays.positions.len();
        self.surface = match Mesh::new(&self.context, arrays)? {
            Some(mesh) => Some((mesh, FieldBuffers::new(&self.context, vertex_count)?)),
            None => None,
        };
        self.other = None;
        self.patches = None;
        self.shade = shade;
        self.pins.set(&self.context, &[], &[], None);
        self.curve.set_points(&self.context, &[]);
        self.track = None;
        self.walkers.clear();
        self.arrows.clear();
        self.arrows.clear_inner();
        self.wires.clear();
        self.inside.clear();
        self.adopt_meshes();
        Ok(())
    }

    /// Replaces the materials that meshes with an appearance are drawn in, and the images that these use.
    pub fn set_materials(&mut self, materials: &[Material], images: &[Image]) {
        // Most files have none, and its pipelines take their time.
        if self.models.is_some() || !materials.is_empty() {
            let make = || ModelRenderer::new(&self.context);
            self.models.get_or_insert_with(make).set_materials(&self.context, materials, images);
            let surface = self.surface.iter_mut().map(|(mesh, _)| mesh);
            surface.chain(&mut self.scenery).for_each(Mesh::forget_order);
            self.dirty = true;
        }
    }

    /// Replaces the scenery.
    ///
    /// # Errors
    /// When the arrays do not fit together, or the device, or are no finite places; the old scenery then stays.
    pub fn set_scenery(&mut self, meshes: Vec<MeshArrays>) -> Result<(), Error> {
        let made = meshes.into_iter().filter_map(|arrays| Mesh::new(&self.context, arrays).transpose());
        self.scenery = made.collect::<Result<_, _>>()?;
        self.adopt_meshes();
        Ok(())
    }

    /// Replaces the patches on the surface, and the materials and images that these use.
    ///
    /// # Errors
    /// When the arrays do not fit together, or the device, or are no finite places; the old patches then stay.
    pub fn set_patches(&mut self, arrays: PatchArrays, materials: &[Material], images: &[Image]) -> Result<(), Error> {
        let models = self.models.get_or_insert_with(|| ModelRenderer::new(&self.context));
        self.patches = Patches::new(&self.context, models, arrays, materials, images)?;
        self.dirty = true;
        Ok(())
    }

    /// Moves the vertices of the surface. What it keeps off the light stays until a pose comes that it is to rest in.
    ///
    /// # Errors
    /// When there are more or fewer, or one is no finite place; the pose before then stays.
    pub fn set_pose(&mut self, pose: MeshPose, rests: bool) -> Result<(), Error> {
        let Some((mesh, _)) = &mut self.surface else { return Ok(()) };
        mesh.pose(&self.context, pose)?;
        self.adopt_pose(rests);
        Ok(())
    }

    /// The same for a mesh of the scenery.
    ///
    /// # Errors
    /// As [`Self::set_pose`].
    pub fn set_scenery_pose(&mut self, index: usize, pose: MeshPose, rests: bool) -> Result<(), Error> {
        let Some(mesh) = self.scenery.get_mut(index) else { return Ok(()) };
        mesh.pose(&self.context, pose)?;
        self.adopt_pose(rests);
        Ok(())
    }

    /// Bounds only grow while poses change, so that shadows and floor stand still.
    fn adopt_pose(&mut self, rests: bool) {
        let grown = |reach: [Vec3; 2], &place: &Vec3| [reach[0].min(place), reach[1].max(place)];
        let before = self.reach.unwrap_or_else(|| self.scene.cube());
        let reach = self.meshes().flat_map(Mesh::positions).fold(before, grown);
        self.reach = Some(reach);
        self.adopt_bounds();
        (self.dirty, self.shadows_dirty) = (true, true);
        if rests {
            self.scene = self.shadowed();
            self.shade = None;
            self.occlusion_dirty = true;
        }
    }

    fn adopt_meshes(&mut self) {
        if self.models.is_none() && self.meshes().any(|mesh| mesh.model.is_some()) {
            self.models = Some(ModelRenderer::new(&self.context));
        }
        let surface = self.surface.as_ref().map_or(BoundingSphere::UNIT, |(mesh, _)| mesh.bounds);
        let all = || BoundingSphere::of_points(self.meshes().flat_map(Mesh::positions));
        let all = if self.scenery.is_empty() { None } else { all() };
        self.scene = all.unwrap_or(surface);
        self.reach = None;
        self.adopt_bounds();
        (self.dirty, self.shadows_dirty, self.occlusion_dirty) = (true, true, true);
    }

    /// Tells the camera what is drawn where.
    pub(super) fn adopt_bounds(&mut self) {
        self.inside.measure(self.shadowed().center);
        let surface = self.surface.as_ref().map_or(BoundingSphere::UNIT, |(mesh, _)| mesh.bounds);
        self.camera.set_bounds(surface, self.drawn());
    }

    /// Replaces the field: `fill` writes one value a vertex, infinite where unreachable, and the direction in which it
    /// grows, four numbers a vertex, 127 for a unit; `is_by_corner`: one a corner of each triangle of a surface that is
    /// [tinted](Self::set_tints) instead. `max` is the largest finite value, 0 where none is above. `count` values come; none
    /// removes the field.
    ///
    /// # Errors
    /// When the count is not the surface's number of vertices, or of corners, or `max` is no finite number, or values come by corner
    /// and the surface is not tinted; the old field then stays.
    pub fn set_field(
        &mut self,
        count: usize,
        max: f64,
        is_by_corner: bool,
        fill: impl FnOnce(&mut [f32], &mut [i8]),
    ) -> Result<(), Error> {
        let expected = self.surface.as_ref().map_or(0, |(_, field)| field.value_count(is_by_corner));
        if count != 0 && count != expected {
            return Err(Error::WrongLength { what: "distances", expected, found: count });
        }
        if !(max >= 0.0 && max.is_finite()) {
            return Err(Error::NoNumber { what: "largest distance" });
        }
        let Some((_, field)) = &mut self.surface else { return Ok(()) };
        self.dirty = true;
        if count == 0 {
            field.clear();
            return Ok(());
        }
        // All are 0 where the largest is.
        let before = std::mem::replace(&mut self.max, if max > 0.0 { max } else { 1.0 });
        if self.max != before {
            self.inside.scale(&self.context, self.max);
        }
        field.write(&self.context, self.max, is_by_corner, fill);
        self.surfaces.set_style(&self.context, &self.style, self.max);
        Ok(())
    }

    /// How the field is drawn.
    #[must_use]
    pub fn style(&self) -> Style {
        self.style
    }

    /// Draws the field in another style.
    pub fn set_style(&mut self, style: Style) {
        self.style = style;
        self.surfaces.set_style(&self.context, &self.style, self.max);
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
        self.inside.set_ramp_row(&self.context, ramp_row(texels));
        self.dirty = true;
        Ok(())
    }

    /// What lights the scene, facing a camera of this yaw; radians.
    pub fn set_environment(&mut self, surroundings: Surroundings, yaw: f32) {
        self.environment = Environment { surroundings, yaw };
        (self.dirty, self.shadows_dirty) = (true, true);
    }

    /// Replaces the lights of a file, which stand in for those of the environment; of more than [`MOST_PUNCTUAL`] the first
    /// are drawn. None: those of the environment light the scene.
    ///
    /// [`MOST_PUNCTUAL`]: crate::MOST_PUNCTUAL
    pub fn set_lights(&mut self, lights: Vec<PunctualLight>) {
        self.lights = lights;
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
    /// When their numbers differ or one is not finite.
    pub fn set_pins(&mut self, positions: &[Vec3], normals: &[Vec3], selected: Option<usize>) -> Result<(), Error> {
        check::same_length("pin normals", positions, normals)?;
        check::places("pin positions", positions)?;
        check::vectors("pin normals", normals)?;
        self.pins.set(&self.context, positions, normals, selected);
        self.dirty = true;
        Ok(())
    }

    /// Replaces the path, from start to source; one normal a point, empty for none. The walker leaves.
    ///
    /// # Errors
    /// When their numbers differ or one is not finite.
    pub fn set_path(&mut self, points: &[Vec3], normals: &[Vec3]) -> Result<(), Error> {
        check::same_length("path normals", points, normals)?;
        check::places("path points", points)?;
        check::vectors("path normals", normals)?;
        self.curve.set_points(&self.context, points);
        self.track = Track::new(points.to_vec(), normals.to_vec());
        self.walkers.hide();
        self.dirty = true;
        Ok(())
    }

    /// Replaces the arrows: one vector a triangle of the surface, of any length; empty for none.
    ///
    /// # Errors
    /// When there are more or fewer, or one is not finite.
    pub fn set_arrows(&mut self, vectors: &[Vec3]) -> Result<(), Error> {
        let triangles = self.surface.as_ref().map_or(0, |(mesh, _)| mesh.picker.triangles().len());
        if !vectors.is_empty() && vectors.len() != triangles {
            return Err(Error::WrongLength { what: "arrows", expected: 3 * triangles, found: 3 * vectors.len() });
        }
        check::vectors("arrows", vectors)?;
        self.dirty = true;
        self.arrows.clear();
        let Some((mesh, _)) = self.surface.as_ref().filter(|_| !vectors.is_empty()) else { return Ok(()) };
        self.arrows.set(&self.context, &mesh.picker, vectors, mesh.bounds.radius);
        Ok(())
    }

    /// Takes all edges away.
    pub fn clear_edges(&mut self) {
        self.wires.clear();
        self.dirty = true;
    }

    /// Adds edges, two ends each, of one colour (sRGB, 0..1) and so wide; CSS pixels.
    ///
    /// # Errors
    /// When an end is no finite place.
    pub fn add_edges(&mut self, ends: &[[Vec3; 2]], color: Vec3, width: f32) -> Result<(), Error> {
        check::places("edges", ends.as_flattened())?;
        self.wires.add(&self.context, ends, color, width);
        self.dirty = true;
        Ok(())
    }

    /// Stands the walker on the path at an arc length from its start; nothing happens without a path.
    pub fn set_walker(&mut self, arc: f32) {
        let arc = if arc.is_finite() { arc } else { 0.0 };
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

    /// Replaces the crowd. `height`: of each walker, in bounding radii of the surface.
    ///
    /// # Errors
    /// When a number is not finite.
    pub fn set_crowd(&mut self, poses: &[CrowdPose], height: f32) -> Result<(), Error> {
        if let Some(index) = poses.iter().position(|pose| !pose.is_finite()) {
            return Err(Error::NotFinite { what: "poses", index });
        }
        let radius = self.radius();
        self.walkers.set_crowd(&self.context, poses, height * radius);
        self.dirty = true;
        Ok(())
    }
}
