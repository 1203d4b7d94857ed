//! Points on the surface and sources of distance.

mod walls;

use glam::DVec3;

use crate::element::{Element, FaceId, HalfedgeId, InputVertex, VertexData, VertexId};
use crate::error::{Error, Result};
use crate::surface::{Surface, SurfaceId};

/// Barycentric weights may miss a sum of 1, or lie below 0, by this much: more than rounding through 32-bit floats,
/// less than anything seen.
const WEIGHT_TOLERANCE: f64 = 1e-5;

/// The sum of three weights that were divided by their sum misses 1 by no more than this.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A crossing nearer to a vertex or an edge than this share of the edge is on it. Rounding of one crossing is 10⁻¹⁶,
/// of a chain of them far less than this; moving a point by 10⁻¹⁰ of an edge is not seen.
pub const SNAP: f64 = 1e-10;

/// Places whose barycentric weights differ by no more than this are one: what is left of rounding after some thousand
/// crossings, and far below [`SNAP`], since it may be along the longest edge of a sliver.
const SAME: f64 = 1e-12;

/// A place on a surface, as a caller gives it: numbers of elements and weights, which may not be there or out of range.
///
/// [`Surface::point`] and [`Surface::source`] check it. The methods here are for places that are known to be on the
/// surface given; for others they panic, as an index out of range does.
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
    /// The same place with weights cut to their range and made to sum to 1.
    fn checked(self, surface: &Surface) -> Result<Self> {
        let outside = |weight: f64| !(-WEIGHT_TOLERANCE..=1.0 + WEIGHT_TOLERANCE).contains(&weight);
        match self {
            Self::Vertex(vertex) if vertex.index() < surface.vertex_count() => Ok(self),
            Self::Vertex(vertex) => {
                Err(Error::NoSuchVertex { vertex: vertex.index(), vertices: surface.vertex_count() })
            }
            Self::Edge { halfedge, fraction } => {
                let (index, halfedges) = (halfedge.index(), surface.mesh().halfedge_count());
                if index >= halfedges {
                    return Err(Error::NoSuchHalfedge { halfedge: index, halfedges });
                }
                if outside(fraction) {
                    return Err(Error::BadFraction { halfedge: index, fraction });
                }
                Ok(Self::Edge { halfedge, fraction: fraction.clamp(0.0, 1.0) })
            }
            Self::Face { face, weights } => {
                if face.index() >= surface.face_count() {
                    return Err(Error::NoSuchFace { face: face.index(), faces: surface.face_count() });
                }
                let cut = weights.map(|weight| weight.max(0.0));
                let sum: f64 = cut.iter().sum();
                let is_outside = weights.iter().any(|&weight| outside(weight)) || outside(weights.iter().sum());
                if is_outside || (sum - 1.0).abs() > WEIGHT_TOLERANCE {
                    return Err(Error::BadWeights { face: face.index(), weights });
                }
                // A place that was checked before stays the same, bit by bit.
                let scale = if (sum - 1.0).abs() <= ROUNDING { 1.0 } else { sum };
                Ok(Self::Face { face, weights: cut.map(|weight| weight / scale) })
            }
        }
    }

    /// The vertices that span it, with their barycentric weights; vertices of weight 0 are left out.
    #[inline]
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
    #[inline]
    pub fn vertex(self, surface: &Surface) -> Option<VertexId> {
        let mut support = self.support(surface);
        support.next().filter(|_| support.next().is_none()).map(|(vertex, _)| vertex)
    }

    /// Its position, in the file's unit.
    #[inline]
    pub fn position(self, surface: &Surface) -> DVec3 {
        self.support(surface).map(|(vertex, weight)| surface.position(vertex) * weight).sum()
    }

    /// The linear interpolation of values given per vertex.
    #[inline]
    pub fn interpolate(self, surface: &Surface, values: &VertexData<f64>) -> f64 {
        self.support(surface).map(|(vertex, weight)| values[vertex] * weight).sum()
    }

    /// The corner of largest weight.
    pub fn nearest_vertex(self, surface: &Surface) -> VertexId {
        self.support(surface).max_by(|a, b| a.1.total_cmp(&b.1)).map_or(VertexId(0), |(vertex, _)| vertex)
    }

    /// The same point as a vertex or on an edge where it is within [`SNAP`] of one.
    #[must_use]
    #[inline]
    pub fn snapped(self, surface: &Surface) -> Self {
        self.snapped_within(surface, SNAP)
    }

    /// The same point as a vertex or on an edge where its weights or its fraction tell it to be on one.
    #[must_use]
    pub fn reduced(self, surface: &Surface) -> Self {
        self.snapped_within(surface, 0.0)
    }

    /// The same point as a vertex or on an edge where it [is at](Self::is_at) one.
    #[must_use]
    pub(crate) fn settled(self, surface: &Surface) -> Self {
        self.snapped_within(surface, SAME)
    }

    /// Whether another place of the same component is this one but for rounding.
    pub fn is_at(self, surface: &Surface, other: Self) -> bool {
        let weight_of =
            |vertex| other.support(surface).find(|&(corner, _)| corner == vertex).map_or(0.0, |found| found.1);
        self.support(surface).all(|(vertex, weight)| (weight - weight_of(vertex)).abs() <= SAME)
    }

    /// The same point as a vertex or on an edge where it is no farther from one than this share of the edges.
    #[must_use]
    pub fn snapped_within(self, surface: &Surface, share: f64) -> Self {
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
            Self::Edge { halfedge, .. } => surface.faces_of_edge(halfedge).collect(),
            Self::Face { face, .. } => vec![face],
        }
    }

    /// Whether it lies on a face.
    pub fn lies_on(self, surface: &Surface, face: FaceId) -> bool {
        self.support(surface).all(|(vertex, _)| surface.faces()[face].contains(&vertex))
    }

    /// Its barycentric weights in one of the faces that it lies on.
    #[inline]
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
    #[inline]
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

impl From<VertexId> for Place {
    fn from(vertex: VertexId) -> Self {
        Self::Vertex(vertex)
    }
}

/// A point of a surface: a [`Place`] that is there, with weights in their range, and the surface that it belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    surface: SurfaceId,
    place: Place,
}

impl SurfacePoint {
    /// Where it is.
    pub fn place(&self) -> Place {
        self.place
    }

    /// The surface that it belongs to.
    pub fn surface(&self) -> SurfaceId {
        self.surface
    }
}

/// A source of distance: a point of a surface, and the distance that it starts from. Distances are the least of initial
/// distance plus length of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    point: SurfacePoint,
    initial_distance: f64,
}

impl Source {
    /// Where.
    pub fn point(&self) -> SurfacePoint {
        self.point
    }

    /// The place of its point.
    pub fn place(&self) -> Place {
        self.point.place
    }

    /// In the file's unit, 0 or more.
    pub fn initial_distance(&self) -> f64 {
        self.initial_distance
    }

    /// The same source, starting from another distance where that is less.
    #[must_use]
    pub fn from_at_most(self, initial_distance: f64) -> Self {
        Self { initial_distance: self.initial_distance.min(initial_distance), ..self }
    }
}

impl From<SurfacePoint> for Source {
    fn from(point: SurfacePoint) -> Self {
        Self { point, initial_distance: 0.0 }
    }
}

/// What becomes a point of a surface by a check: a [`Place`], a [`VertexId`] or an [`InputVertex`], that it is there; a [`SurfacePoint`], that it
/// belongs to this surface.
pub trait ToPoint: Copy {
    /// The point of this surface.
    ///
    /// # Errors
    /// [`Error::NoSuchVertex`], [`Error::NoSuchFace`], [`Error::NoSuchHalfedge`]; [`Error::BadWeights`] and
    /// [`Error::BadFraction`] for weights that are further than rounding from their range; [`Error::ForeignSurface`] for a
    /// point of another surface.
    fn to_point(self, surface: &Surface) -> Result<SurfacePoint>;
}

impl ToPoint for Place {
    fn to_point(self, surface: &Surface) -> Result<SurfacePoint> {
        Ok(SurfacePoint { surface: surface.id(), place: self.checked(surface)? })
    }
}

impl ToPoint for VertexId {
    fn to_point(self, surface: &Surface) -> Result<SurfacePoint> {
        Place::Vertex(self).to_point(surface)
    }
}

/// What became of a vertex of the input; [`Error::UnreferencedVertex`] where that is nothing.
impl ToPoint for InputVertex {
    fn to_point(self, surface: &Surface) -> Result<SurfacePoint> {
        surface.require_vertex(self)?.to_point(surface)
    }
}

impl ToPoint for SurfacePoint {
    fn to_point(self, surface: &Surface) -> Result<SurfacePoint> {
        surface.require_own(self.surface, "point")?;
        Ok(self)
    }
}

/// What becomes a source on a surface by a check: anything that becomes a point, alone (then it starts from 0) or with its
/// initial distance; a [`Source`], that it belongs to this surface.
pub trait ToSource: Copy {
    /// The source on this surface.
    ///
    /// # Errors
    /// As [`ToPoint::to_point`]; [`Error::BadParameter`] for an initial distance that is negative or not finite;
    /// [`Error::SourceInWall`].
    fn to_source(self, surface: &Surface) -> Result<Source>;
}

impl<P: ToPoint> ToSource for P {
    fn to_source(self, surface: &Surface) -> Result<Source> {
        surface.source(self, 0.0)
    }
}

/// A point with its initial distance.
impl<P: ToPoint> ToSource for (P, f64) {
    fn to_source(self, surface: &Surface) -> Result<Source> {
        surface.source(self.0, self.1)
    }
}

impl ToSource for Source {
    fn to_source(self, surface: &Surface) -> Result<Source> {
        surface.require_own(self.point.surface, "source")?;
        Ok(self)
    }
}

impl Surface {
    /// The point of this surface at a place, checked once and for all.
    ///
    /// # Errors
    /// As [`ToPoint::to_point`].
    pub fn point(&self, place: impl ToPoint) -> Result<SurfacePoint> {
        place.to_point(self)
    }

    /// The source at a place that starts from a distance, in the file's unit, 0 or more.
    ///
    /// # Errors
    /// As [`ToSource::to_source`].
    pub fn source(&self, place: impl ToPoint, initial_distance: f64) -> Result<Source> {
        if !(initial_distance.is_finite() && initial_distance >= 0.0) {
            let value = initial_distance.to_string();
            return Err(Error::BadParameter { name: "the initial distance of a source", value, range: "0 or more" });
        }
        let point = place.to_point(self)?;
        if self.is_in_wall(point.place) {
            let face = point.place.faces(self)[0];
            return Err(Error::SourceInWall { face: self.triangle_of_face(face).0 });
        }
        Ok(Source { point, initial_distance })
    }
}
