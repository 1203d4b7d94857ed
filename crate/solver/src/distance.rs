//! The answer of every method.

use std::collections::HashMap;

use heatwalk_surface::edges::EdgeNames;
use heatwalk_surface::{HalfedgeId, Place, Source, Surface, SurfaceId, ToPoint, VertexData};

use crate::cost::Costs;
use crate::error::{Error, Result};

/// Distance from a set of sources.
#[derive(Debug, Clone, PartialEq)]
pub struct Distance {
    pub(crate) surface: SurfaceId,
    /// What a unit of length costs, where that is not the same everywhere.
    pub(crate) costs: Option<Costs>,
    /// `#V`, in the file's unit, times cost where faces have costs, non-negative, never NaN; infinity on components without a source. At a source that is a
    /// vertex it is exactly its initial distance; with summed sources, the mean over the sources of a component is 0
    /// before values below 0 become 0.
    pub values: VertexData<f64>,
    /// `#V`, heat after time t, to an arbitrary scale near 10²⁹⁰; `None` where the distance was found by other means.
    pub(crate) heat: Option<VertexData<f64>>,
    /// The sources, validated. Those whose initial distance is above the distance from another are left out.
    pub sources: Vec<Place>,
    /// Values below this are exact polyhedral distances; infinity when all are.
    pub exact_below: f64,
    /// Where shortest paths cross from one component to another.
    pub crossings: Vec<PortalCrossing>,
}

/// A portal in the direction in which paths to the sources cross it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PortalCrossing {
    /// Where a path leaves its component.
    pub from: Place,
    /// Where it goes on.
    pub to: Place,
    /// The distance at `from`, in the file's unit.
    pub distance: f64,
}

/// Share of its initial distance by which the distance at a source may miss it for rounding.
const ROUNDING: f64 = 1e-9;

/// Whether a source of this initial distance is nearest to its own place, where the distance is `value`.
pub(crate) fn is_nearest_to_itself(initial_distance: f64, value: f64) -> bool {
    value >= initial_distance * (1.0 - ROUNDING)
}

/// What tells a place from others, bit by bit.
pub(crate) type PlaceKey = (u32, [u64; 3]);

pub(crate) fn key(place: Place) -> PlaceKey {
    match place {
        Place::Vertex(vertex) => (vertex.0, [u64::MAX; 3]),
        Place::Edge { halfedge, fraction } => (halfedge.0, [fraction.to_bits(), u64::MAX, u64::MAX]),
        Place::Face { face, weights } => (face.0, weights.map(f64::to_bits)),
    }
}

/// Sources of which each place has one, from its least initial distance, in the order in which places come first.
pub(crate) fn one_a_place(surface: &Surface, sources: impl IntoIterator<Item = Source>) -> Vec<Source> {
    let mut names = EdgeNames::default();
    let mut on_first = |place: Place| match place {
        Place::Edge { halfedge, fraction } => {
            let (halfedge, fraction) = on_first(&mut names, surface, (halfedge, fraction));
            Place::Edge { halfedge, fraction }
        }
        _ => place,
    };
    let mut number: HashMap<PlaceKey, usize> = HashMap::new();
    let mut kept: Vec<Source> = Vec::new();
    for source in sources {
        let own = *number.entry(key(on_first(source.place()))).or_insert(kept.len());
        match kept.get_mut(own) {
            Some(other) => *other = other.from_at_most(source.initial_distance()),
            None => kept.push(source),
        }
    }
    kept
}

/// A place on an edge as the first half-edge of the same edge sees it.
pub(crate) fn on_first(
    names: &mut EdgeNames,
    surface: &Surface,
    (halfedge, fraction): (HalfedgeId, f64),
) -> (HalfedgeId, f64) {
    let first = names.first(surface.edges(), halfedge);
    let is_against = surface.ends(first) != surface.ends(halfedge);
    (first, if is_against { 1.0 - fraction } else { fraction })
}

/// The places of the sources that no other one reaches before their initial distance.
pub(crate) fn places_that_remain(surface: &Surface, sources: &[Source], values: &VertexData<f64>) -> Vec<Place> {
    let remains =
        |source: &&Source| is_nearest_to_itself(source.initial_distance(), source.place().interpolate(surface, values));
    sources.iter().filter(remains).map(|source| source.place()).collect()
}

impl Distance {
    /// By lengths of paths, without heat.
    pub(crate) fn of_paths(surface: &Surface, values: VertexData<f64>, sources: &[Source], exact_below: f64) -> Self {
        let sources = places_that_remain(surface, sources, &values);
        Self { surface: surface.id(), costs: None, values, heat: None, sources, exact_below, crossings: Vec::new() }
    }

    /// The same where paths cross these portals.
    pub(crate) fn crossing(mut self, portals: Vec<PortalCrossing>) -> Self {
        self.crossings = portals;
        self
    }

    /// The same where faces have different costs.
    pub(crate) fn weighted(mut self, costs: Option<&Costs>) -> Self {
        self.costs = costs.cloned();
        self
    }

    /// What a unit of length costs on the surface, where that is not the same everywhere.
    pub fn costs(&self) -> Option<&Costs> {
        self.costs.as_ref()
    }

    /// The surface that it was solved on.
    pub fn surface(&self) -> SurfaceId {
        self.surface
    }

    /// The same values on the same surface in another pose.
    ///
    /// # Errors
    /// [`Error::Surface`](crate::Error::Surface) with `ForeignSurface` where it was not solved on `from`, or `to` is not that
    /// surface in another pose.
    pub fn carried(&self, from: &Surface, to: &Surface) -> Result<Self> {
        from.require_own(self.surface, "distance")?;
        to.require_pose_of(from, "distance")?;
        Ok(Self { surface: to.id(), ..self.clone() })
    }

    /// The distance at a point, in the file's unit, interpolated linearly in its face: between vertices no exact one, which
    /// [`PlaceDistances`](crate::exact::PlaceDistances) gives.
    ///
    /// # Errors
    /// [`Error::Surface`](crate::Error::Surface) with `ForeignSurface` for another surface than [`Self::surface`], and as
    /// [`Surface::point`].
    pub fn at(&self, surface: &Surface, point: impl ToPoint) -> Result<f64> {
        surface.require_own(self.surface, "distance")?;
        Ok(surface.point(point)?.place().interpolate(surface, &self.values))
    }

    /// `#V`, heat after time t, to an arbitrary scale near 10²⁹⁰.
    ///
    /// # Errors
    /// [`Error::NoHeat`] where the distance was found by other means.
    pub fn heat(&self) -> Result<&VertexData<f64>> {
        self.heat.as_ref().ok_or(Error::NoHeat)
    }

    /// The largest finite distance.
    pub fn max(&self) -> f64 {
        self.values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max)
    }

    /// Number of vertices on components without a source.
    pub fn unreachable(&self) -> usize {
        self.values.iter().filter(|value| value.is_infinite()).count()
    }
}
