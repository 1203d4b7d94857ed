//! Queries answered by a factorization.

use std::sync::{Arc, PoisonError};

use heatwalk_surface::{Source, ToSource, VertexData};

use crate::distance::{Distance, places_that_remain};
use crate::error::Result;
use crate::exact::Wavefront;
use crate::heat::discretization::HeatDiscretization;
use crate::heat::factorization::Factorization;
use crate::heat::point_source::PointSource;
use crate::heat::query::Query;
use crate::heat::region::ExactRegion;
use crate::heat::source_heat::SourceHeat;
use crate::heat::triangles::region::{region_of, region_within};
use crate::options::MultiSource;
use crate::propagation::{Propagation, PropagationOptions, REFRACTED};
use crate::refinement;

/// A query with all that does not change while its exact region grows.
#[derive(Debug)]
struct Question {
    sources: Vec<Source>,
    multi_source: MultiSource,
    /// The sources as the heat method takes them, and their heat.
    points: Vec<PointSource>,
    heat: SourceHeat,
}

impl Factorization {
    /// Distance of every vertex from the nearest source, or the least sum of initial distance and distance.
    ///
    /// # Errors
    /// [`Error::NoSource`](crate::Error::NoSource); [`Error::Surface`](crate::Error::Surface) for a source that is not on
    /// the surface or has a bad initial distance; [`Error::BadParameter`](crate::Error::BadParameter) for the exact
    /// radius; [`Error::NotConverged`](crate::Error::NotConverged) of conjugate gradients;
    /// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn distance(&self, query: &Query) -> Result<Distance> {
        let question = self.question(query)?;
        let sources = &question.sources;
        let mean_edge = self.operators().mean_edge();
        if self.exact_geometry().costs().is_some() {
            let options = PropagationOptions { windows: REFRACTED, ..PropagationOptions::default() };
            let mut front = Propagation::new(Arc::clone(self.exact_geometry()), sources, options)?;
            let region = region_within(query.exact_radius, &mut front, &question.points, mean_edge)?;
            return Ok(Distance { exact_below: 0.0, ..self.answer(&question, &region)? });
        }
        // A panic while the front is out leaves none, so what a lock holds is right even after one.
        let kept = self.front.lock().unwrap_or_else(PoisonError::into_inner).take();
        let mut front = match kept {
            Some(mut front) => {
                front.restart_checked(sources.clone());
                front
            }
            None => Wavefront::of_checked(Arc::clone(self.exact_geometry()), sources.clone(), &[])?,
        };
        let answer = {
            let region = region_within(query.exact_radius, &mut front, &question.points, mean_edge)?;
            self.answer(&question, &region)
        };
        *self.front.lock().unwrap_or_else(PoisonError::into_inner) = Some(front);
        answer
    }

    /// Begins to make a distance exact, from the sources outward. The query's exact radius does not matter.
    ///
    /// # Errors
    /// As [`Factorization::distance`].
    pub fn refine(&self, query: &Query) -> Result<Refinement> {
        let question = self.question(query)?;
        Ok(Refinement { front: refinement::start(self.exact_geometry(), &question.sources)?, question })
    }

    /// The wavefront of exact distances from some sources.
    ///
    /// # Errors
    /// As [`Surface::source`](heatwalk_surface::Surface::source); [`Error::OutOfMemory`](crate::Error::OutOfMemory).
    pub fn wavefront<S: ToSource>(&self, sources: &[S]) -> Result<Wavefront> {
        Wavefront::new(Arc::clone(self.exact_geometry()), sources)
    }

    fn question(&self, query: &Query) -> Result<Question> {
        let sources = query.checked(self.surface())?;
        let points: Vec<PointSource> =
            sources.iter().map(|source| self.method.discretization().source(source)).collect();
        let heat = self.method.heat(&points, query.multi_source)?;
        Ok(Question { sources, multi_source: query.multi_source, points, heat })
    }

    /// The right side of the Poisson equation without an exact region.
    pub(super) fn divergence(&self, query: &Query) -> Result<Vec<f64>> {
        let heat = self.question(query)?.heat.values;
        Ok(self.method.discretization().unit_field(&heat, &ExactRegion::none(&heat)).divergence)
    }

    /// Distance where that of a region is exact.
    fn answer(&self, question: &Question, region: &ExactRegion<'_>) -> Result<Distance> {
        let Question { sources, multi_source, points, heat } = question;
        let values = VertexData::from(self.method.distances(points, *multi_source, heat, region)?);
        let surface = &**self.surface();
        let sources = places_that_remain(surface, sources, &values);
        Ok(Distance {
            surface: surface.id(),
            costs: self.exact_geometry().costs().cloned(),
            values,
            heat: Some(heat.values.clone().into()),
            sources,
            exact_below: region.radius(),
            crossings: Vec::new(),
        })
    }
}

/// A distance that becomes exact step by step, from the sources outward.
#[derive(Debug)]
pub struct Refinement {
    front: Wavefront,
    question: Question,
}

impl Refinement {
    /// Propagates about `work` windows further and gives the distance with the exact region so reached: exact inside,
    /// heat beyond.
    ///
    /// # Errors
    /// As [`Factorization::distance`]; [`Error::Surface`](crate::Error::Surface) with `ForeignSurface` for a factorization
    /// of another surface; [`Error::OutOfMemory`](crate::Error::OutOfMemory) for the windows.
    pub fn step(&mut self, factorization: &Factorization, work: usize) -> Result<Distance> {
        factorization.surface().require_own(self.front.surface().id(), "refinement")?;
        refinement::advance(&mut self.front, work)?;
        factorization.answer(&self.question, &region_of(&self.front, self.front.radius()))
    }

    /// Whether every distance is exact.
    pub fn is_done(&self) -> bool {
        self.front.is_done()
    }
}
