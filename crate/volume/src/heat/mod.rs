//! The heat method on tetrahedra: `(M + tL) u = δ`, `X = −∇u / |∇u|`, `L φ = div X`, with exact distances around the sources.
//!
//! Crane, Weischedel, Wardetzky, "Geodesics in Heat" (2013), section 3.2.3 for tetrahedra. Distances around the sources are those of the
//! [march](crate::march): in tetrahedra whose four corners it reached, X is their gradient. Where the time step is automatic, X is
//! the field of the [`Logarithm`] of heat.

mod elements;
mod logarithm;
mod region;
mod unit;

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::ControlFlow;
use std::sync::Arc;

use heatwalk::heat::{Condition, Constraint, HeatFlow, Poisson, SourceHeat, Systems, factor_pair};
use heatwalk::operator::Discretization;
use heatwalk::{Boundary, FactorOptions, LinearSolver, MultiSource, Parameters, Progress, Stage, TimeStep, VertexData};

use crate::error::Result;
use crate::march::Medium;
use crate::mesh::TetMesh;
use crate::point::TetSource;
pub(crate) use elements::{Elements, gradient_in};
use logarithm::Logarithm;
use region::{Region, Right};

/// What stands for the gradient of distance where that is not known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Field {
    /// −∇u / |∇u|.
    Unit,
    /// That of the [`Logarithm`] of heat.
    Logarithm,
}

/// Of the edges, all but this share are no long ones.
const LONG_EDGES: f64 = 0.01;

/// Where some edges are long, √t is at least this share of them, so that heat is not lost within one; but m is at most that of the
/// paper, 1.
const LONG_EDGE_SHARE: f64 = 0.45;

/// Heat falls by about one e-fold per √t of distance; √t is at least the extent over this, which the range of floats leaves room
/// for.
const EFOLDS: f64 = 1200.0;

/// The same for conjugate gradients, which leave noise at 10⁻¹² of the largest heat.
const ITERATED_EFOLDS: f64 = 27.0;

/// Share of the progress before factoring.
const FACTORING_SHARE: f64 = 0.3;

/// All that is factored of a mesh.
#[derive(Debug)]
pub(crate) struct VolumeHeat {
    options: FactorOptions,
    systems: Arc<Systems<Elements>>,
    poisson: Poisson<Elements>,
    flows: Vec<HeatFlow<Elements>>,
    lengths: Lengths,
    /// Whether nearly all edges have positive weights.
    is_monotone: bool,
    logarithm: Logarithm,
}

/// Lengths in a mesh, at the costs around.
#[derive(Debug, Clone, Copy)]
struct Lengths {
    mean_edge: f64,
    /// All but a hundredth of the edges are no longer.
    long_edge: f64,
    /// An upper bound of the distance along edges.
    extent: f64,
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
        let is_monotone = logarithm::is_monotone(systems.operators().laplacian());
        let time = lengths.time(options, Field::of(options, is_monotone));
        let mut conditions = conditions(mesh, &systems, options.boundary).into_iter();
        let first = conditions.next().unwrap_or(Condition::Neumann);
        systems.check_memory(0, 2 + conditions.len(), options.memory)?;
        let (flow, poisson) = factor_pair(&systems, time, first, &mut |share| {
            progress(Stage::Factoring, FACTORING_SHARE + (1.0 - FACTORING_SHARE) * share)
        })?;
        let mut flows = vec![flow];
        for condition in conditions {
            flows.push(HeatFlow::new(&systems, time, condition)?);
        }
        let logarithm = Logarithm::new(medium.is_on_boundary(mesh));
        Ok(Self { options, systems, poisson, flows, lengths, is_monotone, logarithm })
    }

    /// Changes the options; factors the heat matrices anew where that is needed.
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
        let time = self.lengths.time(options, Field::of(options, self.is_monotone));
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
        self.poisson.factor_nonzeros() + self.flows.iter().map(HeatFlow::factor_nonzeros).sum::<usize>()
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
        let field = Field::of(self.options, self.is_monotone);
        let region = Region::new(mesh, medium, sources, parameters.exact_radius, self.lengths.mean_edge, field.work());
        let elements = self.systems.operators();
        let Right { divergence, rims: mut constraints } = match field {
            Field::Unit => unit::right(mesh, medium, &heat, &region),
            Field::Logarithm => self.logarithm.right(elements.laplacian(), &heat, self.flows[0].time(), &region),
        };
        let active: Vec<TetSource> =
            sources.iter().zip(is_active).filter(|&(_, active)| active).map(|(&source, _)| source).collect();
        constraints.extend(region.beyond(mesh, &active));
        let mut values = match parameters.sources {
            MultiSource::Exact => self.poisson.solve(&divergence, &constraints)?,
            MultiSource::Summed => self.poisson.solve_in_mean(&divergence, &constraints)?,
        };
        region.complete(mesh, elements.components(), sources, &mut values);
        Ok(Found { values, heat, exact_below: region.radius() })
    }
}

impl Field {
    /// Heat that is 0 at the boundary has no logarithm there, and conjugate gradients leave noise in that of little heat.
    fn of(options: FactorOptions, is_monotone: bool) -> Self {
        match (options.time_step, options.solver, options.boundary) {
            (TimeStep::Automatic, LinearSolver::Cholesky, Boundary::Neumann) if is_monotone => Self::Logarithm,
            _ => Self::Unit,
        }
    }

    /// m in t = m h² where it is chosen and edges are even, by errors measured on cubes, balls and tubes.
    fn time_factor(self) -> f64 {
        match self {
            Self::Unit => 0.5,
            Self::Logarithm => 0.6,
        }
    }

    /// Work of the march in the exact region for each vertex.
    fn work(self) -> f64 {
        match self {
            Self::Unit => 5.5,
            Self::Logarithm => 3.0,
        }
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

impl Lengths {
    /// At the least cost around each edge.
    fn of(mesh: &TetMesh, medium: &Medium) -> Self {
        let uniform = medium.uniform_cost();
        let length = |[a, b]: [u32; 2]| {
            let cost = uniform.unwrap_or_else(|| least_cost(mesh, medium, [a, b]));
            cost * mesh.positions()[a as usize].distance(mesh.positions()[b as usize])
        };
        let (mut edges, mut extent) = (Vec::new(), 0.0_f64);
        let mut distances = vec![f64::INFINITY; mesh.vertex_count()];
        let mut queue: BinaryHeap<Reverse<(u64, u32)>> = BinaryHeap::new();
        for first in 0..mesh.vertex_count() as u32 {
            if distances[first as usize].is_finite() {
                continue;
            }
            distances[first as usize] = 0.0;
            queue.push(Reverse((0, first)));
            while let Some(Reverse((bits, vertex))) = queue.pop() {
                let distance = f64::from_bits(bits);
                if distance > distances[vertex as usize] {
                    continue;
                }
                extent = extent.max(distance);
                for &other in mesh.adjacent().row(vertex) {
                    let edge = length([vertex, other]);
                    if edge.is_finite() && other > vertex {
                        edges.push(edge);
                    }
                    if distance + edge < distances[other as usize] {
                        distances[other as usize] = distance + edge;
                        queue.push(Reverse(((distance + edge).to_bits(), other)));
                    }
                }
            }
        }
        let mean_edge = edges.iter().sum::<f64>() / edges.len().max(1) as f64;
        let rank = ((1.0 - LONG_EDGES) * edges.len() as f64) as usize;
        let long_edge = if edges.is_empty() { 0.0 } else { *edges.select_nth_unstable_by(rank, f64::total_cmp).1 };
        // From the first vertex to any two others and back.
        Self { mean_edge, long_edge, extent: 2.0 * extent }
    }

    /// t = m h², but long enough for heat to reach everywhere.
    fn time(self, options: FactorOptions, field: Field) -> f64 {
        let efolds = match (options.time_step, options.solver) {
            (TimeStep::Automatic, LinearSolver::ConjugateGradients) => ITERATED_EFOLDS,
            _ => EFOLDS,
        };
        let factor = match options.time_step {
            TimeStep::Automatic => {
                (LONG_EDGE_SHARE * self.long_edge / self.mean_edge).powi(2).clamp(field.time_factor(), 1.0)
            }
            TimeStep::Factor(factor) => factor,
        };
        (factor * self.mean_edge * self.mean_edge).max((self.extent / efolds).powi(2))
    }
}

/// The least cost of the tetrahedra around an edge.
fn least_cost(mesh: &TetMesh, medium: &Medium, [a, b]: [u32; 2]) -> f64 {
    let around = mesh.around().row(a).iter();
    let at_edge = around.filter(|&&tetrahedron| mesh.tetrahedra()[tetrahedron as usize].contains(&b));
    at_edge.map(|&tetrahedron| medium.cost(tetrahedron)).fold(f64::INFINITY, f64::min)
}

/// Nobody stops it.
pub(crate) fn go_on(_: Stage, _: f64) -> ControlFlow<()> {
    ControlFlow::Continue(())
}
