//! What is asked of a factored surface: all that needs no factoring.

use heatwalk_surface::{Source, Surface, ToSource};

use crate::distance::one_a_place;
use crate::error::{Error, Result};
use crate::options::{ExactRadius, MultiSource};

/// Sources and how distance from them is measured.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Query {
    /// Where distance is measured from, with initial distances; at least one.
    pub sources: Vec<Source>,
    /// How far around the sources distances are exact.
    pub exact_radius: ExactRadius,
    /// How several sources are joined.
    pub multi_source: MultiSource,
}

impl Query {
    /// From these sources, with the other options at their defaults.
    ///
    /// # Errors
    /// As [`Surface::source`].
    pub fn new<S: ToSource>(surface: &Surface, sources: &[S]) -> Result<Self> {
        let checked = |source: &S| Ok(source.to_source(surface)?);
        Ok(Self { sources: sources.iter().map(checked).collect::<Result<_>>()?, ..Self::default() })
    }

    /// The sources, each once.
    ///
    /// # Errors
    /// [`Error::NoSource`]; [`Error::Surface`] for a source of another surface;
    /// [`Error::BadParameter`] for the exact radius.
    pub(super) fn checked(&self, surface: &Surface) -> Result<Vec<Source>> {
        self.exact_radius.check()?;
        if self.sources.is_empty() {
            return Err(Error::NoSource);
        }
        let checked: Result<Vec<Source>> = self.sources.iter().map(|source| Ok(source.to_source(surface)?)).collect();
        Ok(one_a_place(surface, checked?))
    }
}
