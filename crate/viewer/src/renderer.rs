mod content;
mod frame;
mod halves;
mod inside;
mod tint;

use glam::{Vec2, Vec3};

use crate::arrow::Arrows;
use crate::background::Background;
use crate::camera::{Camera, Insets, View};
use crate::canvas::Canvas;
use crate::context::{Backend, Context};
use crate::curve::Curve;
use crate::environment::Environment;
use crate::error::Error;
use crate::ground::Ground;
use crate::inside::Inside;
use crate::mesh::Mesh;
use crate::model::ModelRenderer;
use crate::patch::Patches;
use crate::pin::Pins;
use crate::pose::Track;
use crate::punctual::PunctualLight;
use crate::shared::Shared;
use crate::style::Style;
use crate::surface::{FieldBuffers, SurfaceRenderer};
use crate::walker::Walkers;
use crate::wire::Wires;
use heatwalk_bake::{BoundingSphere, Shade};

/// A place on the surface or the section under a pixel.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceHit {
    /// Whether it is on the section.
    pub is_on_section: bool,
    /// Index of the triangle, of the surface or of the section.
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
    canvas: Option<Canvas>,
    shared: Shared,
    background: Background,
    ground: Ground,
    surfaces: SurfaceRenderer,
    /// Once a file with materials was shown.
    models: Option<ModelRenderer>,
    curve: Curve,
    pins: Pins,
    walkers: Walkers,
    arrows: Arrows,
    wires: Wires,
    camera: Camera,
    environment: Environment,
    /// Of the file, in the place of those of the environment; none where these are on.
    lights: Vec<PunctualLight>,
    style: Style,
    /// The largest value of the field, at the ramps' end; above 0.
    max: f64,
    surface: Option<(Mesh, FieldBuffers)>,
    /// The field on the right of the split, where there is one.
    other: Option<FieldBuffers>,
    /// Where that begins, from the middle of what the insets leave free; share of the view's width.
    split: f32,
    /// Of the surface alone, where it was given.
    shade: Option<Shade>,
    scenery: Vec<Mesh>,
    patches: Option<Patches>,
    inside: Inside,
    /// Of surface and scenery together, as they last came to rest.
    scene: BoundingSphere,
    /// Least and greatest corner of these and of all poses since, where there were any.
    reach: Option<[Vec3; 2]>,
    track: Option<Track>,
    /// The last frame is out of date.
    dirty: bool,
    /// And so are the shadows of what stands still.
    shadows_dirty: bool,
    /// And so is what it keeps off the floor and off itself.
    occlusion_dirty: bool,
}

impl Renderer {
    /// Builds all pipelines; without a canvas there are only pictures.
    ///
    /// # Errors
    /// When the device refuses even the small buffers of pins and walker.
    pub fn new(context: Context, canvas: Option<Canvas>) -> Result<Self, Error> {
        let shared = Shared::new(&context);
        let renderer = Self {
            background: Background::new(&context, &shared),
            ground: Ground::new(&context, &shared),
            surfaces: SurfaceRenderer::new(&context, &shared),
            models: None,
            curve: Curve::new(&context, &shared),
            pins: Pins::new(&context, &shared)?,
            walkers: Walkers::new(&context, &shared)?,
            arrows: Arrows::new(&context, &shared)?,
            wires: Wires::new(&context, &shared),
            camera: Camera::new(),
            environment: Environment::default(),
            lights: Vec::new(),
            style: Style::default(),
            max: 1.0,
            surface: None,
            other: None,
            split: 0.0,
            shade: None,
            scenery: Vec::new(),
            patches: None,
            inside: Inside::default(),
            scene: BoundingSphere::UNIT,
            reach: None,
            track: None,
            dirty: true,
            shadows_dirty: true,
            occlusion_dirty: true,
            shared,
            canvas,
            context,
        };
        renderer.surfaces.set_style(&renderer.context, &renderer.style, renderer.max);
        Ok(renderer)
    }

    /// The graphics interface in use.
    #[must_use]
    pub fn backend(&self) -> Backend {
        self.context.backend()
    }

    /// What the device refused first since this was last asked.
    #[must_use]
    pub fn take_error(&self) -> Option<Error> {
        self.context.take_error()
    }

    /// Size of the view in physical pixels, and how many of them make a CSS pixel.
    pub fn resize(&mut self, width: u32, height: u32, pixel_ratio: f32) {
        let (width, height) = self.context.drawable(width, height);
        let is_resized = self.canvas.as_mut().is_some_and(|canvas| canvas.resize(&self.context, width, height));
        self.dirty |= is_resized || pixel_ratio != self.camera.pixel_ratio();
        self.camera.set_size(width, height, pixel_ratio);
    }

    /// Centres the view on what the insets leave free.
    pub fn set_insets(&mut self, insets: Insets) {
        self.camera.set_insets(insets);
        self.dirty = true;
    }

    fn meshes(&self) -> impl Iterator<Item = &Mesh> + Clone {
        self.surface.iter().map(|(mesh, _)| mesh).chain(&self.scenery)
    }

    /// The surface, unless it is hidden.
    fn seen_surface(&self) -> Option<&(Mesh, FieldBuffers)> {
        self.surface.as_ref().filter(|_| !self.inside.hides_surface)
    }

    /// Bounds of all that has cast a shadow since the scene last came to rest, and of the section, whose parts may be drawn
    /// asunder.
    fn drawn(&self) -> BoundingSphere {
        let scene = self.shadowed();
        BoundingSphere { radius: scene.radius.max(self.inside.reach), ..scene }
    }

    /// Bounds of all but the section that has cast a shadow since the scene last came to rest.
    fn shadowed(&self) -> BoundingSphere {
        self.reach.and_then(|reach| BoundingSphere::of_points(reach.iter())).unwrap_or(self.scene)
    }

    fn radius(&self) -> f32 {
        self.surface.as_ref().map_or(BoundingSphere::UNIT.radius, |(mesh, _)| mesh.bounds.radius)
    }

    /// The camera's current view.
    #[must_use]
    pub fn view(&self) -> View {
        self.camera.view()
    }

    /// Distance from which the scene fits into what the insets leave free; bounding radii.
    #[must_use]
    pub fn fitting_distance(&self) -> f64 {
        self.camera.fitting_distance()
    }

    /// Changes the camera.
    pub fn move_camera(&mut self, change: impl FnOnce(&mut Camera)) {
        change(&mut self.camera);
        self.dirty = true;
    }

    /// The nearest place of the surface or the section under a physical pixel; None where there is none or scenery hides it.
    /// What is cut away is not there.
    #[must_use]
    pub fn pick(&self, pixel: Vec2) -> Option<SurfaceHit> {
        let ray = self.camera.ray(pixel);
        let on_surface = self.seen_surface().and_then(|(mesh, _)| {
            let hit = mesh.picker.cast_where(ray, |place| !self.inside.cut.takes(place))?;
            Some((hit, mesh.picker.corners(hit.triangle).map(|vertex| mesh.normals[vertex as usize])))
        });
        let on_section = self.inside.filling.section.as_ref().and_then(|section| {
            let hit = section.cast(ray)?;
            Some((hit, section.corner_normals(hit.triangle)))
        });
        let is_on_section = match (&on_surface, &on_section) {
            (Some((surface, _)), Some((section, _))) => section.depth <= surface.depth,
            (_, section) => section.is_some(),
        };
        let (hit, [a, b, c]) = if is_on_section { on_section } else { on_surface }?;
        if self.scenery.iter().filter_map(|mesh| mesh.picker.cast(ray)).any(|scenery| scenery.depth < hit.depth) {
            return None;
        }
        let normal = hit.weights.x * a + hit.weights.y * b + hit.weights.z * c;
        Some(SurfaceHit {
            is_on_section,
            triangle: hit.triangle,
            weights: hit.weights,
            point: ray.at(hit.depth),
            normal: normal.try_normalize().unwrap_or(a),
        })
    }

    /// The pin whose ball is seen under a physical pixel, or within `slack` CSS pixels.
    #[must_use]
    pub fn pick_pin(&self, pixel: Vec2, slack: f32) -> Option<usize> {
        let (ray, eye) = (self.camera.ray(pixel), self.camera.eye());
        let slope = eye.pixel_slope * f64::from(self.camera.pixel_ratio());
        let css_pixel = |place: Vec3| (slope * eye.world_from_view.z_axis.dot(eye.position - place.as_dvec3())) as f32;
        let (index, depth) = self.pins.cast(ray, slack, self.radius(), css_pixel)?;
        let is_hidden = self.pick(pixel).is_some_and(|hit| hit.point.distance(ray.origin) < depth);
        (!is_hidden).then_some(index)
    }

    /// Physical pixel and depth of a world point; None behind the camera.
    #[must_use]
    pub fn project(&self, point: Vec3) -> Option<Vec3> {
        self.camera.project(point)
    }
}
