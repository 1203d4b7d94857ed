//! Points on the surface and sources of distance.

use glam::DVec3;

use crate::element::{Element, FaceId, HalfedgeId, VertexData, VertexId};
use crate::error::{Error, Result};
use crate::surface::Surface;

/// Barycentric weights may miss a sum of 1, or lie below 0, by this much: more than rounding through 32-bit floats,
/// less than anything seen.
const WEIGHT_TOLERANCE: f64 = 1e-5;

/// A crossing nearer to a vertex or an edge than this share of the edge is on it. Rounding of one crossing is 10⁻¹⁶,
/// of a chain of them far less than this; moving a point by 10⁻¹⁰ of an edge is not seen.
pub const SNAP: f64 = 1e-10;

/// A place on a surface, as a caller gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// A welded vertex.
    Vertex(VertexId),
    /// A point of an edge.
    Edge {
        /// A half-edge of a triangle or of the boundary.
        halfedge: HalfedgeId,
        /// Share of the way along it, 0 to 1.
        fraction: f64,
    },
    /// A point of a face.
    Face {
        /// The triangle.
        face: FaceId,
        /// Barycentric weights of its corners, non-negative, of sum 1.
        weights: [f64; 3],
    },
}

impl Place {
    /// The same point with weights cut to their range and made to sum to 1.
    ///
    /// # Errors
    /// [`Error::BadVertex`] for a point that does not exist; [`Error::BadPoint`] for a face or half-edge that does
    /// not exist, and for weights that are further than rounding from their range.
    pub fn validated(self, surface: &Surface) -> Result<Self> {
        let outside = |weight: f64| !(-WEIGHT_TOLERANCE..=1.0 + WEIGHT_TOLERANCE).contains(&weight);
        match self {
            Self::Vertex(vertex) if vertex.index() < surface.vertex_count() => Ok(self),
            Self::Vertex(vertex) => Err(Error::BadVertex {
                vertex: vertex.index(),
                problem: format!("does not exist; the welded surface has {}", surface.vertex_count()),
            }),
            Self::Edge { halfedge, fraction } => {
                let bad = |problem: &str| {
                    let face = halfedge.triangle().index();
                    Err(Error::BadPoint { face, weights: format!("{fraction}"), problem: problem.to_owned() })
                };
                if halfedge.index() >= surface.mesh().halfedge_count() {
                    return bad("there is no such half-edge");
                }
                if outside(fraction) {
                    return bad("the fraction along the edge must lie between 0 and 1");
                }
                Ok(Self::Edge { halfedge, fraction: fraction.clamp(0.0, 1.0) })
            }
            Self::Face { face, weights } => {
                let bad = |problem: String| {
                    Err(Error::BadPoint { face: face.index(), weights: format!("{weights:?}"), problem })
                };
                if face.index() >= surface.face_count() {
                    return bad(format!("there are only {} faces", surface.face_count()));
                }
                if weights.iter().any(|&weight| outside(weight)) || outside(weights.iter().sum()) {
                    return bad("weights must not be negative and must sum to 1".to_owned());
                }
                let cut = weights.map(|weight| weight.max(0.0));
                let sum: f64 = cut.iter().sum();
                if (sum - 1.0).abs() > WEIGHT_TOLERANCE {
                    return bad("weights must sum to 1".to_owned());
                }
                Ok(Self::Face { face, weights: cut.map(|weight| weight / sum) })
            }
        }
    }

    /// The vertices that span it, with their barycentric weights; vertices of weight 0 are left out.
    pub fn support(self, surface: &Surface) -> impl Iterator<Item = (VertexId, f64)> + use<> {
        let (vertices, weights) = match self {
            Self::Vertex(vertex) => ([vertex; 3], [1.0, 0.0, 0.0]),
            Self::Edge { halfedge, fraction } => {
                let [a, b] = surface.ends(halfedge);
                ([a, b, b], [1.0 - fraction, fraction, 0.0])
            }
            Self::Face { face, weights } => (surface.faces()[face], weights),
        };
        vertices.into_iter().zip(weights).filter(|&(_, weight)| weight > 0.0)
    }

    /// The vertex that it is, if it is one.
    pub fn vertex(self, surface: &Surface) -> Option<VertexId> {
        let mut support = self.support(surface);
        support.next().filter(|_| support.next().is_none()).map(|(vertex, _)| vertex)
    }

    /// Its position, in the file's unit.
    pub fn position(self, surface: &Surface) -> DVec3 {
        self.support(surface).map(|(vertex, weight)| surface.position(vertex) * weight).sum()
    }

    /// The linear interpolation of values given per vertex.
    pub fn interpolate(self, surface: &Surface, values: &VertexData<f64>) -> f64 {
        self.support(surface).map(|(vertex, weight)| values[vertex] * weight).sum()
    }

    /// The corner of largest weight.
    pub fn nearest_vertex(self, surface: &Surface) -> VertexId {
        self.support(surface).max_by(|a, b| a.1.total_cmp(&b.1)).map_or(VertexId(0), |(vertex, _)| vertex)
    }

    /// The same point as a vertex or on an edge where it is within [`SNAP`] of one.
    #[must_use]
    pub fn snapped(self, surface: &Surface) -> Self {
        self.snapped_within(surface, SNAP)
    }

    /// The same point as a vertex or on an edge where its weights or its fraction tell it to be on one.
    #[must_use]
    pub fn reduced(self, surface: &Surface) -> Self {
        self.snapped_within(surface, 0.0)
    }

    fn snapped_within(self, surface: &Surface, share: f64) -> Self {
        match self {
            Self::Vertex(_) => self,
            Self::Edge { halfedge, fraction } => {
                let [a, b] = surface.ends(halfedge);
                match fraction {
                    _ if fraction <= share => Self::Vertex(a),
                    _ if fraction >= 1.0 - share => Self::Vertex(b),
                    _ => self,
                }
            }
            Self::Face { face, weights } => match weights.iter().position(|&weight| weight <= share) {
                None => self,
                Some(k) => {
                    let [i, j] = [(k + 1) % 3, (k + 2) % 3];
                    let fraction = weights[j] / (weights[i] + weights[j]);
                    let edge = Self::Edge { halfedge: face.halfedge(i), fraction };
                    edge.snapped_within(surface, share)
                }
            },
        }
    }

    /// The faces that it lies on.
    pub fn faces(self, surface: &Surface) -> Vec<FaceId> {
        match self {
            Self::Vertex(vertex) => surface.corners_of_vertex(vertex).map(|(face, _)| face).collect(),
            Self::Edge { halfedge, .. } => {
                let [a, b] = surface.ends(halfedge);
                surface.faces_of_edge(a, b).collect()
            }
            Self::Face { face, .. } => vec![face],
        }
    }

    /// Its barycentric weights in one of the faces that it lies on.
    pub fn weights_in(self, surface: &Surface, face: FaceId) -> [f64; 3] {
        let mut weights = [0.0; 3];
        for (vertex, weight) in self.support(surface) {
            if let Some(k) = surface.faces()[face].iter().position(|&corner| corner == vertex) {
                weights[k] = weight;
            }
        }
        weights
    }

    /// The point on an edge of `face` at this share of the way from `a` to `b`.
    ///
    /// # Panics
    /// Where the face has no such edge.
    pub fn on_edge(surface: &Surface, face: FaceId, [a, b]: [VertexId; 2], share: f64) -> Self {
        let corners = surface.faces()[face];
        let k = (0..3).find(|&k| corners[k] == a).expect("an edge of the face");
        let is_along = corners[(k + 1) % 3] == b;
        let (k, fraction) = if is_along { (k, share) } else { ((k + 2) % 3, 1.0 - share) };
        Self::Edge { halfedge: face.halfedge(k), fraction }
    }

    /// The connected component that it lies on.
    pub fn component(self, surface: &Surface) -> u32 {
        surface.component(self.nearest_vertex(surface))
    }
}

/// A source: a point of the surface and the distance that it starts from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    /// Where.
    pub point: Place,
    /// The distance that it starts from, in the file's unit, 0 or more: distances are the least of initial distance plus
    /// length of a path.
    pub initial_distance: f64,
}

impl From<Place> for Source {
    fn from(point: Place) -> Self {
        Self { point, initial_distance: 0.0 }
    }
}

impl From<(Place, f64)> for Source {
    fn from((point, initial_distance): (Place, f64)) -> Self {
        Self { point, initial_distance }
    }
}

impl Source {
    /// The same source with a valid point.
    ///
    /// # Errors
    /// As [`Place::validated`]; [`Error::BadParameter`] for an initial distance that is negative or not finite.
    pub fn validated(self, surface: &Surface) -> Result<Self> {
        if !(self.initial_distance.is_finite() && self.initial_distance >= 0.0) {
            let value = self.initial_distance.to_string();
            return Err(Error::BadParameter { name: "the initial distance of a source", value, range: "0 or more" });
        }
        Ok(Self { point: self.point.validated(surface)?, initial_distance: self.initial_distance })
    }
}
