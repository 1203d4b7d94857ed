//! Corners of paths.

use glam::DVec3;

use crate::mesh::Start;

/// A corner of a path.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Corner {
    pub(crate) place: DVec3,
    /// Where that is in the mesh.
    pub(crate) start: Start,
    /// Cost of what follows.
    pub(crate) cost: f64,
}

impl Corner {
    /// Where a unit of length costs 1.
    pub(crate) fn at(place: DVec3, start: Start) -> Self {
        Self { place, start, cost: 1.0 }
    }
}
