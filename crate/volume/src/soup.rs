//! Tetrahedron soup: what a file holds, before any connectivity.

use glam::DVec3;

/// Tetrahedra over shared vertices, in the order of the file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TetSoup {
    /// `#V × 3`, input vertices in file order, in the file's unit.
    pub positions: Vec<DVec3>,
    /// `#T × 4`, indices into `positions`, in either orientation.
    pub tetrahedra: Vec<[u32; 4]>,
}
