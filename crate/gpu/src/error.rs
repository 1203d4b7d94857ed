use thiserror::Error;

/// Result with this crate's [`enum@Error`].
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Why the graphics device gives no distance.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// Some edges are not between two faces of one orientation.
    #[error(
        "{edges} edges have more than two faces, or two that cannot agree in orientation, which the graphics device does not follow; compute the distance on the processor"
    )]
    NotManifold {
        /// How many edges; each once, however many faces it has.
        edges: usize,
    },
    /// Something does not fit into one buffer of the device, or into the numbers of the shaders.
    #[error(
        "the {what} of the mesh need {needed} {unit}, {limit} are allowed on this graphics device; compute the distance on the processor, or simplify the mesh"
    )]
    TooLarge {
        /// Which part of the mesh's data.
        what: &'static str,
        /// What it needs.
        needed: u64,
        /// What is allowed.
        limit: u64,
        /// Of what.
        unit: &'static str,
    },
    /// Distances of no vertex were asked for.
    #[error("no vertex to write distances of; choose one at least")]
    NoVertex,
    /// No source was given.
    #[error("no source; choose one vertex at least")]
    NoSource,
    /// A source is not on the surface, or has no finite initial distance.
    #[error(transparent)]
    Source(#[from] heatwalk::surface::Error),
    /// An edge is too long to be measured beside the others.
    #[error(
        "the longest edge is {times:e} mean edges long, which single precision cannot measure with; compute the distance on the processor"
    )]
    LongEdge {
        /// Its length, in mean edges.
        times: f64,
    },
    /// Distances are no numbers of single precision.
    #[error("the mean edge is {mean_edge:e} long, which is out of the range of single precision; scale the mesh")]
    UnitOutOfRange {
        /// Its length, in the file's unit.
        mean_edge: f64,
    },
    /// There is no device, or it is lost.
    #[error("the graphics device does not answer; compute the distance on the processor ({reason})")]
    Device {
        /// What it says.
        reason: String,
    },
    /// The front went on for longer than on any mesh that is known.
    #[error("the distance was not finished after {rounds} rounds; compute it on the processor")]
    NotFinished {
        /// Rounds done.
        rounds: u32,
    },
}
