//! Searches in windows, in memory that is kept.

use std::sync::Arc;

use super::answer::Answer;
use super::options::DistanceOptions;
use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, WORK_BETWEEN_CALLS};
use crate::options::Method;
use crate::progress::{Step, Steps};
use crate::propagation::{Propagation, PropagationOptions};
use heatwalk_surface::Source;

/// The last search, restarted for the next question where that is asked in the same way.
#[derive(Debug, Default)]
pub(super) struct Search {
    kept: Option<(PropagationOptions, Propagation)>,
}

impl Search {
    /// # Errors
    /// Those of [`Propagation::new`]; [`Error::Cancelled`].
    pub fn answer(
        &mut self,
        geometry: &Arc<ExactGeometry>,
        sources: &[Source],
        (asked, options): (&DistanceOptions, PropagationOptions),
        progress: Steps<'_>,
    ) -> Result<Answer> {
        let propagation = self.start(geometry, sources, options)?;
        // A value of just the maximum distance is final, too.
        let radius = asked.max_distance.next_up();
        while !propagation.advance(radius, WORK_BETWEEN_CALLS) {
            if progress(Step::Radius(propagation.radius())).is_break() {
                return Err(Error::Cancelled);
            }
        }
        let mut distance = propagation.distance();
        for value in distance.values.as_mut_slice() {
            if *value > asked.max_distance {
                *value = f64::INFINITY;
            }
        }
        let method = if propagation.is_exact() { Method::Exact } else { Method::Propagation };
        Ok(Answer { distance, method, windows: propagation.windows() })
    }

    fn start(
        &mut self,
        geometry: &Arc<ExactGeometry>,
        sources: &[Source],
        options: PropagationOptions,
    ) -> Result<&mut Propagation> {
        let kept = self.kept.take().filter(|(kept, _)| *kept == options);
        let propagation = match kept {
            Some((_, mut propagation)) => {
                propagation.restart(sources)?;
                propagation
            }
            None => Propagation::new(Arc::clone(geometry), sources, options)?,
        };
        let (_, propagation) = self.kept.insert((options, propagation));
        Ok(propagation)
    }
}
