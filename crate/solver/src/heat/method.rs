//! The heat method on elements of any kind.

use std::sync::{Arc, OnceLock};

use heatwalk_sparse::{Progress, Stage, go_on};
use heatwalk_surface::VertexData;

use crate::error::Result;
use crate::extremum::larger;
use crate::heat::discretization::HeatDiscretization;
use crate::heat::field::{Field, RightSide};
use crate::heat::flow::{Condition, HEAT_MATRIX, HeatFlow, HeatStep};
use crate::heat::point_source::PointSource;
use crate::heat::poisson::{POISSON_MATRIX, Poisson};
use crate::heat::region::ExactRegion;
use crate::heat::source_heat::SourceHeat;
use crate::heat::systems::Systems;
use crate::heat::time;
use crate::options::{Boundary, FactorOptions, MemoryLimit, MultiSource};

/// Numbers that the factors of heat systems may take that are not needed now, so that going back to another time or
/// boundary condition is free: 256 MiB.
const SPARE_NUMBERS: usize = 1 << 25;

/// Share of the progress before factoring.
const FACTORING_SHARE: f64 = 0.3;

/// The factored heat and Poisson matrices of a discretization: expensive to make, cheap to ask.
#[derive(Debug)]
pub struct HeatMethod<D> {
    options: FactorOptions,
    systems: Arc<Systems<D>>,
    /// Made when it is first needed: distance along the field of the logarithm does without.
    poisson: OnceLock<Poisson<D>>,
    /// Those that the options need, after others that were needed before.
    flows: Vec<HeatFlow<D>>,
    /// Neumann, and Dirichlet if any vertex is cold then.
    neumann: Condition,
    dirichlet: Option<Condition>,
    /// `#V`, that of the operators.
    mass: Arc<[f64]>,
    component_count: usize,
}

impl<D: HeatDiscretization> HeatMethod<D> {
    /// Factors what the options need.
    ///
    /// # Errors
    /// [`Cancelled`](crate::Error::Cancelled); [`NotPositiveDefinite`](crate::Error::NotPositiveDefinite);
    /// [`TooLarge`](crate::Error::TooLarge) where the factors do not fit, before any is made;
    /// [`OutOfMemory`](crate::Error::OutOfMemory).
    pub fn new(discretization: D, options: FactorOptions, progress: Progress<'_>) -> Result<Self> {
        let mass: Arc<[f64]> = discretization.laplacian().mass.as_slice().into();
        let component_count = discretization.components().iter().max().map_or(0, |&last| last as usize + 1);
        let dirichlet = dirichlet(&discretization, component_count);
        let numbering = discretization.numbering();
        let systems = Systems::numbered(discretization, numbering, options.solver, progress)?;
        let mut method = Self {
            options,
            systems,
            poisson: OnceLock::new(),
            flows: Vec::new(),
            neumann: Condition::Neumann,
            dirichlet,
            mass,
            component_count,
        };
        method.factor(options, FACTORING_SHARE, progress)?;
        Ok(method)
    }

    /// Changes the options, but for operator and solver, which take another method; factors the matrices that this touches, with the
    /// order found before. Going back to a recent boundary condition and time factors nothing.
    ///
    /// # Errors
    /// As [`Self::new`]. After an error it still answers, with the old options: the old factors go only when the new ones are there.
    pub fn set_options(&mut self, options: FactorOptions, progress: Progress<'_>) -> Result<()> {
        self.factor(options, 0.0, progress)
    }

    /// Factors the matrices that are needed and absent, and drops those longest unneeded where there are many.
    // Inlined with those below, it would make the page's module a sixteenth larger.
    #[inline(never)]
    fn factor(&mut self, options: FactorOptions, done: f64, progress: Progress<'_>) -> Result<()> {
        let is_absent = |step: &HeatStep| !self.flows.iter().any(|flow| flow.step().is_same(step));
        let mut steps: Vec<HeatStep> = self.needed(options).into_iter().filter(is_absent).collect();
        let needs_poisson = self.field_with(options) == Field::Unit && self.poisson.get().is_none();
        // Two matrices side by side take less time than one after the other.
        let beside_poisson = if needs_poisson { steps.pop() } else { None };
        let count = steps.len() + 2 * usize::from(beside_poisson.is_some());
        self.make_room(count, options.memory)?;
        let laplacian = self.systems.operators().laplacian();
        let mut factored = 0;
        let mut told = |factored: usize, stage: Stage, share: f64| {
            progress(stage, done + (1.0 - done) * (factored as f64 + share) / count as f64)
        };
        let mut poisson = None;
        let mut made = Vec::with_capacity(count);
        if let Some(step) = beside_poisson {
            let matrices = [(Poisson::matrix(&self.systems), POISSON_MATRIX), (step.matrix(laplacian), HEAT_MATRIX)];
            let [system, heat] = self.systems.systems(matrices, &mut |stage, share| told(0, stage, 2.0 * share))?;
            poisson = Some(Poisson::with_system(&self.systems, system));
            made.push(HeatFlow::with_system(&self.systems, step, heat));
            factored = 2;
        }
        for step in steps {
            let matrix = (step.matrix(laplacian), HEAT_MATRIX);
            let [system] = self.systems.systems([matrix], &mut |stage, share| told(factored, stage, share))?;
            made.push(HeatFlow::with_system(&self.systems, step, system));
            factored += 1;
        }
        if let Some(poisson) = poisson {
            self.poisson = poisson.into();
        }
        self.options = options;
        let flows = std::mem::take(&mut self.flows);
        let (kept, mut spare): (Vec<HeatFlow<D>>, Vec<HeatFlow<D>>) =
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
    fn needed(&self, options: FactorOptions) -> Vec<HeatStep> {
        let special = self.discretization().logarithm_mass().filter(|_| self.field_with(options) == Field::Logarithm);
        let mass = special.unwrap_or(&self.mass);
        let time = self.time_with(options);
        let conditions = conditions(options.boundary, &self.neumann, self.dirichlet.as_ref());
        let step = |condition: &Condition| HeatStep { time, condition: condition.clone(), mass: Arc::clone(mass) };
        conditions.into_iter().map(step).collect()
    }

    fn is_needed(&self, flow: &HeatFlow<D>) -> bool {
        self.needed(self.options).iter().any(|step| flow.step().is_same(step))
    }

    /// The heat systems that the options need.
    pub(super) fn needed_flows(&self) -> impl Iterator<Item = &HeatFlow<D>> {
        self.flows.iter().filter(|flow| self.is_needed(flow))
    }

    /// The Poisson system, factored now if it was not before.
    #[inline(never)]
    pub(super) fn poisson(&self) -> Result<&Poisson<D>> {
        if let Some(poisson) = self.poisson.get() {
            return Ok(poisson);
        }
        self.check_memory(1, self.options.memory)?;
        let poisson = Poisson::new(&self.systems, &mut go_on)?;
        Ok(self.poisson.get_or_init(|| poisson))
    }

    fn poisson_nonzeros(&self) -> usize {
        self.poisson.get().map_or(0, Poisson::factor_nonzeros)
    }

    /// What the matrices are made of.
    pub fn discretization(&self) -> &D {
        self.systems.operators()
    }

    /// The options in force.
    pub fn options(&self) -> FactorOptions {
        self.options
    }

    /// The field that stands for the gradient of distance.
    pub fn field(&self) -> Field {
        self.field_with(self.options)
    }

    /// Where no vertex can be cold, all boundary conditions are one.
    fn field_with(&self, options: FactorOptions) -> Field {
        let boundary = if self.dirichlet.is_some() { options.boundary } else { Boundary::Neumann };
        Field::of(FactorOptions { boundary, ..options }, self.discretization().has_logarithm())
    }

    /// The diffusion time t, in the unit of the lengths, squared: m h², or more on long meshes, where heat would underflow.
    pub fn time(&self) -> f64 {
        self.time_with(self.options)
    }

    /// m in t = m h², with the t that holds.
    pub fn time_factor(&self) -> f64 {
        self.time_factor_with(self.options)
    }

    fn time_factor_with(&self, options: FactorOptions) -> f64 {
        let discretization = self.discretization();
        let suited = discretization.time_factor(self.field_with(options));
        time::time_factor(options, suited, discretization.mean_edge(), discretization.extent())
    }

    fn time_with(&self, options: FactorOptions) -> f64 {
        let mean_edge = self.discretization().mean_edge();
        self.time_factor_with(options) * mean_edge * mean_edge
    }

    /// Stored entries of all factors that the options need, zeros inside supernodes counted; 0 for conjugate gradients.
    pub fn factor_nonzeros(&self) -> usize {
        self.poisson_nonzeros() + self.needed_flows().map(HeatFlow::factor_nonzeros).sum::<usize>()
    }

    /// Heat of sources, at least one.
    ///
    /// # Errors
    /// [`NotConverged`](crate::Error::NotConverged) of conjugate gradients; [`OutOfMemory`](crate::Error::OutOfMemory).
    pub fn heat(&self, sources: &[PointSource], multi_source: MultiSource) -> Result<SourceHeat> {
        SourceHeat::new(self.needed_flows(), sources, multi_source)
    }

    /// Distances (`#V`) from sources by the [heat](Self::heat) of them, exact in a region around them. Infinite in components without a
    /// source. At a source that is a vertex and nearest to itself it is exactly its initial distance, unless sources are summed.
    ///
    /// # Errors
    /// As [`Self::heat`]; [`TooLarge`](crate::Error::TooLarge) where the Poisson matrix is needed and does not fit.
    #[inline(never)]
    pub fn distances(
        &self,
        sources: &[PointSource],
        multi_source: MultiSource,
        heat: &SourceHeat,
        region: &ExactRegion<'_>,
    ) -> Result<Vec<f64>> {
        let (discretization, components) = (self.discretization(), self.discretization().components());
        let mut has_source = vec![false; self.component_count];
        for vertex in sources.iter().flat_map(PointSource::vertices) {
            has_source[components[vertex as usize] as usize] = true;
        }
        let is_exact =
            |vertex: usize| region.value(vertex as u32).is_some() || !has_source[components[vertex] as usize];
        let is_exact_everywhere = (0..components.len()).all(is_exact);
        let field = if multi_source == MultiSource::Exact { self.field() } else { Field::Unit };
        let active = || sources.iter().zip(&heat.is_active).filter(|&(_, &active)| active).map(|(source, _)| source);
        let mut values = match field {
            _ if is_exact_everywhere => vec![0.0; components.len()],
            Field::Logarithm => {
                let known = region.known(discretization.positions(), active());
                discretization.along_logarithm(&heat.values, self.time(), known)
            }
            Field::Unit => {
                let RightSide { divergence, rims: mut constraints } = discretization.unit_field(&heat.values, region);
                let beyond = active().filter(|source| region.lacks(source));
                constraints.extend(beyond.map(|source| source.constraint.clone()));
                match multi_source {
                    MultiSource::Exact => self.poisson()?.solve_beyond(&divergence, &constraints, region.values())?,
                    MultiSource::Summed => self.poisson()?.solve_in_mean(&divergence, &constraints)?,
                }
            }
        };
        let least = if region.radius().is_finite() { region.radius() } else { 0.0 };
        for (value, &component) in values.iter_mut().zip(components) {
            *value = if has_source[component as usize] { larger(*value, least) } else { f64::INFINITY };
        }
        region.write(&mut values);
        if let Some(bounds) = discretization.bounds(field).filter(|_| !is_exact_everywhere) {
            sources.iter().for_each(|source| source.lower(discretization.positions(), &mut values));
            bounds.keep(discretization.positions(), sources, &mut values);
            // These keep them but for rounding.
            region.write(&mut values);
        }
        if multi_source == MultiSource::Exact {
            sources.iter().for_each(|source| source.write_where_nearest(&mut values));
        }
        Ok(values)
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
fn dirichlet(discretization: &impl HeatDiscretization, component_count: usize) -> Option<Condition> {
    let (components, boundary) = (discretization.components(), discretization.boundary());
    let mut has_inside = vec![false; component_count];
    for (&component, is_boundary) in components.iter().zip(&boundary) {
        has_inside[component as usize] |= !is_boundary;
    }
    let cold = components.iter().zip(boundary).map(|(&component, boundary)| boundary && has_inside[component as usize]);
    let is_cold: VertexData<bool> = cold.collect();
    let is_any_cold = is_cold.iter().any(|&cold| cold);
    is_any_cold.then(|| Condition::Dirichlet(Arc::new(is_cold)))
}
