//! What can go wrong, with the element at fault and a remedy.

use strum::IntoStaticStr;
use thiserror::Error;

/// Result with this crate's [`enum@Error`].
pub type Result<T> = std::result::Result<T, Error>;

/// Every failure of meshes and distances in space. Vertices and tetrahedra are counted from 0, as the input has them.
#[derive(Debug, Clone, PartialEq, Error, IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Error {
    /// A soup without tetrahedra.
    #[error("there are no tetrahedra: give a tetrahedral mesh, or fill a closed surface")]
    NoTetrahedra,
    /// A tetrahedron names a vertex that is not there.
    #[error("tetrahedron {tetrahedron} names vertex {vertex}, but there are {vertices}")]
    IndexOutOfRange {
        /// The tetrahedron.
        tetrahedron: usize,
        /// What it names.
        vertex: u32,
        /// Number of vertices.
        vertices: usize,
    },
    /// A vertex of a tetrahedron has a coordinate that is infinite or not a number.
    #[error("vertex {vertex} is at {position:?}: every coordinate must be a finite number")]
    NotFinite {
        /// The vertex.
        vertex: u32,
        /// Where it is.
        position: [f64; 3],
    },
    /// So large or so small that squares of lengths are no numbers.
    #[error("the largest coordinate is {size:e}, where it can be {least:e} to {most:e}; scale the mesh")]
    BadSize {
        /// The largest coordinate by size.
        size: f64,
        /// The least that it can be.
        least: f64,
        /// The most that it can be.
        most: f64,
    },
    /// No tetrahedron has a volume.
    #[error("all {tetrahedra} tetrahedra are flat: none has a volume")]
    AllFlat {
        /// How many there are.
        tetrahedra: usize,
    },
    /// More than two tetrahedra share a triangle.
    #[error(
        "tetrahedra {tetrahedra:?} share the triangle of vertices {vertices:?}: two may, so take out those that overlap"
    )]
    NonManifoldFace {
        /// The first three of them.
        tetrahedra: [u32; 3],
        /// Corners of the triangle.
        vertices: [u32; 3],
    },
    /// More than this crate's numbers can count.
    #[error("{count} {what} are more than the {most} that can be numbered")]
    TooMany {
        /// Of what.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many there may be.
        most: usize,
    },
    /// A place at a vertex that is not in the mesh.
    #[error("there is no vertex {vertex}: the mesh has {vertices}, counted from 0")]
    NoSuchVertex {
        /// Its number.
        vertex: usize,
        /// How many there are.
        vertices: usize,
    },
    /// A place in a tetrahedron that is not in the mesh.
    #[error("there is no tetrahedron {tetrahedron}: the mesh has {tetrahedra}, counted from 0")]
    NoSuchTetrahedron {
        /// Its number.
        tetrahedron: usize,
        /// How many there are.
        tetrahedra: usize,
    },
    /// Barycentric weights that are not a point of their tetrahedron.
    #[error("the weights {weights:?} in tetrahedron {tetrahedron} must be 0 or more, and sum to 1")]
    BadWeights {
        /// The tetrahedron.
        tetrahedron: usize,
        /// The weights given.
        weights: [f64; 4],
    },
    /// A distance that a source starts from is negative or not finite.
    #[error("a source starts from the distance {distance}; it must be a finite number, 0 or more")]
    BadInitialDistance {
        /// The distance given.
        distance: f64,
    },
    /// Values of another number than vertices.
    #[error("{values} values were given for {vertices} vertices: give one for each")]
    ValueCount {
        /// Values given.
        values: usize,
        /// Vertices there are.
        vertices: usize,
    },
    /// A level that no surface of equal distance has.
    #[error("a level is {level}; it must be a finite number")]
    BadLevel {
        /// The level given.
        level: f64,
    },
    /// Costs of another number than tetrahedra.
    #[error("{costs} costs were given for {tetrahedra} tetrahedra: give one for each")]
    CostCount {
        /// Costs given.
        costs: usize,
        /// Tetrahedra there are.
        tetrahedra: usize,
    },
    /// A cost out of range.
    #[error(
        "the cost of tetrahedron {tetrahedron} is {cost}; it must be from {least} to {most}, or infinite for a wall"
    )]
    BadCost {
        /// The tetrahedron.
        tetrahedron: usize,
        /// Its cost.
        cost: f64,
        /// The least that is allowed.
        least: f64,
        /// The largest that is allowed.
        most: f64,
    },
    /// A source that walls surround.
    #[error("the source {source_number} lies in a wall: all tetrahedra around it have an infinite cost")]
    SourceInWall {
        /// Its place among the sources, counted from 0.
        source_number: usize,
    },
    /// Costs that leave nothing but walls.
    #[error("every tetrahedron is a wall: give one of them a finite cost")]
    AllWalls,
    /// Start and sources are not connected.
    #[error("no source can be reached from there: the parts are not connected")]
    Unreachable,
    /// A distance or path of another mesh.
    #[error("the {what} belongs to another mesh")]
    ForeignMesh {
        /// What was given.
        what: &'static str,
    },
    /// Linear systems and their options.
    #[error(transparent)]
    Heat(#[from] heatwalk::Error),
}

impl Error {
    /// Names the kind of failure, in kebab case. It stays the same between versions; messages may not.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Heat(error) => error.code(),
            _ => self.into(),
        }
    }
}
