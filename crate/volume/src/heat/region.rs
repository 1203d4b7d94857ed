//! Exact distances around the sources, and what distance beyond has to meet.

use heatwalk::ExactRadius;
use heatwalk::heat::Constraint;

use crate::march::{March, Medium};
use crate::mesh::TetMesh;
use crate::point::TetSource;

/// Work of the march on any mesh: that of some 300 vertices.
const LEAST_WORK: f64 = 3000.0;

/// Exact distances below a radius.
pub(super) struct Region {
    distances: Vec<f64>,
    radius: f64,
}

/// Right side of the Poisson equation.
pub(super) struct Right {
    /// `#V`, integrated divergence of the field that should be the gradient of distance.
    pub(super) divergence: Vec<f64>,
    /// On the rim of each patch of the region the mean of the exact distances.
    pub(super) rims: Vec<Constraint>,
}

impl Region {
    /// Where the radius is chosen, the march takes so much work for each vertex of the mesh. Where all vertices see the sources, half
    /// of them take 5.5; around obstacles each takes more.
    pub(super) fn new(
        mesh: &TetMesh,
        medium: &Medium,
        sources: &[TetSource],
        radius: ExactRadius,
        mean_edge: f64,
        work: f64,
    ) -> Self {
        let least = sources.iter().map(|source| source.initial_distance).fold(f64::INFINITY, f64::min);
        let mut march = March::new(mesh, medium, sources);
        let radius = match radius {
            ExactRadius::Edges(edges) => march.advance(least + edges * mean_edge, usize::MAX),
            ExactRadius::Automatic => {
                let work = (work * mesh.vertex_count() as f64).max(LEAST_WORK);
                march.advance(f64::INFINITY, work as usize)
            }
        };
        Self { distances: march.into_distances(), radius }
    }

    /// Every distance below it is exact.
    pub(super) fn radius(&self) -> f64 {
        self.radius
    }

    /// The distance of a vertex, if it is in the region.
    #[inline]
    pub(super) fn value(&self, vertex: u32) -> Option<f64> {
        Some(self.distances[vertex as usize]).filter(|&distance| distance < self.radius)
    }

    /// The initial distances of sources that the region does not contain.
    pub(super) fn beyond(&self, mesh: &TetMesh, sources: &[TetSource]) -> impl Iterator<Item = Constraint> {
        let is_beyond =
            |source: &&TetSource| source.point.support(mesh).any(|(vertex, _)| self.value(vertex.0).is_none());
        let at_source = |source: &TetSource| Constraint::new(source.point.support(mesh), source.initial_distance);
        sources.iter().filter(is_beyond).map(at_source)
    }

    /// Puts exact values in their places, and infinity where no source is.
    pub(super) fn complete(&self, mesh: &TetMesh, components: &[u32], sources: &[TetSource], values: &mut [f64]) {
        let mut has_source = vec![false; components.iter().max().map_or(0, |&last| last as usize + 1)];
        for (vertex, _) in sources.iter().flat_map(|source| source.point.support(mesh)) {
            has_source[components[vertex.0 as usize] as usize] = true;
        }
        let least = if self.radius.is_finite() { self.radius } else { 0.0 };
        for (vertex, (value, &component)) in values.iter_mut().zip(components).enumerate() {
            *value = match self.value(vertex as u32) {
                Some(exact) => exact,
                None if has_source[component as usize] => value.max(least),
                None => f64::INFINITY,
            };
        }
    }
}
