//! A factorization together with the options of its queries.

use std::sync::Arc;

use heatwalk_sparse::Progress;
use heatwalk_surface::{Surface, ToSource, VertexId};

use crate::cost::Costs;
use crate::distance::Distance;
use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};
use crate::heat::answer::Refinement;
use crate::heat::factorization::Factorization;
use crate::heat::query::Query;
use crate::options::Parameters;

/// Answers with one set of options: a [`Factorization`] and what its queries have in common.
#[derive(Debug)]
pub struct HeatSolver {
    factorization: Factorization,
    parameters: Parameters,
}

impl HeatSolver {
    /// Factors a surface.
    ///
    /// # Errors
    /// As [`Factorization::new`].
    pub fn new(surface: impl Into<Arc<Surface>>, parameters: Parameters, progress: Progress<'_>) -> Result<Self> {
        Self::weighted(surface, None, parameters, progress)
    }

    /// The same where faces have costs.
    ///
    /// # Errors
    /// As [`Factorization::new`].
    pub fn weighted(
        surface: impl Into<Arc<Surface>>,
        costs: Option<Costs>,
        parameters: Parameters,
        progress: Progress<'_>,
    ) -> Result<Self> {
        parameters.check()?;
        let factorization = Factorization::weighted(surface, costs, parameters.factor_options(), progress)?;
        Ok(Self { factorization, parameters })
    }

    /// Changes parameters; factors only what this touches.
    ///
    /// # Errors
    /// As [`Factorization::set_options`]. After an error the solver still answers, with the old parameters.
    pub fn set_parameters(&mut self, parameters: Parameters, progress: Progress<'_>) -> Result<()> {
        parameters.check()?;
        self.factorization.set_options(parameters.factor_options(), progress)?;
        self.parameters = parameters;
        Ok(())
    }

    /// Distance of every vertex from the nearest source, or the least sum of initial distance and distance.
    ///
    /// # Errors
    /// As [`Factorization::distance`].
    pub fn distance<S: ToSource>(&self, sources: &[S]) -> Result<Distance> {
        self.factorization.distance(&self.query(sources)?)
    }

    /// Begins to make a distance exact, from the sources outward.
    ///
    /// # Errors
    /// As [`Factorization::distance`].
    pub fn refine<S: ToSource>(&self, sources: &[S]) -> Result<Refinement> {
        self.factorization.refine(&self.query(sources)?)
    }

    /// The query that these parameters make of sources.
    ///
    /// # Errors
    /// As [`Query::new`].
    pub fn query<S: ToSource>(&self, sources: &[S]) -> Result<Query> {
        let Parameters { exact_radius, sources: multi_source, .. } = self.parameters;
        Ok(Query { exact_radius, multi_source, ..Query::new(self.surface(), sources)? })
    }

    /// What is factored.
    pub fn factorization(&self) -> &Factorization {
        &self.factorization
    }

    /// The parameters in force.
    pub fn parameters(&self) -> Parameters {
        self.parameters
    }

    /// The surface.
    pub fn surface(&self) -> &Arc<Surface> {
        self.factorization.surface()
    }

    /// What exact distances and paths need of the surface.
    pub fn exact_geometry(&self) -> &Arc<ExactGeometry> {
        self.factorization.exact_geometry()
    }

    /// The wavefront of exact distances from some sources.
    ///
    /// # Errors
    /// As [`Factorization::wavefront`].
    pub fn wavefront<S: ToSource>(&self, sources: &[S]) -> Result<Wavefront> {
        self.factorization.wavefront(sources)
    }

    /// The edges of the triangles that carry the operators, as [`Operators::edges`](crate::operator::Operators::edges).
    pub fn operator_edges(&self, tolerance: f64) -> Vec<([VertexId; 2], f64)> {
        self.factorization.operators().edges(tolerance)
    }

    /// The diffusion time t, in the file's unit squared: m h², or more on long surfaces, where heat would underflow.
    pub fn time(&self) -> f64 {
        self.factorization.time()
    }

    /// m in t = m h², with the t that holds.
    pub fn time_factor(&self) -> f64 {
        self.factorization.time_factor()
    }

    /// Stored entries of all factors that the parameters need, zeros inside supernodes counted; 0 for conjugate gradients.
    pub fn factor_nonzeros(&self) -> usize {
        self.factorization.factor_nonzeros()
    }
}
