//! What clips change.

use super::hierarchy::Placement;

/// The nodes of a motion at a moment.
pub struct State {
    pub placements: Vec<Placement>,
    /// Weights of the morph targets of each node's mesh, where a clip changes them.
    pub weights: Vec<Option<Vec<f64>>>,
}
