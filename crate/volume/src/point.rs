//! Places in a mesh and sources of distance.

use glam::DVec3;
use heatwalk::VertexId;
use heatwalk::surface::index::Bounds;

use crate::boxes::Boxes;
use crate::corner::Corner;
use crate::error::{Error, Result};
use crate::mesh::locate::{GRAZING, weights};
use crate::mesh::{Start, TetId, TetMesh};

/// Barycentric weights may miss a sum of 1, or lie below 0, by this much: more than rounding through 32-bit floats,
/// less than anything seen.
const WEIGHT_TOLERANCE: f64 = 1e-5;

/// A place in a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TetPoint {
    /// A vertex.
    Vertex(VertexId),
    /// A place in a tetrahedron, on one of its faces or on one of its edges.
    Inside {
        /// The tetrahedron.
        tetrahedron: TetId,
        /// Barycentric weights of its corners, non-negative, of sum 1; those of corners that a face or an edge has not are 0.
        weights: [f64; 4],
    },
}

impl TetPoint {
    /// A place whose weights are right up to rounding.
    pub(crate) fn inside(tetrahedron: TetId, weights: [f64; 4]) -> Self {
        let cut = weights.map(|weight| weight.max(0.0));
        let sum: f64 = cut.iter().sum();
        Self::Inside { tetrahedron, weights: cut.map(|weight| weight / sum) }
    }

    /// The same place with weights cut to their range, as a vertex where it is one.
    ///
    /// # Errors
    /// [`Error::NoSuchVertex`]; [`Error::NoSuchTetrahedron`]; [`Error::BadWeights`].
    pub fn checked(self, mesh: &TetMesh) -> Result<Self> {
        match self {
            Self::Vertex(VertexId(vertex)) if (vertex as usize) < mesh.vertex_count() => Ok(self),
            Self::Vertex(VertexId(vertex)) => {
                Err(Error::NoSuchVertex { vertex: vertex as usize, vertices: mesh.vertex_count() })
            }
            Self::Inside { tetrahedron, weights } => {
                let (index, tetrahedra) = (tetrahedron.index(), mesh.tetrahedron_count());
                if index >= tetrahedra {
                    return Err(Error::NoSuchTetrahedron { tetrahedron: index, tetrahedra });
                }
                let sum: f64 = weights.iter().sum();
                let is_right = weights.iter().all(|&weight| weight >= -WEIGHT_TOLERANCE);
                // Written so that not a number is refused.
                if !(is_right && (sum - 1.0).abs() <= WEIGHT_TOLERANCE) {
                    return Err(Error::BadWeights { tetrahedron: index, weights });
                }
                let Self::Inside { weights, .. } = Self::inside(tetrahedron, weights) else { return Ok(self) };
                let corner = weights.iter().position(|&weight| weight == 1.0);
                Ok(corner.map_or(Self::Inside { tetrahedron, weights }, |corner| {
                    Self::Vertex(VertexId(mesh.tetrahedra()[index][corner]))
                }))
            }
        }
    }

    /// The vertices that span it, with their weights; vertices of weight 0 are left out.
    pub fn support(self, mesh: &TetMesh) -> impl Iterator<Item = (VertexId, f64)> + use<> {
        let (vertices, weights) = match self {
            Self::Vertex(vertex) => ([vertex.0; 4], [1.0, 0.0, 0.0, 0.0]),
            Self::Inside { tetrahedron, weights } => (mesh.tetrahedra()[tetrahedron.index()], weights),
        };
        vertices.map(VertexId).into_iter().zip(weights).filter(|&(_, weight)| weight > 0.0)
    }

    /// A path's end there.
    pub(crate) fn corner(self, mesh: &TetMesh) -> Corner {
        let mut support = self.support(mesh).map(|(vertex, _)| vertex.0);
        let start = match (self, [support.next(), support.next(), support.next()]) {
            (Self::Inside { .. }, [Some(a), Some(b), None]) => Start::Edge([a, b]),
            (Self::Inside { tetrahedron, .. }, _) => Start::Inside(tetrahedron.0),
            (Self::Vertex(vertex), _) => Start::Vertex(vertex.0),
        };
        Corner::at(self.position(mesh), start)
    }

    /// Where it is, in the file's unit.
    pub fn position(self, mesh: &TetMesh) -> DVec3 {
        match self {
            Self::Vertex(vertex) => mesh.position(vertex),
            Self::Inside { .. } => self.support(mesh).map(|(vertex, weight)| mesh.position(vertex) * weight).sum(),
        }
    }

    /// The linear interpolation of values given per vertex.
    pub fn interpolate(self, mesh: &TetMesh, values: &[f64]) -> f64 {
        self.support(mesh).map(|(vertex, weight)| values[vertex.0 as usize] * weight).sum()
    }
}

/// Where distance is measured from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TetSource {
    /// The place.
    pub point: TetPoint,
    /// The distance there, in the file's unit: 0 unless the source is to be behind others.
    pub initial_distance: f64,
}

impl TetSource {
    /// The same source if it is in a mesh.
    ///
    /// # Errors
    /// As [`TetPoint::checked`]; [`Error::BadInitialDistance`].
    pub(crate) fn checked(self, mesh: &TetMesh) -> Result<Self> {
        let distance = self.initial_distance;
        if !(distance.is_finite() && distance >= 0.0) {
            return Err(Error::BadInitialDistance { distance });
        }
        Ok(Self { point: self.point.checked(mesh)?, ..self })
    }
}

impl<P: Into<TetPoint>> From<P> for TetSource {
    fn from(point: P) -> Self {
        Self { point: point.into(), initial_distance: 0.0 }
    }
}

impl TetMesh {
    /// The point at a place in space; none outside of the mesh. Where it is on a face, an edge or a vertex, it is in the first of the
    /// tetrahedra there. The first question makes a hierarchy of boxes, of about 16 bytes a tetrahedron, which is kept.
    pub fn locate(&self, place: DVec3) -> Option<TetPoint> {
        let bounds = |tetrahedron: usize| {
            let own = Bounds::of_points(self.corners(TetId(tetrahedron as u32)));
            own.grown(GRAZING * own.size())
        };
        let boxes = self.boxes().get_or_init(|| Boxes::new(self.tetrahedron_count(), bounds));
        let mut first: Option<(u32, [f64; 4])> = None;
        boxes.near(place, |tetrahedron| {
            let is_first = first.is_none_or(|(other, _)| tetrahedron < other);
            if is_first && bounds(tetrahedron as usize).holds(place) {
                let weights = weights(self.scaled_corners(TetId(tetrahedron)), self.scaled(place));
                if weights.iter().all(|&weight| weight >= -GRAZING) {
                    first = Some((tetrahedron, weights));
                }
            }
        });
        first.map(|(tetrahedron, weights)| TetPoint::inside(TetId(tetrahedron), weights))
    }
}

/// A vertex as a place.
impl From<VertexId> for TetPoint {
    fn from(vertex: VertexId) -> Self {
        Self::Vertex(vertex)
    }
}
