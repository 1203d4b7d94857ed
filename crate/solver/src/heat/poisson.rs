//! A function from its gradient: the Poisson equation under any constraints.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::error::Result;
use crate::heat::constraint::Constraint;
use crate::heat::systems::{CachedSystem, Systems};
use crate::operator::{Discretization, Operators};
use heatwalk_sparse::{Functional, Progress, SchurColumn, SchurComplement, SymmetricMatrix, System, evaluate};

/// Name of the matrix in errors.
pub(super) const POISSON_MATRIX: &str = "Poisson";

/// Added to every entry of the Schur complement of constraints whose multipliers sum to 0, which it does not change: the
/// column of a constraint at the grounded vertex alone is 0 and would not be seen.
const SCHUR_SHIFT: f64 = 1.0;

/// `L φ = divergence`: the function whose gradient is nearest to a field. On each connected component a constant is free.
#[derive(Debug)]
pub struct Poisson<D = Operators> {
    systems: Arc<Systems<D>>,
    system: CachedSystem,
    /// The first vertex of each component, where the solution is 0 before its constant is known.
    grounded: Vec<u32>,
}

impl<D: Discretization> Poisson<D> {
    /// Factors the matrix.
    ///
    /// # Errors
    /// [`NotPositiveDefinite`](crate::Error::NotPositiveDefinite) on degenerate triangles;
    /// [`OutOfMemory`](crate::Error::OutOfMemory); [`Cancelled`](crate::Error::Cancelled).
    pub fn new(systems: &Arc<Systems<D>>, progress: Progress<'_>) -> Result<Self> {
        let [system] = systems.systems([(Self::matrix(systems), POISSON_MATRIX)], progress)?;
        Ok(Self::with_system(systems, system))
    }

    pub(super) fn matrix(systems: &Systems<D>) -> SymmetricMatrix {
        constrained_matrix(systems, grounded(systems).into_iter())
    }

    /// With the matrix made ready elsewhere.
    pub(super) fn with_system(systems: &Arc<Systems<D>>, system: System) -> Self {
        Self { system: CachedSystem::new(system), grounded: grounded(systems), systems: Arc::clone(systems) }
    }

    /// Stored entries of the factor, zeros inside supernodes counted; 0 for conjugate gradients.
    pub fn factor_nonzeros(&self) -> usize {
        self.system.system.factor_nonzeros()
    }

    /// The solution (`#V`) for an integrated divergence (`#V`, sums to 0 on each component) that has the value of each
    /// constraint. Components without one have 0 at their first vertex.
    ///
    /// # Errors
    /// [`NotConverged`](crate::Error::NotConverged) of conjugate gradients;
    /// [`OutOfMemory`](crate::Error::OutOfMemory).
    pub fn solve(&self, divergence: &[f64], constraints: &[Constraint]) -> Result<Vec<f64>> {
        self.solve_beyond(divergence, constraints, std::iter::empty())
    }

    /// The same where more is known: `inside` gives vertices whose values follow from the divergence and the
    /// constraints. They are constrained, too, where that is free.
    pub(super) fn solve_beyond(
        &self,
        divergence: &[f64],
        constraints: &[Constraint],
        inside: impl Iterator<Item = (u32, f64)>,
    ) -> Result<Vec<f64>> {
        if self.systems.is_cheaper_to_factor(constraints.len()) {
            let prescribed = self.prescribed(inside, constraints);
            let matrix = constrained_matrix(&self.systems, prescribed.values.keys().copied());
            let system = self.systems.system(matrix, POISSON_MATRIX)?;
            let free = self.free(constraints, &prescribed);
            let columns = system.schur_columns(&functionals(&free))?;
            return self.joined(&system, divergence, &prescribed, &free, &columns);
        }
        let prescribed = self.ground();
        let free = self.free(constraints, &prescribed);
        if free.values().all(|free| free.len() == 1) {
            return self.shifted(divergence, &prescribed, &free);
        }
        let columns = self.system.columns(&functionals(&free))?;
        self.joined(&self.system.system, divergence, &prescribed, &free, &columns)
    }

    /// The solution that meets the constraints of each component in their mean only.
    ///
    /// # Errors
    /// [`NotConverged`](crate::Error::NotConverged) of conjugate gradients.
    pub fn solve_in_mean(&self, divergence: &[f64], constraints: &[Constraint]) -> Result<Vec<f64>> {
        let prescribed = self.ground();
        let free = self.free(constraints, &prescribed);
        self.shifted(divergence, &prescribed, &free)
    }

    /// The right side of the factored system.
    pub(super) fn grounded_right(&self, divergence: &[f64]) -> Vec<f64> {
        self.lifted(divergence, &self.ground())
    }

    /// The solution of the factored system plus the constant that meets the constraints in their mean.
    fn shifted(&self, divergence: &[f64], prescribed: &Prescribed, free: &FreeConstraints) -> Result<Vec<f64>> {
        let mut values = self.system.system.solve(&self.lifted(divergence, prescribed))?;
        let mut constants = vec![0.0; self.grounded.len()];
        for (&component, free) in free {
            let missing = free.iter().map(|Constraint { functional, value }| value - evaluate(functional, &values));
            constants[component as usize] = missing.sum::<f64>() / free.len() as f64;
        }
        self.complete(&mut values, prescribed, &constants);
        Ok(values)
    }

    /// The solution that has every wanted value, by one solve and the multipliers of the constraints.
    fn joined(
        &self,
        system: &System,
        divergence: &[f64],
        prescribed: &Prescribed,
        free: &FreeConstraints,
        mut columns: &[Arc<SchurColumn>],
    ) -> Result<Vec<f64>> {
        let mut partial = system.partial_solve(&self.lifted(divergence, prescribed))?;
        let mut constants = vec![0.0; self.grounded.len()];
        for (&component, free) in free {
            let (own, others) = columns.split_at(free.len());
            columns = others;
            let floats = prescribed.floats[component as usize];
            let missing: Vec<f64> =
                free.iter().zip(own).map(|(constraint, column)| constraint.value - partial.evaluate(column)).collect();
            let schur = SchurComplement::new(own, if floats { SCHUR_SHIFT } else { 0.0 });
            let mut multipliers = schur.solve(&missing);
            if floats {
                // The constant is free, so the multipliers sum to 0.
                let ones = schur.solve(&vec![1.0; own.len()]);
                let constant = multipliers.iter().sum::<f64>() / ones.iter().sum::<f64>();
                for (multiplier, one) in multipliers.iter_mut().zip(&ones) {
                    *multiplier -= constant * one;
                }
                constants[component as usize] = constant;
            }
            for (&multiplier, column) in multipliers.iter().zip(own) {
                partial.add(multiplier, column);
            }
        }
        let mut values = partial.finish();
        self.complete(&mut values, prescribed, &constants);
        Ok(values)
    }

    /// One vertex of each component at 0.
    fn ground(&self) -> Prescribed {
        let values = self.grounded.iter().map(|&vertex| (vertex, 0.0)).collect();
        Prescribed { values, floats: vec![true; self.grounded.len()] }
    }

    /// Known vertices and those of constraints, and the grounded vertex of each component that has none of these.
    fn prescribed(&self, inside: impl Iterator<Item = (u32, f64)>, constraints: &[Constraint]) -> Prescribed {
        let mut values: BTreeMap<u32, f64> = inside.collect();
        for constraint in constraints {
            if let Some(vertex) = constraint.vertex() {
                let value = values.entry(vertex).or_insert(constraint.value);
                *value = value.min(constraint.value);
            }
        }
        let mut floats = vec![true; self.grounded.len()];
        for &vertex in values.keys() {
            floats[self.systems.operators().components()[vertex as usize] as usize] = false;
        }
        let floating = self.grounded.iter().zip(&floats).filter(|&(_, &floats)| floats);
        values.extend(floating.map(|(&vertex, _)| (vertex, 0.0)));
        Prescribed { values, floats }
    }

    /// The constraints on the free vertices, by component. A component that floats needs even that on its grounded vertex
    /// alone.
    fn free(&self, constraints: &[Constraint], prescribed: &Prescribed) -> FreeConstraints {
        let mut free = FreeConstraints::new();
        for Constraint { functional, value } in constraints {
            let component = self.systems.operators().components()[functional[0].0 as usize];
            let given = |vertex: u32| prescribed.values.get(&vertex).copied();
            let part: Functional = functional.iter().copied().filter(|&(vertex, _)| given(vertex).is_none()).collect();
            if prescribed.floats[component as usize] || !part.is_empty() {
                let known: f64 = functional.iter().filter_map(|&(vertex, weight)| Some(weight * given(vertex)?)).sum();
                free.entry(component).or_default().push(Constraint { functional: part, value: value - known });
            }
        }
        free
    }

    /// The right side of the free vertices when the others have their prescribed values.
    fn lifted(&self, divergence: &[f64], prescribed: &Prescribed) -> Vec<f64> {
        let mut right = divergence.to_vec();
        if prescribed.values.values().any(|&value| value != 0.0) {
            let mut levels = vec![0.0; right.len()];
            for (&vertex, &value) in &prescribed.values {
                levels[vertex as usize] = value;
            }
            for (right, outflow) in right.iter_mut().zip(self.systems.operators().laplacian().apply(|_| 0.0, &levels)) {
                *right -= outflow;
            }
        }
        for &vertex in prescribed.values.keys() {
            right[vertex as usize] = 0.0;
        }
        right
    }

    /// Adds the prescribed values and the constants of components that float.
    fn complete(&self, values: &mut [f64], prescribed: &Prescribed, constants: &[f64]) {
        for (value, &component) in values.iter_mut().zip(self.systems.operators().components()) {
            *value += constants[component as usize];
        }
        for (&vertex, &value) in &prescribed.values {
            values[vertex as usize] += value;
        }
    }
}

/// Values that vertices have while the others are solved for.
struct Prescribed {
    /// By vertex.
    values: BTreeMap<u32, f64>,
    /// Per component whether only its grounded vertex has one, so that a constant is still free.
    floats: Vec<bool>,
}

/// Constraints on free vertices, by component.
type FreeConstraints = BTreeMap<u32, Vec<Constraint>>;

fn functionals(free: &FreeConstraints) -> Vec<Functional> {
    free.values().flatten().map(|constraint| constraint.functional.clone()).collect()
}

/// The stiffness with these vertices constrained.
fn constrained_matrix(systems: &Systems<impl Discretization>, vertices: impl Iterator<Item = u32>) -> SymmetricMatrix {
    let laplacian = systems.operators().laplacian();
    let mut is_constrained = vec![false; laplacian.size()];
    for vertex in vertices {
        is_constrained[vertex as usize] = true;
    }
    laplacian.combine(|_| 0.0, |vertex| is_constrained[vertex])
}

/// The first vertex of each component.
fn grounded(systems: &Systems<impl Discretization>) -> Vec<u32> {
    let mut first = Vec::new();
    for (vertex, &component) in systems.operators().components().iter().enumerate() {
        if component as usize == first.len() {
            first.push(vertex as u32);
        }
    }
    first
}
