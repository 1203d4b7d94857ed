//! Distance by a few windows of each half-edge: nothing is factored, memory grows with the mesh alone, and every value is the
//! length of a path, so never below the exact one.
//!
//! Around the sources the [exact search](crate::exact) goes first, where windows are few and errors would show most. Beyond,
//! each half-edge keeps for each of its stretches the one window that reaches the stretch's middle soonest, bent at its end
//! where it does not see so far. Windows cross faces as in the exact search, in buckets of their distance; what the test of
//! Xin & Wang ("Improving Chen and Han's algorithm on the discrete geodesic problem", 2009) cuts is cut here too. Where
//! windows that were not kept leave holes, vertices fill them: each sends windows anew, as if paths could bend there. One
//! window an edge with all vertices as pseudo-sources is near to the virtual source propagation of Trettner, Bommes, Kobbelt
//! ("Geodesic distance computation via virtual source propagation", 2021), which keeps one source a face and may fall below
//! the exact distance.
//!
//! Of many sources on one edge of many faces, some go for all.
//!
//! [`Carriers::Vertices`] goes on by fast marching instead, which keeps no windows. Beyond the exact search its values are not lengths
//! of paths, may be below the exact distance, and may still fall a little below a radius that was reached.

mod crowded;
mod ends;
mod front;
mod grow;
mod labels;
mod march;
mod medium;
mod options;
mod queue;

use std::sync::Arc;

pub use options::{ALL, Carriers, ExactSearch, PropagationOptions, REFRACTED, Windows};

use crate::distance::{Distance, PortalCrossing};
use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, Wavefront, checked_sources};
use ends::NOWHERE;
use front::Front;
use grow::Grow;
use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::{Source, Surface, ToSource, VertexData, VertexId};
use labels::Fixed;
use march::March;
use medium::Uniform;

/// Windows that the exact search may propagate, unless told otherwise, and, before windows, one more for so many faces.
const EXACT_WINDOWS: usize = 5_000;
const FACES_PER_EXACT_WINDOW: usize = 8;

/// Windows of each half-edge, at least, where many triangles are thin: errors are a tenth of those of one, or less.
const LEAST_WHERE_THIN: usize = 2;

/// Distances that grow outward from their sources; stopped and continued at will, with the same result.
#[derive(Debug)]
pub struct Propagation {
    options: PropagationOptions,
    geometry: Arc<ExactGeometry>,
    sources: Vec<Source>,
    /// The numbers of those that go for all; none where each does.
    going: Option<Vec<u32>>,
    /// Goes first.
    exact: Wavefront,
    /// Windows that it may propagate.
    exact_windows: usize,
    /// Goes on from there. `None` where the search stays exact.
    front: Option<Box<dyn Grow>>,
    is_beyond: bool,
}

impl Propagation {
    /// Starts at sources on the geometry's surface. Where its faces have different costs, no exact search goes first, and
    /// windows that cross an edge between two costs are refracted.
    ///
    /// # Errors
    /// [`Error::NoSource`]; those of [`ToSource::to_source`]; [`Error::OutOfMemory`]; [`Error::NotExact`] for
    /// [`Windows::All`] where faces have different costs.
    pub fn new<S: ToSource>(geometry: Arc<ExactGeometry>, sources: &[S], options: PropagationOptions) -> Result<Self> {
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        let sources = checked_sources(geometry.surface(), sources)?;
        let faces = geometry.surface().face_count();
        let going = Self::going(&geometry, &sources, options);
        let exact = Wavefront::of_checked(Arc::clone(&geometry), of_numbers(&sources, going.as_deref()), &[])?;
        let front = match options.windows {
            Windows::All if geometry.costs().is_some() => return Err(Error::NotExact),
            Windows::All => None,
            Windows::AtMost(count) => {
                let least = if geometry.is_thin() { LEAST_WHERE_THIN } else { 1 };
                Some(front(Arc::clone(&geometry), options.carriers, usize::from(count.get()).max(least))?)
            }
        };
        let exact_windows = match (options.exact, options.carriers) {
            (ExactSearch::Automatic, Carriers::Windows) => EXACT_WINDOWS + faces / FACES_PER_EXACT_WINDOW,
            (ExactSearch::Automatic, Carriers::Vertices) => EXACT_WINDOWS,
            (ExactSearch::AtMost(windows), _) => windows,
        };
        let mut propagation = Self { options, geometry, sources, going, exact, exact_windows, front, is_beyond: false };
        propagation.begin()?;
        Ok(propagation)
    }

    fn going(geometry: &ExactGeometry, sources: &[Source], options: PropagationOptions) -> Option<Vec<u32>> {
        if options.windows == Windows::All { None } else { crowded::going(geometry, sources) }
    }

    /// Lets the front begin at the sources where no exact search may go first.
    fn begin(&mut self) -> Result<()> {
        self.is_beyond = self.geometry.costs().is_some();
        if let Some(front) = self.front.as_mut().filter(|_| self.is_beyond) {
            front.start_at(self.exact.sources())?;
        }
        Ok(())
    }

    /// Starts at sources, in the memory of an earlier one where that has the same geometry and options.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn reusing<S: ToSource>(
        earlier: Option<Self>,
        geometry: &Arc<ExactGeometry>,
        sources: &[S],
        options: PropagationOptions,
    ) -> Result<Self> {
        let is_alike = |earlier: &Self| earlier.options == options && Arc::ptr_eq(&earlier.geometry, geometry);
        match earlier.filter(is_alike) {
            Some(mut propagation) => {
                propagation.restart(sources)?;
                Ok(propagation)
            }
            None => Self::new(Arc::clone(geometry), sources, options),
        }
    }

    /// Starts anew at other sources, in the memory held.
    ///
    /// # Errors
    /// [`Error::NoSource`]; those of [`ToSource::to_source`]. Then nothing has changed. [`Error::OutOfMemory`].
    pub fn restart<S: ToSource>(&mut self, sources: &[S]) -> Result<()> {
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        let sources = checked_sources(self.geometry.surface(), sources)?;
        self.going = Self::going(&self.geometry, &sources, self.options);
        self.exact.restart_checked(of_numbers(&sources, self.going.as_deref()));
        self.sources = sources;
        self.begin()
    }

    /// Grows until every value below `radius` is final, or about `work` windows have crossed a face. Returns whether the
    /// radius was reached.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`]; then values are still lengths of paths, but it may not grow until it is
    /// [restarted](Self::restart), and none is final before.
    pub fn advance(&mut self, radius: f64, work: usize) -> Result<bool> {
        let Some(front) = &mut self.front else { return self.exact.advance(radius, work) };
        let mut left = work;
        if !self.is_beyond {
            let before = self.exact.windows();
            let allowed = self.exact_windows.saturating_sub(before);
            self.exact.advance(radius, left.min(allowed))?;
            left -= left.min(self.exact.windows() - before);
            if self.exact.windows() < self.exact_windows || self.exact.is_done() {
                return Ok(self.exact.radius() >= radius);
            }
            front.start(&self.exact)?;
            self.is_beyond = true;
        }
        front.advance(radius, left)?;
        Ok(front.radius() >= radius)
    }

    /// The exact search that went first.
    pub(crate) fn exact(&self) -> &Wavefront {
        &self.exact
    }

    /// The front that has come farthest, unless that is the exact search.
    fn beyond(&self) -> Option<&dyn Grow> {
        self.front.as_deref().filter(|_| self.is_beyond)
    }

    /// The surface that it grows on.
    pub fn surface(&self) -> &Arc<Surface> {
        self.exact.surface()
    }

    /// Every value below this is final; infinity when all is done.
    pub fn radius(&self) -> f64 {
        self.beyond().map_or_else(|| self.exact.radius(), Grow::radius)
    }

    /// Whether every value is final.
    pub fn is_done(&self) -> bool {
        self.radius() == f64::INFINITY
    }

    /// Whether the exact search has done it all.
    pub fn is_exact(&self) -> bool {
        self.beyond().is_none() && self.going.is_none()
    }

    /// Every value below this is exact, once it is final; infinity when all are. 0 where faces have different costs, and where some
    /// sources on an edge of many faces go for all.
    pub fn exact_below(&self) -> f64 {
        if self.geometry.costs().is_some() || self.going.is_some() { 0.0 } else { self.exact.radius() }
    }

    /// `#V`, distances from the sources, by windows lengths of paths, in the file's unit; infinite where none has been found.
    pub fn values(&self) -> &VertexData<f64> {
        self.beyond().map_or_else(|| self.exact.values(), |front| &front.reached().values)
    }

    /// `#V`, the number of the source that each value comes from, in the order in which they were given; `None` where none
    /// has been found.
    pub fn nearest_sources(&self) -> VertexData<Option<usize>> {
        let number = |vertex: VertexId| match self.beyond() {
            Some(front) => front.reached().nearest[vertex],
            None if self.exact.values()[vertex] < f64::INFINITY => self.exact.source_of(vertex.0),
            None => NOWHERE,
        };
        let of_all = |number: u32| self.going.as_ref().map_or(number, |going| going[number as usize]) as usize;
        let known = |vertex| Some(number(vertex)).filter(|&number| number != NOWHERE).map(of_all);
        self.surface().vertices().map(known).collect()
    }

    /// Windows that have crossed a face; beyond the exact search, where vertices alone go on, how often faces were crossed.
    pub fn windows(&self) -> usize {
        self.exact.windows() + self.beyond().map_or(0, |front| front.reached().crossed)
    }

    /// The distance, as it is now.
    pub fn distance(&self) -> Distance {
        Distance::of_paths(self.surface(), self.values().clone(), &self.sources, self.exact_below())
            .crossing(self.crossings())
            .weighted(self.geometry.costs())
    }

    /// The portals that shortest paths cross.
    fn crossings(&self) -> Vec<PortalCrossing> {
        let front = self.beyond();
        self.geometry.portals().crossings(|end| match front {
            Some(front) => front.entered(end),
            None => self.exact.entered(end),
        })
    }
}

/// Sources of these numbers, or all.
fn of_numbers(sources: &[Source], numbers: Option<&[u32]>) -> Vec<Source> {
    numbers.map_or_else(|| sources.to_vec(), |numbers| numbers.iter().map(|&number| sources[number as usize]).collect())
}

/// A front that is nowhere yet; where windows carry it, with so many stretches of each half-edge.
///
/// # Errors
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory).
fn front(geometry: Arc<ExactGeometry>, carriers: Carriers, stretches: usize) -> Result<Box<dyn Grow>> {
    Ok(match (carriers, geometry.costs().cloned(), stretches) {
        (Carriers::Vertices, _, _) => Box::new(March::new(geometry)),
        (Carriers::Windows, Some(costs), _) => Box::new(Front::new(geometry, costs, stretches)?),
        (Carriers::Windows, None, 1) => Box::new(Front::new(geometry, Uniform, Fixed::<1>)?),
        (Carriers::Windows, None, _) => Box::new(Front::new(geometry, Uniform, stretches)?),
    })
}

/// Distance from sources by propagation.
///
/// # Errors
/// Those of [`Propagation::new`]; [`Error::Cancelled`].
pub fn propagated_distance<S: ToSource>(
    surface: &Arc<Surface>,
    sources: &[S],
    options: PropagationOptions,
    progress: Progress<'_>,
) -> Result<Distance> {
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(surface)));
    let mut propagation = Propagation::new(geometry, sources, options)?;
    while !propagation.advance(f64::INFINITY, crate::exact::WORK_BETWEEN_CALLS)? {
        report(progress, Stage::Searching { radius: propagation.radius() }, 0.0)?;
    }
    Ok(propagation.distance())
}
