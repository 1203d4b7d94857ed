//! Exact distances around the sources, and what distance beyond has to meet.

use heatwalk::ExactRadius;
use heatwalk::heat::Constraint;

use crate::march::{March, Medium};
use crate::mesh::TetMesh;
use crate::point::{TetPoint, TetSource};

/// Work of the march on any mesh: that of some 300 vertices.
const LEAST_WORK: f64 = 3000.0;

/// Exact distances below a radius.
pub(super) struct Region {
    distances: Vec<f64>,
    radius: f64,
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

    /// Distances in the region and at sources that it does not contain (`#V`, infinite elsewhere).
    pub(super) fn known(&self, mesh: &TetMesh, medium: &Medium, sources: &[TetSource]) -> Vec<f64> {
        let inside = |&distance: &f64| if distance < self.radius { distance } else { f64::INFINITY };
        let mut known: Vec<f64> = self.distances.iter().map(inside).collect();
        for source in sources {
            let place = source.point.position(mesh);
            let cost = match source.point {
                TetPoint::Vertex(_) => 0.0,
                TetPoint::Inside { tetrahedron, .. } => medium.cost(tetrahedron.0),
            };
            for (vertex, _) in source.point.support(mesh) {
                let distance = source.initial_distance + cost * place.distance(mesh.position(vertex));
                let known = &mut known[vertex.0 as usize];
                *known = known.min(distance);
            }
        }
        known
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
