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
