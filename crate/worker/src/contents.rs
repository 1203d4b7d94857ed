//! What the page gets of a file.

use heatwalk_bindings::Message;

use crate::motion::Clip;

/// What a file holds, but for its triangles.
#[derive(Message)]
pub struct Contents {
    /// Its parts.
    pub parts: Vec<PartInfo>,
    /// Its animations.
    pub clips: Vec<Clip>,
    /// What was left out of it, or taken otherwise than it is written.
    pub warnings: Vec<Warning>,
    /// What it refers to that was not given, as it calls it.
    pub missing: Vec<String>,
    /// The symbol of the unit of lengths, `mm`; empty where there is none.
    pub unit: String,
    /// Whether only its size suggests that unit.
    pub unit_assumed: bool,
    /// The axis that points up by the rules of the format, or by the shape.
    #[typescript("Up")]
    pub upright: &'static str,
    /// Whether it is a terrain, as far as only the shape tells: a height field over the map, north along Y.
    pub is_terrain: bool,
}

/// A part of a file.
#[derive(Message)]
pub struct PartInfo {
    /// Its name.
    pub name: String,
    /// How many triangles it has.
    pub triangles: usize,
    /// Its triangles as ranges of the file's, ascending: of each its first one and the one behind its last.
    pub ranges: Vec<u32>,
}

/// What was left out of a file, or taken otherwise than it is written.
#[derive(Message)]
pub struct Warning {
    /// Its kind, in kebab case.
    pub code: &'static str,
    /// Of how many things.
    pub count: usize,
    /// Where the first of them is.
    pub place: String,
}

impl Warning {
    pub(crate) fn new(warning: &heatwalk::Warning) -> Self {
        Self { code: warning.code.name(), count: warning.count, place: warning.place.clone() }
    }
}

/// What vertices of the input cost.
#[derive(Message)]
pub struct Weights {
    /// What the file calls it.
    pub name: String,
    /// One number a vertex of the input, NaN where the file has none.
    pub values: Vec<f32>,
}
