//! Questions to a factored surface and their answers.

use crate::error::{Error, Result};
use crate::exact::Wavefront;
use crate::extremum::larger;
use crate::heat::HeatSolver;
use crate::heat::field::divergence;
use crate::heat::near::Near;
use crate::options::MultiSource;
use heatwalk_surface::{Place, Source, Surface, SurfaceId, ToPoint, ToSource, VertexData};

/// Share of its initial distance by which the distance at a source may miss it for rounding.
const ROUNDING: f64 = 1e-9;

/// Distance from a set of sources.
#[derive(Debug, Clone, PartialEq)]
pub struct Distance {
    surface: SurfaceId,
    /// `#P`, in the file's unit, non-negative, never NaN; infinity on pieces without a source. At a source that is a
    /// vertex it is exactly its initial distance; with summed sources, the mean over the sources of a component is 0
    /// before values below 0 become 0.
    pub values: VertexData<f64>,
    /// `#P`, heat after time t, to an arbitrary scale near 10²⁹⁰.
    pub heat: VertexData<f64>,
    /// The sources, validated. Those whose starting value is above the distance from another are left out.
    pub sources: Vec<Place>,
    /// Values below this are exact polyhedral distances; infinity when all are.
    pub exact_below: f64,
}

impl Distance {
    /// The surface that it was solved on.
    pub fn surface(&self) -> SurfaceId {
        self.surface
    }

    /// The distance at a point, in the file's unit, interpolated linearly in its face.
    ///
    /// # Errors
    /// [`Error::Surface`] with `ForeignSurface` for another surface than [`Self::surface`], and as [`Surface::point`].
    pub fn at(&self, surface: &Surface, point: impl ToPoint) -> Result<f64> {
        surface.require_own(self.surface, "distance")?;
        Ok(surface.point(point)?.place().interpolate(surface, &self.values))
    }

    /// The largest finite distance.
    pub fn max(&self) -> f64 {
        self.values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max)
    }

    /// Number of points on pieces without a source.
    pub fn unreachable(&self) -> usize {
        self.values.iter().filter(|value| value.is_infinite()).count()
    }
}

impl HeatSolver {
    /// Distance of every point from the nearest source, or least sum of starting value and distance.
    ///
    /// # Errors
    /// [`Error::NoSource`]; [`Error::BadVertex`], [`Error::BadPoint`] and [`Error::BadParameter`] for a source that is
    /// not on the surface or starts from a bad value; [`Error::NotConverged`] of conjugate gradients;
    /// [`Error::OutOfMemory`].
    pub fn distance<S: ToSource>(&self, sources: &[S]) -> Result<Distance> {
        let sources = self.validated(sources)?;
        let (heat, is_active) = self.heat(&sources)?;
        self.with_near_field(&sources, |near| self.distance_beyond(near, heat, &sources, &is_active))
    }

    /// Begins to make a distance exact, from the sources outward.
    ///
    /// # Errors
    /// As [`HeatSolver::distance`].
    pub fn refine<S: ToSource>(&self, sources: &[S]) -> Result<Refinement> {
        let sources = self.validated(sources)?;
        let (heat, is_active) = self.heat(&sources)?;
        Ok(Refinement { front: self.start_wavefront(sources.clone()), heat, sources, is_active })
    }

    fn validated<S: ToSource>(&self, sources: &[S]) -> Result<Vec<Source>> {
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        let mut valid: Vec<Source> = Vec::with_capacity(sources.len());
        for &source in sources {
            let source = source.to_source(&self.surface)?;
            match valid.iter_mut().find(|other| other.place() == source.place()) {
                Some(other) => *other = other.from_at_most(source.initial_distance()),
                None => valid.push(source),
            }
        }
        Ok(valid)
    }

    /// Distance where some of it is known to be exact. `is_active` tells the sources that heat comes from.
    fn distance_beyond(
        &self,
        near: &Near<'_>,
        heat: Vec<f64>,
        sources: &[Source],
        is_active: &[bool],
    ) -> Result<Distance> {
        let surface = &*self.surface;
        let mut has_source = vec![false; surface.report().components];
        for source in sources {
            has_source[source.place().component(surface) as usize] = true;
        }
        let is_reachable = |point: usize| has_source[surface.components().as_slice()[point] as usize];
        let is_known = |point: usize| near.at(point as u32).is_some() || !is_reachable(point);
        let mut values = if (0..surface.vertex_count()).all(is_known) {
            vec![0.0; surface.vertex_count()]
        } else {
            let mut mixed = Vec::new();
            let active: Vec<Source> =
                sources.iter().zip(is_active).filter(|&(_, &active)| active).map(|(&source, _)| source).collect();
            let divergence = divergence(&self.elements, &heat, near, |face, whole| mixed.push((face, whole)));
            self.poisson(divergence, near, &self.known(near, &mixed, &active))?
        };
        for (value, &component) in values.iter_mut().zip(surface.components()) {
            *value = if has_source[component as usize] { larger(*value, near.radius) } else { f64::INFINITY };
        }
        for (point, exact) in near.points() {
            values[point as usize] = exact;
        }
        let mut values = VertexData::from(values);
        let is_source = |source: &Source, value: f64| value >= source.initial_distance() * (1.0 - ROUNDING);
        if self.parameters().sources == MultiSource::Exact {
            for source in sources {
                if let Some(vertex) = source.place().vertex(surface) {
                    let value = &mut values[vertex];
                    if is_source(source, *value) {
                        *value = source.initial_distance();
                    }
                }
            }
        }
        // A source that another one reaches before its starting value is none.
        let remains = |source: &&Source| is_source(source, source.place().interpolate(surface, &values));
        let sources = sources.iter().filter(remains).map(|source| source.place()).collect();
        Ok(Distance { surface: surface.id(), values, heat: heat.into(), sources, exact_below: near.radius })
    }
}

/// A distance that becomes exact step by step, from the sources outward.
#[derive(Debug)]
pub struct Refinement {
    front: Wavefront,
    heat: Vec<f64>,
    sources: Vec<Source>,
    is_active: Vec<bool>,
}

impl Refinement {
    /// Propagates about `work` windows further and gives the distance with the near field so reached: exact inside,
    /// heat beyond.
    ///
    /// # Errors
    /// As [`HeatSolver::distance`]; [`Error::Surface`] with `ForeignSurface` for a solver of another surface.
    pub fn step(&mut self, solver: &HeatSolver, work: usize) -> Result<Distance> {
        solver.surface().require_own(self.front.surface().id(), "refinement")?;
        self.front.advance(f64::INFINITY, work);
        let near = Near::of(&self.front, self.front.radius());
        solver.distance_beyond(&near, self.heat.clone(), &self.sources, &self.is_active)
    }

    /// Whether every distance is exact.
    pub fn is_done(&self) -> bool {
        self.front.is_done()
    }
}
