//! The solver's face in the page's worker: converts arguments, calls, turns errors into sentences. No algorithm lives here.
//!
//! The objects follow the way of the data: a [`MeshFile`] is taken or made, an [`ActiveSurface`] is built from some of its parts, a
//! [`Drawing`] is made of that, a [`solver::Solver`] answers, by windows or by heat where it is factored.

#![cfg(target_arch = "wasm32")]

mod appearance;
mod camera;
mod contents;
mod drawn;
mod field;
mod ground;
mod measuring;
mod motion;
mod outline;
mod results;
mod solver;

use std::sync::Arc;

use glam::DVec3;
use heatwalk::surface::soup::{Attribute, Part};
use heatwalk::{Choice, LengthUnit, MemoryLimit, Soup, Surface, Unit, UnitRule, Up, go_on};
use heatwalk_bindings::{Failure, Result, reporter};
use heatwalk_model::{Appearance, Camera, Light, Model};
use heatwalk_scene::{DrawTransform, Posing, light_rows, upright};
use heatwalk_shapes::icosphere;
use js_sys::{Float64Array, Function, Object, Uint32Array};
use wasm_bindgen::prelude::*;

use crate::appearance::{EncodedImage, Material};
use crate::camera::CameraView;
use crate::contents::{Contents, PartInfo, Warning, Weights};
use crate::drawn::Drawn;
use crate::motion::{Clip, Scenery};
use crate::outline::Outline;
use crate::results::{BuildReport, DrawMesh, Shade};
use crate::solver::Solver;

/// Bytes that a program on wasm32 can have.
const ADDRESS_SPACE: u64 = 1 << 32;

/// What a file holds.
#[wasm_bindgen]
pub struct MeshFile {
    model: Model,
    /// By the rules of its format or by its shape.
    up: Up,
    /// Of a file; a shape has none.
    unit: LengthUnit,
    is_terrain: bool,
}

/// What another module has packed.
fn unpacked(packed: &[u8]) -> Result<Model> {
    Model::unpacked(packed).ok_or_else(|| Failure::misuse("this is no mesh that this build has packed"))
}

impl MeshFile {
    /// Of no unit, with Y up.
    fn plain(model: Model) -> Self {
        Self { model, up: Up::Y, unit: LengthUnit::default(), is_terrain: false }
    }

    /// The unit is assumed where the model says none, and what points up found by the shape where that is not known.
    fn of_unknown_unit(model: Model, up: Option<String>) -> Result<Self> {
        let is_terrain = up.is_none() && model.soup.is_terrain();
        let up = up.map(|up| up.parse()).transpose()?.unwrap_or_else(|| upright(&model.soup));
        let unit = model.soup.length_unit(UnitRule::Automatic);
        Ok(Self { model, up, unit, is_terrain })
    }
}

#[wasm_bindgen]
impl MeshFile {
    /// Takes what the module that reads files has read. `up`: what points up, by the shape where that is not known.
    pub fn unpacked(
        packed: &[u8],
        #[wasm_bindgen(unchecked_param_type = "Up | undefined")] up: Option<String>,
    ) -> Result<Self> {
        Self::of_unknown_unit(unpacked(packed)?, up)
    }

    /// Takes what the module that makes shapes has made.
    pub fn made(packed: &[u8]) -> Result<Self> {
        Ok(Self::plain(unpacked(packed)?))
    }

    /// A sphere of ten thousand points to warm up on: enough for every kernel to run often, and over before anybody opens a mesh.
    pub fn sphere() -> Self {
        Self::plain(icosphere(5).into())
    }

    /// Takes triangles as they are: `positions` is `#V × 3`, `triangles` is `#F × 3`.
    pub fn arrays(name: &str, positions: &[f32], triangles: &[u32]) -> Self {
        let positions = positions.as_chunks().0.iter().map(|&[x, y, z]| DVec3::new(x.into(), y.into(), z.into()));
        let soup = Soup::single(name, positions.collect(), triangles.as_chunks().0.to_vec());
        Self::plain(soup.into())
    }

    /// Takes triangles in double precision: `positions` is `#V × 3`, `triangles` is `#F × 3`. `up`: what points up, by the shape where
    /// that is not known. The unit is assumed.
    pub fn surface_of(
        name: &str,
        positions: &[f64],
        triangles: &[u32],
        #[wasm_bindgen(unchecked_param_type = "Up | undefined")] up: Option<String>,
    ) -> Result<Self> {
        let positions = positions.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
        Self::of_unknown_unit(Soup::single(name, positions, triangles.as_chunks().0.to_vec()).into(), up)
    }

    /// `#V × 3`, all vertices of the file.
    pub fn positions(&self) -> Float64Array {
        let numbers: Vec<f64> = self.model.soup.positions.iter().flat_map(|position| position.to_array()).collect();
        numbers.as_slice().into()
    }

    /// `#F × 3`, the triangles of these parts.
    pub fn triangles_of(&self, parts: &[u32]) -> Uint32Array {
        let parts = parts.iter().filter_map(|&part| self.model.soup.parts.get(part as usize));
        let triangles: Vec<[u32; 3]> =
            parts.flat_map(Part::triangles).map(|triangle| self.model.soup.triangles[triangle]).collect();
        triangles.as_flattened().into()
    }

    /// What it holds.
    pub fn contents(&self) -> Contents {
        let part = |part: &Part| PartInfo {
            name: part.name.clone(),
            triangles: part.len(),
            ranges: part.ranges.iter().flat_map(|range| [range.start as u32, range.end as u32]).collect(),
        };
        Contents {
            parts: self.model.soup.parts.iter().map(part).collect(),
            clips: self.model.motion.clips().iter().map(Clip::new).collect(),
            warnings: self.model.soup.warnings.iter().map(Warning::new).collect(),
            missing: self.model.appearance.missing.clone(),
            unit: self.unit.unit.map_or("", Unit::symbol).to_owned(),
            unit_assumed: self.unit.is_assumed,
            upright: self.up.name(),
            is_terrain: self.is_terrain,
        }
    }

    /// Whether it says how its triangles look.
    pub fn has_appearance(&self) -> bool {
        !self.model.appearance.runs.is_empty() || !self.model.appearance.colors.is_empty()
    }

    /// The materials that triangles have.
    pub fn materials(&self) -> Vec<Material> {
        self.model.appearance.materials.iter().map(Material::new).collect()
    }

    /// The images that materials use.
    pub fn images(&self) -> Vec<EncodedImage> {
        self.model.appearance.images.iter().map(EncodedImage::new).collect()
    }

    /// Refuses the parts `active` where there is no room for them and for so many windows of each half-edge, in all there is
    /// or in so many MiB; 0 windows: for what is factored, before its factors.
    pub fn require_room(&self, active: &[u32], windows: u16, mebibytes: Option<f64>) -> Result<()> {
        let parts = active.iter().filter_map(|&part| self.model.soup.parts.get(part as usize));
        let triangles = parts.map(Part::len).sum();
        let vertices = self.model.soup.positions.len().min(3 * triangles);
        let available = match mebibytes.map(MemoryLimit::mebibytes) {
            Some(MemoryLimit::Bytes(most)) => most.min(ADDRESS_SPACE),
            Some(MemoryLimit::Automatic) | None => ADDRESS_SPACE,
        };
        Ok(heatwalk::require_room(vertices, triangles, windows, available)?)
    }

    /// What a simplifier is given of the parts `active`.
    pub fn outline(&self, active: &[u32]) -> Result<Outline> {
        let chosen: Vec<usize> = active.iter().map(|&part| part as usize).collect();
        Ok(Outline::new(self.model.select(&chosen)?))
    }

    /// The same file in other triangles, `#F × 3`, over the vertices of an outline of it: one part, in no materials.
    pub fn simplified(&self, outline: &Outline, name: &str, triangles: &[u32]) -> Result<Self> {
        let model = outline.with_triangles(name, triangles)?;
        Ok(Self { model, up: self.up, unit: self.unit, is_terrain: self.is_terrain })
    }

    /// The surface formed by the parts `active`, to be drawn with the axis `up` upward.
    pub fn surface(
        &self,
        active: &[u32],
        #[wasm_bindgen(unchecked_param_type = "Up")] up: &str,
    ) -> Result<ActiveSurface> {
        let up = up.parse()?;
        let chosen: Vec<usize> = active.iter().map(|&part| part as usize).collect();
        let selection;
        let model = if chosen.iter().copied().eq(0..self.model.soup.parts.len()) {
            &self.model
        } else {
            selection = self.model.chosen(&chosen)?;
            &selection
        };
        let surface = Surface::build(&model.soup)?;
        let transform = DrawTransform::around(&surface, &self.model.soup, up);
        let (appearance, moving) = (Arc::clone(&model.appearance), model.motion.moves().then(|| model.clone()));
        let (cameras, lights) = (model.cameras.clone(), model.lights.clone());
        let weights = model.soup.attributes.iter().find(|attribute| is_weight(&attribute.name)).cloned();
        Ok(ActiveSurface { transform, surface: Arc::new(surface), appearance, moving, cameras, lights, weights })
    }

    /// The triangles of an inactive part, to be drawn beside those of the surface.
    pub fn scenery(&self, part: u32, beside: &ActiveSurface) -> Result<Scenery> {
        let model = self.model.select(&[part as usize])?;
        match Surface::build(&model.soup) {
            Ok(surface) => Ok(Scenery::new(&surface, &model, beside.transform)),
            // Scenery without a sound triangle draws as nothing; it is no reason to refuse the surface.
            Err(heatwalk::surface::Error::Empty { .. }) => Ok(Scenery::empty()),
            Err(error) => Err(error.into()),
        }
    }
}

/// Whether numbers of vertices that are called so are costs.
fn is_weight(name: &str) -> bool {
    let name = name.trim_start_matches('_').to_ascii_lowercase();
    matches!(name.as_str(), "weight" | "weights" | "cost" | "costs")
}

/// A welded surface.
#[wasm_bindgen]
pub struct ActiveSurface {
    surface: Arc<Surface>,
    appearance: Arc<Appearance>,
    /// What it was built from, where that moves.
    moving: Option<Model>,
    cameras: Vec<Camera>,
    lights: Vec<Light>,
    /// What its vertices cost.
    weights: Option<Attribute>,
    transform: DrawTransform,
}

#[wasm_bindgen]
impl ActiveSurface {
    /// How it is drawn.
    pub fn draw_transform(&self) -> heatwalk_bindings::DrawTransform {
        self.transform.into()
    }

    /// Mean edge length.
    pub fn mean_edge(&self) -> f64 {
        self.surface.mean_edge()
    }

    /// What the file says that its vertices cost; none where it says nothing.
    pub fn weights(&self) -> Option<Weights> {
        let Attribute { name, values } = self.weights.as_ref()?;
        Some(Weights { name: name.clone(), values: values.iter().map(|&value| value as f32).collect() })
    }

    /// What was done to make it.
    pub fn report(&self) -> BuildReport {
        self.surface.report().into()
    }

    /// Makes its triangles ready to be drawn.
    pub fn draw(&self) -> Drawing {
        let (drawn, mesh, posing) = Drawn::new(&self.surface, &self.appearance, self.moving.as_ref(), self.transform);
        Drawing {
            surface: Arc::clone(&self.surface),
            drawn: Arc::new(drawn),
            mesh,
            posing,
            cameras: self.cameras.clone(),
            lights: self.lights.clone(),
        }
    }
}

/// A surface as it is drawn, ready to be solved on.
#[wasm_bindgen]
pub struct Drawing {
    surface: Arc<Surface>,
    drawn: Arc<Drawn>,
    mesh: DrawMesh,
    posing: Option<Posing>,
    cameras: Vec<Camera>,
    lights: Vec<Light>,
}

#[wasm_bindgen]
impl Drawing {
    /// What its triangles keep off the light where there are no others; to be asked before they are taken.
    pub fn shade(&self) -> Shade {
        self.mesh.shade()
    }

    /// The cameras of the file; to be asked before the triangles are taken.
    pub fn cameras(&self) -> Vec<CameraView> {
        let bounds = self.mesh.bounds();
        self.cameras.iter().map(|camera| CameraView::new(camera, &self.drawn.transform, bounds)).collect()
    }

    /// `#lights × 12`, the lights of the file as the renderer takes them; to be asked before the triangles are taken.
    pub fn lights(&self) -> Vec<f32> {
        let bounds = self.mesh.bounds();
        light_rows(&self.lights, &self.drawn.transform, bounds.center, bounds.radius)
    }

    /// Takes its triangles, which only the page needs.
    pub fn take_mesh(&mut self) -> DrawMesh {
        std::mem::take(&mut self.mesh)
    }

    /// For each drawn vertex, its vertex in the input.
    pub fn input_vertices(&self) -> Vec<u32> {
        self.drawn.input_vertices()
    }

    /// A solver by windows; nothing is factored.
    pub fn solver(&self) -> Result<Solver> {
        Solver::new(&self.surface, &self.drawn, self.posing.clone(), None, &mut go_on)
    }

    /// A solver by heat as well: factors the heat and Poisson matrices. `progress` is told the stages.
    pub fn factor(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Partial<Parameters>")] parameters: &Object,
        #[wasm_bindgen(unchecked_param_type = "Progress")] progress: &Function,
    ) -> Result<Solver> {
        let parameters = heatwalk_bindings::parameters(parameters)?;
        Solver::new(&self.surface, &self.drawn, self.posing.clone(), Some(parameters), &mut reporter(progress))
    }
}
