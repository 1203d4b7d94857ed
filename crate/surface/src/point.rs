//! Points on the surface and sources of distance.

use glam::DVec3;

use crate::error::{Error, Result};
use crate::halfedge::{Face, Halfedge};
use crate::surface::Surface;

/// Barycentric weights may miss a sum of 1, or lie below 0, by this much: more than rounding through 32-bit floats,
/// less than anything seen.
const WEIGHT_TOLERANCE: f64 = 1e-5;

/// A crossing nearer to a vertex or an edge than this share of the edge is on it. Rounding of one crossing is 10⁻¹⁶,
/// of a chain of them far less than this; moving a point by 10⁻¹⁰ of an edge is not seen.
pub const SNAP: f64 = 1e-10;

/// A point of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SurfacePoint {
    /// A welded point.
    Vertex(u32),
    /// A point of an edge.
    Edge {
        /// A half-edge of a triangle or of the boundary.
        halfedge: Halfedge,
        /// Share of the way along it, 0 to 1.
        fraction: f64,
    },
    /// A point of a face.
    Face {
        /// The triangle.
        face: Face,
        /// Barycentric weights of its corners, non-negative, of sum 1.
        weights: [f64; 3],
    },
}

impl SurfacePoint {
    /// The same point with weights cut to their range and made to sum to 1.
    ///
    /// # Errors
    /// [`Error::BadVertex`] for a point that does not exist; [`Error::BadPoint`] for a face or half-edge that does
    /// not exist, and for weights that are further than rounding from their range.
    pub fn validated(self, surface: &Surface) -> Result<Self> {
        let outside = |weight: f64| !(-WEIGHT_TOLERANCE..=1.0 + WEIGHT_TOLERANCE).contains(&weight);
        match self {
            Self::Vertex(point) if (point as usize) < surface.point_count() => Ok(self),
            Self::Vertex(point) => Err(Error::BadVertex {
                vertex: point as usize,
                problem: format!("does not exist; the welded surface has {}", surface.point_count()),
            }),
            Self::Edge { halfedge, fraction } => {
                let bad = |problem: &str| {
                    let face = halfedge.0 as usize / 3;
                    Err(Error::BadPoint { face, weights: format!("{fraction}"), problem: problem.to_owned() })
                };
                if halfedge.0 as usize >= surface.mesh.halfedge_count() {
                    return bad("there is no such half-edge");
                }
                if outside(fraction) {
                    return bad("the fraction along the edge must lie between 0 and 1");
                }
                Ok(Self::Edge { halfedge, fraction: fraction.clamp(0.0, 1.0) })
            }
            Self::Face { face, weights } => {
                let bad = |problem: String| {
                    Err(Error::BadPoint { face: face.0 as usize, weights: format!("{weights:?}"), problem })
                };
                if face.0 as usize >= surface.face_count() {
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

    /// The welded points that span it, with their barycentric weights; points of weight 0 are left out.
    pub fn support(self, surface: &Surface) -> impl Iterator<Item = (u32, f64)> + use<> {
        let (points, weights) = match self {
            Self::Vertex(point) => ([point; 3], [1.0, 0.0, 0.0]),
            Self::Edge { halfedge, fraction } => {
                let [a, b] = surface.ends(halfedge);
                ([a, b, b], [1.0 - fraction, fraction, 0.0])
            }
            Self::Face { face, weights } => (surface.faces[face], weights),
        };
        points.into_iter().zip(weights).filter(|&(_, weight)| weight > 0.0)
    }

    /// The welded point that it is, if it is one.
    pub fn vertex(self, surface: &Surface) -> Option<u32> {
        let mut support = self.support(surface);
        support.next().filter(|_| support.next().is_none()).map(|(point, _)| point)
    }

    /// Its position, in the file's unit.
    pub fn position(self, surface: &Surface) -> DVec3 {
        self.support(surface).map(|(point, weight)| surface.position(point) * weight).sum()
    }

    /// The linear interpolation of values given per point (`#P`).
    pub fn interpolate(self, surface: &Surface, values: &[f64]) -> f64 {
        self.support(surface).map(|(point, weight)| values[point as usize] * weight).sum()
    }

    /// The corner of largest weight.
    pub fn nearest_point(self, surface: &Surface) -> u32 {
        self.support(surface).max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(point, _)| point)
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
                    let edge = Self::Edge { halfedge: Halfedge(face.0 * 3 + i as u32), fraction };
                    edge.snapped_within(surface, share)
                }
            },
        }
    }

    /// The faces that it lies on.
    pub fn faces(self, surface: &Surface) -> Vec<Face> {
        match self {
            Self::Vertex(point) => surface.corners_of_point(point).map(|(face, _)| face).collect(),
            Self::Edge { halfedge, .. } => {
                let [a, b] = surface.ends(halfedge);
                surface.faces_of_edge(a, b).collect()
            }
            Self::Face { face, .. } => vec![face],
        }
    }

    /// Its barycentric weights in one of the faces that it lies on.
    pub fn weights_in(self, surface: &Surface, face: Face) -> [f64; 3] {
        let mut weights = [0.0; 3];
        for (point, weight) in self.support(surface) {
            if let Some(k) = surface.faces[face].iter().position(|&corner| corner == point) {
                weights[k] = weight;
            }
        }
        weights
    }

    /// The point on an edge of `face` at this share of the way from `a` to `b`.
    ///
    /// # Panics
    /// Where the face has no such edge.
    pub fn on_edge(surface: &Surface, face: Face, [a, b]: [u32; 2], share: f64) -> Self {
        let corners = surface.faces[face];
        let k = (0..3).find(|&k| corners[k] == a).expect("an edge of the face");
        let is_along = corners[(k + 1) % 3] == b;
        let (k, fraction) = if is_along { (k, share) } else { ((k + 2) % 3, 1.0 - share) };
        Self::Edge { halfedge: Halfedge(face.0 * 3 + k as u32), fraction }
    }

    /// The connected piece that it lies on.
    pub fn component(self, surface: &Surface) -> u32 {
        surface.component_of_point[self.nearest_point(surface) as usize]
    }
}

/// A source: a point of the surface and the distance that it starts from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    /// Where.
    pub point: SurfacePoint,
    /// Starting value, in the file's unit, 0 or more: distances are the least of starting value plus way.
    pub offset: f64,
}

impl From<SurfacePoint> for Source {
    fn from(point: SurfacePoint) -> Self {
        Self { point, offset: 0.0 }
    }
}

impl From<(SurfacePoint, f64)> for Source {
    fn from((point, offset): (SurfacePoint, f64)) -> Self {
        Self { point, offset }
    }
}

impl Source {
    /// The same source with a valid point.
    ///
    /// # Errors
    /// As [`SurfacePoint::validated`]; [`Error::BadParameter`] for a starting value that is negative or not finite.
    pub fn validated(self, surface: &Surface) -> Result<Self> {
        if !(self.offset.is_finite() && self.offset >= 0.0) {
            let value = self.offset.to_string();
            return Err(Error::BadParameter { name: "the starting value of a source", value, range: "0 or more" });
        }
        Ok(Self { point: self.point.validated(surface)?, offset: self.offset })
    }
}
