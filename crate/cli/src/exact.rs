//! Exact polyhedral distances, and how far others are from them.

use std::sync::Arc;
use std::time::Instant;

use anyhow::Result;
use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{Surface, ToSource, VertexData};

use crate::report::milliseconds;

/// What exact distances need of a surface, and the milliseconds that it took.
pub fn geometry(surface: &Arc<Surface>) -> (Arc<ExactGeometry>, f64) {
    let start = Instant::now();
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(surface)));
    (geometry, milliseconds(start))
}

/// `#V`, infinite where no source can be reached.
pub fn distances<S: ToSource>(geometry: &Arc<ExactGeometry>, sources: &[S]) -> Result<VertexData<f64>> {
    let mut front = Wavefront::new(Arc::clone(geometry), sources)?;
    front.advance(f64::INFINITY, usize::MAX);
    Ok(front.into_values())
}
