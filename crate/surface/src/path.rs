//! Curves on the surface.

use glam::DVec3;

use crate::element::{Element, FaceId, VertexId};
use crate::error::{Error, Result};
use crate::point::Place;
use crate::surface::{Surface, SurfaceId};
use crate::triangle;

/// A point of a [`Path`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PathPoint {
    /// Position, in the file's unit.
    pub position: DVec3,
    /// Where on the surface: at a vertex, on an edge, or inside a face.
    pub location: Place,
    /// The face that the path goes through, or along, after this point; at the last point the one before.
    pub face: FaceId,
}

/// A piecewise straight curve on the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    surface: SurfaceId,
    /// From the start to the end, both included; where they are one, one point.
    pub points: Vec<PathPoint>,
    /// Unit surface normal at each of `points`.
    pub normals: Vec<DVec3>,
}

impl Path {
    /// Of points on the surface; takes the normals there.
    ///
    /// # Panics
    /// For a location or a face that the surface does not have.
    pub fn new(surface: &Surface, points: Vec<PathPoint>) -> Self {
        let normals = points.iter().map(|point| normal(surface, point)).collect();
        Self { surface: surface.id(), points, normals }
    }

    /// The surface that it lies on.
    pub fn surface(&self) -> SurfaceId {
        self.surface
    }

    /// The path along edges through these vertices, as shortest paths along edges give them.
    ///
    /// # Errors
    /// [`Error::NoSuchVertex`]; [`Error::NotAdjacent`] for a vertex that has no edge to the one before it;
    /// [`Error::BadParameter`] where there is no vertex.
    pub fn along_edges(surface: &Surface, through: &[VertexId]) -> Result<Self> {
        let mut points: Vec<PathPoint> = Vec::with_capacity(through.len());
        for &vertex in through {
            let location = surface.point(vertex)?.place();
            let face = match points.last_mut() {
                None => location.faces(surface)[0],
                Some(before) => {
                    let around = before.location.faces(surface);
                    let face = around.into_iter().find(|&face| surface.faces()[face].contains(&vertex));
                    let bad = || Error::NotAdjacent { vertex: vertex.index() };
                    before.face = face.filter(|_| before.location != location).ok_or_else(bad)?;
                    before.face
                }
            };
            points.push(PathPoint { position: surface.position(vertex), location, face });
        }
        if points.is_empty() {
            return Err(Error::BadParameter { name: "path", value: "empty".to_owned(), range: "one point at least" });
        }
        Ok(Self::new(surface, points))
    }

    /// The same places on the same surface in another pose.
    ///
    /// # Errors
    /// [`Error::ForeignSurface`] where it does not lie on `from`, or `to` is not that surface in another pose.
    pub fn carried(&self, from: &Surface, to: &Surface) -> Result<Self> {
        from.require_own(self.surface, "path")?;
        to.require_pose_of(from, "path")?;
        let moved = |point: &PathPoint| PathPoint { position: point.location.position(to), ..*point };
        Ok(Self::new(to, self.points.iter().map(moved).collect()))
    }

    /// Length, in the file's unit.
    pub fn length(&self) -> f64 {
        let segments = self.points.windows(2).map(|ends| triangle::length(ends[1].position - ends[0].position));
        // The empty sum of floats is −0.
        segments.fold(0.0, |sum, segment| sum + segment)
    }
}

fn normal(surface: &Surface, point: &PathPoint) -> DVec3 {
    let normal = match point.location {
        Place::Vertex(vertex) => surface.vertex_normal(vertex),
        Place::Edge { .. } | Place::Face { .. } => {
            let faces = point.location.faces(surface);
            triangle::unit(faces.into_iter().map(|face| surface.face_normal(face)).sum())
        }
    };
    // Faces back to back cancel.
    if normal == DVec3::ZERO { surface.face_normal(point.face) } else { normal }
}
