//! Which components are joined, and how that is written.

use crate::length_rule::length_rule;

/// Which components are joined.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum BridgeRule {
    /// None.
    Off,
    /// Those that pierce each other, touch, or are so near that they look as if they did.
    #[default]
    Automatic,
    /// Those that pierce each other, or are no farther apart than this, in the file's unit; 0 or more. More than 5 % of the
    /// diagonal of the surface's bounding box counts as 5 %.
    Within(f64),
}

length_rule!(BridgeRule, Off = "off", "the distance to bridge");
