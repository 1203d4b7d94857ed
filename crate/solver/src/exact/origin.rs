//! Where distances came from, to trace paths back.

/// Where a value came from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Origin {
    /// Nowhere yet.
    None,
    /// From the other end of the portal that it is an end of.
    Portal,
    /// Straight through, or along, a face from a root on it.
    Straight { face: u32, root: u32 },
    /// Through position `at` of a half-edge, whose face it lies on, in a window with the source at `(x, −depth)`.
    Window { halfedge: u32, root: u32, at: f64, x: f64, depth: f64 },
}
