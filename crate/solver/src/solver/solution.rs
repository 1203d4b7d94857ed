//! An answer that becomes exact step by step.

use std::mem;

use heatwalk_surface::VertexData;

use super::{Answer, DistanceSolver};
use crate::accuracy::RelativeError;
use crate::error::{Error, Result};
use crate::heat::{HeatSolver, Refinement};
use crate::options::Method;
use crate::refinement::PropagationRefinement;

/// An answer, and how far it has become exact since; see [`DistanceSolver::refine`].
#[derive(Debug)]
pub struct Solution {
    answer: Answer,
    /// Absent before the first step and after the last.
    refining: Option<Refining>,
    /// The values before the first step.
    instant: Option<VertexData<f64>>,
}

/// What the exact region grows in.
#[derive(Debug)]
enum Refining {
    Heat(Refinement),
    Windows(PropagationRefinement),
}

impl From<Answer> for Solution {
    fn from(answer: Answer) -> Self {
        Self { answer, refining: None, instant: None }
    }
}

impl Solution {
    /// As it is by now.
    pub fn answer(&self) -> &Answer {
        &self.answer
    }

    /// `#V`, the values before they were made exact, in the file's unit; `None` until all are.
    pub fn instant(&self) -> Option<&VertexData<f64>> {
        self.instant.as_ref().filter(|_| self.answer.is_exact())
    }

    /// How far these were off; `None` until all are exact.
    pub fn error(&self) -> Option<RelativeError> {
        self.instant().map(|instant| RelativeError::between(instant, &self.answer.distance.values))
    }

    /// `#V`, how far each was off, relative to the exact distance; 0 at sources and where nothing is reached. `None` until all are exact.
    pub fn errors(&self) -> Option<VertexData<f64>> {
        let error = |(instant, exact): (&f64, &f64)| {
            let error = (instant - exact).abs() / exact;
            if error.is_finite() { error } else { 0.0 }
        };
        self.instant().map(|instant| instant.iter().zip(&self.answer.distance.values).map(error).collect())
    }
}

impl DistanceSolver {
    /// Makes a solution exact by about `work` windows further from its sources; once all is exact, nothing changes. After an error it is as
    /// it was, and the next step begins at the sources again.
    ///
    /// # Errors
    /// [`Error::NotExact`] where faces have different costs; as [`PropagationRefinement::new`] and
    /// [`HeatSolver::refine`]; [`Error::NoHeat`] where the factors of its answer are gone.
    pub fn refine(&mut self, solution: &mut Solution, work: usize) -> Result<()> {
        if solution.answer.is_exact() {
            return Ok(());
        }
        let mut refining = match solution.refining.take() {
            Some(refining) => refining,
            None => self.begin(&solution.answer)?,
        };
        let distance = match &mut refining {
            Refining::Heat(refinement) => refinement.step(self.factors()?.factorization(), work)?,
            Refining::Windows(refinement) => refinement.step(work)?,
        };
        let before = mem::replace(&mut solution.answer.distance, distance);
        solution.instant.get_or_insert(before.values);
        if !solution.answer.is_exact() {
            solution.refining = Some(refining);
        }
        Ok(())
    }

    fn begin(&mut self, answer: &Answer) -> Result<Refining> {
        // Heat knows nothing of the components beyond portals, nor of a cost that all faces have.
        let is_of_heat = answer.distance.crossings.is_empty() && self.constant_cost().is_none();
        if answer.method == Method::Heat && is_of_heat {
            return Ok(Refining::Heat(self.factors()?.refine(&answer.sources)?));
        }
        let lengths = answer.distance.clone();
        Ok(Refining::Windows(PropagationRefinement::new(self.exact_geometry(), &answer.sources, lengths)?))
    }

    fn factors(&self) -> Result<&HeatSolver> {
        self.heat.as_ref().ok_or(Error::NoHeat)
    }
}
