//! Searches from sources, and where these are.

use std::sync::Arc;

use super::random;
use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::{Element, FaceId, Place, Surface, VertexId};

pub fn geometry(surface: &Arc<Surface>) -> Arc<ExactGeometry> {
    Arc::new(ExactGeometry::new(Arc::clone(surface)))
}

pub fn exact(geometry: &Arc<ExactGeometry>, sources: &[(Place, f64)]) -> Wavefront {
    let mut front = Wavefront::new(Arc::clone(geometry), sources).expect("valid sources");
    front.advance(f64::INFINITY, usize::MAX).expect("room for windows");
    front
}

pub fn at(vertex: u32) -> [(Place, f64); 1] {
    [(Place::Vertex(VertexId(vertex)), 0.0)]
}

/// Sources at a vertex, inside a face and, later than these, at another vertex.
pub fn mixed_sources(surface: &Surface, seed: &mut u64) -> [(Place, f64); 3] {
    let vertex = |seed: &mut u64| Place::Vertex(VertexId::from_index(random(seed, surface.vertex_count())));
    let face = FaceId::from_index(random(seed, surface.face_count()));
    let inside = Place::Face { face, weights: [0.2, 0.5, 0.3] };
    [(vertex(seed), 0.0), (inside, 0.0), (vertex(seed), 0.7 * surface.mean_edge())]
}
