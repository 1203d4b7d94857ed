//! The heat method on tetrahedra: `(M + tL) u = δ`, `X = −∇u / |∇u|`, `L φ = div X`, with exact distances around the sources.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), section 3.2.3 for tetrahedra. Distances around the sources are those of the
//! [march](crate::march): in tetrahedra whose four corners it reached, X is their gradient. Where the time step is automatic, X is
//! the field of the [`Logarithm`] of heat, and distance follows it from vertex to vertex.

mod bounds;
mod elements;
mod field;
mod lengths;
mod logarithm;
mod region;
mod unit;

use std::ops::ControlFlow;
use std::sync::Arc;

use heatwalk::heat::{Condition, Constraint, HeatFlow, Poisson, SourceHeat, Systems, factor_pair};
use heatwalk::operator::Discretization;
use heatwalk::{Boundary, FactorOptions, MultiSource, Parameters, Progress, Stage, VertexData};

use crate::error::Result;
use crate::march::Medium;
use crate::mesh::TetMesh;
use crate::point::TetSource;
pub(crate) use elements::{Elements, gradient_in};
use field::Field;
use lengths::Lengths;
use logarithm::Logarithm;
use region::Region;
use unit::Right;

/// Share of the progress before factoring.
const FACTORING_SHARE: f64 = 0.3;

/// All that is factored of a mesh.
#[derive(Debug)]
pub(crate) struct VolumeHeat {
    options: FactorOptions,
    systems: Arc<Systems<Elements>>,
    /// None as long as no options needed it: distance along the field of the logarithm does not.
    poisson: Option<Poisson<Elements>>,
    flows: Vec<HeatFlow<Elements>>,
    lengths: Lengths,
    logarithm: Logarithm,
}

/// What the heat method finds.
pub(crate) struct Found {
    pub(crate) values: Vec<f64>,
    pub(crate) heat: Vec<f64>,
    pub(crate) exact_below: f64,
}

impl VolumeHeat {
    pub(crate) fn new(mesh: &TetMesh, medium: &Medium, options: FactorOptions, progress: Progress<'_>) -> Result<Self> {
        options.time_step.check()?;
        if progress(Stage::Assembling, 0.0).is_break() {
            return Err(heatwalk::Error::Cancelled.into());
        }
        let lengths = Lengths::of(mesh, medium);
        let systems = Systems::new(Elements::new(mesh, medium), options.solver, progress)?;
        let field = Field::of(options, systems.operators().is_monotone());
        let time = lengths.time(options, field);
        let mut conditions = conditions(mesh, &systems, options.boundary).into_iter();
        let first = conditions.next().unwrap_or(Condition::Neumann);
        let mut factoring = |share| progress(Stage::Factoring, FACTORING_SHARE + (1.0 - FACTORING_SHARE) * share);
        let (flow, poisson) = match field {
            Field::Logarithm => {
                systems.check_memory(0, 1, options.memory)?;
                (HeatFlow::with_progress(&systems, time, first, &mut factoring)?, None)
            }
            Field::Unit => {
                systems.check_memory(0, 2 + conditions.len(), options.memory)?;
                let (flow, poisson) = factor_pair(&systems, time, first, &mut factoring)?;
                (flow, Some(poisson))
            }
        };
        let mut flows = vec![flow];
        for condition in conditions {
            flows.push(HeatFlow::new(&systems, time, condition)?);
        }
        let logarithm = Logarithm::new(mesh, medium, systems.operators().laplacian(), lengths.mean_edge);
        Ok(Self { options, systems, poisson, flows, lengths, logarithm })
    }

    /// Changes the options; factors the heat matrices anew where that is needed, and the Poisson matrix where it was not before.
    pub(crate) fn set_options(
        &mut self,
        mesh: &TetMesh,
        medium: &Medium,
        options: FactorOptions,
        progress: Progress<'_>,
    ) -> Result<()> {
        options.time_step.check()?;
        if options == self.options {
            return Ok(());
        }
        if options.solver != self.options.solver {
            *self = Self::new(mesh, medium, options, progress)?;
            return Ok(());
        }
        let field = Field::of(options, self.systems.operators().is_monotone());
        if field == Field::Unit && self.poisson.is_none() {
            if progress(Stage::Factoring, 0.0).is_break() {
                return Err(heatwalk::Error::Cancelled.into());
            }
            self.systems.check_memory(self.factor_nonzeros(), 1, options.memory)?;
            self.poisson = Some(Poisson::new(&self.systems)?);
        }
        let time = self.lengths.time(options, field);
        let mut flows = Vec::new();
        for condition in conditions(mesh, &self.systems, options.boundary) {
            if progress(Stage::Factoring, 0.0).is_break() {
                return Err(heatwalk::Error::Cancelled.into());
            }
            self.systems.check_memory(self.factor_nonzeros(), 1, options.memory)?;
            flows.push(HeatFlow::new(&self.systems, time, condition)?);
        }
        self.flows = flows;
        self.options = options;
        Ok(())
    }

    /// Stored entries of all factors; 0 for conjugate gradients.
    pub(crate) fn factor_nonzeros(&self) -> usize {
        self.poisson.as_ref().map_or(0, Poisson::factor_nonzeros)
            + self.flows.iter().map(HeatFlow::factor_nonzeros).sum::<usize>()
    }

    /// m in t = m h².
    pub(crate) fn time_factor(&self) -> f64 {
        self.flows[0].time() / (self.lengths.mean_edge * self.lengths.mean_edge)
    }

    /// Distances from sources that were checked.
    pub(crate) fn distance(
        &self,
        mesh: &TetMesh,
        medium: &Medium,
        sources: &[TetSource],
        parameters: &Parameters,
    ) -> Result<Found> {
        parameters.exact_radius.check()?;
        let constraint = |source: &TetSource| Constraint::new(source.point.support(mesh), source.initial_distance);
        let constraints: Vec<Constraint> = sources.iter().map(constraint).collect();
        let SourceHeat { values: heat, is_active } =
            SourceHeat::new(self.flows.iter(), &constraints, parameters.sources)?;
        let field = Field::of(self.options, self.systems.operators().is_monotone());
        let region = Region::new(mesh, medium, sources, parameters.exact_radius, self.lengths.mean_edge, field.work());
        let active: Vec<TetSource> =
            sources.iter().zip(is_active).filter(|&(_, active)| active).map(|(&source, _)| source).collect();
        let elements = self.systems.operators();
        let mut values = match &self.poisson {
            Some(poisson) if field == Field::Unit => {
                let Right { divergence, rims: mut constraints } = unit::right(mesh, medium, &heat, &region);
                constraints.extend(region.beyond(mesh, &active));
                match parameters.sources {
                    MultiSource::Exact => poisson.solve(&divergence, &constraints)?,
                    MultiSource::Summed => poisson.solve_in_mean(&divergence, &constraints)?,
                }
            }
            _ => {
                let known = region.known(mesh, medium, &active);
                self.logarithm.distances(elements.laplacian(), &heat, self.flows[0].time(), known)
            }
        };
        region.complete(mesh, elements.components(), sources, &mut values);
        bounds::cap(mesh, medium, sources, &mut values);
        bounds::raise(mesh, medium, sources, &mut values);
        Ok(Found { values, heat, exact_below: region.radius() })
    }
}

/// What becomes of heat at the boundary; at least one.
fn conditions(mesh: &TetMesh, systems: &Systems<Elements>, boundary: Boundary) -> Vec<Condition> {
    if boundary == Boundary::Neumann {
        return vec![Condition::Neumann];
    }
    let is_on_boundary = mesh.is_on_boundary();
    let components = systems.operators().components();
    let mut has_inside = vec![false; components.iter().max().map_or(0, |&last| last as usize + 1)];
    for (&component, is_on_boundary) in components.iter().zip(&is_on_boundary) {
        has_inside[component as usize] |= !is_on_boundary;
    }
    let is_cold: VertexData<bool> = components
        .iter()
        .zip(is_on_boundary)
        .map(|(&component, boundary)| boundary && has_inside[component as usize])
        .collect();
    if !is_cold.iter().any(|&cold| cold) {
        return vec![Condition::Neumann];
    }
    let dirichlet = Condition::Dirichlet(Arc::new(is_cold));
    if boundary == Boundary::Dirichlet { vec![dirichlet] } else { vec![Condition::Neumann, dirichlet] }
}

/// Nobody stops it.
pub(crate) fn go_on(_: Stage, _: f64) -> ControlFlow<()> {
    ControlFlow::Continue(())
}
