//! Heat across bridges: windows carry distances to the portals, and from there heat acts inside each component.
//!
//! Links between the unknowns of components would do without windows, but are off by tens of per cent: heat passes a link
//! of two vertices as if it were a pipe.

use std::sync::Arc;

use crate::distance::{Distance, PortalCrossing};
use crate::error::Result;
use crate::exact::ExactGeometry;
use crate::propagation::{Propagation, PropagationOptions};
use heatwalk_surface::{Source, ToSource};

/// Sources, and after them the portals by which they reach other components, as sources with an initial distance.
#[derive(Debug, Clone)]
pub struct CarriedSources {
    sources: Vec<Source>,
    crossings: Vec<PortalCrossing>,
}

impl CarriedSources {
    /// Of sources on the geometry's surface. Without bridges nothing is computed.
    ///
    /// # Errors
    /// Those of [`Propagation::new`].
    pub fn new<S: ToSource>(geometry: &Arc<ExactGeometry>, sources: &[S]) -> Result<Self> {
        let surface = geometry.surface();
        let mut carried =
            sources.iter().map(|source| Ok(source.to_source(surface)?)).collect::<Result<Vec<Source>>>()?;
        if geometry.portals().places().is_empty() {
            return Ok(Self { sources: carried, crossings: Vec::new() });
        }
        let mut propagation = Propagation::new(Arc::clone(geometry), &carried, PropagationOptions::default())?;
        propagation.advance(f64::INFINITY, usize::MAX);
        let crossings = propagation.distance().crossings;
        for crossing in &crossings {
            carried.push(surface.source(crossing.from, crossing.distance)?);
        }
        Ok(Self { sources: carried, crossings })
    }

    /// The sources to ask for.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// A distance from these sources, as one from those that were given.
    #[must_use]
    pub fn distance(&self, mut distance: Distance) -> Distance {
        let is_portal = |place| self.crossings.iter().any(|crossing| crossing.from == place);
        distance.sources.retain(|&place| !is_portal(place));
        distance.crossing(self.crossings.clone())
    }
}
