//! Places inside of tetrahedra, in the numbers of a file.

use glam::DVec3;
use heatwalk_surface::VertexId;
use heatwalk_volume::{TetMesh, TetPoint, TetSoup};
use thiserror::Error;

/// A place as a caller names it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TetPlace {
    /// A vertex of the file, counted from 0.
    Vertex(usize),
    /// A place in a tetrahedron of the file, counted from 0.
    Inside {
        /// The tetrahedron.
        tetrahedron: usize,
        /// Barycentric weights of its corners in the order of the file, none negative, of sum 1.
        weights: [f64; 4],
    },
    /// Coordinates, in the unit and the axes of the file.
    At(DVec3),
}

/// A place that is not there.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TetPlaceError {
    /// The file has no such vertex.
    #[error("vertex {vertex} does not exist; there are {vertices}, counted from 0")]
    NoSuchVertex {
        /// The vertex.
        vertex: usize,
        /// How many there are.
        vertices: usize,
    },
    /// A vertex that is not of the mesh.
    #[error("vertex {vertex} is in no tetrahedron; choose another")]
    LooseVertex {
        /// The vertex.
        vertex: usize,
    },
    /// The file has no such tetrahedron.
    #[error("tetrahedron {tetrahedron} does not exist; there are {tetrahedra}, counted from 0")]
    NoSuchTetrahedron {
        /// The tetrahedron.
        tetrahedron: usize,
        /// How many there are.
        tetrahedra: usize,
    },
    /// A tetrahedron that is not of the mesh.
    #[error("tetrahedron {tetrahedron} has no volume or repeats an earlier one and was left out; choose another")]
    LeftOut {
        /// The tetrahedron.
        tetrahedron: usize,
    },
    /// Weights that are no place of a tetrahedron.
    #[error("the weights {weights:?} in tetrahedron {tetrahedron} must be 0 or more, and sum to 1")]
    BadWeights {
        /// The tetrahedron.
        tetrahedron: usize,
        /// Its weights.
        weights: [f64; 4],
    },
    /// Coordinates that are in no tetrahedron.
    #[error("the place {} is outside of all tetrahedra; give coordinates inside of one", written(*place))]
    Outside {
        /// Where.
        place: DVec3,
    },
}

fn written(DVec3 { x, y, z }: DVec3) -> String {
    format!("{x},{y},{z}")
}

impl TetPlaceError {
    /// Names the kind of failure, in kebab case.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoSuchVertex { .. } => "no-such-vertex",
            Self::LooseVertex { .. } => "unreferenced-vertex",
            Self::NoSuchTetrahedron { .. } | Self::LeftOut { .. } => "no-such-tetrahedron",
            Self::BadWeights { .. } => "bad-weights",
            Self::Outside { .. } => "outside",
        }
    }
}

impl TetPlace {
    /// The point of a mesh that was built of `soup`.
    ///
    /// # Errors
    /// Where there is none.
    pub fn on(self, soup: &TetSoup, mesh: &TetMesh) -> Result<TetPoint, TetPlaceError> {
        match self {
            Self::Vertex(vertex) => Ok(Self::vertex_of(vertex, soup, mesh)?.into()),
            Self::At(place) => mesh.locate(place).ok_or(TetPlaceError::Outside { place }),
            Self::Inside { tetrahedron, weights } => {
                let tetrahedra = soup.tetrahedra.len();
                let of_input = soup.tetrahedra.get(tetrahedron);
                let of_input = of_input.ok_or(TetPlaceError::NoSuchTetrahedron { tetrahedron, tetrahedra })?;
                let own = mesh.tetrahedron_of_input(tetrahedron).ok_or(TetPlaceError::LeftOut { tetrahedron })?;
                // Its corners may have been turned.
                let weight_of = |vertex: u32| {
                    let input = mesh.input_of_vertex(VertexId(vertex)) as u32;
                    of_input.iter().position(|&corner| corner == input).map_or(0.0, |corner| weights[corner])
                };
                let own_weights = mesh.tetrahedra()[own.index()].map(weight_of);
                let point = TetPoint::Inside { tetrahedron: own, weights: own_weights }.checked(mesh);
                point.map_err(|_| TetPlaceError::BadWeights { tetrahedron, weights })
            }
        }
    }

    /// The vertex of a mesh that was built of `soup` which is this one of the file.
    ///
    /// # Errors
    /// [`TetPlaceError::NoSuchVertex`], [`TetPlaceError::LooseVertex`].
    pub fn vertex_of(vertex: usize, soup: &TetSoup, mesh: &TetMesh) -> Result<VertexId, TetPlaceError> {
        let vertices = soup.positions.len();
        if vertex >= vertices {
            return Err(TetPlaceError::NoSuchVertex { vertex, vertices });
        }
        mesh.vertex_of_input(vertex).ok_or(TetPlaceError::LooseVertex { vertex })
    }
}
