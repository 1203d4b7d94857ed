//! A surface that answers questions, the field solved last, and who walks on it.

mod convergence;
mod ground;
mod pose;
mod tape;
mod tracks;
mod values;

use std::num::NonZeroU16;
use std::sync::Arc;

use heatwalk::operator::Operators;
use heatwalk::{
    DistanceOptions, DistanceSolver, EdgeKind, FaceField, HeatSolver, Method, Parameters, Path, PathSearch, Progress,
    Surface, Windows, go_on,
};
use heatwalk_bindings::{DrawPath, Failure, Field, Message, Result, logarithms, parameters, reporter};
use heatwalk_scene::{Crowd, Posing, overlay};
use js_sys::{Array, Function, Object};
use wasm_bindgen::prelude::*;

use crate::drawn::Drawn;
use crate::field::{Origin, Solved, field};
use crate::ground::Ground;

/// The same walkers start at the same places whenever a mesh is opened.
const CROWD_SEED: u64 = 1;

/// What joins components.
#[derive(Message)]
pub struct Joined {
    /// Groups of components that paths lead between; 0 where nothing was joined.
    pub groups: usize,
    /// Pairs of components that meet, without those that are linked.
    pub contacts: usize,
    /// Whether all contacts were looked at, or there are too many.
    pub contacts_complete: bool,
    /// Places where paths cross cracks within components.
    pub crack_portals: usize,
    /// The widest of these cracks, in the unit of the file.
    pub crack_gap: f64,
    /// Links between groups that would stay apart.
    pub links: usize,
    /// The widest gap that is linked, in the unit of the file; 0 without links.
    pub linked_gap: f64,
}

/// A surface that answers, the distance field solved last, and the crowd that walks to the sources.
#[wasm_bindgen]
pub struct Solver {
    drawn: Arc<Drawn>,
    ground: Ground,
    solver: DistanceSolver,
    /// Of heat, where it may be asked.
    heat: Option<Parameters>,
    /// How many vertices are in walls.
    in_walls: usize,
    /// The surface as it is shown: in another pose, if distances are measured in that of the file.
    shown: Arc<Surface>,
    posing: Option<Posing>,
    /// The path that was traced last.
    path: Option<Path>,
    solved: Option<Solved>,
    /// The exact path that is searched on it.
    search: Option<PathSearch>,
    /// The leg of a tape that is measured.
    measuring: Option<PathSearch>,
    crowd: Option<Crowd>,
}

impl Solver {
    /// `heat`: with factors for these parameters.
    pub(crate) fn new(
        surface: &Arc<Surface>,
        drawn: &Arc<Drawn>,
        posing: Option<Posing>,
        heat: Option<Parameters>,
        progress: Progress<'_>,
    ) -> Result<Self> {
        let mut solver = DistanceSolver::new(Arc::clone(surface));
        solver.prepare(&heat.map_or(DistanceOptions::default(), by_heat), progress)?;
        Ok(Self {
            drawn: Arc::clone(drawn),
            ground: Ground::new(surface, drawn),
            solver,
            heat,
            in_walls: 0,
            shown: Arc::clone(surface),
            posing,
            path: None,
            solved: None,
            search: None,
            measuring: None,
            crowd: None,
        })
    }

    fn answer(&mut self, sources: &Array, options: DistanceOptions, quick: bool) -> Result<Field> {
        let options = if quick { options.quick() } else { options };
        let surface = self.solver.surface();
        let sources = sources.iter().map(|source| self.drawn.source(surface, &source)).collect::<Result<Vec<_>>>()?;
        let answer = self.solver.distance(&sources, &options, &mut go_on)?;
        let origin = match (options.windows, self.solver.heat()) {
            (_, Some(heat)) if options.method == Method::Heat => Origin::Heat { time_factor: heat.time_factor() },
            (Windows::AtMost(count), _) if !quick => Origin::Windows(count.get()),
            _ => Origin::Windows(0),
        };
        self.solved = Some(Solved { solution: answer.into(), origin });
        self.search = None;
        self.field()
    }

    /// The last field as the page gets it; the crowd follows it.
    fn field(&mut self) -> Result<Field> {
        self.lead_crowd()?;
        Ok(field(&self.drawn, self.solved()?, self.in_walls))
    }

    fn lead_crowd(&mut self) -> Result<()> {
        if let (Some(crowd), Some(solved)) = (&mut self.crowd, &self.solved) {
            crowd.follow(&solved.distance().carried(self.solver.surface(), &self.shown)?)?;
        }
        Ok(())
    }

    fn solved(&self) -> Result<&Solved> {
        self.solved.as_ref().ok_or_else(|| heatwalk::Error::NoSource.into())
    }

    fn forget(&mut self) {
        (self.solved, self.search) = (None, None);
    }

    fn heat_options(&self) -> Result<DistanceOptions> {
        self.heat.map(by_heat).ok_or_else(|| Failure::misuse("nothing is factored"))
    }

    /// The factors of the surface as it is.
    fn factors(&mut self) -> Result<&HeatSolver> {
        self.solver.prepare(&self.heat_options()?, &mut go_on)?;
        self.solver.heat().ok_or_else(|| heatwalk::Error::NoHeat.into())
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
        if self.heat.is_some() {
            self.solver.prepare(&by_heat(parameters), &mut reporter(progress))?;
            self.heat = Some(parameters);
        }
        self.forget();
        Ok(())
    }

    /// Finds what joins components, by the rule "auto", "off" or a distance in the file's unit, and so many links between the
    /// nearest of the groups that stay apart, where they meet in the pose that is shown (`posed`) or in that of the file; forgets
    /// the field.
    pub fn bridge(&mut self, rule: &str, links: u32, posed: bool) -> Result<()> {
        let whole = self.solver.whole();
        let pose = match &self.posing {
            Some(posing) if posed => Arc::new(whole.posed(posing.positions(whole))),
            _ => Arc::clone(whole),
        };
        self.solver.join(&pose, rule.parse()?, links as usize)?;
        self.forget();
        Ok(())
    }

    /// What joins components.
    pub fn joined(&self) -> Joined {
        let joined = self.solver.joined();
        let bridges = joined.bridges();
        Joined {
            groups: bridges.group_count(),
            contacts: joined.contact_count(),
            contacts_complete: bridges.is_complete(),
            crack_portals: bridges.across_cracks().count(),
            crack_gap: bridges.crack_width(),
            links: joined.linked().len(),
            linked_gap: joined.linked().last().map_or(0.0, |link| link.gap),
        }
    }

    /// With how many links, at least, the sources of the last field reach more than they do; as many as there are where they
    /// reach all that can be linked.
    pub fn links_to_reach_more(&mut self) -> Result<u32> {
        let solved = self.solved.as_ref().ok_or(heatwalk::Error::NoSource)?;
        Ok(self.solver.links_to_reach_more(solved.solution.answer()) as u32)
    }

    /// Whether what is factored is the same for every operator.
    pub fn operators_agree(&self) -> bool {
        self.solver.heat().is_some_and(|heat| Operators::agree(heat.surface()))
    }

    /// Stored entries of all Cholesky factors together; 0 where nothing is factored.
    pub fn factor_nonzeros(&self) -> f64 {
        self.solver.heat().map_or(0, HeatSolver::factor_nonzeros) as f64
    }

    /// Distance to the nearest of `sources` by heat; with a small exact region when `quick`.
    pub fn solve(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "readonly Source[]")] sources: &Array,
        quick: bool,
    ) -> Result<Field> {
        self.answer(sources, self.heat_options()?, quick)
    }

    /// Distance to the nearest of `sources` by so many windows of each half-edge, or carried by vertices alone when `quick`. Needs
    /// no factors.
    pub fn propagate(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "readonly Source[]")] sources: &Array,
        windows: u16,
        quick: bool,
    ) -> Result<Field> {
        let count = NonZeroU16::new(windows).ok_or_else(|| Failure::misuse("one window at least is kept"))?;
        let options = DistanceOptions { windows: Windows::AtMost(count), ..DistanceOptions::by(Method::Propagation) };
        self.answer(sources, options, quick)
    }

    /// Makes the last field exact by about `work` windows further from the sources; once all is exact, nothing changes.
    pub fn refine(&mut self, work: u32) -> Result<Field> {
        let solved = self.solved.as_mut().ok_or(heatwalk::Error::NoSource)?;
        self.search = None;
        self.solver.refine(&mut solved.solution, work as usize)?;
        self.field()
    }

    /// The path from a place to its nearest source: "descent" of the last field, the same made "straight", or "exact".
    pub fn path(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] from: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "PathKind")] kind: &str,
    ) -> Result<DrawPath> {
        let solved = self.solved.as_ref().ok_or(heatwalk::Error::NoSource)?;
        let from = self.drawn.point(self.solver.surface(), from)?;
        let path = self.solver.path(solved.solution.answer(), from, kind.parse()?)?;
        self.shown_path(path)
    }

    /// Searches the exact path from a place to its nearest source by about `work` windows further; none until it is found.
    pub fn search_path(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] from: &JsValue,
        work: u32,
    ) -> Result<Option<DrawPath>> {
        let solved = self.solved.as_ref().ok_or(heatwalk::Error::NoSource)?;
        let from = self.drawn.point(self.solver.surface(), from)?;
        let sources = &solved.solution.answer().sources;
        let path = self.solver.search_path(&mut self.search, from, sources, work as usize)?;
        path.map(|path| self.shown_path(path)).transpose()
    }

    /// The last field at a place, in the file's unit, Infinity where no source reaches it: see [`DistanceSolver::at`].
    pub fn distance_at(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "SurfacePoint")] place: &JsValue,
    ) -> Result<f64> {
        let solved = self.solved.as_ref().ok_or(heatwalk::Error::NoSource)?;
        let place = self.drawn.point(self.solver.surface(), place)?;
        Ok(self.solver.at(solved.solution.answer(), place)?)
    }

    /// The last field at places, in the file's unit, Infinity where no source reaches them; none until all of it is exact.
    pub fn exact_distances(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "readonly SurfacePoint[]")] places: &Array,
    ) -> Result<Option<Vec<f64>>> {
        let solved = self.solved.as_ref().ok_or(heatwalk::Error::NoSource)?;
        let surface = Arc::clone(self.solver.surface());
        let Some(distances) = self.solver.place_distances(solved.solution.answer())? else { return Ok(None) };
        let point = |place| self.drawn.point(&surface, &place);
        let points = places.iter().map(point).collect::<Result<Vec<_>>>()?;
        Ok(Some(distances.at_all(&points)?))
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
    pub fn edges(&mut self, #[wasm_bindgen(unchecked_param_type = "EdgeKind")] kind: &str) -> Result<Vec<f32>> {
        let surface = Arc::clone(&self.shown);
        let edges = match kind.parse()? {
            EdgeKind::Mesh => overlay::inner_edges(&surface),
            EdgeKind::Boundary => overlay::boundary_edges(&surface),
            EdgeKind::Contact => overlay::contact_lines(&surface, self.solver.joined().bridges()),
            EdgeKind::Operator => overlay::operator_edges(self.factors()?, &surface)?,
        };
        Ok(self.drawn.transform.places(edges.as_flattened().iter().copied()))
    }

    /// `#D`: how far the last field was off before it was made exact, relative to the exact distance; 0 at sources and
    /// where nothing is reached. None until all of it is exact.
    pub fn errors(&self) -> Result<Option<Vec<f32>>> {
        Ok(self.solved()?.solution.errors().map(|errors| self.drawn.spread(&errors)))
    }

    /// `#D`: log10 of the last field's heat over its maximum, −∞ where there is none.
    pub fn heat(&self) -> Result<Vec<f32>> {
        let heat = self.solved()?.distance().heat()?;
        Ok(self.drawn.spread(&logarithms(heat.as_slice()).collect()))
    }

    /// Changes the number of walkers; 0 sends all away. `height`: of those who set out, in bounding radii of the surface.
    pub fn set_crowd(&mut self, count: u32, height: f64) -> Result<()> {
        match &mut self.crowd {
            _ if count == 0 => self.crowd = None,
            Some(crowd) => crowd.set_count(count as usize),
            None => {
                let height = height * self.solver.surface().bounding_radius();
                let mut crowd = Crowd::new(Arc::clone(&self.shown), count as usize, height, CROWD_SEED)?;
                crowd.set_costs(self.solver.costs());
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

fn by_heat(heat: Parameters) -> DistanceOptions {
    DistanceOptions { heat, ..DistanceOptions::by(Method::Heat) }
}
