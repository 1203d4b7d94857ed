//! What the shape of the ground costs.

use glam::DVec3;
use heatwalk_surface::Surface;

use crate::cost::{Costs, tobler};
use crate::error::Result;

/// What the shape of the ground costs, against the direction that points up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relief {
    /// Whether slopes cost what [`tobler`] says: the mean of both directions.
    pub slope: bool,
    /// What it costs at the highest place, as a multiple of the lowest one; between, its logarithm grows with height.
    /// 1 where height costs nothing.
    pub highest: f64,
}

impl Relief {
    /// Where the shape costs nothing.
    pub const LEVEL: Self = Self { slope: false, highest: 1.0 };

    /// The costs of a surface's faces, `up` being of any length; `None` where they are all 1. Those outside of
    /// [`Costs::RANGE`] are cut to it.
    ///
    /// # Errors
    /// [`Error::BadParameter`](crate::Error::BadParameter) where [`Self::highest`] is negative or not a number.
    pub fn costs(self, surface: &Surface, up: DVec3) -> Result<Option<Costs>> {
        let slope = if self.slope { Some(Costs::of_slope(surface, up, tobler)?) } else { None };
        let of_height = || Costs::of_height(surface, up, |share| self.highest.powf(share));
        let height = if self.highest == 1.0 { None } else { Some(of_height()?) };
        Ok(Costs::both(slope, height))
    }
}
