//! Curves on the surface.

use glam::DVec3;

use crate::error::{Error, Result};
use crate::halfedge::Face;
use crate::point::SurfacePoint;
use crate::surface::Surface;
use crate::triangle;

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
    /// Of points on the surface; takes the normals there.
    pub fn new(surface: &Surface, points: Vec<PathPoint>) -> Self {
        let normals = points.iter().map(|point| normal(surface, point)).collect();
        Self { points, normals }
    }

    /// The path along edges through these points, as shortest paths along edges give them.
    ///
    /// # Errors
    /// [`Error::BadVertex`] for a point that does not exist, or that has no edge to the one before it;
    /// [`Error::BadParameter`] where there is no point.
    pub fn along_edges(surface: &Surface, through: &[u32]) -> Result<Self> {
        let mut points: Vec<PathPoint> = Vec::with_capacity(through.len());
        for &point in through {
            let location = SurfacePoint::Vertex(point).validated(surface)?;
            let face = match points.last_mut() {
                None => location.faces(surface)[0],
                Some(before) => {
                    let beside = before.location.faces(surface);
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

fn normal(surface: &Surface, point: &PathPoint) -> DVec3 {
    let normal = match point.location {
        SurfacePoint::Vertex(vertex) => surface.point_normal(vertex),
        SurfacePoint::Edge { .. } | SurfacePoint::Face { .. } => {
            let faces = point.location.faces(surface);
            triangle::unit(faces.into_iter().map(|face| surface.face_normal(face)).sum())
        }
    };
    // Faces back to back cancel.
    if normal == DVec3::ZERO { surface.face_normal(point.face) } else { normal }
}
