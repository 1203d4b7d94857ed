//! Geodesic distance by the heat method: `(M + tL) u = δ`, `X = −∇u / |∇u|`, `L φ = div X`.
//!
//! The heat matrix is divided by t, so that no number here depends on the file's unit.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), algorithm 1; section 3.2.2 for the boundary.

mod distance;
mod field;
mod flow;
mod near;
mod poisson;
mod systems;

use std::sync::{Arc, Mutex};

use crate::dijkstra;
use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};
use crate::operator::elements::Elements;
use crate::operator::laplacian::Laplacian;
use crate::options::{Boundary, LinearSolver, MemoryLimit, Parameters, TimeStep};
use crate::progress::{Progress, Stage, report};
use heatwalk_sparse::{Permutation, SchurCache, Symbolic, System};
use heatwalk_surface::VertexId;
use heatwalk_surface::memory;
use heatwalk_surface::surface::Surface;

pub use distance::{Distance, Refinement};
use systems::Solve;

/// Heat falls by about one e-fold per √t of distance. √t is at least the surface's extent over this: the e-folds that
/// `SOURCE_HEAT` leaves room for, less an eighth for triangles that slow heat down.
const EFOLDS: f64 = 1200.0;

/// The same where the time is chosen for conjugate gradients, which leave noise at 10⁻¹² of the largest heat.
const ITERATED_EFOLDS: f64 = 27.0;

/// Root-mean-square deviation of edge lengths, as a share of their mean, up to which a mesh is even and from which on
/// it is not.
const EVENNESS: [f64; 2] = [0.15, 0.25];

/// m on even meshes and on others, where so short a time would follow the edges, up to the extents of `RESOLUTIONS`.
/// Measured on forty cases; the near field takes the first rings, where a short time is too coarse on any mesh.
const SUITED_FACTORS: [f64; 2] = [0.3, 1.0];

/// Numbers that the factors of heat systems may take that are not needed now, so that going back to another time or
/// boundary condition is free: 256 MiB.
const SPARE_NUMBERS: usize = 1 << 25;

/// Share of the progress before factoring, and of that, with the first heat matrix, in all.
const FACTORING_SHARES: [f64; 2] = [0.3, 0.75];

/// Extents in mean edges up to which these hold. Beyond, m grows with the power of 2/3: what heat errs by for following
/// the edges falls as 1/m, what it errs by for rounding the distance off grows as √t, and so their sum falls with the
/// size of the edges.
const RESOLUTIONS: [f64; 2] = [80.0, 120.0];

/// Bytes that the triangles of the operators, the matrices and what exact distances need take at once, a face.
const BYTES_PER_FACE: u64 = 256;

/// A surface ready to be asked: expensive to make, cheap to ask.
#[derive(Debug)]
pub struct HeatSolver {
    surface: Arc<Surface>,
    parameters: Parameters,
    elements: Elements,
    laplacian: Laplacian,
    solve: Solve,
    /// `L`, with `pinned` held.
    poisson: System,
    poisson_responses: Mutex<SchurCache>,
    /// Those that the parameters need, after others that were needed before.
    heats: Vec<Heat>,
    /// Per point whether Dirichlet holds it: the boundary of pieces that also have an inside.
    held: Vec<bool>,
    /// Any point of each piece, where the Poisson solution is held at 0.
    pinned: Vec<u32>,
    /// Mean edge of the triangles that carry the operators, and the m that suits them.
    mean_edge: f64,
    suited_factor: f64,
    /// Largest distance along edges, in the file's unit.
    extent: f64,
    exact: Arc<ExactGeometry>,
    /// The wavefront of the last near field, kept for its memory.
    front: Mutex<Option<Wavefront>>,
}

/// `M / t + L` for one boundary condition.
#[derive(Debug)]
struct Heat {
    condition: Condition,
    time: f64,
    system: System,
    responses: Mutex<SchurCache>,
}

/// What becomes of heat at the boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Condition {
    /// It does not leave: Neumann.
    Insulated,
    /// It is held at 0 where the solver's `held` says: Dirichlet.
    Held,
}

impl HeatSolver {
    /// Factors a surface.
    ///
    /// # Errors
    /// [`BadParameter`](crate::Error::BadParameter); [`Cancelled`](crate::Error::Cancelled);
    /// [`NotPositiveDefinite`](crate::Error::NotPositiveDefinite); [`TooLarge`](crate::Error::TooLarge) where the factors
    /// do not fit, before any is made; [`OutOfMemory`](crate::Error::OutOfMemory).
    pub fn new(surface: impl Into<Arc<Surface>>, parameters: Parameters, progress: Progress<'_>) -> Result<Self> {
        let surface = surface.into();
        parameters.check()?;
        report(progress, Stage::Assembling, 0.0)?;
        memory::require(BYTES_PER_FACE * surface.face_count() as u64, "assembling the matrices")?;
        let extent = dijkstra::extent(&surface);
        let exact = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
        Self::assemble(surface, parameters, extent, exact, progress)
    }

    fn assemble(
        surface: Arc<Surface>,
        parameters: Parameters,
        extent: f64,
        exact: Arc<ExactGeometry>,
        progress: Progress<'_>,
    ) -> Result<Self> {
        let elements = parameters.operator.elements(&surface);
        let laplacian = Laplacian::of_elements(surface.vertex_count(), &elements);
        let mean_edge = elements.mean_edge;
        let suited_factor = suited_factor(elements.deviation, extent / mean_edge);
        let solve = match parameters.solver {
            LinearSolver::Cholesky => {
                report(progress, Stage::Ordering, 0.1)?;
                let permutation = Permutation::fill_reducing(laplacian.pattern())?;
                report(progress, Stage::Analysing, 0.2)?;
                Solve::Factored(Arc::new(Symbolic::analyse(laplacian.pattern(), permutation)?))
            }
            LinearSolver::ConjugateGradients => Solve::Iterated,
        };
        let pinned = first_of_components(&surface);
        let mut is_pinned = vec![false; surface.vertex_count()];
        for &point in &pinned {
            is_pinned[point as usize] = true;
        }
        let held = dirichlet_points(&surface);
        let time = time_factor(parameters, suited_factor, mean_edge, extent) * mean_edge * mean_edge;
        let needed = conditions(parameters.boundary, &held);
        solve.check_memory(0, 1 + needed.len(), parameters.memory)?;
        let condition = needed[0];
        let grounded = laplacian.combine(0.0, |point| is_pinned[point]);
        let values = laplacian.combine(1.0 / time, |point| condition == Condition::Held && held[point]);
        let [from, to] = FACTORING_SHARES;
        let [poisson, system] = solve.systems([(grounded, "Poisson"), (values, "heat")], &mut |share| {
            progress(Stage::Factoring, from + (to - from) * share)
        })?;
        let mut solver = Self {
            surface,
            parameters,
            elements,
            laplacian,
            solve,
            poisson,
            poisson_responses: Mutex::default(),
            heats: vec![Heat { condition, time, system, responses: Mutex::default() }],
            held,
            pinned,
            mean_edge,
            suited_factor,
            extent,
            exact,
            front: Mutex::default(),
        };
        solver.factor_heat(parameters, to, progress)?;
        Ok(solver)
    }

    /// Changes parameters; factors the matrices that this touches, with the order found before where the operator
    /// stays. Going back to a boundary condition and time of late factors nothing.
    ///
    /// # Errors
    /// As [`HeatSolver::new`]. After an error the solver still answers, with the old parameters: the old factors go
    /// only when the new ones are there.
    pub fn set_parameters(&mut self, parameters: Parameters, progress: Progress<'_>) -> Result<()> {
        parameters.check()?;
        if (parameters.operator, parameters.solver) == (self.parameters.operator, self.parameters.solver) {
            return self.factor_heat(parameters, 0.0, progress);
        }
        report(progress, Stage::Assembling, 0.0)?;
        let (surface, exact) = (Arc::clone(&self.surface), Arc::clone(&self.exact));
        *self = Self::assemble(surface, parameters, self.extent, exact, progress)?;
        Ok(())
    }

    /// Factors the heat matrices that are needed and absent, and drops those longest unneeded where there are many.
    fn factor_heat(&mut self, parameters: Parameters, done: f64, progress: Progress<'_>) -> Result<()> {
        let time = self.time_with(parameters);
        let needed = conditions(parameters.boundary, &self.held);
        let is_kept =
            |condition: &&Condition| self.heats.iter().any(|heat| (heat.condition, heat.time) == (**condition, time));
        let absent: Vec<Condition> = needed.iter().filter(|condition| !is_kept(condition)).copied().collect();
        self.make_room(absent.len(), parameters.memory)?;
        let mut made = Vec::with_capacity(absent.len());
        for (index, &condition) in absent.iter().enumerate() {
            let values = self.laplacian.combine(1.0 / time, |point| condition == Condition::Held && self.held[point]);
            let [system] = self.solve.systems([(values, "heat")], &mut |share| {
                let share = (index as f64 + share) / absent.len() as f64;
                progress(Stage::Factoring, done + (1.0 - done) * share)
            })?;
            made.push(Heat { condition, time, system, responses: Mutex::default() });
        }
        self.parameters = parameters;
        let is_needed = |heat: &Heat| heat.time == time && needed.contains(&heat.condition);
        let (kept, mut spare): (Vec<Heat>, Vec<Heat>) =
            std::mem::take(&mut self.heats).into_iter().partition(is_needed);
        let mut numbers = 0;
        let first = spare.iter().rposition(|heat| {
            numbers += heat.system.factor_nonzeros();
            numbers > SPARE_NUMBERS
        });
        spare.drain(..first.map_or(0, |index| index + 1));
        self.heats = spare.into_iter().chain(kept).chain(made).collect();
        Ok(())
    }

    /// Sees to room for the factors of so many more matrices. Spare ones go where it is short.
    fn make_room(&mut self, matrices: usize, limit: MemoryLimit) -> Result<()> {
        if self.check_memory(matrices, limit).is_ok() {
            return Ok(());
        }
        let (time, needed) = (self.time(), conditions(self.parameters.boundary, &self.held));
        self.heats.retain(|heat| heat.time == time && needed.contains(&heat.condition));
        self.check_memory(matrices, limit)
    }

    fn check_memory(&self, matrices: usize, limit: MemoryLimit) -> Result<()> {
        let heats = self.heats.iter().map(|heat| heat.system.factor_nonzeros());
        self.solve.check_memory(self.poisson.factor_nonzeros() + heats.sum::<usize>(), matrices, limit)
    }

    /// The heat systems that the parameters need.
    fn needed_heats(&self) -> impl Iterator<Item = &Heat> {
        let (time, needed) = (self.time(), conditions(self.parameters.boundary, &self.held));
        self.heats.iter().filter(move |heat| heat.time == time && needed.contains(&heat.condition))
    }

    /// The surface.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// What exact distances and paths need of the surface.
    pub fn exact_geometry(&self) -> &Arc<ExactGeometry> {
        &self.exact
    }

    /// The edges of the triangles that carry the operators: points, the lower first, and length, in the file's unit. Edges
    /// of the same points whose lengths differ by a share of `tolerance` at most are there once.
    pub fn operator_edges(&self, tolerance: f64) -> Vec<([VertexId; 2], f64)> {
        let edges = self.elements.edges(tolerance).into_iter();
        edges.map(|(ends, length)| (ends.map(VertexId), length)).collect()
    }

    /// The parameters in force.
    pub fn parameters(&self) -> Parameters {
        self.parameters
    }

    /// The diffusion time t, in the file's unit squared: m h², or more on long surfaces, where heat would underflow.
    pub fn time(&self) -> f64 {
        self.time_with(self.parameters)
    }

    /// m in t = m h², with the t that holds.
    pub fn time_factor(&self) -> f64 {
        self.time_factor_with(self.parameters)
    }

    fn time_factor_with(&self, parameters: Parameters) -> f64 {
        time_factor(parameters, self.suited_factor, self.mean_edge, self.extent)
    }

    fn time_with(&self, parameters: Parameters) -> f64 {
        self.time_factor_with(parameters) * self.mean_edge * self.mean_edge
    }

    /// Stored entries of all factors that the parameters need, zeros inside supernodes counted; 0 for conjugate gradients.
    pub fn factor_nonzeros(&self) -> usize {
        self.poisson.factor_nonzeros() + self.needed_heats().map(|heat| heat.system.factor_nonzeros()).sum::<usize>()
    }
}

/// What becomes of heat at the boundary in the systems that a boundary condition needs.
fn conditions(boundary: Boundary, held: &[bool]) -> &'static [Condition] {
    match boundary {
        Boundary::Dirichlet if held.contains(&true) => &[Condition::Held],
        Boundary::Average if held.contains(&true) => &[Condition::Insulated, Condition::Held],
        _ => &[Condition::Insulated],
    }
}

/// m in t = m h², as given or chosen, but large enough for heat to reach everywhere.
fn time_factor(parameters: Parameters, suited_factor: f64, mean_edge: f64, extent: f64) -> f64 {
    let (factor, efolds) = match (parameters.time_step, parameters.solver) {
        (TimeStep::Automatic, LinearSolver::ConjugateGradients) => (suited_factor, ITERATED_EFOLDS),
        (TimeStep::Automatic, LinearSolver::Cholesky) => (suited_factor, EFOLDS),
        (TimeStep::Factor(factor), _) => (factor, EFOLDS),
    };
    factor.max((extent / (efolds * mean_edge)).powi(2))
}

/// m by the deviation of edge lengths as a share of their mean, and the extent in mean edges.
fn suited_factor(deviation: f64, extent: f64) -> f64 {
    let [even, uneven] = EVENNESS;
    let unevenness = ((deviation - even) / (uneven - even)).clamp(0.0, 1.0);
    let [factor, resolution] = [SUITED_FACTORS, RESOLUTIONS].map(|[low, high]| low + (high - low) * unevenness);
    factor * (extent / resolution).max(1.0).powf(2.0 / 3.0)
}

/// The first point of each piece.
fn first_of_components(surface: &Surface) -> Vec<u32> {
    let mut first = Vec::with_capacity(surface.report().components);
    for (point, &component) in surface.components().iter().enumerate() {
        if component as usize == first.len() {
            first.push(point as u32);
        }
    }
    first
}

/// The boundary points of pieces that also have other points.
fn dirichlet_points(surface: &Surface) -> Vec<bool> {
    let mut has_inside = vec![false; surface.report().components];
    for (&component, is_boundary) in surface.components().iter().zip(surface.boundary_vertices()) {
        has_inside[component as usize] |= !is_boundary;
    }
    let components = surface.components().iter();
    let held = components.zip(surface.boundary_vertices()).map(|(&c, &boundary)| boundary && has_inside[c as usize]);
    held.collect()
}
