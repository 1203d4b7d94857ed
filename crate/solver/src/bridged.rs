//! Heat across bridges: windows carry distances to the portals, and from there heat acts inside each component.
//!
//! Links between the unknowns of components would do without windows, but are off by tens of per cent: heat passes a link
//! of two vertices as if it were a pipe. Portals are no sources themselves: several of them in one face, each with its own
//! distance, ask more of three unknowns than these can give, and what is left of the heat method's error between them grows
//! without limit. The corners of their faces, with the distances that windows give them, are.
//!
//! Portals across cracks within a component carry nothing: the heat of sources on both sides of a crack would mix around its ends.

use std::collections::{BTreeSet, HashSet};
use std::sync::Arc;

use heatwalk_surface::{Place, Source, VertexId};

use crate::distance::{Distance, PlaceKey, PortalCrossing, key};
use crate::error::Result;
use crate::exact::ExactGeometry;
use crate::propagation::{Propagation, PropagationOptions, REFRACTED, Windows};

/// Sources, and after them the corners of the faces by which paths from these enter other components, as sources with an
/// initial distance.
#[derive(Debug)]
pub(crate) struct CarriedSources {
    sources: Vec<Source>,
    /// How many of them were given.
    given: usize,
    crossings: Vec<PortalCrossing>,
}

impl CarriedSources {
    /// Of sources on the geometry's surface. Without bridges from one component to another nothing is computed.
    ///
    /// # Errors
    /// Those of [`Propagation::new`].
    pub fn new(geometry: &Arc<ExactGeometry>, sources: &[Source]) -> Result<Self> {
        let surface = geometry.surface();
        let (mut carried, given) = (sources.to_vec(), sources.len());
        let parts = |from: Place, to: Place| from.component(surface) != to.component(surface);
        if !geometry.portals().places().chunks_exact(2).any(|ends| parts(ends[0], ends[1])) {
            return Ok(Self { sources: carried, given, crossings: Vec::new() });
        }
        let windows = if geometry.costs().is_some() { REFRACTED } else { Windows::default() };
        let options = PropagationOptions { windows, ..PropagationOptions::default() };
        let mut propagation = Propagation::new(Arc::clone(geometry), &carried, options)?;
        propagation.advance(f64::INFINITY, usize::MAX)?;
        let Distance { values, mut crossings, .. } = propagation.distance();
        crossings.retain(|crossing| parts(crossing.from, crossing.to));
        let faces = crossings.iter().flat_map(|crossing| crossing.from.faces(surface));
        let corners: BTreeSet<VertexId> = faces.flat_map(|face| surface.faces()[face]).collect();
        for corner in corners {
            carried.push(surface.source(corner, values[corner])?);
        }
        Ok(Self { sources: carried, given, crossings })
    }

    /// The sources to ask for.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// A distance from these sources, as one from those that were given.
    pub fn distance(&self, mut distance: Distance) -> Distance {
        let given: HashSet<PlaceKey> = self.sources[..self.given].iter().map(|source| key(source.place())).collect();
        distance.sources.retain(|&place| given.contains(&key(place)));
        distance.crossing(self.crossings.clone())
    }
}
