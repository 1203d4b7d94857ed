//! What can go wrong, with the element at fault and a remedy.

use strum::IntoStaticStr;
use thiserror::Error;

/// Result with this crate's [`enum@Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every failure of the crate. The message is one sentence that names what is at fault; [`Error::code`] is for programs, and
/// for those who word what to do in their own terms.
#[derive(Debug, Clone, PartialEq, Error, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// No triangle is left to work on.
    #[error("no triangles: {reason}")]
    Empty {
        /// Why there is none.
        reason: String,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} refers to vertex {vertex}, but there are only {vertices} vertices")]
    IndexOutOfRange {
        /// Triangle, counted from 0.
        triangle: usize,
        /// The index it uses.
        vertex: u64,
        /// Number of vertices.
        vertices: usize,
    },
    /// A vertex has a NaN or infinite coordinate.
    #[error("vertex {vertex} has a coordinate that is not a finite number; repair the file")]
    NotFinite {
        /// Vertex of the input, counted from 0.
        vertex: usize,
    },
    /// A vertex has a coordinate beyond ±[`MOST_COORDINATE`](crate::MOST_COORDINATE).
    #[error("vertex {vertex} has a coordinate beyond ±1e150, where areas are no numbers any more; scale the mesh down")]
    TooFar {
        /// Vertex of the input, counted from 0.
        vertex: usize,
    },
    /// A source lies where walls are all around.
    #[error("a source lies in a wall, at face {face}; move it, or open the wall there")]
    SourceInWall {
        /// Triangle of the input, counted from 0.
        face: u32,
    },
    /// There is no such part.
    #[error("there is no part {part}; the file has {parts}, counted from 0")]
    NoSuchPart {
        /// The part asked for.
        part: usize,
        /// Number of parts.
        parts: usize,
    },
    /// There is no such attribute.
    #[error("the vertices have no attribute {name}; {}", if names.is_empty() { "the file gives them none".to_owned() } else { format!("the file has {names}") })]
    NoSuchAttribute {
        /// The name asked for.
        name: String,
        /// The names that there are, separated by commas.
        names: String,
    },
    /// There is no such vertex: of the input, or of the surface where a surface was asked.
    #[error("vertex {vertex} does not exist; there are {vertices}, counted from 0")]
    NoSuchVertex {
        /// The vertex asked for.
        vertex: usize,
        /// Number of vertices.
        vertices: usize,
    },
    /// No triangle uses a vertex of the input, so it is not on the surface.
    #[error("vertex {vertex} is used by no triangle of the surface; choose another")]
    UnreferencedVertex {
        /// Vertex of the input, counted from 0.
        vertex: usize,
    },
    /// There is no such triangle of the input.
    #[error("triangle {triangle} does not exist; there are {triangles}, counted from 0")]
    NoSuchTriangle {
        /// The triangle asked for.
        triangle: usize,
        /// Number of triangles.
        triangles: usize,
    },
    /// A triangle of the input is in none of the parts that make the surface.
    #[error("triangle {triangle} is in none of the chosen parts; choose another")]
    InactiveTriangle {
        /// Triangle of the input, counted from 0.
        triangle: usize,
    },
    /// A triangle of the input became no face.
    #[error("triangle {triangle} has no area or repeats an earlier one and was dropped; choose another")]
    DroppedTriangle {
        /// Triangle of the input, counted from 0.
        triangle: usize,
    },
    /// A path along edges was to go where there is no edge.
    #[error("vertex {vertex} has no edge to the vertex before it on the path")]
    NotAdjacent {
        /// Vertex of the surface, counted from 0.
        vertex: usize,
    },
    /// There is no such face.
    #[error("face {face} does not exist; there are {faces}, counted from 0")]
    NoSuchFace {
        /// The face asked for.
        face: usize,
        /// Number of faces.
        faces: usize,
    },
    /// There is no such half-edge.
    #[error("half-edge {halfedge} does not exist; there are {halfedges}, counted from 0")]
    NoSuchHalfedge {
        /// The half-edge asked for.
        halfedge: usize,
        /// Number of half-edges, those of boundary loops included.
        halfedges: usize,
    },
    /// A place on an edge is beyond its ends.
    #[error("{fraction} of the way along half-edge {halfedge} is not on it; the fraction must lie between 0 and 1")]
    BadFraction {
        /// Half-edge, counted from 0.
        halfedge: usize,
        /// Share of the way along it, as given.
        fraction: f64,
    },
    /// Barycentric weights of a place are negative or do not sum to 1.
    #[error(
        "face {face} with weights {weights:?} is not a point of the surface: weights must not be negative and must sum to 1"
    )]
    BadWeights {
        /// Face, counted from 0.
        face: usize,
        /// Weights of its corners, as given.
        weights: [f64; 3],
    },
    /// A face was named for a point that does not lie on it.
    #[error("the point does not lie on face {face}")]
    NotOnFace {
        /// Face, counted from 0.
        face: usize,
    },
    /// A thing that was made on one surface was used with another.
    #[error("the {thing} belongs to another surface; make it on this one")]
    ForeignSurface {
        /// What belongs elsewhere: a point, a source, a path, a distance.
        thing: &'static str,
    },
    /// A parameter is outside its range.
    #[error("{name} is {value}; it must be {range}")]
    BadParameter {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: String,
        /// The range allowed.
        range: &'static str,
    },
    /// Something other than the factors does not fit into memory.
    #[error("out of memory while {stage}")]
    OutOfMemory {
        /// What was being done.
        stage: &'static str,
    },
}

impl Error {
    /// Names the kind of failure, in kebab case. It stays the same between versions; messages may not.
    pub fn code(&self) -> &'static str {
        self.into()
    }
}
