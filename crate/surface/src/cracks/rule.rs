//! Which cracks are closed, and how that is written.

use crate::length_rule::length_rule;

/// Which vertices become one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum WeldRule {
    /// Those of equal position.
    Exact,
    /// And those on both sides of cracks that are too narrow to be seen: 10⁻⁴ of the diagonal of the bounding box.
    #[default]
    Automatic,
    /// And those on both sides of cracks no wider than this, in the file's unit; 0 or more.
    Within(f64),
}

length_rule!(WeldRule, Exact = "exact", "the width of cracks to weld");
