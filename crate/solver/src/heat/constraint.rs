//! What a solution shall be at places.

use heatwalk_sparse::Functional;
use heatwalk_surface::VertexId;

/// The value that a solution shall have at a place: at a vertex, or as a weighted mean of vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    pub(super) functional: Functional,
    pub(super) value: f64,
}

impl Constraint {
    /// At the mean of vertices by weights that sum to 1, such as barycentric ones.
    ///
    /// # Panics
    /// Without a vertex.
    pub fn new(support: impl IntoIterator<Item = (VertexId, f64)>, value: f64) -> Self {
        let functional: Functional = support.into_iter().map(|(vertex, weight)| (vertex.0, weight)).collect();
        assert!(!functional.is_empty(), "a constraint is at some vertex");
        Self { functional, value }
    }

    /// At a vertex.
    pub fn at_vertex(vertex: VertexId, value: f64) -> Self {
        Self::new([(vertex, 1.0)], value)
    }

    /// The vertex, where it is at one.
    pub(super) fn vertex(&self) -> Option<u32> {
        match self.functional[..] {
            [(vertex, _)] => Some(vertex),
            _ => None,
        }
    }
}
