//! A surface that answers questions, the field solved last, and who walks on it.

mod convergence;
mod ground;
mod pose;
mod tape;
mod tracks;
mod values;

use std::num::NonZeroU16;
use std::ops::ControlFlow;
use std::sync::Arc;

use heatwalk::exact::{self, ExactGeometry, PlaceDistances};
use heatwalk::surface::memory;
use heatwalk::{
    CarriedSources, Carriers, Distance, EdgeKind, ExactRadius, FaceField, HeatSolver, Path, PathKind, PathSearch,
    Propagation, PropagationOptions, Query, Source, Stage, Surface, SurfacePoint, VertexData, Windows, descend,
    refract, straighten,
};
use heatwalk_bindings::{Failure, Result, parameters};
use heatwalk_scene::{Crowd, Posing, overlay};
use js_sys::{Array, Function, Object};
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;
use crate::field::{Field, Origin};
use crate::ground::Ground;
use crate::joined::Joined;
use crate::measuring::Measuring;
use crate::results::SurfacePath;
use crate::solved::{Solved, factored};

/// Exact radius of quick solves, in mean edges. Up to here it costs little beside the systems that are solved anyway, and
/// the rings around a source, where heat is off most, are exact.
const QUICK_EDGES: f64 = 8.0;

/// Bytes that exact distances and windows need of the surface, a face.
const BYTES_PER_FACE: u64 = 128;

/// The same walkers start at the same places whenever a mesh is opened.
const CROWD_SEED: u64 = 1;

/// A surface that answers, the distance field solved last, and the crowd that walks to the sources.
#[wasm_bindgen]
pub struct Solver {
    drawn: Arc<Drawn>,
    /// The surface that distances are measured on, with what it costs.
    geometry: Arc<ExactGeometry>,
    /// The same without costs, where these differ.
    unweighted: Option<Arc<ExactGeometry>>,
    ground: Ground,
    /// The surface in the pose of the file, as walls part it.
    parted: Arc<Surface>,
    /// How many of its vertices are in walls.
    in_walls: usize,
    /// The same as it is shown: in another pose, if distances are measured in that of the file.
    shown: Arc<Surface>,
    joined: Joined,
    posing: Option<Posing>,
    /// The path that was traced last.
    path: Option<Path>,
    /// What is factored, if anything.
    heat: Option<HeatSolver>,
    /// Whether that is for another ground.
    is_stale: bool,
    /// That of the last field by windows, kept for its memory.
    propagation: Option<Propagation>,
    solved: Option<Solved>,
    /// The exact path that is searched on it, and whence.
    search: Option<(SurfacePoint, PathSearch)>,
    /// The leg of a tape that is measured on it.
    measuring: Option<Measuring>,
    crowd: Option<Crowd>,
}

impl Solver {
    pub(crate) fn unfactored(surface: &Arc<Surface>, drawn: &Arc<Drawn>, posing: Option<Posing>) -> Result<Self> {
        memory::require(BYTES_PER_FACE * surface.face_count() as u64, "unfolding the triangles")?;
        Ok(Self::new(drawn, Arc::new(ExactGeometry::new(Arc::clone(surface))), posing, None))
    }

    pub(crate) fn factored(
        surface: &Arc<Surface>,
        drawn: &Arc<Drawn>,
        posing: Option<Posing>,
        given: &Object,
        progress: &Function,
    ) -> Result<Self> {
        let heat = HeatSolver::new(Arc::clone(surface), parameters(given)?, &mut reporter(progress))?;
        Ok(Self::new(drawn, Arc::clone(heat.exact_geometry()), posing, Some(heat)))
    }

    fn new(drawn: &Arc<Drawn>, geometry: Arc<ExactGeometry>, posing: Option<Posing>, heat: Option<HeatSolver>) -> Self {
        let surface = Arc::clone(geometry.surface());
        Self {
            drawn: Arc::clone(drawn),
            geometry,
            unweighted: None,
            ground: Ground::new(&surface, drawn),
            parted: Arc::clone(&surface),
            in_walls: 0,
            posing,
            path: None,
            shown: surface,
            joined: Joined::default(),
            heat,
            is_stale: false,
            propagation: None,
            solved: None,
            search: None,
            measuring: None,
            crowd: None,
        }
    }

    fn sources(&self, given: &Array) -> Result<Vec<Source>> {
        given.iter().map(|source| self.drawn.source(self.geometry.surface(), &source)).collect()
    }

    fn heat_distance(&self, sources: &[Source], quick: bool) -> Result<Distance> {
        let heat = factored(self.heat.as_ref())?;
        let carried = CarriedSources::new(&self.geometry, sources)?;
        let query = heat.query(carried.sources())?;
        let exact_radius = match query.exact_radius {
            radius if !quick => radius,
            ExactRadius::Edges(edges) => ExactRadius::Edges(edges.min(QUICK_EDGES)),
            ExactRadius::Automatic => ExactRadius::Edges(QUICK_EDGES),
        };
        Ok(carried.distance(heat.factorization().distance(&Query { exact_radius, ..query })?))
    }

    fn propagated_distance(&mut self, sources: &[Source], windows: u16, quick: bool) -> Result<Distance> {
        let count = NonZeroU16::new(windows).ok_or_else(|| Failure::misuse("one window at least is kept"))?;
        let carriers = if quick { Carriers::Vertices } else { Carriers::Windows };
        let options = PropagationOptions { windows: Windows::AtMost(count), carriers, ..PropagationOptions::default() };
        let mut propagation = Propagation::reusing(self.propagation.take(), &self.geometry, sources, options)?;
        propagation.advance(f64::INFINITY, usize::MAX)?;
        let distance = propagation.distance();
        self.propagation = Some(propagation);
        Ok(distance)
    }

    fn answer(&mut self, solved: Solved) -> Result<Field> {
        self.solved = Some(solved);
        self.search = None;
        self.field()
    }

    /// The last field as the page gets it; the crowd follows it.
    fn field(&mut self) -> Result<Field> {
        self.lead_crowd()?;
        Ok(self.solved()?.field(&self.drawn, self.in_walls))
    }

    fn lead_crowd(&mut self) -> Result<()> {
        if let (Some(crowd), Some(solved)) = (&mut self.crowd, &self.solved) {
            crowd.follow(&solved.distance.carried(self.geometry.surface(), &self.shown)?)?;
        }
        Ok(())
    }

    fn solved(&self) -> Result<&Solved> {
        self.solved.as_ref().ok_or_else(|| heatwalk::Error::NoSource.into())
    }
}

#[wasm_bindgen]
impl Solver {
    /// Factors again what the change needs, where anything is factored, and forgets the field.
    pub fn configure(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Partial<Parameters>")] given: &Object,
        #[wasm_bindgen(unchecked_param_type = "Progress")] progress: &Function,
    ) -> Result<()> {
        let parameters = parameters(given)?;
        if let (Some(heat), false) = (&mut self.heat, self.is_stale) {
            heat.set_parameters(parameters, &mut reporter(progress))?;
        } else if self.heat.is_some() {
            self.heat = Some(self.factored_for(self.geometry.surface(), parameters)?);
            self.is_stale = false;
        }
        self.solved = None;
        self.search = None;
        Ok(())
    }

    /// Finds what joins components, by the rule "auto", "off" or a distance in the file's unit, and so many links between the
    /// nearest of the groups that stay apart, where they meet in the pose that is shown (`posed`) or in that of the file; forgets
    /// the field.
    pub fn bridge(&mut self, rule: &str, links: u32, posed: bool) -> Result<()> {
        let surface = match &self.posing {
            Some(posing) if posed => Arc::new(self.ground.surface.posed(posing.positions(&self.ground.surface))),
            _ => Arc::clone(&self.ground.surface),
        };
        let is_changed = self.joined.join(&surface, rule.parse()?, links as usize);
        self.propagation = None;
        self.solved = None;
        self.search = None;
        if is_changed {
            self.lay_out(self.plain_geometry());
        }
        Ok(())
    }

    /// Groups of components that paths lead between; 0 before the first [`bridge`](Self::bridge).
    pub fn groups(&self) -> u32 {
        self.joined.bridges().group_count() as u32
    }

    /// Pairs of components that meet, without those that are linked.
    pub fn contacts(&self) -> u32 {
        self.joined.contact_count() as u32
    }

    /// Whether all contacts were looked at, or there are too many.
    pub fn contacts_complete(&self) -> bool {
        self.joined.bridges().is_complete()
    }

    /// Portals across cracks within components.
    pub fn crack_portals(&self) -> u32 {
        self.joined.bridges().across_cracks().count() as u32
    }

    /// The widest gap that these lead across, in the unit of the file.
    pub fn crack_gap(&self) -> f64 {
        self.joined.bridges().crack_width()
    }

    /// Links between groups.
    pub fn links(&self) -> u32 {
        self.joined.linked().len() as u32
    }

    /// The widest gap that is linked, in the file's unit; 0 without links.
    pub fn linked_gap(&self) -> f64 {
        self.joined.linked().last().map_or(0.0, |link| link.gap)
    }

    /// With how many links, at least, the sources of the last field reach more than they do; as many as there are where they
    /// reach all that can be linked.
    pub fn links_to_reach_more(&mut self) -> Result<u32> {
        let solved = self.solved.as_ref().ok_or(heatwalk::Error::NoSource)?;
        let surface = &self.ground.surface;
        let components: Vec<u32> = solved.sources.iter().map(|source| source.place().component(surface)).collect();
        Ok(self.joined.links_to_reach_more(&components) as u32)
    }

    /// Stored entries of all Cholesky factors together; 0 where nothing is factored.
    pub fn factor_nonzeros(&self) -> f64 {
        self.heat.as_ref().map_or(0, HeatSolver::factor_nonzeros) as f64
    }

    /// Distance to the nearest of `sources` by heat; with an exact radius of at most [`QUICK_EDGES`] when `quick`.
    pub fn solve(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "readonly Source[]")] sources: &Array,
        quick: bool,
    ) -> Result<Field> {
        self.factor_anew()?;
        let sources = self.sources(sources)?;
        let distance = self.heat_distance(&sources, quick)?;
        let origin = Origin::of_heat(factored(self.heat.as_ref())?);
        self.answer(Solved::new(sources, distance, origin))
    }

    /// Distance to the nearest of `sources` by so many windows of each half-edge, or carried by vertices alone when `quick`. Needs
    /// no factors.
    pub fn propagate(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "readonly Source[]")] sources: &Array,
        windows: u16,
        quick: bool,
    ) -> Result<Field> {
        let sources = self.sources(sources)?;
        let distance = self.propagated_distance(&sources, windows, quick)?;
        let windows = if quick { 0 } else { windows };
        self.answer(Solved::new(sources, distance, Origin::Windows(windows)))
    }

    /// Makes the last field exact by about `work` windows further from the sources; once all is exact, nothing changes.
    pub fn refine(&mut self, work: u32) -> Result<Field> {
        let solved = self.solved.as_mut().ok_or(heatwalk::Error::NoSource)?;
        self.search = None;
        solved.refine(&self.geometry, self.heat.as_ref(), work as usize)?;
        self.field()
    }

    /// The path from a place to its nearest source: "descent" of the last field, the same made "straight", or "exact".
    pub fn path(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] from: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "PathKind")] kind: &str,
    ) -> Result<SurfacePath> {
        let solved = self.solved()?;
        let surface = self.geometry.surface();
        let from = self.drawn.point(surface, from)?;
        let steepest = || descend(surface, &solved.distance, from);
        let path = match (kind.parse()?, self.geometry.costs()) {
            (PathKind::Descent, _) => steepest()?,
            // Where costs differ, no path is known to be exact.
            (PathKind::Straightened | PathKind::Exact, Some(costs)) => refract(surface, costs, &steepest()?)?,
            (PathKind::Straightened, None) => straighten(surface, &steepest()?)?,
            (PathKind::Exact, None) => exact::shortest_path(&self.geometry, from, &solved.sources)?,
        };
        self.shown_path(path)
    }

    /// Searches the exact path from a place to its nearest source by about `work` windows further; none until it is found.
    pub fn search_path(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] from: &JsValue,
        work: u32,
    ) -> Result<Option<SurfacePath>> {
        let solved = self.solved.as_ref().ok_or(heatwalk::Error::NoSource)?;
        let from = self.drawn.point(self.geometry.surface(), from)?;
        let begun = self.search.take().filter(|&(place, _)| place == from);
        let mut search = match begun {
            Some((_, search)) => search,
            None => PathSearch::new(&self.geometry, from, &solved.sources)?,
        };
        let path = search.step(work as usize)?;
        if path.is_none() {
            self.search = Some((from, search));
        }
        path.map(|path| self.shown_path(path)).transpose()
    }

    /// The last field at places, in the file's unit, Infinity where no source reaches them; none until all of it is exact.
    pub fn exact_distances(
        &self,
        #[wasm_bindgen(unchecked_param_type = "readonly SurfacePoint[]")] places: &Array,
    ) -> Result<Option<Vec<f64>>> {
        let solved = self.solved()?;
        if !solved.is_exact() {
            return Ok(None);
        }
        let distances = PlaceDistances::new(&self.geometry, &solved.distance.values, &solved.sources)?;
        let at = |place| Ok(distances.at(self.drawn.point(self.geometry.surface(), &place)?)?);
        places.iter().map(at).collect::<Result<_>>().map(Some)
    }

    /// `#D × 4`: direction in which the last field grows, 127 for a unit; the fourth number is 0.
    pub fn tangents(&self) -> Result<Vec<i8>> {
        let directions = self.shown_distance()?.directions(&self.shown)?;
        Ok(self.drawn.spread_directions(&directions))
    }

    /// `#F × 3`: unit vectors along the gradient of "heat", or the gradient of "distance", of the last field.
    pub fn gradients(&self, #[wasm_bindgen(unchecked_param_type = "FaceField")] kind: &str) -> Result<Vec<f32>> {
        let distance = self.shown_distance()?;
        let vectors = match kind.parse()? {
            FaceField::Heat => distance.heat_directions(&self.shown)?,
            FaceField::Distance => distance.gradients(&self.shown)?,
        };
        Ok(self.drawn.spread_vectors(&vectors))
    }

    /// `#E × 2 × 3`: ends of the edges between faces ("mesh"), of those with one face ("boundary"), or of those that the
    /// operators see ("operator"), drawn on the surface; or the lines that show where components meet ("contact").
    pub fn edges(&self, #[wasm_bindgen(unchecked_param_type = "EdgeKind")] kind: &str) -> Result<Vec<f32>> {
        let surface = &*self.shown;
        let edges = match kind.parse()? {
            EdgeKind::Mesh => overlay::inner_edges(surface),
            EdgeKind::Boundary => overlay::boundary_edges(surface),
            EdgeKind::Contact => overlay::contact_lines(surface, self.joined.bridges()),
            EdgeKind::Operator => overlay::operator_edges(factored(self.heat.as_ref())?, surface)?,
        };
        Ok(self.drawn.transform.places(edges.as_flattened().iter().copied()))
    }

    /// `#D`: how far the last field was off before it was made exact, relative to the exact distance; 0 at sources and
    /// where nothing is reached. None until all of it is exact.
    pub fn errors(&self) -> Result<Option<Vec<f32>>> {
        let solved = self.solved()?;
        let Some(instant) = solved.instant() else { return Ok(None) };
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
                let height = height * self.geometry.surface().bounding_radius();
                let mut crowd = Crowd::new(Arc::clone(&self.shown), count as usize, height, CROWD_SEED)?;
                crowd.set_costs(self.ground.costs.as_ref());
                self.crowd = Some(crowd);
                self.lead_crowd()?;
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
