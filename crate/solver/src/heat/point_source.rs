//! Sources as elements of any kind have them.

use glam::DVec3;

use crate::distance::is_nearest_to_itself;
use crate::heat::constraint::Constraint;

/// A place that distance starts from.
#[derive(Debug, Clone)]
pub struct PointSource {
    /// Its initial distance, at the vertices that span the place.
    pub constraint: Constraint,
    /// Where it is, in the unit of the lengths.
    pub position: DVec3,
    /// What a unit of length costs around it, at least.
    pub cost: f64,
}

impl PointSource {
    /// The distance there.
    pub fn initial_distance(&self) -> f64 {
        self.constraint.value
    }

    /// The vertices that span its place, which are in one component.
    pub(super) fn vertices(&self) -> impl Iterator<Item = u32> + '_ {
        self.constraint.functional.iter().map(|&(vertex, _)| vertex)
    }

    /// Lowers distances (`#V`) at those vertices to that of the straight line from here. `positions` are those of all vertices.
    pub(super) fn lower(&self, positions: &[DVec3], distances: &mut [f64]) {
        for vertex in self.vertices() {
            let straight = self.cost * self.position.distance(positions[vertex as usize]);
            let known = &mut distances[vertex as usize];
            *known = known.min(self.initial_distance() + straight);
        }
    }

    /// Sets the distance at its vertex, if it is at one, to its initial distance, unless another source is nearer (`distances`, `#V`).
    pub(super) fn write_where_nearest(&self, distances: &mut [f64]) {
        if let Some(vertex) = self.constraint.vertex() {
            let value = &mut distances[vertex as usize];
            if is_nearest_to_itself(self.initial_distance(), *value) {
                *value = self.initial_distance();
            }
        }
    }
}
