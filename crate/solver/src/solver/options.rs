//! What is asked of a solver, beside the sources.

use crate::error::{Error, Result};
use crate::options::{Method, Parameters};
use crate::propagation::{ExactSearch, PropagationOptions, REFRACTED, Windows};

/// Windows that [`Method::Auto`] propagates exactly: about a second.
const AFFORDABLE_WINDOWS: usize = 8_000_000;

/// The same of each face where that is more: about as long as the factors of heat would take.
const AFFORDABLE_WINDOWS_PER_FACE: usize = 16;

/// How distances are found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DistanceOptions {
    /// By which method.
    pub method: Method,
    /// Windows that [`Method::Propagation`] and [`Method::Auto`] keep of each half-edge.
    pub windows: Windows,
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
        let windows = self.windows;
        let affordable = AFFORDABLE_WINDOWS.max(AFFORDABLE_WINDOWS_PER_FACE * faces);
        match self.method {
            Method::Heat => None,
            Method::Exact => Some(PropagationOptions { windows: Windows::All, ..PropagationOptions::default() }),
            Method::Propagation => Some(PropagationOptions { windows, ..PropagationOptions::default() }),
            Method::Auto => {
                let exact = ExactSearch::AtMost(affordable);
                Some(PropagationOptions { windows, exact, ..PropagationOptions::default() })
            }
        }
    }

    /// The same where faces have different costs.
    ///
    /// # Errors
    /// [`Error::NotExact`] for exact distances.
    pub(super) fn refraction(&self) -> Result<Option<PropagationOptions>> {
        let by = |windows| Ok(Some(PropagationOptions { windows, ..PropagationOptions::default() }));
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
