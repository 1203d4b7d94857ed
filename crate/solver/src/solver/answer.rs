//! What a solver gives.

use heatwalk_surface::Source;

use crate::distance::Distance;
use crate::options::Method;

/// A distance and how it was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// What was asked: the sources with their initial distances, those included that others reach before.
    pub sources: Vec<Source>,
    /// The distance. Its `exact_below` says how far it is exact.
    pub distance: Distance,
    /// What found it, never [`Method::Auto`]: [`Method::Exact`] where all windows were propagated, whatever was asked for.
    pub method: Method,
    /// Windows that crossed a face; 0 with [`Method::Heat`].
    pub windows: usize,
}

impl Answer {
    /// The same with the distances so many times as large, but not those of its sources.
    pub(super) fn times(mut self, factor: f64) -> Self {
        let Distance { values, exact_below, crossings, .. } = &mut self.distance;
        values.iter_mut().for_each(|value| *value *= factor);
        *exact_below *= factor;
        crossings.iter_mut().for_each(|crossing| crossing.distance *= factor);
        self
    }

    /// Whether all values are exact.
    pub fn is_exact(&self) -> bool {
        self.distance.exact_below == f64::INFINITY
    }
}
