//! The class `Mesh`: a surface in the caller's words, with its solver.

use std::cell::{OnceCell, RefCell};
use std::num::NonZeroUsize;
use std::sync::Arc;

use glam::DVec3;
use heatwalk::exact::ExactGeometry;
use heatwalk::heat::VectorHeat;
use heatwalk::{
    BridgeRule, Costs, DistanceSolver, Element, FaceData, InputTriangle, NearestPlaces, Progress, Soup, Surface,
    UnitRule, VertexData, Walls, WeldRule,
};
use heatwalk_bindings::{Failure, Message, Result};
use heatwalk_model::Model;
use js_sys::Object;
use wasm_bindgen::prelude::*;

use crate::given::{count, entries, numbers, parsed};
use crate::vectors::{coordinates, points};

/// A surface, and what answers questions on it.
#[wasm_bindgen]
pub struct Mesh {
    soup: Soup,
    whole: Arc<Surface>,
    /// As walls part it.
    surface: Arc<Surface>,
    solver: RefCell<DistanceSolver>,
    nearest: OnceCell<NearestPlaces>,
    diffusion: RefCell<Option<Arc<VectorHeat>>>,
}

/// What a surface is, and what was done when it was made of triangles.
#[derive(Message)]
pub struct About {
    /// Vertices of the caller.
    pub vertices: usize,
    /// Triangles of the caller.
    pub faces: usize,
    /// Polygons that these are cut from; a triangle is one.
    pub polygons: usize,
    /// Vertices that were merged into another.
    pub welded_vertices: usize,
    /// Vertices that were merged into one across a crack.
    pub crack_vertices: usize,
    /// Vertices that no triangle uses.
    pub unreferenced_vertices: usize,
    /// Triangles without area that were left out.
    pub degenerate_faces: usize,
    /// Triangles that were there before, and left out.
    pub duplicate_faces: usize,
    /// Triangles that were turned over.
    pub flipped_faces: usize,
    /// Edges of more than two triangles.
    pub non_manifold_edges: usize,
    /// Parts that no edge joins.
    pub components: usize,
    /// Closed chains of edges of one triangle.
    pub boundary_loops: usize,
    /// Vertices less edges plus faces.
    pub euler_characteristic: i32,
    /// The mean length of the edges.
    pub mean_edge: f64,
    /// Of lengths, as the file says it.
    pub unit: Option<&'static str>,
    /// What was left out of the file, or read otherwise than it is written.
    #[typescript("string[]")]
    pub warnings: JsValue,
}

/// How a surface is made of triangles.
#[derive(Default)]
struct Options {
    weld: WeldRule,
    bridges: BridgeRule,
    links: usize,
    costs: Option<Vec<f64>>,
    walls: Vec<f64>,
    parts: Option<Vec<usize>>,
}

impl Options {
    fn of(given: &Object) -> Result<Self> {
        let mut options = Self::default();
        for (name, value) in entries(given) {
            match name.as_str() {
                "weld" => options.weld = parsed(&name, &value)?,
                "bridges" => options.bridges = parsed(&name, &value)?,
                "links" => options.links = count(&name, &value)?,
                "costs" => options.costs = Some(numbers(&value)),
                "walls" => options.walls = numbers(&value),
                "parts" => options.parts = Some(numbers(&value).into_iter().map(|part| part as usize).collect()),
                _ => {
                    let sentence =
                        format!("there is no option {name}; the options are weld, bridges, links, costs, walls, parts");
                    return Err(Failure::of("bad-parameter", &sentence));
                }
            }
        }
        Ok(options)
    }
}

#[wasm_bindgen]
impl Mesh {
    /// Of `positions`, three coordinates a vertex, and `indices`, three vertices a triangle.
    pub fn of(positions: &[f64], indices: &[u32], options: &Object) -> Result<Self> {
        let (positions, vertices) = (points(positions).collect::<Vec<_>>(), positions.len() / 3);
        let triangles = indices.as_chunks().0.to_vec();
        if let Some(place) = indices.iter().position(|&vertex| vertex as usize >= vertices) {
            let (triangle, vertex) = (place / 3, u64::from(indices[place]));
            return Err(heatwalk::surface::Error::IndexOutOfRange { triangle, vertex, vertices }.into());
        }
        Self::build(Soup::single("mesh", positions, triangles), &Options::of(options)?)
    }

    /// Of what the module that reads files made of one.
    pub fn of_packed(packed: &[u8], options: &Object) -> Result<Self> {
        let model = Model::unpacked(packed).ok_or_else(|| Failure::misuse("the bytes are no packed model"))?;
        let options = Options::of(options)?;
        let model = match &options.parts {
            Some(parts) => model.chosen(parts)?,
            None => model,
        };
        Self::build(model.soup, &options)
    }

    /// What it is, and what was done when it was made.
    pub fn about(&self) -> About {
        let report = self.whole.report();
        let unit = self.soup.unit.map(|unit| UnitRule::Is(Some(unit)));
        let warnings = self.soup.warnings.iter().map(|warning| JsValue::from(warning.to_string()));
        About {
            vertices: self.soup.positions.len(),
            faces: self.soup.triangles.len(),
            polygons: report.polygons,
            welded_vertices: report.welded_vertices,
            crack_vertices: report.crack_vertices,
            unreferenced_vertices: report.unreferenced_vertices,
            degenerate_faces: report.degenerate_faces,
            duplicate_faces: report.duplicate_faces,
            flipped_faces: report.flipped_faces,
            non_manifold_edges: report.non_manifold_edges,
            components: report.components,
            boundary_loops: report.boundary_loops,
            euler_characteristic: report.euler_characteristic as i32,
            mean_edge: self.whole.mean_edge(),
            unit: unit.and_then(|rule| self.soup.length_unit(rule).unit).map(|unit| unit.symbol()),
            warnings: warnings.collect::<js_sys::Array>().into(),
        }
    }

    /// Three coordinates a vertex of the caller or the file.
    pub fn positions(&self) -> Vec<f64> {
        coordinates(self.soup.positions.iter().copied())
    }

    /// Three vertices a triangle of the caller or the file.
    pub fn indices(&self) -> Vec<u32> {
        self.soup.triangles.iter().flatten().copied().collect()
    }
}

impl Mesh {
    fn build(soup: Soup, options: &Options) -> Result<Self> {
        let whole = Arc::new(Surface::build_by(&soup, options.weld, NonZeroUsize::MIN)?);
        let mut solver = DistanceSolver::new(Arc::clone(&whole));
        if !options.walls.is_empty() {
            let face = |&triangle: &f64| whole.require_face(&soup, triangle as usize);
            let faces = options.walls.iter().map(face).collect::<heatwalk::surface::Result<_>>()?;
            solver.set_walls(&Walls { faces, edges: Vec::new() })?;
        }
        if let Some(costs) = &options.costs {
            solver.set_costs(Some(Costs::new(&whole, of_faces(costs, &soup, &whole)?)?));
        }
        solver.join(&whole, options.bridges, options.links)?;
        let surface = Arc::clone(solver.surface());
        let (nearest, diffusion) = (OnceCell::new(), RefCell::default());
        Ok(Self { soup, whole, surface, solver: RefCell::new(solver), nearest, diffusion })
    }

    /// As the caller gave it.
    pub(crate) fn soup(&self) -> &Soup {
        &self.soup
    }

    pub(crate) fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// Works with the solver.
    pub(crate) fn with_solver<R>(&self, work: impl FnOnce(&mut DistanceSolver) -> R) -> R {
        work(&mut self.solver.borrow_mut())
    }

    /// What exact distances need.
    pub(crate) fn geometry(&self) -> Arc<ExactGeometry> {
        self.with_solver(|solver| Arc::clone(solver.exact_geometry()))
    }

    /// What diffuses vectors, factored at the first call.
    pub(crate) fn diffusion(&self, progress: Progress<'_>) -> Result<Arc<VectorHeat>> {
        if self.with_solver(|solver| !solver.joined().bridges().portals().is_empty()) {
            let sentence = "heat carries nothing across bridges; make the mesh with bridges: 'off'";
            return Err(Failure::of("bad-parameter", sentence));
        }
        let mut kept = self.diffusion.borrow_mut();
        if let Some(diffusion) = &*kept {
            return Ok(Arc::clone(diffusion));
        }
        let made = Arc::new(VectorHeat::new(&self.surface, progress)?);
        *kept = Some(Arc::clone(&made));
        Ok(made)
    }

    /// The place that is nearest to a point in space, and how far it is.
    pub(crate) fn nearest_to(&self, point: DVec3) -> Result<(heatwalk::Place, f64)> {
        let places = self.nearest.get_or_init(|| NearestPlaces::new(&self.surface));
        let refused = || Failure::of("not-finite", &format!("the coordinates {:?} are not finite", point.to_array()));
        places.nearest(&self.surface, point).ok_or_else(refused)
    }

    /// Numbers of vertices in the order of the caller's.
    pub(crate) fn to_inputs<T: Copy>(&self, values: &VertexData<T>, absent: T) -> Vec<T> {
        let value = |vertex: &Option<_>| vertex.map_or(absent, |vertex| values[vertex]);
        self.surface.vertices_of_inputs().iter().map(value).collect()
    }
}

/// What a unit of length costs in each face, of each triangle.
fn of_faces(costs: &[f64], soup: &Soup, surface: &Surface) -> Result<FaceData<f64>> {
    let (given, triangles) = (costs.len(), soup.triangles.len());
    if given != triangles {
        let sentence = format!("there are {given} costs and {triangles} triangles; give one for each");
        return Err(Failure::of("bad-shape", &sentence));
    }
    let mut of_faces: FaceData<f64> = vec![1.0; surface.face_count()].into();
    for (triangle, &cost) in costs.iter().enumerate() {
        if let Some(face) = surface.face_of_triangle(InputTriangle::from_index(triangle)) {
            of_faces[face] = cost;
        }
    }
    Ok(of_faces)
}

/// Faces of the surface in the words of the caller.
pub fn triangles(surface: &Surface, faces: impl Iterator<Item = heatwalk::FaceId>) -> Vec<u32> {
    faces.map(|face| surface.triangle_of_face(face).0).collect()
}
