//! What is asked of a solver, beside the sources.

use crate::error::{Error, Result};
use crate::options::{Method, Parameters};
use crate::propagation::{Carriers, ExactSearch, PropagationOptions, REFRACTED, Windows};

/// Windows that [`Method::Auto`] propagates exactly: about a second.
const AFFORDABLE_WINDOWS: usize = 8_000_000;

/// The same of each face where that is more: about as long as the factors of heat would take.
const AFFORDABLE_WINDOWS_PER_FACE: usize = 16;

/// Exact radius of quick answers by heat, in mean edges. Up to here it costs little beside the systems that are solved anyway, and
/// the rings around a source, where heat is off most, are exact.
const QUICK_EDGES: f64 = 8.0;

/// How distances are found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DistanceOptions {
    /// By which method.
    pub method: Method,
    /// Windows that [`Method::Propagation`] and [`Method::Auto`] keep of each half-edge.
    pub windows: Windows,
    /// What carries distances on beyond the exact search of [`Method::Propagation`].
    pub carriers: Carriers,
    /// Vertices farther than this, in the file's unit, stay at infinity, and no work is done there; positive. Infinite for
    /// [`Method::Heat`], which finds all distances at once.
    pub max_distance: f64,
    /// The options of [`Method::Heat`]; no other method looks at them.
    pub heat: Parameters,
}

impl Default for DistanceOptions {
    fn default() -> Self {
        Self {
            method: Method::default(),
            windows: Windows::default(),
            carriers: Carriers::default(),
            max_distance: f64::INFINITY,
            heat: Parameters::default(),
        }
    }
}

impl DistanceOptions {
    /// This method with all else at its default.
    pub fn by(method: Method) -> Self {
        Self { method, ..Self::default() }
    }

    /// For an answer in a fraction of the time, as while a source is dragged: with a smaller exact region by [`Method::Heat`], else
    /// carried by vertices alone.
    #[must_use]
    pub fn quick(self) -> Self {
        let heat = Parameters { exact_radius: self.heat.exact_radius.at_most(QUICK_EDGES), ..self.heat };
        let method = if self.method == Method::Heat { Method::Heat } else { Method::Propagation };
        Self { method, carriers: Carriers::Vertices, heat, ..self }
    }

    /// # Errors
    /// [`Error::BadParameter`].
    pub(super) fn check(&self) -> Result<()> {
        let bad =
            |range| Error::BadParameter { name: "the maximum distance", value: self.max_distance.to_string(), range };
        if self.max_distance.is_nan() || self.max_distance <= 0.0 {
            return Err(bad("a positive number"));
        }
        if self.method == Method::Heat && self.max_distance.is_finite() {
            return Err(bad("infinite for heat, which finds all distances at once"));
        }
        Ok(())
    }

    /// The same where all lengths are so many times as small.
    pub(super) fn per(&self, factor: f64) -> Self {
        Self { max_distance: self.max_distance / factor, ..*self }
    }

    /// How windows are propagated on a surface of so many faces; `None` for heat.
    pub(super) fn propagation(&self, faces: usize) -> Option<PropagationOptions> {
        let propagation = PropagationOptions { windows: self.windows, carriers: self.carriers, ..Default::default() };
        let affordable = AFFORDABLE_WINDOWS.max(AFFORDABLE_WINDOWS_PER_FACE * faces);
        match self.method {
            Method::Heat => None,
            Method::Exact => Some(PropagationOptions { windows: Windows::All, ..propagation }),
            Method::Propagation => Some(propagation),
            Method::Auto => Some(PropagationOptions { exact: ExactSearch::AtMost(affordable), ..propagation }),
        }
    }

    /// The same where faces have different costs.
    ///
    /// # Errors
    /// [`Error::NotExact`] for exact distances.
    pub(super) fn refraction(&self) -> Result<Option<PropagationOptions>> {
        let by = |windows| Ok(Some(PropagationOptions { windows, carriers: self.carriers, ..Default::default() }));
        match (self.method, self.windows) {
            (Method::Heat, _) => Ok(None),
            (Method::Exact, _) | (_, Windows::All) => Err(Error::NotExact),
            (Method::Auto, windows) => by(windows.max(REFRACTED)),
            (Method::Propagation, windows) => by(windows),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn auto_is_exact_for_about_a_second_or_as_long_as_factors_take() {
        let exact = |faces| DistanceOptions::default().propagation(faces).map(|options| options.exact);
        assert_eq!(exact(1_000), Some(ExactSearch::AtMost(8_000_000)));
        assert_eq!(exact(1_000_000), Some(ExactSearch::AtMost(16_000_000)));
        let asked = DistanceOptions { windows: Windows::All, ..DistanceOptions::by(Method::Propagation) };
        assert_eq!(asked.propagation(10).map(|options| options.windows), Some(Windows::All));
        assert_eq!(DistanceOptions::by(Method::Heat).propagation(10), None);
    }
}
