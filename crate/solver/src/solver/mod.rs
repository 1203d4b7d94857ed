//! One object that answers by any method.
//!
//! It owns the surface, with its bridges, walls and costs, makes what a method needs when it is first asked for (the factors of
//! [heat](crate::heat), the unfolded triangles and the memory of a [search in windows](crate::propagation)) and keeps it for the
//! next question.

mod answer;
mod ground;
mod joined;
mod options;
mod pairs;
mod parcels;
mod paths;
mod questions;
mod rows;
mod search;
mod solution;

use std::num::NonZeroUsize;
use std::sync::Arc;

pub use answer::Answer;
pub use joined::Joined;
pub use options::DistanceOptions;
pub use parcels::ParcelDistance;
pub use rows::row_source;
pub use solution::Solution;

use crate::bridged::CarriedSources;
use crate::cost::Costs;
use crate::distance::one_a_place;
use crate::error::{Error, Result};
use crate::exact::ExactGeometry;
use crate::heat::HeatSolver;
use crate::options::{Method, Parameters};
use crate::propagation::PropagationOptions;
use heatwalk_base::parallel;
use heatwalk_sparse::Progress;
use heatwalk_surface::{Source, Surface, ToSource, memory};
use search::Search;

/// Bytes that exact distances and windows need of the surface, a face.
const BYTES_PER_FACE: u64 = 128;

/// Distances and paths on a surface by any [`Method`].
#[derive(Debug)]
pub struct DistanceSolver {
    /// Without walls.
    whole: Arc<Surface>,
    /// The same as walls part it.
    parted: Arc<Surface>,
    /// That in the pose in which distances are measured.
    surface: Arc<Surface>,
    /// Those that make the geometry and find bridges.
    threads: NonZeroUsize,
    /// What paths cross from one component of the whole surface to another.
    joined: Joined,
    /// As they were set.
    given_costs: Option<Costs>,
    /// What a unit of length costs beside the walls, where that is not 1 everywhere.
    costs: Option<Costs>,
    /// Without costs, which change more often than all else.
    plain: Option<Arc<ExactGeometry>>,
    geometry: Option<Arc<ExactGeometry>>,
    /// Of this surface and its costs, or of others before.
    heat: Option<HeatSolver>,
    /// One for each thread that has answered.
    searches: Vec<Search>,
}

impl DistanceSolver {
    /// Of a surface. Nothing is computed yet.
    pub fn new(surface: impl Into<Arc<Surface>>) -> Self {
        Self::on_threads(surface, parallel::ONE)
    }

    /// The same, to unfold triangles and to find bridges on so many threads. It makes no difference to the answers how many.
    pub fn on_threads(surface: impl Into<Arc<Surface>>, threads: NonZeroUsize) -> Self {
        let surface = surface.into();
        Self {
            whole: Arc::clone(&surface),
            parted: Arc::clone(&surface),
            surface,
            threads,
            joined: Joined::default(),
            given_costs: None,
            costs: None,
            plain: None,
            geometry: None,
            heat: None,
            searches: Vec::new(),
        }
    }

    /// Makes what a method needs before its first question: factors for [`Method::Heat`], the unfolded triangles for the
    /// others. The questions do so by themselves.
    ///
    /// # Errors
    /// [`Error::BadParameter`]; as [`HeatSolver::new`] for [`Method::Heat`], [`Error::OutOfMemory`] for the others. Then what was
    /// there before still answers.
    pub fn prepare(&mut self, options: &DistanceOptions, progress: Progress<'_>) -> Result<()> {
        options.check()?;
        if options.method == Method::Heat {
            self.factored(options.heat, progress)?;
        } else if self.geometry.is_none() && self.plain.is_none() {
            memory::require(BYTES_PER_FACE * self.surface.face_count() as u64, "unfolding the triangles")?;
            self.asked();
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
        progress: Progress<'_>,
    ) -> Result<Answer> {
        let sources = one_a_place(&self.surface, self.checked(sources)?);
        self.prepare(options, progress)?;
        let (geometry, cost) = self.asked();
        let (options, scaled) = (&options.per(cost), self.per(cost, &sources)?);
        let answer = match self.propagation(options)? {
            Some(propagation) => self.searches(1)[0].answer(&geometry, &scaled, (options, propagation), progress),
            None => by_heat(self.factored(options.heat, progress)?, &geometry, &scaled),
        };
        Ok(Answer { sources, ..answer?.times(cost) })
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
        progress: Progress<'_>,
    ) -> Result<Vec<Answer>> {
        self.map_from_each(sources, options, threads, |_, answer| answer, progress)
    }

    /// The same, of each of which no more is kept than what `map` makes of it; it is told the number of the source. Threads
    /// call it as they have answers.
    ///
    /// # Errors
    /// As [`Self::distance`], and then for all.
    ///
    /// # Panics
    /// As [`Self::distances_from_each`].
    pub fn map_from_each<S: ToSource, T: Send>(
        &mut self,
        sources: &[S],
        options: &DistanceOptions,
        threads: NonZeroUsize,
        map: impl Fn(usize, Answer) -> T + Sync,
        progress: Progress<'_>,
    ) -> Result<Vec<T>> {
        let sources = self.checked(sources)?;
        self.prepare(options, progress)?;
        let (count, threads) = (sources.len(), threads.get().min(sources.len()));
        let (geometry, cost) = self.asked();
        let (options, scaled) = (&options.per(cost), self.per(cost, &sources)?);
        let mapped = |number: usize, answer: Result<Answer>| {
            Ok(map(number, Answer { sources: vec![sources[number]], ..answer?.times(cost) }))
        };
        if let Some(propagation) = self.propagation(options)? {
            let answer = |search: &mut Search, number: usize, within: Progress<'_>| {
                mapped(number, search.answer(&geometry, &scaled[number..][..1], (options, propagation), within))
            };
            questions::answers(self.searches(threads), count, answer, progress)
        } else {
            let heat = self.factored(options.heat, progress)?;
            let answer = |heat: &mut &HeatSolver, number: usize, _: Progress<'_>| {
                mapped(number, by_heat(heat, &geometry, &scaled[number..][..1]))
            };
            questions::answers(&mut vec![heat; threads], count, answer, progress)
        }
    }

    /// The surface that is asked: as walls part it, in the pose in which distances are measured.
    pub fn surface(&self) -> &Arc<Surface> {
        &self.surface
    }

    /// What exact distances and paths need of the surface, made here unless it was before.
    pub fn exact_geometry(&mut self) -> &Arc<ExactGeometry> {
        let geometry = match self.geometry.take() {
            Some(geometry) => geometry,
            None => self.laid_out(),
        };
        self.geometry.insert(geometry)
    }

    /// The solver of [`Method::Heat`], with the parameters of its last question; `None` before the first.
    pub fn heat(&self) -> Option<&HeatSolver> {
        self.heat.as_ref()
    }

    /// The distance of each vertex of the input, in its order, in the file's unit; infinite where nothing is reached, and for vertices that no
    /// triangle uses.
    pub fn of_inputs(&self, answer: &Answer) -> Vec<f64> {
        self.surface.to_inputs(&answer.distance.values, f64::INFINITY)
    }

    fn checked<S: ToSource>(&self, sources: &[S]) -> Result<Vec<Source>> {
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        sources.iter().map(|source| Ok(source.to_source(&self.surface)?)).collect()
    }

    /// The geometry that distances are computed on, and what they are multiplied by: a cost that all faces have, without which they
    /// are computed, so that its rounding does not choose between equally good windows.
    fn asked(&mut self) -> (Arc<ExactGeometry>, f64) {
        match self.constant_cost() {
            Some(cost) => (Arc::clone(self.unfolded()), cost),
            None => (Arc::clone(self.exact_geometry()), 1.0),
        }
    }

    /// The cost of all faces, where they have one.
    fn constant_cost(&self) -> Option<f64> {
        self.costs.as_ref().and_then(Costs::constant)
    }

    /// Sources where all lengths are so many times as small.
    fn per(&self, factor: f64, sources: &[Source]) -> Result<Vec<Source>> {
        let scaled = |source: &Source| Ok(self.surface.source(source.point(), source.initial_distance() / factor)?);
        sources.iter().map(scaled).collect()
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

    /// Whether factors are for the surface with its present costs.
    fn is_present(&self, heat: &HeatSolver) -> bool {
        let is_same_cost = match (heat.factorization().costs(), self.several_costs()) {
            (Some(own), Some(costs)) => own.is_same(costs),
            (own, costs) => own.is_none() && costs.is_none(),
        };
        is_same_cost && heat.surface().id() == self.surface.id()
    }

    /// The solver of heat with these parameters. Factors what is absent.
    fn factored(&mut self, parameters: Parameters, progress: Progress<'_>) -> Result<&HeatSolver> {
        // Old factors go before new ones are made.
        let Some(mut solver) = self.heat.take().filter(|heat| self.is_present(heat)) else {
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

/// Bridges carry the sources first. Without any, those are the ones given.
fn by_heat(heat: &HeatSolver, geometry: &Arc<ExactGeometry>, sources: &[Source]) -> Result<Answer> {
    let carried = CarriedSources::new(geometry, sources)?;
    let distance = carried.distance(heat.distance(carried.sources())?);
    Ok(Answer { sources: sources.to_vec(), distance, method: Method::Heat, windows: 0 })
}
