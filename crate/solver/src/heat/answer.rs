//! Queries answered by a factorization.

use std::sync::{Arc, PoisonError};

use crate::distance::{Distance, is_nearest_to_itself, places_that_remain};
use crate::error::Result;
use crate::exact::Wavefront;
use crate::extremum::larger;
use crate::heat::constraint::Constraint;
use crate::heat::exact_region::ExactRegion;
use crate::heat::factorization::Factorization;
use crate::heat::field::divergence;
use crate::heat::query::Query;
use crate::heat::source_heat::SourceHeat;
use crate::options::MultiSource;
use crate::propagation::{Propagation, PropagationOptions, REFRACTED};
use crate::refinement;
use heatwalk_surface::{Source, ToSource, VertexData};

/// A query with all that does not change while its exact region grows.
#[derive(Debug)]
struct Question {
    sources: Vec<Source>,
    multi_source: MultiSource,
    heat: Vec<f64>,
    /// Per source whether heat comes from it.
    is_active: Vec<bool>,
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
            let region = ExactRegion::within(query.exact_radius, &mut front, sources, mean_edge)?;
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
            let region = ExactRegion::within(query.exact_radius, &mut front, sources, mean_edge)?;
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
        let constraint =
            |source: &Source| Constraint::new(source.place().support(self.surface()), source.initial_distance());
        let constraints: Vec<Constraint> = sources.iter().map(constraint).collect();
        let SourceHeat { values, is_active } = SourceHeat::new(self.needed_flows(), &constraints, query.multi_source)?;
        Ok(Question { sources, multi_source: query.multi_source, heat: values, is_active })
    }

    /// The right side of the Poisson equation without an exact region.
    pub(super) fn divergence(&self, query: &Query) -> Result<Vec<f64>> {
        let heat = VertexData::from(self.question(query)?.heat);
        Ok(divergence(&self.operators().elements, heat.as_slice(), &ExactRegion::none(&heat)).0)
    }

    /// Distance where that of a region is exact.
    fn answer(&self, question: &Question, region: &ExactRegion<'_>) -> Result<Distance> {
        let surface = &**self.surface();
        let Question { sources, multi_source, heat, is_active } = question;
        let mut has_source = vec![false; surface.report().components];
        for source in sources {
            has_source[source.place().component(surface) as usize] = true;
        }
        let components = surface.components().as_slice();
        let is_exact =
            |vertex: usize| region.value(vertex as u32).is_some() || !has_source[components[vertex] as usize];
        let logarithm = self.logarithm().filter(|_| *multi_source == MultiSource::Exact);
        let is_exact_everywhere = (0..surface.vertex_count()).all(is_exact);
        let mut values = if is_exact_everywhere {
            vec![0.0; surface.vertex_count()]
        } else {
            let active: Vec<Source> =
                sources.iter().zip(is_active).filter(|&(_, &active)| active).map(|(&source, _)| source).collect();
            match logarithm {
                Some(logarithm) => {
                    let known = region.known(surface, self.exact_geometry().costs(), &active);
                    logarithm.distances(self.operators(), heat, self.time(), known)
                }
                None => {
                    let (divergence, touched) = divergence(&self.operators().elements, heat, region);
                    let constraints = region.constraints(surface, &touched, &active);
                    match multi_source {
                        MultiSource::Exact => {
                            self.poisson()?.solve_beyond(&divergence, &constraints, region.values())?
                        }
                        MultiSource::Summed => self.poisson()?.solve_in_mean(&divergence, &constraints)?,
                    }
                }
            }
        };
        for (value, &component) in values.iter_mut().zip(surface.components()) {
            *value = if has_source[component as usize] { larger(*value, region.radius) } else { f64::INFINITY };
        }
        region.write(&mut values);
        if let Some(logarithm) = logarithm.filter(|_| !is_exact_everywhere) {
            logarithm.bounds().keep(surface, sources, &mut values);
            // These keep them but for rounding.
            region.write(&mut values);
        }
        let mut values = VertexData::from(values);
        if *multi_source == MultiSource::Exact {
            for source in sources {
                if let Some(vertex) = source.place().vertex(surface) {
                    let value = &mut values[vertex];
                    if is_nearest_to_itself(source, *value) {
                        *value = source.initial_distance();
                    }
                }
            }
        }
        let sources = places_that_remain(surface, sources, &values);
        Ok(Distance {
            surface: surface.id(),
            costs: self.exact_geometry().costs().cloned(),
            values,
            heat: Some(heat.clone().into()),
            sources,
            exact_below: region.radius,
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
        factorization.answer(&self.question, &ExactRegion::of(&self.front, self.front.radius()))
    }

    /// Whether every distance is exact.
    pub fn is_done(&self) -> bool {
        self.front.is_done()
    }
}
