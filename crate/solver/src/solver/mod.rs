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
use crate::error::{Error, Result};
use crate::exact::ExactGeometry;
use crate::heat::HeatSolver;
use crate::options::{Method, Parameters};
use crate::progress::{Step, Steps};
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
        let sources = self.checked(sources)?;
        let Some(propagation) = options.propagation(self.surface.face_count()) else {
            let carried = self.carried(&sources)?;
            return by_heat(self.factored(options.heat, progress)?, &carried);
        };
        let geometry = Arc::clone(self.exact_geometry());
        self.searches(1)[0].answer(&geometry, &sources, (options, propagation), progress)
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
        let sources = self.checked(sources)?;
        let (count, threads) = (sources.len(), threads.get().min(sources.len()));
        let Some(propagation) = options.propagation(self.surface.face_count()) else {
            let carried = sources.iter().map(|&source| self.carried(&[source])).collect::<Result<Vec<_>>>()?;
            let mut solvers = vec![self.factored(options.heat, progress)?; threads];
            let answer = |solver: &mut &HeatSolver, question: usize| by_heat(solver, &carried[question]);
            return questions::answers(&mut solvers, count, answer, progress);
        };
        let geometry = Arc::clone(self.exact_geometry());
        let answer = |search: &mut Search, question: usize| {
            let go_on = &mut |_| ControlFlow::Continue(());
            search.answer(&geometry, &[sources[question]], (options, propagation), go_on)
        };
        questions::answers(self.searches(threads), count, answer, progress)
    }

    /// The surface.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// What exact distances and paths need of the surface, made here unless it was before.
    pub fn exact_geometry(&mut self) -> &Arc<ExactGeometry> {
        let Self { surface, heat, bridges, threads, .. } = self;
        self.geometry.get_or_insert_with(|| match heat {
            Some(heat) if bridges.portals().is_empty() => Arc::clone(heat.exact_geometry()),
            _ => Arc::new(ExactGeometry::on_threads(Arc::clone(surface), *threads).bridged(bridges)),
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
        sources.iter().map(|source| Ok(source.to_source(&self.surface)?)).collect()
    }

    /// The solver of heat with these parameters. Factors what is absent.
    fn factored(&mut self, parameters: Parameters, progress: Steps<'_>) -> Result<&HeatSolver> {
        let progress = &mut |stage, done| progress(Step::Precompute(stage, done));
        let Some(mut solver) = self.heat.take() else {
            return Ok(self.heat.insert(HeatSolver::new(Arc::clone(&self.surface), parameters, progress)?));
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
