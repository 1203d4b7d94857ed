//! The field solved last, and how far it has become exact since.

use std::sync::Arc;

use heatwalk::exact::ExactGeometry;
use heatwalk::{Distance, HeatSolver, PropagationRefinement, Refinement, RelativeError, Source, VertexData};
use heatwalk_bindings::{Failure, Result};

use crate::drawn::Drawn;
use crate::field::{Field, Origin};

/// A distance, what it was found from, and what makes it exact.
pub struct Solved {
    pub sources: Vec<Source>,
    pub distance: Distance,
    origin: Origin,
    /// Absent before the first step and after the last.
    refining: Option<Refining>,
    /// The values before the first step, to be compared with the exact ones.
    instant: Option<VertexData<f64>>,
}

/// What the exact region grows in.
enum Refining {
    Heat(Refinement),
    Windows(PropagationRefinement),
}

impl Solved {
    pub fn new(sources: Vec<Source>, distance: Distance, origin: Origin) -> Self {
        Self { sources, distance, origin, refining: None, instant: None }
    }

    /// As the page gets it.
    pub fn field(&self, drawn: &Drawn, in_walls: usize) -> Field {
        let error = self.instant().map(|instant| RelativeError::between(instant, &self.distance.values));
        Field::of(drawn, &self.distance, self.origin, error, in_walls)
    }

    /// The values before they were made exact; none until all are.
    pub fn instant(&self) -> Option<&VertexData<f64>> {
        self.instant.as_ref().filter(|_| self.is_exact())
    }

    /// Whether all values are.
    pub fn is_exact(&self) -> bool {
        self.distance.exact_below == f64::INFINITY
    }

    /// Makes it exact by about `work` windows further from the sources. After an error it is as it was, and the next step
    /// begins at the sources again.
    pub fn refine(&mut self, geometry: &Arc<ExactGeometry>, heat: Option<&HeatSolver>, work: usize) -> Result<()> {
        if self.is_exact() {
            return Ok(());
        }
        let mut refining = match self.refining.take() {
            Some(refining) => refining,
            None => self.begin(geometry, heat)?,
        };
        let distance = match &mut refining {
            Refining::Heat(refinement) => refinement.step(factored(heat)?.factorization(), work)?,
            Refining::Windows(refinement) => refinement.step(work)?,
        };
        let before = std::mem::replace(&mut self.distance, distance);
        self.instant.get_or_insert(before.values);
        if !self.is_exact() {
            self.refining = Some(refining);
        }
        Ok(())
    }

    fn begin(&self, geometry: &Arc<ExactGeometry>, heat: Option<&HeatSolver>) -> Result<Refining> {
        Ok(match self.origin {
            // Where paths cross portals, heat knows nothing of the components beyond.
            Origin::Heat { .. } if self.distance.crossings.is_empty() => {
                Refining::Heat(factored(heat)?.refine(&self.sources)?)
            }
            Origin::Heat { .. } | Origin::Windows(_) => {
                let lengths = self.distance.clone();
                Refining::Windows(PropagationRefinement::new(geometry, &self.sources, lengths)?)
            }
        })
    }
}

/// The factors, which a field by heat needs.
pub fn factored(heat: Option<&HeatSolver>) -> Result<&HeatSolver> {
    heat.ok_or_else(|| Failure::misuse("nothing is factored"))
}
