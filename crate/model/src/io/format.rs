//! What a reader says of its format.

use glam::DVec3;

use super::budget::Budget;
use super::reader::Resources;
use crate::error::Result;
use crate::model::Model;

/// A format that can be read.
pub struct Format {
    /// Those of its files, in lower case.
    pub extensions: &'static [&'static str],
    /// Whether bytes begin as such a file does; never where the format has no mark.
    pub is: fn(&[u8]) -> bool,
    /// The model of a file of this stem, with what it refers to.
    pub read: fn(&Budget, &str, &[u8], Resources<'_>) -> Result<Model>,
    /// What points up by its rules; none where they say nothing.
    pub upward: Option<DVec3>,
}
