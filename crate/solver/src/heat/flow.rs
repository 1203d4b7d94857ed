//! Heat after time t, from any supply and under any constraints.

use std::collections::BTreeMap;
use std::sync::Arc;

use heatwalk_sparse::{Functional, Progress, SchurComplement, SymmetricMatrix, System};
use heatwalk_surface::{VertexData, VertexId};

use crate::error::Result;
use crate::heat::constraint::Constraint;
use crate::heat::systems::{CachedSystem, Systems};
use crate::operator::{Discretization, Laplacian, Operators};

/// Name of the matrix in errors.
pub(super) const HEAT_MATRIX: &str = "heat";

/// What becomes of heat at the boundary.
#[derive(Debug, Clone)]
pub enum Condition {
    /// None leaves.
    Neumann,
    /// It is 0 at these vertices (`#V`).
    Dirichlet(Arc<VertexData<bool>>),
}

impl Condition {
    /// Whether this is the other or a clone of it.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Neumann, Self::Neumann) => true,
            (Self::Dirichlet(one), Self::Dirichlet(other)) => Arc::ptr_eq(one, other),
            _ => false,
        }
    }

    /// Whether heat is 0 at a vertex.
    pub(super) fn is_cold(&self, vertex: u32) -> bool {
        match self {
            Self::Neumann => false,
            Self::Dirichlet(is_cold) => is_cold[VertexId(vertex)],
        }
    }
}

/// What a heat matrix is made of beside the stiffness.
#[derive(Debug, Clone)]
pub(super) struct HeatStep {
    /// In the unit of the lengths, squared.
    pub(super) time: f64,
    pub(super) condition: Condition,
    /// `#V`.
    pub(super) mass: Arc<[f64]>,
}

impl HeatStep {
    /// With the lumped mass of the operators.
    pub(super) fn lumped(systems: &Systems<impl Discretization>, time: f64, condition: Condition) -> Self {
        Self { time, condition, mass: systems.operators().laplacian().mass.as_slice().into() }
    }

    /// Whether this is the other or a clone of it.
    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.time == other.time && self.condition.is_same(&other.condition) && Arc::ptr_eq(&self.mass, &other.mass)
    }

    /// `M / t + L`, with cold vertices constrained.
    pub(super) fn matrix(&self, laplacian: &Laplacian) -> SymmetricMatrix {
        laplacian.combine(|vertex| self.share(vertex), |vertex| self.condition.is_cold(vertex as u32))
    }

    /// Diagonal entry of `M / t`.
    pub(super) fn share(&self, vertex: usize) -> f64 {
        self.mass[vertex] / self.time
    }
}

/// Heat `u` after one implicit step of time t: `(M / t + L) u = supply`. It is linear in the supply, and any function will
/// do as one: a point, a curve, or a coordinate of a vector field.
#[derive(Debug)]
pub struct HeatFlow<D = Operators> {
    systems: Arc<Systems<D>>,
    step: HeatStep,
    system: CachedSystem,
}

impl<D: Discretization> HeatFlow<D> {
    /// Factors the matrix. `time` is in the unit of the lengths, squared.
    ///
    /// # Errors
    /// [`NotPositiveDefinite`](crate::Error::NotPositiveDefinite) on degenerate triangles;
    /// [`OutOfMemory`](crate::Error::OutOfMemory); [`Cancelled`](crate::Error::Cancelled).
    pub fn new(systems: &Arc<Systems<D>>, time: f64, condition: Condition, progress: Progress<'_>) -> Result<Self> {
        let step = HeatStep::lumped(systems, time, condition);
        let [system] = systems.systems([(step.matrix(systems.operators().laplacian()), HEAT_MATRIX)], progress)?;
        Ok(Self::with_system(systems, step, system))
    }

    /// With the matrix made ready elsewhere.
    pub(super) fn with_system(systems: &Arc<Systems<D>>, step: HeatStep, system: System) -> Self {
        Self { systems: Arc::clone(systems), step, system: CachedSystem::new(system) }
    }

    /// What its matrix is made of.
    pub(super) fn step(&self) -> &HeatStep {
        &self.step
    }

    /// The time t, in the unit of the lengths, squared.
    pub fn time(&self) -> f64 {
        self.step.time
    }

    /// How the system is solved.
    pub(super) fn systems(&self) -> &Systems<D> {
        &self.systems
    }

    /// What becomes of heat at the boundary.
    pub fn condition(&self) -> &Condition {
        &self.step.condition
    }

    /// Stored entries of the factor, zeros inside supernodes counted; 0 for conjugate gradients.
    pub fn factor_nonzeros(&self) -> usize {
        self.system.system.factor_nonzeros()
    }

    /// Heat (`#V`) from a supply (`#V`): heat put in at each vertex, per time t. Supply at cold vertices is lost.
    ///
    /// # Errors
    /// [`NotConverged`](crate::Error::NotConverged) of conjugate gradients.
    pub fn solve(&self, supply: &[f64]) -> Result<Vec<f64>> {
        let cold =
            |(vertex, &value): (usize, &f64)| if self.step.condition.is_cold(vertex as u32) { 0.0 } else { value };
        Ok(self.system.system.solve(&supply.iter().enumerate().map(cold).collect::<Vec<_>>())?)
    }

    /// Heat from a supply at a few vertices, none of them cold.
    pub(super) fn solve_sparse(&self, supply: &Functional) -> Result<Vec<f64>> {
        Ok(self.system.system.solve_sparse(supply)?)
    }

    /// Heat from a supply (`#V`) where some vertices have prescribed values (`#V`, 0 elsewhere), all of them cold.
    pub(super) fn solve_prescribed(&self, supply: &[f64], prescribed: &[f64]) -> Result<Vec<f64>> {
        let right = self.lifted(supply, prescribed, |vertex| self.step.condition.is_cold(vertex));
        let mut values = self.system.system.solve(&right)?;
        for (value, level) in values.iter_mut().zip(prescribed) {
            *value += level;
        }
        Ok(values)
    }

    /// Heat from a supply (`#V`) that has the value of each constraint, also where that is on cold vertices, and the heat
    /// that each constraint puts in for it, which is negative where it takes heat out.
    ///
    /// # Errors
    /// [`NotConverged`](crate::Error::NotConverged) of conjugate gradients;
    /// [`OutOfMemory`](crate::Error::OutOfMemory).
    pub fn solve_constrained(&self, supply: &[f64], constraints: &[Constraint]) -> Result<(Vec<f64>, Vec<f64>)> {
        let laplacian = self.systems.operators().laplacian();
        let vertices: Vec<u32> = constraints.iter().filter_map(Constraint::vertex).collect();
        let count = laplacian.size();
        let mut is_fixed: Vec<bool> = (0..count as u32).map(|vertex| self.step.condition.is_cold(vertex)).collect();
        let factored;
        let factors_anew = vertices.len() > 1 && self.systems.is_cheaper_to_factor(vertices.len());
        let system = if factors_anew {
            for &vertex in &vertices {
                is_fixed[vertex as usize] = true;
            }
            let matrix = laplacian.combine(|vertex| self.step.share(vertex), |vertex| is_fixed[vertex]);
            factored = self.systems.system(matrix, HEAT_MATRIX)?;
            &factored
        } else {
            &self.system.system
        };

        // Constraints on fixed vertices are prescribed there; the others are met by Schur complement.
        let mut levels: BTreeMap<u32, f64> = BTreeMap::new();
        let mut free: Vec<(usize, Functional)> = Vec::new();
        for (index, Constraint { functional, value }) in constraints.iter().enumerate() {
            let part: Functional =
                functional.iter().copied().filter(|&(vertex, _)| !is_fixed[vertex as usize]).collect();
            if part.is_empty() {
                for &(vertex, _) in functional {
                    levels.entry(vertex).and_modify(|level| *level = level.max(*value)).or_insert(*value);
                }
            } else {
                free.push((index, part));
            }
        }
        let mut prescribed = vec![0.0; count];
        for (&vertex, &level) in &levels {
            prescribed[vertex as usize] = level;
        }
        let right = self.lifted(supply, &prescribed, |vertex| is_fixed[vertex as usize]);
        let mut supplies = vec![0.0; constraints.len()];
        let mut values = if free.is_empty() {
            system.solve(&right)?
        } else {
            let functionals: Vec<Functional> = free.iter().map(|(_, part)| part.clone()).collect();
            let columns =
                if factors_anew { system.schur_columns(&functionals)? } else { self.system.columns(&functionals)? };
            let mut partial = system.partial_solve(&right)?;
            let missing: Vec<f64> = free
                .iter()
                .zip(&columns)
                .map(|(&(index, _), column)| {
                    let Constraint { functional, value } = &constraints[index];
                    let known: f64 =
                        functional.iter().map(|&(vertex, weight)| prescribed[vertex as usize] * weight).sum();
                    value - known - partial.evaluate(column)
                })
                .collect();
            let multipliers = SchurComplement::new(&columns, 0.0).solve(&missing);
            for ((&(index, _), column), &multiplier) in free.iter().zip(&columns).zip(&multipliers) {
                partial.add(multiplier, column);
                supplies[index] = multiplier;
            }
            partial.finish()
        };
        if !levels.is_empty() {
            for (value, level) in values.iter_mut().zip(&prescribed) {
                *value += level;
            }
            let put_in = laplacian.apply(|vertex| self.step.share(vertex), &values);
            for (constraint, given) in constraints.iter().zip(&mut supplies) {
                if let Some(vertex) = constraint.vertex().filter(|&vertex| is_fixed[vertex as usize]) {
                    *given = put_in[vertex as usize] - supply[vertex as usize];
                }
            }
        }
        Ok((values, supplies))
    }

    /// The right side of the free vertices when the fixed ones have their prescribed values.
    fn lifted(&self, supply: &[f64], prescribed: &[f64], is_fixed: impl Fn(u32) -> bool) -> Vec<f64> {
        let mut right = supply.to_vec();
        if prescribed.iter().any(|&level| level != 0.0) {
            let outflow = self.systems.operators().laplacian().apply(|vertex| self.step.share(vertex), prescribed);
            for (value, outflow) in right.iter_mut().zip(outflow) {
                *value -= outflow;
            }
        }
        for (vertex, value) in right.iter_mut().enumerate() {
            if is_fixed(vertex as u32) {
                *value = 0.0;
            }
        }
        right
    }
}
