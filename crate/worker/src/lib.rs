//! The solver's face in the page's worker: converts arguments, calls, turns errors into sentences. No algorithm lives here.
//!
//! The objects follow the way of the data: a [`MeshFile`] is read, a [`WalkedSurface`] is built from some of its parts,
//! a [`solver::Solver`] factors it and answers.

#![cfg(target_arch = "wasm32")]

mod crowd;
mod drawn;
mod failure;
mod field;
mod parameters;
mod results;
mod solver;

use std::sync::Arc;

use glam::DVec3;
use heatwalk::Soup;
use heatwalk::{Surface, io};
use heatwalk_scene::{DrawTransform, shapes};
use js_sys::{Function, Uint8Array};
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;
use crate::results::{DrawMesh, Report};
use crate::solver::Solver;

/// A panic ends with its message as a `RuntimeError`, so that a bare trap is one thing only: memory that was refused.
#[wasm_bindgen(start)]
pub fn start() {
    std::panic::set_hook(Box::new(|panic| failure::end(&panic.to_string())));
}

/// Names that [`MeshFile::shape`] takes.
#[wasm_bindgen]
pub fn shape_names() -> Vec<String> {
    shapes::names().iter().map(|&name| name.to_owned()).collect()
}

/// What a file holds.
#[wasm_bindgen]
pub struct MeshFile {
    soup: Soup,
}

#[wasm_bindgen]
impl MeshFile {
    /// Reads the first file; the others are what it refers to. `names` and `bytes` are in step.
    pub fn read(names: Vec<String>, bytes: Vec<Uint8Array>) -> Result<Self, JsValue> {
        let files: Vec<(String, Vec<u8>)> =
            names.into_iter().zip(bytes).map(|(name, bytes)| (name, bytes.to_vec())).collect();
        let (name, bytes) = files.first().ok_or_else(|| JsError::new("no file was given"))?;
        let resource = |uri: &str| {
            let wanted = uri.rsplit('/').next();
            files.iter().find(|(name, _)| Some(name.as_str()) == wanted).map(|(_, bytes)| bytes.clone())
        };
        let soup = io::read(name, bytes, &resource).map_err(|error| failure::thrown(&error.into()))?;
        Ok(Self { soup })
    }

    /// Makes a shape.
    pub fn shape(name: &str) -> Result<Self, JsError> {
        Ok(Self { soup: shapes::by_name(name)? })
    }

    /// Takes triangles as they are: `positions` is `#V × 3`, `triangles` is `#F × 3`.
    pub fn arrays(name: &str, positions: &[f32], triangles: &[u32]) -> Self {
        let positions = positions.as_chunks().0.iter().map(|&[x, y, z]| DVec3::new(x.into(), y.into(), z.into()));
        Self { soup: Soup::single(name, positions.collect(), triangles.as_chunks().0.to_vec()) }
    }

    /// Names of the parts.
    pub fn part_names(&self) -> Vec<String> {
        self.soup.parts.iter().map(|part| part.name.clone()).collect()
    }

    /// Triangles of each part.
    pub fn part_triangles(&self) -> Vec<u32> {
        self.soup.parts.iter().map(|part| part.triangles.len() as u32).collect()
    }

    /// The surface formed by the parts `walked`.
    pub fn surface(&self, walked: &[u32]) -> Result<WalkedSurface, JsValue> {
        let chosen: Vec<usize> = walked.iter().map(|&part| part as usize).collect();
        let soup = self.soup.select(&chosen).map_err(|error| failure::thrown(&error.into()))?;
        let surface = Surface::build(&soup).map_err(|error| failure::thrown(&error.into()))?;
        let transform = DrawTransform::around(&surface, &self.soup);
        Ok(WalkedSurface { drawn: Arc::new(Drawn::new(&surface, transform)), surface: Arc::new(surface) })
    }

    /// The triangles of a part that is not walked on, to be drawn beside those that are.
    pub fn scenery(&self, part: u32, beside: &WalkedSurface) -> Result<DrawMesh, JsError> {
        let soup = self.soup.select(&[part as usize])?;
        match Surface::build(&soup) {
            Ok(surface) => Ok(Drawn::new(&surface, beside.drawn.transform).mesh()),
            // Scenery without a sound triangle draws as nothing; it is no reason to refuse the surface.
            Err(heatwalk::surface::Error::Empty { .. }) => Ok(DrawMesh::default()),
            Err(error) => Err(error.into()),
        }
    }
}

/// A welded surface, ready to be factored.
#[wasm_bindgen]
pub struct WalkedSurface {
    surface: Arc<Surface>,
    drawn: Arc<Drawn>,
}

#[wasm_bindgen]
impl WalkedSurface {
    /// The surface's triangles, to be drawn.
    pub fn drawing(&self) -> DrawMesh {
        self.drawn.mesh()
    }

    /// Four numbers: what is drawn at the origin, and the drawn length of the file's unit.
    pub fn draw_transform(&self) -> Vec<f64> {
        let DrawTransform { center, scale } = self.drawn.transform;
        center.extend(scale).to_array().to_vec()
    }

    /// For each drawn vertex, its vertex in the input.
    pub fn input_vertices(&self) -> Vec<u32> {
        self.drawn.input_vertices()
    }

    /// Mean edge length.
    pub fn mean_edge(&self) -> f64 {
        self.surface.mean_edge()
    }

    /// What was done to make it.
    pub fn report(&self) -> Report {
        Report::of(self.surface.report())
    }

    /// Factors the heat and Poisson matrices. `progress` is called with a stage in words and its fraction.
    pub fn factor(&self, parameters: &JsValue, progress: &Function) -> Result<Solver, JsValue> {
        Solver::new(&self.surface, &self.drawn, parameters, progress)
    }
}
