//! Exact polyhedral distances, and how far others are from them.

use std::sync::Arc;
use std::time::Instant;

use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{Source, Surface, VertexData};

use crate::report::milliseconds;

/// What exact distances need of a surface, and the milliseconds that it took.
pub fn geometry(surface: &Arc<Surface>) -> (Arc<ExactGeometry>, f64) {
    let start = Instant::now();
    let geometry = Arc::new(ExactGeometry::new(surface));
    (geometry, milliseconds(start))
}

/// `#V`, infinite where no source can be reached.
pub fn distances(surface: &Arc<Surface>, geometry: &Arc<ExactGeometry>, sources: &[Source]) -> VertexData<f64> {
    let mut front = Wavefront::new(Arc::clone(surface), Arc::clone(geometry), sources, &[]);
    front.advance(f64::INFINITY, usize::MAX);
    front.into_values()
}
