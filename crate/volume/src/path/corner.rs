//! Corners of paths.

use glam::DVec3;

use crate::mesh::Start;

/// A corner of a path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub(super) place: DVec3,
    /// Where that is in the mesh.
    pub(super) start: Start,
    /// Cost of what follows.
    pub(super) cost: f64,
}
