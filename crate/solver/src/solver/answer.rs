//! What a solver gives.

use crate::distance::Distance;
use crate::options::Method;

/// A distance and how it was found.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The distance. Its `exact_below` says how far it is exact.
    pub distance: Distance,
    /// What found it, never [`Method::Auto`]: [`Method::Exact`] where all windows were propagated, whatever was asked for.
    pub method: Method,
    /// Windows that crossed a face; 0 with [`Method::Heat`].
    pub windows: usize,
}

impl Answer {
    /// The same where all lengths are so many times as large.
    pub(super) fn times(mut self, factor: f64) -> Self {
        let Distance { values, exact_below, crossings, .. } = &mut self.distance;
        values.iter_mut().for_each(|value| *value *= factor);
        *exact_below *= factor;
        crossings.iter_mut().for_each(|crossing| crossing.distance *= factor);
        self
    }
}
