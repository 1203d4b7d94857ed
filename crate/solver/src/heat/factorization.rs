//! All that is factored of a surface.

use std::sync::{Arc, Mutex, OnceLock};

use crate::cost::Costs;
use crate::dijkstra;
use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};
use crate::extremum::larger;
use crate::heat::bounds::Bounds;
use crate::heat::flow::{Condition, HEAT_MATRIX, HeatFlow, Step};
use crate::heat::logarithm::Logarithm;
use crate::heat::poisson::{POISSON_MATRIX, Poisson};
use crate::heat::systems::Systems;
use crate::heat::time::{suited_factor, time_factor};
use crate::operator::Operators;
use crate::options::{Boundary, FactorOptions, LinearSolver, MemoryLimit, Operator, TimeStep};
use crate::progress::{Progress, Stage, report};
use heatwalk_surface::{Surface, VertexData, VertexId, memory};

/// Numbers that the factors of heat systems may take that are not needed now, so that going back to another time or
/// boundary condition is free: 256 MiB.
const SPARE_NUMBERS: usize = 1 << 25;

/// Share of the progress before factoring.
const FACTORING_SHARE: f64 = 0.3;

/// Bytes that the triangles of the operators, the matrices and what exact distances need take at once, a face.
const BYTES_PER_FACE: u64 = 268;

/// A surface with its factored heat and Poisson matrices: expensive to make, cheap to ask.
#[derive(Debug)]
pub struct Factorization {
    surface: Arc<Surface>,
    /// What a unit of length costs, where that is not 1 everywhere.
    costs: Option<Costs>,
    options: FactorOptions,
    systems: Arc<Systems>,
    /// Made when it is first needed: distance along the field of the logarithm does without.
    poisson: OnceLock<Poisson>,
    /// Those that the options need, after others that were needed before.
    flows: Vec<HeatFlow>,
    /// Neumann, and Dirichlet if any vertex is cold then.
    neumann: Condition,
    dirichlet: Option<Condition>,
    /// `#V`, that of the operators.
    mass: Arc<[f64]>,
    /// For factors of the Delaunay triangulation.
    logarithm: Option<Logarithm>,
    /// The m that suits the triangles that carry the operators.
    suited_factor: f64,
    /// Largest distance along edges, in the file's unit times cost.
    extent: f64,
    exact: Arc<ExactGeometry>,
    /// The wavefront of the last exact region, kept for its memory.
    pub(super) front: Mutex<Option<Wavefront>>,
}

impl Factorization {
    /// Factors a surface.
    ///
    /// # Errors
    /// [`BadParameter`](crate::Error::BadParameter); [`Cancelled`](crate::Error::Cancelled);
    /// [`NotPositiveDefinite`](crate::Error::NotPositiveDefinite); [`TooLarge`](crate::Error::TooLarge) where the factors
    /// do not fit, before any is made; [`OutOfMemory`](crate::Error::OutOfMemory).
    pub fn new(surface: impl Into<Arc<Surface>>, options: FactorOptions, progress: Progress<'_>) -> Result<Self> {
        Self::weighted(surface, None, options, progress)
    }

    /// The same where faces have costs.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Panics
    /// Where there is not one cost a face.
    pub fn weighted(
        surface: impl Into<Arc<Surface>>,
        costs: Option<Costs>,
        options: FactorOptions,
        progress: Progress<'_>,
    ) -> Result<Self> {
        let surface = surface.into();
        options.check()?;
        report(progress, Stage::Assembling, 0.0)?;
        memory::require(BYTES_PER_FACE * surface.face_count() as u64, "assembling the matrices")?;
        let extent = dijkstra::extent(&surface, costs.as_ref());
        let exact = ExactGeometry::new(Arc::clone(&surface));
        let exact = Arc::new(costs.as_ref().map_or(exact.clone(), |costs| exact.weighted(costs)));
        Self::assemble(surface, costs, options, (extent, exact), progress)
    }

    fn assemble(
        surface: Arc<Surface>,
        costs: Option<Costs>,
        options: FactorOptions,
        (extent, exact): (f64, Arc<ExactGeometry>),
        progress: Progress<'_>,
    ) -> Result<Self> {
        let operators = Operators::weighted(&surface, costs.as_ref(), options.operator);
        let mass: Arc<[f64]> = operators.laplacian().mass.as_slice().into();
        let suited_factor = suited_factor(&operators, extent);
        let has_logarithm = (options.operator, options.solver) == (Operator::Delaunay, LinearSolver::Cholesky);
        let logarithm = has_logarithm.then(|| {
            let bounds = Bounds::new(&exact, costs.as_ref());
            Logarithm::new(&operators, exact.bumpiness(&mass), bounds)
        });
        let systems = Systems::numbered(operators, numbering(&surface), options.solver, progress)?;
        let dirichlet = dirichlet(&surface);
        let mut factorization = Self {
            surface,
            costs,
            options,
            systems,
            poisson: OnceLock::new(),
            flows: Vec::new(),
            neumann: Condition::Neumann,
            dirichlet,
            mass,
            logarithm,
            suited_factor,
            extent,
            exact,
            front: Mutex::default(),
        };
        factorization.factor(options, FACTORING_SHARE, progress)?;
        Ok(factorization)
    }

    /// Changes the options; factors the matrices that this touches, with the order found before where the operator
    /// stays. Going back to a boundary condition and time of late factors nothing.
    ///
    /// # Errors
    /// As [`Factorization::new`]. After an error it still answers, with the old options: the old factors go only when the
    /// new ones are there.
    pub fn set_options(&mut self, options: FactorOptions, progress: Progress<'_>) -> Result<()> {
        options.check()?;
        if (options.operator, options.solver) == (self.options.operator, self.options.solver) {
            return self.factor(options, 0.0, progress);
        }
        report(progress, Stage::Assembling, 0.0)?;
        let (surface, exact) = (Arc::clone(&self.surface), Arc::clone(&self.exact));
        *self = Self::assemble(surface, self.costs.clone(), options, (self.extent, exact), progress)?;
        Ok(())
    }

    /// Factors the matrices that are needed and absent, and drops those longest unneeded where there are many.
    fn factor(&mut self, options: FactorOptions, done: f64, progress: Progress<'_>) -> Result<()> {
        let is_absent = |step: &Step| !self.flows.iter().any(|flow| flow.step().is_same(step));
        let mut steps: Vec<Step> = self.needed(options).into_iter().filter(is_absent).collect();
        let needs_poisson = self.logarithm_with(options).is_none() && self.poisson.get().is_none();
        // Two matrices side by side take less time than one after the other.
        let beside_poisson = if needs_poisson { steps.pop() } else { None };
        let count = steps.len() + 2 * usize::from(beside_poisson.is_some());
        self.make_room(count, options.memory)?;
        let laplacian = self.systems.operators().laplacian();
        let mut factored = 0;
        let mut told = |factored: usize, share: f64| {
            progress(Stage::Factoring, done + (1.0 - done) * (factored as f64 + share) / count as f64)
        };
        let mut poisson = None;
        let mut made = Vec::with_capacity(count);
        if let Some(step) = beside_poisson {
            let matrices = [(Poisson::matrix(&self.systems), POISSON_MATRIX), (step.matrix(laplacian), HEAT_MATRIX)];
            let [system, heat] = self.systems.systems(matrices, &mut |share| told(0, 2.0 * share))?;
            poisson = Some(Poisson::with_system(&self.systems, system));
            made.push(HeatFlow::with_system(&self.systems, step, heat));
            factored = 2;
        }
        for step in steps {
            let matrix = (step.matrix(laplacian), HEAT_MATRIX);
            let [system] = self.systems.systems([matrix], &mut |share| told(factored, share))?;
            made.push(HeatFlow::with_system(&self.systems, step, system));
            factored += 1;
        }
        if let Some(poisson) = poisson {
            self.poisson = poisson.into();
        }
        self.options = options;
        let flows = std::mem::take(&mut self.flows);
        let (kept, mut spare): (Vec<HeatFlow>, Vec<HeatFlow>) =
            flows.into_iter().partition(|flow| self.is_needed(flow));
        let mut numbers = 0;
        let first = spare.iter().rposition(|flow| {
            numbers += flow.factor_nonzeros();
            numbers > SPARE_NUMBERS
        });
        spare.drain(..first.map_or(0, |index| index + 1));
        self.flows = spare.into_iter().chain(kept).chain(made).collect();
        Ok(())
    }

    /// Sees to room for the factors of so many more matrices. Spare ones go where it is short.
    fn make_room(&mut self, matrices: usize, limit: MemoryLimit) -> Result<()> {
        if self.check_memory(matrices, limit).is_ok() {
            return Ok(());
        }
        let flows = std::mem::take(&mut self.flows);
        self.flows = flows.into_iter().filter(|flow| self.is_needed(flow)).collect();
        self.check_memory(matrices, limit)
    }

    fn check_memory(&self, matrices: usize, limit: MemoryLimit) -> Result<()> {
        let flows = self.flows.iter().map(HeatFlow::factor_nonzeros);
        self.systems.check_memory(self.poisson_nonzeros() + flows.sum::<usize>(), matrices, limit)
    }

    /// The heat systems that options need; at least one.
    fn needed(&self, options: FactorOptions) -> Vec<Step> {
        let mass = self.logarithm_with(options).map_or(&self.mass, Logarithm::mass);
        let time = self.time_with(options);
        let conditions = conditions(options.boundary, &self.neumann, self.dirichlet.as_ref());
        let step = |condition: &Condition| Step { time, condition: condition.clone(), mass: Arc::clone(mass) };
        conditions.into_iter().map(step).collect()
    }

    fn is_needed(&self, flow: &HeatFlow) -> bool {
        self.needed(self.options).iter().any(|step| flow.step().is_same(step))
    }

    /// The heat systems that the options need.
    pub(super) fn needed_flows(&self) -> impl Iterator<Item = &HeatFlow> {
        self.flows.iter().filter(|flow| self.is_needed(flow))
    }

    /// The Poisson system, factored now if it was not before.
    pub(super) fn poisson(&self) -> Result<&Poisson> {
        if let Some(poisson) = self.poisson.get() {
            return Ok(poisson);
        }
        self.check_memory(1, self.options.memory)?;
        let poisson = Poisson::new(&self.systems)?;
        Ok(self.poisson.get_or_init(|| poisson))
    }

    fn poisson_nonzeros(&self) -> usize {
        self.poisson.get().map_or(0, Poisson::factor_nonzeros)
    }

    /// The surface.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// The operators that are factored.
    pub fn operators(&self) -> &Operators {
        self.systems.operators()
    }

    /// What exact distances and paths need of the surface.
    pub fn exact_geometry(&self) -> &Arc<ExactGeometry> {
        &self.exact
    }

    /// The options in force.
    pub fn options(&self) -> FactorOptions {
        self.options
    }

    /// The diffusion time t, in the file's unit squared: m h², or more on long surfaces, where heat would underflow.
    pub fn time(&self) -> f64 {
        self.time_with(self.options)
    }

    /// m in t = m h², with the t that holds.
    pub fn time_factor(&self) -> f64 {
        self.time_factor_with(self.options)
    }

    fn time_factor_with(&self, options: FactorOptions) -> f64 {
        let mean_edge = self.operators().mean_edge();
        let least = self.logarithm_with(options).map_or(0.0, Logarithm::least_time_factor);
        let suited = larger(self.suited_factor, least);
        time_factor(options.time_step, options.solver, suited, mean_edge, self.extent)
    }

    /// Distance along the field of the logarithm of heat, where that stands for the gradient of distance.
    pub(super) fn logarithm(&self) -> Option<&Logarithm> {
        self.logarithm_with(self.options)
    }

    /// Heat that is 0 at the boundary has no logarithm there.
    fn logarithm_with(&self, options: FactorOptions) -> Option<&Logarithm> {
        let suits = options.time_step == TimeStep::Automatic && options.boundary == Boundary::Neumann;
        self.logarithm.as_ref().filter(|_| suits)
    }

    fn time_with(&self, options: FactorOptions) -> f64 {
        let mean_edge = self.operators().mean_edge();
        self.time_factor_with(options) * mean_edge * mean_edge
    }

    /// Stored entries of all factors that the options need, zeros inside supernodes counted; 0 for conjugate gradients.
    pub fn factor_nonzeros(&self) -> usize {
        self.poisson_nonzeros() + self.needed_flows().map(HeatFlow::factor_nonzeros).sum::<usize>()
    }
}

/// What becomes of heat at the boundary in the systems that a boundary condition needs; at least one.
fn conditions<'a>(boundary: Boundary, neumann: &'a Condition, dirichlet: Option<&'a Condition>) -> Vec<&'a Condition> {
    match (boundary, dirichlet) {
        (Boundary::Dirichlet, Some(dirichlet)) => vec![dirichlet],
        (Boundary::Average, Some(dirichlet)) => vec![neumann, dirichlet],
        _ => vec![neumann],
    }
}

/// Cold on the boundary of components that also have an inside, if there is one.
fn dirichlet(surface: &Surface) -> Option<Condition> {
    let mut has_inside = vec![false; surface.report().components];
    for (&component, is_boundary) in surface.components().iter().zip(surface.boundary_vertices()) {
        has_inside[component as usize] |= !is_boundary;
    }
    let boundary = surface.components().iter().zip(surface.boundary_vertices());
    let is_cold: VertexData<bool> = boundary.map(|(&c, &boundary)| boundary && has_inside[c as usize]).collect();
    let is_any_cold = is_cold.iter().any(|&cold| cold);
    is_any_cold.then(|| Condition::Dirichlet(Arc::new(is_cold)))
}

/// The vertices in the order of the file, where that is another one.
fn numbering(surface: &Surface) -> Option<Vec<u32>> {
    let first_input = |vertex: VertexId| surface.inputs_of_vertex(vertex)[0];
    if surface.vertices().is_sorted_by_key(first_input) {
        return None;
    }
    let mut vertices: Vec<u32> = surface.vertices().map(|vertex| vertex.0).collect();
    vertices.sort_unstable_by_key(|&vertex| first_input(VertexId(vertex)));
    Some(vertices)
}
