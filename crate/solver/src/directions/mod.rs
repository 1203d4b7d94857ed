//! Directions of exact shortest paths: the log map, and parallel transport along them.
//!
//! A tangent plane at a vertex has the angles around it, those of an inner vertex scaled to sum to 2π, as in [`Frames`](crate::operator::Frames)
//! (Sharp, Soliman, Crane, "The vector heat method", 2019). Between vertices shortest paths are straight where faces are unfolded, and a
//! vector that is carried along keeps its angle with them.

mod log_map;
mod plane;
mod propagated;
mod transport;

use std::sync::Arc;

pub use log_map::{LogMap, LogMapSearch, log_map};
pub(crate) use plane::Plane;
pub use propagated::propagated_log_map;
pub use transport::transport;

use heatwalk_sparse::Progress;
use heatwalk_surface::ToSource;

use crate::error::Result;
use crate::exact::{ExactGeometry, Wavefront};

/// The search from sources, at its end.
pub(crate) fn searched<S: ToSource>(
    geometry: &Arc<ExactGeometry>,
    sources: &[S],
    progress: Progress<'_>,
) -> Result<Wavefront> {
    let mut front = Wavefront::new(Arc::clone(geometry), sources)?;
    front.grow(f64::INFINITY, progress)?;
    Ok(front)
}
