//! One object that answers by any method.
//!
//! It owns the surface, makes what a method needs when it is first asked for (the factors of [heat](crate::heat), the
//! unfolded triangles and the memory of a [search in windows](crate::propagation)) and keeps it for the next question.

mod answer;
mod options;
mod questions;
mod search;

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::Arc;

pub use answer::Answer;
pub use options::DistanceOptions;

use crate::bridged::CarriedSources;
use crate::cost::Costs;
use crate::distance::one_a_place;
use crate::error::{Error, Result};
use crate::exact::ExactGeometry;
use crate::heat::HeatSolver;
use crate::options::{Method, Parameters};
use crate::progress::{Step, Steps};
use crate::propagation::PropagationOptions;
use heatwalk_surface::{Bridges, Source, Surface, ToSource, parallel};
use search::Search;

/// Distances on a surface by any [`Method`].
#[derive(Debug)]
pub struct DistanceSolver {
    surface: Arc<Surface>,
    /// Those that make the geometry.
    threads: NonZeroUsize,
    /// What paths cross from one component to another.
    bridges: Bridges,
    /// What a unit of length costs, where that is not 1 everywhere.
    costs: Option<Costs>,
    geometry: Option<Arc<ExactGeometry>>,
    heat: Option<HeatSolver>,
    /// One for each thread that has answered.
    searches: Vec<Search>,
}

impl DistanceSolver {
    /// Of a surface. Nothing is computed yet.
    pub fn new(surface: impl Into<Arc<Surface>>) -> Self {
        Self::on_threads(surface, parallel::ONE)
    }

    /// The same, to unfold triangles on so many threads. It makes no difference to the answers how many.
    pub fn on_threads(surface: impl Into<Arc<Surface>>, threads: NonZeroUsize) -> Self {
        Self {
            surface: surface.into(),
            threads,
            bridges: Bridges::default(),
            costs: None,
            geometry: None,
            heat: None,
            searches: Vec::new(),
        }
    }

    /// The same with distances and paths that cross these bridges of the surface.
    #[must_use]
    pub fn bridged(self, bridges: Bridges) -> Self {
        Self { bridges, geometry: None, ..self }
    }

    /// The same where faces have costs: distances are the least costs of paths. Where faces have different ones,
    /// [`Method::Auto`] and [`Method::Propagation`] refract windows, and there are no exact distances.
    ///
    /// # Panics
    /// Where there is not one cost a face.
    #[must_use]
    pub fn weighted(mut self, costs: Costs) -> Self {
        self.set_costs(Some(costs));
        self
    }

    /// Changes what faces cost, `None` for 1 everywhere. What is factored has to be factored again.
    ///
    /// # Panics
    /// Where there is not one cost a face.
    pub fn set_costs(&mut self, costs: Option<Costs>) {
        if let Some(costs) = &costs {
            assert_eq!(costs.of_faces().len(), self.surface.face_count(), "one cost a face");
        }
        (self.costs, self.geometry, self.heat) = (costs, None, None);
    }

    /// What a unit of length costs, where that is not 1 everywhere.
    pub fn costs(&self) -> Option<&Costs> {
        self.costs.as_ref()
    }

    /// Makes what a method needs before its first question: factors for [`Method::Heat`], the unfolded triangles for the
    /// others. The questions do so by themselves.
    ///
    /// # Errors
    /// [`Error::BadParameter`]; as [`HeatSolver::new`] for [`Method::Heat`]. Then what was there before still answers.
    pub fn prepare(&mut self, options: &DistanceOptions, progress: Steps<'_>) -> Result<()> {
        options.check()?;
        if options.method == Method::Heat {
            self.factored(options.heat, progress)?;
        } else {
            self.exact_geometry();
        }
        Ok(())
    }

    /// Distance of every vertex from the nearest source, or the least sum of initial distance and distance.
    ///
    /// # Errors
    /// [`Error::NoSource`]; those of [`ToSource::to_source`]; as [`Self::prepare`]; for [`Method::Heat`] as
    /// [`HeatSolver::distance`], for the others [`Error::OutOfMemory`]; [`Error::Cancelled`].
    pub fn distance<S: ToSource>(
        &mut self,
        sources: &[S],
        options: &DistanceOptions,
        progress: Steps<'_>,
    ) -> Result<Answer> {
        options.check()?;
        let (sources, cost) = (self.checked(sources)?, self.constant_cost());
        let Some(propagation) = self.propagation(options)? else {
            let carried = self.carried(&sources)?;
            return Ok(by_heat(self.factored(options.heat, progress)?, &carried)?.times(cost));
        };
        let (geometry, sources) = (Arc::clone(self.exact_geometry()), one_a_place(&self.surface, sources));
        let options = options.per(cost);
        Ok(self.searches(1)[0].answer(&geometry, &sources, (&options, propagation), progress)?.times(cost))
    }

    /// The distances from each source by itself, in the order of the sources, on so many threads. They are those that
    /// [`Self::distance`] gives, to the last bit.
    ///
    /// # Errors
    /// As [`Self::distance`], and then for all.
    ///
    /// # Panics
    /// Where there are no threads, as on wasm32, and more than one is asked for.
    pub fn distances_from_each<S: ToSource>(
        &mut self,
        sources: &[S],
        options: &DistanceOptions,
        threads: NonZeroUsize,
        progress: Steps<'_>,
    ) -> Result<Vec<Answer>> {
        options.check()?;
        let (sources, cost) = (self.checked(sources)?, self.constant_cost());
        let (count, threads) = (sources.len(), threads.get().min(sources.len()));
        let Some(propagation) = self.propagation(options)? else {
            let carried = sources.iter().map(|&source| self.carried(&[source])).collect::<Result<Vec<_>>>()?;
            let mut solvers = vec![self.factored(options.heat, progress)?; threads];
            let answer =
                |solver: &mut &HeatSolver, question: usize| Ok(by_heat(solver, &carried[question])?.times(cost));
            return questions::answers(&mut solvers, count, answer, progress);
        };
        let geometry = Arc::clone(self.exact_geometry());
        let options = options.per(cost);
        let answer = |search: &mut Search, question: usize| {
            let go_on = &mut |_| ControlFlow::Continue(());
            Ok(search.answer(&geometry, &[sources[question]], (&options, propagation), go_on)?.times(cost))
        };
        questions::answers(self.searches(threads), count, answer, progress)
    }

    /// The surface.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// What exact distances and paths need of the surface, made here unless it was before. It does not know of a cost that all
    /// faces have.
    pub fn exact_geometry(&mut self) -> &Arc<ExactGeometry> {
        let costs = self.several_costs().cloned();
        let Self { surface, heat, bridges, threads, .. } = self;
        self.geometry.get_or_insert_with(|| match heat {
            Some(heat) if bridges.portals().is_empty() => Arc::clone(heat.exact_geometry()),
            _ => {
                let geometry = ExactGeometry::on_threads(Arc::clone(surface), *threads).bridged(bridges);
                Arc::new(match costs {
                    Some(costs) => geometry.weighted(&costs),
                    None => geometry,
                })
            }
        })
    }

    /// The sources that heat flows from. Without bridges they are those given.
    fn carried(&mut self, sources: &[Source]) -> Result<CarriedSources> {
        let geometry = Arc::clone(self.exact_geometry());
        CarriedSources::new(&geometry, sources)
    }

    /// The solver of [`Method::Heat`], with the parameters of its last question; `None` before the first.
    pub fn heat(&self) -> Option<&HeatSolver> {
        self.heat.as_ref()
    }

    fn checked<S: ToSource>(&self, sources: &[S]) -> Result<Vec<Source>> {
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        let cost = self.constant_cost();
        let checked = |source: &S| {
            let source = source.to_source(&self.surface)?;
            Ok(self.surface.source(source.point(), source.initial_distance() / cost)?)
        };
        sources.iter().map(checked).collect()
    }

    /// The cost of all faces, where they have one. All is computed as if it were 1, and then multiplied.
    fn constant_cost(&self) -> f64 {
        self.costs.as_ref().and_then(Costs::constant).unwrap_or(1.0)
    }

    /// The costs, where they are not the same everywhere.
    fn several_costs(&self) -> Option<&Costs> {
        self.costs.as_ref().filter(|costs| costs.constant().is_none())
    }

    /// How windows are propagated; `None` for heat.
    fn propagation(&self, options: &DistanceOptions) -> Result<Option<PropagationOptions>> {
        match self.several_costs() {
            None => Ok(options.propagation(self.surface.face_count())),
            Some(_) => options.refraction(),
        }
    }

    /// The solver of heat with these parameters. Factors what is absent.
    fn factored(&mut self, parameters: Parameters, progress: Steps<'_>) -> Result<&HeatSolver> {
        let progress = &mut |stage, done| progress(Step::Precompute(stage, done));
        let Some(mut solver) = self.heat.take() else {
            let solver =
                HeatSolver::weighted(Arc::clone(&self.surface), self.several_costs().cloned(), parameters, progress)?;
            return Ok(self.heat.insert(solver));
        };
        let changed = solver.set_parameters(parameters, progress);
        let solver = self.heat.insert(solver);
        changed.map(|()| &*solver)
    }

    /// So many searches, those of before first.
    fn searches(&mut self, count: usize) -> &mut [Search] {
        if self.searches.len() < count {
            self.searches.resize_with(count, Search::default);
        }
        &mut self.searches[..count]
    }
}

fn by_heat(solver: &HeatSolver, carried: &CarriedSources) -> Result<Answer> {
    let distance = carried.distance(solver.distance(carried.sources())?);
    Ok(Answer { distance, method: Method::Heat, windows: 0 })
}
