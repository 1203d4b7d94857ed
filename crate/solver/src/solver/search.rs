//! Searches in windows, in memory that is kept.

use std::sync::Arc;

use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::Source;

use super::answer::Answer;
use super::options::DistanceOptions;
use crate::error::Result;
use crate::exact::{ExactGeometry, WORK_BETWEEN_CALLS};
use crate::options::Method;
use crate::propagation::{Propagation, PropagationOptions};

/// The last search, whose memory serves the next one.
#[derive(Debug, Default)]
pub(super) struct Search {
    kept: Option<Propagation>,
}

impl Search {
    /// # Errors
    /// Those of [`Propagation::new`]; [`Error::Cancelled`].
    pub fn answer(
        &mut self,
        geometry: &Arc<ExactGeometry>,
        sources: &[Source],
        (asked, options): (&DistanceOptions, PropagationOptions),
        progress: Progress<'_>,
    ) -> Result<Answer> {
        let propagation = Propagation::reusing(self.kept.take(), geometry, sources, options)?;
        let propagation = self.kept.insert(propagation);
        // A value of just the maximum distance is final, too.
        let radius = asked.max_distance.next_up();
        while !propagation.advance(radius, WORK_BETWEEN_CALLS)? {
            let radius = propagation.radius();
            report(progress, Stage::Searching { radius }, radius / asked.max_distance)?;
        }
        let mut distance = propagation.distance();
        for value in distance.values.as_mut_slice() {
            if *value > asked.max_distance {
                *value = f64::INFINITY;
            }
        }
        let method = if propagation.is_exact() { Method::Exact } else { Method::Propagation };
        Ok(Answer { sources: sources.to_vec(), distance, method, windows: propagation.windows() })
    }
}
