//! A factored surface that answers questions, the field solved last, and who walks on it.

use std::ops::ControlFlow;
use std::sync::Arc;

use heatwalk::{
    Distance, EdgeKind, ExactRadius, FaceField, HeatSolver, PathKind, Query, Refinement, RelativeError, Source, Stage,
    Surface, VertexData, descend, exact, straighten,
};
use heatwalk_scene::{Crowd, overlay};
use js_sys::{Array, Function, Object};
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;
use crate::failure::Result;
use crate::field::Field;
use crate::parameters::parameters;
use crate::results::SurfacePath;

/// Exact radius of quick solves, in mean edges. Up to here it costs little beside the systems that are solved anyway, and
/// the rings around a source, where heat is off most, are exact.
const QUICK_EDGES: f64 = 8.0;

/// The same walkers start at the same places whenever a mesh is opened.
const CROWD_SEED: u64 = 1;

/// The factors of a surface, the distance field solved last, and the crowd that walks to the sources.
#[wasm_bindgen]
pub struct Solver {
    solver: HeatSolver,
    drawn: Arc<Drawn>,
    solved: Option<Solved>,
    crowd: Option<Crowd>,
}

struct Solved {
    sources: Vec<Source>,
    distance: Distance,
    /// Absent before the first step and after the last.
    refining: Option<Refining>,
    error: Option<RelativeError>,
    /// The values before they were made exact; present once all are.
    instant: Option<VertexData<f64>>,
}

struct Refining {
    refinement: Refinement,
    /// The values before the first step, to be compared with the exact ones.
    instant: VertexData<f64>,
}

impl Solver {
    pub(crate) fn new(surface: &Arc<Surface>, drawn: &Arc<Drawn>, given: &Object, progress: &Function) -> Result<Self> {
        let parameters = parameters(given)?;
        let solver = HeatSolver::new(Arc::clone(surface), parameters, &mut reporter(progress))?;
        Ok(Self { solver, drawn: Arc::clone(drawn), solved: None, crowd: None })
    }

    fn quick_distance(&self, sources: &[Source]) -> Result<Distance> {
        let query = self.solver.query(sources)?;
        let edges = match query.exact_radius {
            ExactRadius::Edges(edges) => edges.min(QUICK_EDGES),
            ExactRadius::Automatic => QUICK_EDGES,
        };
        let quick = Query { exact_radius: ExactRadius::Edges(edges), ..query };
        Ok(self.solver.factorization().distance(&quick)?)
    }

    fn solved(&self) -> Result<&Solved> {
        self.solved.as_ref().ok_or_else(|| heatwalk::Error::NoSource.into())
    }
}

#[wasm_bindgen]
impl Solver {
    /// Factors again what the change needs, and forgets the field.
    pub fn configure(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Partial<Parameters>")] given: &Object,
        #[wasm_bindgen(unchecked_param_type = "Progress")] progress: &Function,
    ) -> Result<()> {
        self.solver.set_parameters(parameters(given)?, &mut reporter(progress))?;
        self.solved = None;
        Ok(())
    }

    /// Stored entries of all Cholesky factors together.
    pub fn factor_nonzeros(&self) -> f64 {
        self.solver.factor_nonzeros() as f64
    }

    /// Distance to the nearest of `sources`; with an exact radius of at most [`QUICK_EDGES`] when `quick`.
    pub fn solve(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "readonly Source[]")] sources: &Array,
        quick: bool,
    ) -> Result<Field> {
        let sources = sources.iter().map(|source| self.drawn.source(self.solver.surface(), &source));
        let sources = sources.collect::<Result<Vec<_>>>()?;
        let distance = if quick { self.quick_distance(&sources)? } else { self.solver.distance(&sources)? };
        let field = Field::of(&self.drawn, &distance, self.solver.time_factor(), None);
        if let Some(crowd) = &mut self.crowd {
            crowd.follow(&distance)?;
        }
        self.solved = Some(Solved { sources, distance, refining: None, error: None, instant: None });
        Ok(field)
    }

    /// Makes the last field exact by about `work` windows further from the sources; once all is exact, nothing changes.
    pub fn refine(&mut self, work: u32) -> Result<Field> {
        let solved = self.solved.as_mut().ok_or(heatwalk::Error::NoSource)?;
        if solved.distance.exact_below < f64::INFINITY {
            let mut refining = match solved.refining.take() {
                Some(refining) => refining,
                None => Refining {
                    refinement: self.solver.refine(&solved.sources)?,
                    instant: solved.distance.values.clone(),
                },
            };
            solved.distance = refining.refinement.step(self.solver.factorization(), work as usize)?;
            if let Some(crowd) = &mut self.crowd {
                crowd.follow(&solved.distance)?;
            }
            if refining.refinement.is_done() {
                solved.distance.exact_below = f64::INFINITY;
                solved.error = Some(RelativeError::between(&refining.instant, &solved.distance.values));
                solved.instant = Some(refining.instant);
            } else {
                solved.refining = Some(refining);
            }
        }
        Ok(Field::of(&self.drawn, &solved.distance, self.solver.time_factor(), solved.error))
    }

    /// The path from a place to its nearest source: "descent" of the last field, the same made "straight", or "exact".
    pub fn path(
        &self,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] from: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "PathKind")] kind: &str,
    ) -> Result<SurfacePath> {
        let solved = self.solved()?;
        let surface = self.solver.surface();
        let from = self.drawn.point(surface, from)?;
        let path = match kind.parse()? {
            PathKind::Descent => descend(surface, &solved.distance, from)?,
            PathKind::Straightened => straighten(surface, &descend(surface, &solved.distance, from)?)?,
            PathKind::Exact => exact::shortest_path(self.solver.exact_geometry(), from, &solved.sources)?,
        };
        Ok(SurfacePath::of(&path, &self.drawn.transform))
    }

    /// `#D × 4`: direction in which the last field grows, 127 for a unit; the fourth number is 0.
    pub fn tangents(&self) -> Result<Vec<i8>> {
        let directions = self.solved()?.distance.directions(self.solver.surface())?;
        Ok(self.drawn.spread_directions(&directions))
    }

    /// `#F × 3`: unit vectors along the gradient of "heat", or the gradient of "distance", of the last field.
    pub fn gradients(&self, #[wasm_bindgen(unchecked_param_type = "FaceField")] kind: &str) -> Result<Vec<f32>> {
        let solved = self.solved()?;
        let surface = self.solver.surface();
        let vectors = match kind.parse()? {
            FaceField::Heat => solved.distance.heat_directions(surface)?,
            FaceField::Distance => solved.distance.gradients(surface)?,
        };
        Ok(self.drawn.spread_vectors(&vectors))
    }

    /// `#E × 2 × 3`: ends of the edges between faces ("mesh"), of those with one face ("boundary"), or of those that the
    /// operators see ("operator"), drawn on the surface.
    pub fn edges(&self, #[wasm_bindgen(unchecked_param_type = "EdgeKind")] kind: &str) -> Result<Vec<f32>> {
        let surface = self.solver.surface();
        let edges = match kind.parse()? {
            EdgeKind::Mesh => overlay::inner_edges(surface),
            EdgeKind::Boundary => overlay::boundary_edges(surface),
            EdgeKind::Operator => overlay::operator_edges(&self.solver)?,
        };
        Ok(self.drawn.transform.places(edges.as_flattened().iter().copied()))
    }

    /// `#D`: how far the last field was off before it was made exact, relative to the exact distance; 0 at sources and
    /// where nothing is reached. None until all of it is exact.
    pub fn errors(&self) -> Result<Option<Vec<f32>>> {
        let solved = self.solved()?;
        let Some(instant) = &solved.instant else { return Ok(None) };
        let error = |(instant, exact): (&f64, &f64)| {
            let error = (instant - exact).abs() / exact;
            if error.is_finite() { error } else { 0.0 }
        };
        let errors: VertexData<f64> = instant.iter().zip(&solved.distance.values).map(error).collect();
        Ok(Some(self.drawn.spread(&errors)))
    }

    /// `#D`: log10 of the last field's heat over its maximum, −∞ where there is none.
    pub fn heat(&self) -> Result<Vec<f32>> {
        let heat = self.solved()?.distance.heat()?;
        let max = heat.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let logarithms: VertexData<f64> = heat.iter().map(|&value| (value.max(0.0) / max).log10()).collect();
        Ok(self.drawn.spread(&logarithms))
    }

    /// Changes the number of walkers; 0 sends all away. `height`: of those who set out, in bounding radii of the surface.
    pub fn set_crowd(&mut self, count: u32, height: f64) -> Result<()> {
        match &mut self.crowd {
            _ if count == 0 => self.crowd = None,
            Some(crowd) => crowd.set_count(count as usize),
            None => {
                let surface = self.solver.surface();
                let height = height * surface.bounding_radius();
                let mut crowd = Crowd::new(Arc::clone(surface), count as usize, height, CROWD_SEED)?;
                if let Some(solved) = &self.solved {
                    crowd.follow(&solved.distance)?;
                }
                self.crowd = Some(crowd);
            }
        }
        Ok(())
    }

    /// Moves the crowd by `step` down the last field and gives each walker's pose, `#walkers × 10`: position, unit normal
    /// and unit heading (three numbers each), and the length walked so far. Empty without a field or a crowd.
    pub fn step_crowd(&mut self, step: f64) -> Result<Vec<f32>> {
        let (Some(crowd), Some(_)) = (&mut self.crowd, &self.solved) else { return Ok(Vec::new()) };
        crowd.advance(step)?;
        Ok(crowd.poses(&self.drawn.transform))
    }
}

/// Passes the stages on to the page. What the page does with them is no reason to stop.
fn reporter(progress: &Function) -> impl FnMut(Stage, f64) -> ControlFlow<()> {
    move |stage, fraction| {
        let _ = progress.call2(&JsValue::NULL, &stage.to_string().into(), &fraction.into());
        ControlFlow::Continue(())
    }
}
