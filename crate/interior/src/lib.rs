//! The face of tetrahedra in the page's worker: converts arguments, calls, turns errors into sentences. No algorithm lives here.
//!
//! [`Tetrahedra`] are read, made or filled into a closed surface. The page draws their [boundary](Boundary) as it draws any surface;
//! with that, an [`InnerSolver`] answers and shows what is inside.

#![cfg(target_arch = "wasm32")]

mod drawn;
mod results;
mod solver;
mod view;

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;
use heatwalk::{Soup, Surface};
use heatwalk_bindings::{Failure, Resource, Result, resources, transform};
use heatwalk_model::Model;
use heatwalk_volume::fill::{Resolution, Solid};
use heatwalk_volume::{TetMesh, TetSoup, io, shapes};
use js_sys::{Float64Array, Function, Uint32Array};
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;
use crate::results::{InnerReport, Origin};
use crate::solver::InnerSolver;

/// What [`Tetrahedra::fill`] calls.
#[wasm_bindgen(typescript_custom_section)]
const PROGRESS: &str = "
/** Told the fraction that is done, 0 to 1. */
export type FillProgress = (fraction: number) => void;
";

/// Tetrahedra, checked, with their neighbors.
#[wasm_bindgen]
pub struct Tetrahedra {
    /// As they came.
    soup: Arc<TetSoup>,
    mesh: Arc<TetMesh>,
    origin: Origin,
}

impl Tetrahedra {
    fn build(soup: TetSoup, origin: Origin) -> Result<Self> {
        Ok(Self { mesh: Arc::new(TetMesh::build(&soup)?), soup: Arc::new(soup), origin })
    }
}

#[wasm_bindgen]
impl Tetrahedra {
    /// Reads a file. `resource` gives the bytes of the other one of two.
    pub fn read(name: &str, bytes: &[u8], resource: &Resource) -> Result<Self> {
        let file = io::read(name, bytes, &resources(resource))?;
        Self::build(file.soup, Origin::File(file.cells))
    }

    /// Reads the faces of a file without tetrahedra, for the solver's module.
    pub fn surface(name: &str, bytes: &[u8], resource: &Resource) -> Result<Vec<u8>> {
        Ok(Model::from(io::read_surface(name, bytes, &resources(resource))?).packed())
    }

    /// Makes a shape.
    pub fn shape(name: &str) -> Result<Self> {
        let soup = shapes::by_name(name).ok_or_else(|| Failure::misuse("there is no such shape of tetrahedra"))?;
        Self::build(soup, Origin::Code)
    }

    /// Fills a closed surface with about so many tetrahedra: `positions` are `#V × 3`, in the file's unit, `triangles` `#F × 3`.
    pub fn fill(
        positions: &[f64],
        triangles: &[u32],
        tetrahedra: u32,
        #[wasm_bindgen(unchecked_param_type = "FillProgress")] progress: &Function,
    ) -> Result<Self> {
        let positions = positions.as_chunks().0.iter().copied().map(DVec3::from_array).collect();
        let soup = Soup::single("surface", positions, triangles.as_chunks().0.to_vec());
        let surface = Surface::build(&soup)?;
        let solid = Solid::new(&soup, &surface, NonZeroUsize::MIN)?;
        let filled = solid.fill(Resolution::Tetrahedra(tetrahedra as usize), &mut |_, share| {
            // What the page does with it is no reason to stop.
            let _ = progress.call1(&JsValue::NULL, &share.into());
            ControlFlow::Continue(())
        })?;
        Self::build(filled.soup, Origin::Fill(filled.report))
    }

    /// What they are.
    pub fn report(&self) -> InnerReport {
        InnerReport::new(&self.mesh, &self.origin)
    }

    /// Their boundary.
    pub fn boundary(&self) -> Boundary {
        Boundary { boundary: self.mesh.boundary(), mesh: Arc::clone(&self.mesh) }
    }

    /// `#V × 3`, where the vertices of the input are drawn.
    pub fn places(&self, #[wasm_bindgen(unchecked_param_type = "DrawTransform")] drawn: &JsValue) -> Result<Vec<f32>> {
        Ok(transform(drawn)?.places(self.soup.positions.iter().copied()))
    }

    /// `#T × 4`, corners of the tetrahedra of the input.
    pub fn corners(&self) -> Uint32Array {
        self.soup.tetrahedra.as_flattened().into()
    }

    /// A solver on them as they are drawn: `vertices` are those of the input that drawn vertices are (`#D`), `triangles` those that are drawn
    /// (`#F × 3`).
    pub fn solver(
        &self,
        vertices: &[u32],
        triangles: &[u32],
        #[wasm_bindgen(unchecked_param_type = "DrawTransform")] drawn: &JsValue,
    ) -> Result<InnerSolver> {
        let drawn = Drawn::new(&self.soup, &self.mesh, vertices, triangles.as_chunks().0, transform(drawn)?);
        Ok(InnerSolver::new(&self.mesh, drawn))
    }
}

/// A boundary, counter-clockwise seen from outside.
#[wasm_bindgen]
pub struct Boundary {
    boundary: heatwalk_volume::mesh::Boundary,
    mesh: Arc<TetMesh>,
}

#[wasm_bindgen]
impl Boundary {
    /// `#B × 3`, in the file's unit.
    pub fn positions(&self) -> Float64Array {
        let numbers: Vec<f64> = self.boundary.soup.positions.iter().flat_map(|position| position.to_array()).collect();
        numbers.as_slice().into()
    }

    /// `#F × 3`, indices of its own vertices.
    pub fn triangles(&self) -> Uint32Array {
        self.boundary.soup.triangles.as_flattened().into()
    }

    /// `#B`, the vertices of the input that they are.
    pub fn vertices(&self) -> Vec<u32> {
        self.boundary.vertices.iter().map(|&vertex| self.mesh.input_of_vertex(vertex) as u32).collect()
    }
}
