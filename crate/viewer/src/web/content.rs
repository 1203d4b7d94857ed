//! What is shown.

use glam::Vec3;
use js_sys::{Array, Float32Array, Int8Array};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use super::Viewer;
use super::materials::{DrawnMaterial, image, material};
use super::numbers::{
    DrawnMesh, DrawnShade, appearance, color, finish, lights as lights_of, mesh_arrays, mesh_pose, patch_arrays,
    points, shade,
};
use crate::environment;
use crate::error::Error;
use crate::image::Image;
use crate::material::Material;
use crate::pose::CrowdPose;
use crate::style::{Blend, Pattern, Style};

/// The names of the [surroundings](environment::Surroundings).
#[wasm_bindgen]
#[derive(Clone, Copy)]
pub enum Surroundings {
    Studio = "studio",
    Sky = "sky",
    Night = "night",
}

/// The names of the [ways](Blend) in which stripes lie on the materials of a file.
#[wasm_bindgen]
#[derive(Clone, Copy)]
pub enum StripeBlend {
    Over = "over",
    Contrast = "contrast",
    Multiply = "multiply",
}

#[wasm_bindgen]
impl Viewer {
    /// Replaces the surface; clears field, patches, pins, path, walker, crowd, arrows, edges, cut, section and shells. `shaded`: what it
    /// keeps off the light where it is alone, if that is known.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together, are too large for the device or hold no finite places; what is shown
    /// stays.
    pub fn set_surface(&mut self, mesh: &DrawnMesh, shaded: Option<DrawnShade>) -> Result<(), JsError> {
        let shade = shaded.map(|shaded| shade(&shaded)).transpose()?;
        Ok(self.renderer.set_surface(mesh_arrays(mesh)?, shade)?)
    }

    /// Replaces the materials of the file and the images that these use, decoded without colour conversion and without
    /// alpha multiplied in; null for one that could not be decoded. To be set before the meshes.
    ///
    /// # Errors
    /// Throws when a material has other than four numbers for its base color or five channels.
    pub fn set_materials(
        &mut self,
        materials: Vec<DrawnMaterial>,
        #[wasm_bindgen(unchecked_param_type = "readonly (ImageBitmap | null)[]")] images: &Array,
    ) -> Result<(), JsError> {
        let (materials, images) = given(materials, images)?;
        self.renderer.set_materials(&materials, &images);
        Ok(())
    }

    /// Whether a surface whose file has materials is seen in these, and how stripes lie on them.
    ///
    /// # Errors
    /// Throws for another name.
    pub fn set_materials_of_file(&mut self, has_materials_of_file: bool, blend: StripeBlend) -> Result<(), JsError> {
        let blend = match blend {
            StripeBlend::Over => Blend::Over,
            StripeBlend::Contrast => Blend::Contrast,
            StripeBlend::Multiply => Blend::Multiply,
            StripeBlend::__Invalid => return Err(JsError::new("There is no such blending.")),
        };
        self.change_style(|style| Style { has_materials_of_file, blend, ..style });
        Ok(())
    }

    /// Replaces the scenery; empty for none.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together, are too large for the device or hold no finite places; what is shown
    /// stays.
    pub fn set_scenery(&mut self, meshes: Vec<DrawnMesh>) -> Result<(), JsError> {
        let meshes = meshes.into_iter().map(|mesh| mesh_arrays(&mesh)).collect::<Result<_, _>>()?;
        Ok(self.renderer.set_scenery(meshes)?)
    }

    /// Replaces what lies on the surface, a little above it, and lets it through by the alpha of these materials, which are set as those
    /// of the file are. Of the mesh `order` and `boxes` are not used. Without triangles: nothing.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together, are too large for the device or hold no finite places; what is shown
    /// stays.
    pub fn set_patches(
        &mut self,
        mesh: &DrawnMesh,
        materials: Vec<DrawnMaterial>,
        #[wasm_bindgen(unchecked_param_type = "readonly (ImageBitmap | null)[]")] images: &Array,
    ) -> Result<(), JsError> {
        let (materials, images) = given(materials, images)?;
        Ok(self.renderer.set_patches(patch_arrays(mesh)?, &materials, &images)?)
    }

    /// Moves the surface's vertices: `#D × 3` positions and unit normals. `rests`: it stays in this pose for a while.
    ///
    /// # Errors
    /// Throws when there are more or fewer numbers than vertices, or one is not finite.
    pub fn set_pose(&mut self, positions: &Float32Array, normals: &Float32Array, rests: bool) -> Result<(), JsError> {
        Ok(self.renderer.set_pose(mesh_pose(positions, normals)?, rests)?)
    }

    /// The same for a mesh of the scenery, by its index.
    ///
    /// # Errors
    /// As `set_pose`.
    pub fn set_scenery_pose(
        &mut self,
        index: usize,
        positions: &Float32Array,
        normals: &Float32Array,
        rests: bool,
    ) -> Result<(), JsError> {
        Ok(self.renderer.set_scenery_pose(index, mesh_pose(positions, normals)?, rests)?)
    }

    /// One value a drawn vertex, Infinity = unreachable, and the direction in which it grows, four numbers a drawn vertex,
    /// 127 for a unit; empty = no field. `by_corner`: one a corner of each triangle of a tinted surface instead.
    ///
    /// # Errors
    /// Throws when the numbers of values are not those of the surface's vertices, or `max`, the largest finite value, is no
    /// finite number.
    pub fn set_field(
        &mut self,
        values: &Float32Array,
        tangents: &Int8Array,
        max: f64,
        by_corner: bool,
    ) -> Result<(), JsError> {
        let count = value_count(values, tangents)?;
        Ok(self.renderer.set_field(count, max, by_corner, writer(values, tangents))?)
    }

    /// Another field of the same surface, on the right of the split, in colors up to the `max` of the first, which is to be set
    /// before; empty = none.
    ///
    /// # Errors
    /// Throws when the numbers of values are not those of the surface's vertices.
    pub fn set_other_field(
        &mut self,
        values: &Float32Array,
        tangents: &Int8Array,
        by_corner: bool,
    ) -> Result<(), JsError> {
        let count = value_count(values, tangents)?;
        Ok(self.renderer.set_other_field(count, by_corner, writer(values, tangents))?)
    }

    /// Where the right of two fields begins: so far right of the middle of what the insets leave free, a share of the view's width.
    pub fn set_split(&mut self, split: f32) {
        self.renderer.set_split(split);
    }

    /// Tints the triangles of the surface, which `mesh` was set as: `#F × 4` bytes, linear RGB and opacity, 255 for walls.
    ///
    /// # Errors
    /// Throws when there are more or fewer, or the arrays are too large for the device.
    pub fn set_tints(&mut self, mesh: &DrawnMesh, tints: &[u8]) -> Result<(), JsError> {
        let (faces, rest) = tints.as_chunks::<4>();
        if !rest.is_empty() {
            return Err(Error::WrongLength { what: "tints", expected: 4 * faces.len(), found: tints.len() }.into());
        }
        Ok(self.renderer.set_tints(faces, || appearance(mesh))?)
    }

    /// Outlines a brush of a radius about a place on the surface; 0 for none.
    pub fn set_brush(&mut self, x: f32, y: f32, z: f32, radius: f32) {
        self.renderer.set_brush(Vec3::new(x, y, z), radius);
    }

    /// Stripes: period in the unit of the field's values, share of it covered, sharpness 0..1, height in periods.
    pub fn set_bands(&mut self, period: f64, width: f32, sharpness: f32, relief: f32) {
        self.change_style(|style| Style { period, pattern: Pattern::Bands { width, sharpness, relief }, ..style });
    }

    /// Thin lines: period in the unit of the field's values, width in CSS pixels.
    pub fn set_lines(&mut self, period: f64, width: f32) {
        self.change_style(|style| Style { period, pattern: Pattern::Lines { width }, ..style });
    }

    /// Opacity of the stripes' own colour, then metalness, roughness and glow of the surface and of the stripes.
    ///
    /// # Errors
    /// Throws when a finish has not three numbers.
    pub fn set_finish(&mut self, stripe_opacity: f32, surface: &[f32], stripe: &[f32]) -> Result<(), JsError> {
        let (surface, stripe) = (finish("surface finish", surface)?, finish("stripe finish", stripe)?);
        self.change_style(|style| Style { stripe_opacity, surface, stripe, ..style });
        Ok(())
    }

    /// Moves the pattern away from the sources; periods.
    pub fn set_offset(&mut self, offset: f32) {
        self.change_style(|style| Style { offset, ..style });
    }

    /// 256 × 4 sRGB bytes over value / max for the surface, then as many for the stripes.
    ///
    /// # Errors
    /// Throws when the length differs.
    pub fn set_ramps(&mut self, ramps: &[u8]) -> Result<(), JsError> {
        Ok(self.renderer.set_ramps(ramps)?)
    }

    /// Lights of the file in the place of those of the environment, twelve numbers each: position and 1, or the direction to
    /// one that is far away and 0; direction in which it shines and the offset of its cone; colour and the slope of its cone.
    /// Empty for none.
    ///
    /// # Errors
    /// Throws when numbers are left over, or one is not finite.
    pub fn set_lights(&mut self, lights: &[f32]) -> Result<(), JsError> {
        self.renderer.set_lights(lights_of(lights)?);
        Ok(())
    }

    /// What lights the scene, facing a camera of this yaw in radians.
    ///
    /// # Errors
    /// Throws for another name.
    pub fn set_environment(&mut self, surroundings: Surroundings, yaw: f32) -> Result<(), JsError> {
        let surroundings = match surroundings {
            Surroundings::Studio => environment::Surroundings::Studio,
            Surroundings::Sky => environment::Surroundings::Sky,
            Surroundings::Night => environment::Surroundings::Night,
            Surroundings::__Invalid => return Err(JsError::new("There are no such surroundings.")),
        };
        self.renderer.set_environment(surroundings, yaw);
        Ok(())
    }

    /// Colours of the upper and lower edge; sRGB 0..1.
    ///
    /// # Errors
    /// Throws when a colour has not three numbers.
    pub fn set_background(&mut self, top: &[f32], bottom: &[f32]) -> Result<(), JsError> {
        self.renderer.set_background(color("top color", top)?, color("bottom color", bottom)?);
        Ok(())
    }

    /// `#P × 3` positions and normals; selected −1 = none.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together or hold no finite places.
    pub fn set_pins(&mut self, positions: &[f32], normals: &[f32], selected: i32) -> Result<(), JsError> {
        let selected = usize::try_from(selected).ok();
        Ok(self.renderer.set_pins(&points("pin positions", positions)?, &points("pin normals", normals)?, selected)?)
    }

    /// `#P × 3` points and normals from start to source; empty = none.
    ///
    /// # Errors
    /// Throws when the arrays do not fit together or hold no finite places.
    pub fn set_path(&mut self, path: &[f32], normals: &[f32]) -> Result<(), JsError> {
        Ok(self.renderer.set_path(&points("path points", path)?, &points("path normals", normals)?)?)
    }

    /// `#F × 3` vectors, of any length, drawn as arrows; empty = none.
    ///
    /// # Errors
    /// Throws when their number is not that of the surface's triangles.
    pub fn set_arrows(&mut self, vectors: &[f32]) -> Result<(), JsError> {
        Ok(self.renderer.set_arrows(&points("arrows", vectors)?)?)
    }

    /// Takes all edges away.
    pub fn clear_edges(&mut self) {
        self.renderer.clear_edges();
    }

    /// Adds `#E × 2 × 3` ends of edges in an sRGB colour, 0..1, so many CSS pixels wide.
    ///
    /// # Errors
    /// Throws when the numbers are no pairs of points or the colour has not three numbers.
    pub fn add_edges(&mut self, ends: &[f32], rgb: &[f32], width: f32) -> Result<(), JsError> {
        let (pairs, rest) = ends.as_chunks::<6>();
        if !rest.is_empty() {
            return Err(Error::WrongLength { what: "edges", expected: 6 * pairs.len(), found: ends.len() }.into());
        }
        let ends: Vec<[Vec3; 2]> =
            pairs.iter().map(|&[a, b, c, d, e, f]| [Vec3::new(a, b, c), Vec3::new(d, e, f)]).collect();
        Ok(self.renderer.add_edges(&ends, color("edge color", rgb)?, width)?)
    }

    /// Stands the walker at an arc length of the path.
    pub fn set_walker(&mut self, arc: f32) {
        self.renderer.set_walker(arc);
    }

    /// `#walkers × 10`: position, unit normal, unit heading, length walked; empty = none. `height`: of each, in bounding
    /// radii of the surface.
    ///
    /// # Errors
    /// Throws when the numbers are no tens or not finite.
    pub fn set_crowd(&mut self, poses: &[f32], height: f32) -> Result<(), JsError> {
        let walkers: &[CrowdPose] = bytemuck::try_cast_slice(poses).map_err(|_| {
            let expected = poses.len() - poses.len() % (size_of::<CrowdPose>() / size_of::<f32>());
            Error::WrongLength { what: "poses", expected, found: poses.len() }
        })?;
        Ok(self.renderer.set_crowd(walkers, height)?)
    }

    /// Takes the walker away.
    pub fn hide_walker(&mut self) {
        self.renderer.hide_walker();
    }
}

impl Viewer {
    fn change_style(&mut self, change: impl FnOnce(Style) -> Style) {
        self.renderer.set_style(change(self.renderer.style()));
    }
}

/// Materials and the images that they use.
fn given(materials: Vec<DrawnMaterial>, images: &Array) -> Result<(Vec<Material>, Vec<Image>), Error> {
    let materials = materials.into_iter().map(|given| material(&given)).collect::<Result<_, _>>()?;
    Ok((materials, images.iter().map(image).collect()))
}

/// How many values come, each with its direction.
fn value_count(values: &Float32Array, tangents: &Int8Array) -> Result<usize, Error> {
    let (count, found) = (values.length() as usize, tangents.length() as usize);
    if found != 4 * count {
        return Err(Error::WrongLength { what: "tangents", expected: 4 * count, found });
    }
    Ok(count)
}

/// What writes values and their directions.
fn writer(values: &Float32Array, tangents: &Int8Array) -> impl FnOnce(&mut [f32], &mut [i8]) {
    move |distances, directions| {
        values.copy_to(distances);
        tangents.copy_to(directions);
    }
}
