//! Curves on the surface: down a distance, along edges, straightened, straightest.

pub mod descent;
mod funnel;
mod link;
pub mod straighten;
pub mod straightest;
mod strip;

use glam::DVec3;

use crate::error::{Error, Result};
use crate::halfedge::{Face, Halfedge};
use crate::sources::SurfacePoint;
use crate::surface::Surface;
use crate::triangle;

pub use descent::descend;
pub use straighten::straighten;
pub use straightest::{Straightest, straightest};

/// A crossing nearer to a vertex or an edge than this share of the edge is on it. Rounding of one crossing is 10⁻¹⁶,
/// of a chain of them far less than this; moving a point by 10⁻¹⁰ of an edge is not seen.
pub(crate) const SNAP: f64 = 1e-10;

/// A point of a [`Path`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// Position, in the file's unit.
    pub position: DVec3,
    /// Where on the surface: at a point, on an edge, or inside a face.
    pub location: SurfacePoint,
    /// The face that the path goes through, or along, after this point; at the last point the one before.
    pub face: Face,
}

/// A piecewise straight curve on the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// From the start to the end, both included; where they are one, one point.
    pub points: Vec<PathPoint>,
    /// Unit surface normal at each of `points`.
    pub normals: Vec<DVec3>,
}

impl Path {
    fn new(surface: &Surface, points: Vec<PathPoint>) -> Self {
        let normals = points.iter().map(|point| normal(surface, point)).collect();
        Self { points, normals }
    }

    /// The path along edges through these points, as [`edge_path`](crate::edge_path) gives them.
    ///
    /// # Errors
    /// [`Error::BadVertex`] for a point that does not exist, or that has no edge to the one before it;
    /// [`Error::BadParameter`] where there is no point.
    pub fn along_edges(surface: &Surface, through: &[u32]) -> Result<Self> {
        let mut points: Vec<PathPoint> = Vec::with_capacity(through.len());
        for &point in through {
            let location = SurfacePoint::Vertex(point).validated(surface)?;
            let face = match points.last_mut() {
                None => faces_at(surface, location)[0],
                Some(before) => {
                    let beside = faces_at(surface, before.location);
                    let face = beside.into_iter().find(|&face| surface.faces[face].contains(&point));
                    let problem = || "has no edge to the point before it on the path".to_owned();
                    let bad = || Error::BadVertex { vertex: point as usize, problem: problem() };
                    before.face = face.filter(|_| before.location != location).ok_or_else(bad)?;
                    before.face
                }
            };
            points.push(PathPoint { position: surface.position(point), location, face });
        }
        if points.is_empty() {
            return Err(Error::BadParameter { name: "path", value: "empty".to_owned(), range: "one point at least" });
        }
        Ok(Self::new(surface, points))
    }

    /// Length, in the file's unit.
    pub fn length(&self) -> f64 {
        let pieces = self.points.windows(2).map(|ends| triangle::length(ends[1].position - ends[0].position));
        // The empty sum of floats is −0.
        pieces.fold(0.0, |sum, piece| sum + piece)
    }
}

/// The same point as a vertex or on an edge where it is within `SNAP` of one.
pub(crate) fn snapped(surface: &Surface, location: SurfacePoint) -> SurfacePoint {
    snapped_within(surface, location, SNAP)
}

/// The same point as a vertex or on an edge where its weights or its fraction tell it to be on one.
fn reduced(surface: &Surface, location: SurfacePoint) -> SurfacePoint {
    snapped_within(surface, location, 0.0)
}

fn snapped_within(surface: &Surface, location: SurfacePoint, share: f64) -> SurfacePoint {
    match location {
        SurfacePoint::Vertex(_) => location,
        SurfacePoint::Edge { halfedge, fraction } => {
            let [a, b] = surface.ends(halfedge);
            match fraction {
                _ if fraction <= share => SurfacePoint::Vertex(a),
                _ if fraction >= 1.0 - share => SurfacePoint::Vertex(b),
                _ => location,
            }
        }
        SurfacePoint::Face { face, weights } => match weights.iter().position(|&weight| weight <= share) {
            None => location,
            Some(k) => {
                let [i, j] = [(k + 1) % 3, (k + 2) % 3];
                let fraction = weights[j] / (weights[i] + weights[j]);
                let edge = SurfacePoint::Edge { halfedge: Halfedge(face.0 * 3 + i as u32), fraction };
                snapped_within(surface, edge, share)
            }
        },
    }
}

/// The faces that a point lies on.
pub(crate) fn faces_at(surface: &Surface, location: SurfacePoint) -> Vec<Face> {
    match location {
        SurfacePoint::Vertex(point) => surface.corners_of_point(point).map(|(face, _)| face).collect(),
        SurfacePoint::Edge { halfedge, .. } => {
            let [a, b] = surface.ends(halfedge);
            surface.faces_of_edge(a, b).collect()
        }
        SurfacePoint::Face { face, .. } => vec![face],
    }
}

/// Barycentric weights of a point in one of the faces that it lies on.
pub(crate) fn weights_in(surface: &Surface, location: SurfacePoint, face: Face) -> [f64; 3] {
    let mut weights = [0.0; 3];
    for (point, weight) in location.support(surface) {
        if let Some(k) = surface.faces[face].iter().position(|&corner| corner == point) {
            weights[k] = weight;
        }
    }
    weights
}

/// The point on an edge of `face` at this share of the way from `a` to `b`.
fn crossing(surface: &Surface, face: Face, [a, b]: [u32; 2], share: f64) -> SurfacePoint {
    let corners = surface.faces[face];
    let k = (0..3).find(|&k| corners[k] == a).expect("an edge of the face");
    let is_along = corners[(k + 1) % 3] == b;
    let (k, fraction) = if is_along { (k, share) } else { ((k + 2) % 3, 1.0 - share) };
    SurfacePoint::Edge { halfedge: Halfedge(face.0 * 3 + k as u32), fraction }
}

pub(crate) fn normal(surface: &Surface, point: &PathPoint) -> DVec3 {
    let normal = match point.location {
        SurfacePoint::Vertex(vertex) => surface.point_normal(vertex),
        SurfacePoint::Edge { .. } | SurfacePoint::Face { .. } => {
            let faces = faces_at(surface, point.location);
            triangle::unit(faces.into_iter().map(|face| surface.face_normal(face)).sum())
        }
    };
    // Faces back to back cancel.
    if normal == DVec3::ZERO { surface.face_normal(point.face) } else { normal }
}
