//! The answer to a query.

use crate::error::Result;
use heatwalk_surface::{Place, Surface, SurfaceId, ToPoint, VertexData};

/// Distance from a set of sources.
#[derive(Debug, Clone, PartialEq)]
pub struct Distance {
    pub(super) surface: SurfaceId,
    /// `#V`, in the file's unit, non-negative, never NaN; infinity on components without a source. At a source that is a
    /// vertex it is exactly its initial distance; with summed sources, the mean over the sources of a component is 0
    /// before values below 0 become 0.
    pub values: VertexData<f64>,
    /// `#V`, heat after time t, to an arbitrary scale near 10²⁹⁰.
    pub heat: VertexData<f64>,
    /// The sources, validated. Those whose initial distance is above the distance from another are left out.
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
    /// [`Error::Surface`](crate::Error::Surface) with `ForeignSurface` for another surface than [`Self::surface`], and as
    /// [`Surface::point`].
    pub fn at(&self, surface: &Surface, point: impl ToPoint) -> Result<f64> {
        surface.require_own(self.surface, "distance")?;
        Ok(surface.point(point)?.place().interpolate(surface, &self.values))
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
