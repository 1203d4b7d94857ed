//! Curves on the surface.

use std::collections::HashMap;

use glam::DVec3;

use crate::element::{Element, FaceId, HalfedgeId, VertexId};
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
    /// From the start to the end, both included; where they are one, one point. No place is there twice in a row, and no
    /// coordinate is −0.
    pub points: Vec<PathPoint>,
    /// Unit surface normal at each of `points`.
    pub normals: Vec<DVec3>,
}

impl Path {
    /// Of points on the surface; takes the normals there. Points that follow each other at one place become one.
    ///
    /// # Panics
    /// For a location or a face that the surface does not have.
    pub fn new(surface: &Surface, given: Vec<PathPoint>) -> Self {
        let mut points: Vec<PathPoint> = Vec::with_capacity(given.len());
        for point in given {
            match points.last_mut().filter(|last| last.location.is_at(surface, point.location)) {
                Some(last) => {
                    // What both lie on, and so lies on the faces before and after.
                    let location = last.location.settled(surface);
                    *last = PathPoint { position: location.position(surface), location, face: point.face };
                }
                None => points.push(point),
            }
        }
        // Adding 0 makes −0 to 0.
        points.iter_mut().for_each(|point| point.position += DVec3::ZERO);
        // A path may pass a vertex of many faces as often as it has points.
        let mut of_vertices: HashMap<VertexId, DVec3> = HashMap::new();
        let mut at_vertex = |vertex| *of_vertices.entry(vertex).or_insert_with(|| surface.vertex_normal(vertex));
        let normals = points.iter().map(|point| normal(surface, point, &mut at_vertex)).collect();
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
                    let last = before.location.nearest_vertex(surface);
                    let joining = surface.halfedge_between(last, vertex).filter(|_| last != vertex);
                    let bad = Error::NotAdjacent { vertex: vertex.index() };
                    before.face = joining.map(HalfedgeId::triangle).ok_or(bad)?;
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

    /// This path and then another one of the same surface, which begins where it ends.
    #[must_use]
    pub fn followed_by(&self, surface: &Surface, next: &Self) -> Self {
        Self::new(surface, [self.points.as_slice(), &next.points].concat())
    }

    /// The same path from its end to its start.
    #[must_use]
    pub fn reversed(&self, surface: &Surface) -> Self {
        let faces = self.points.iter().rev().skip(1).map(|point| point.face);
        let last = self.points.first().map(|point| point.face);
        let points = self.points.iter().rev().zip(faces.chain(last));
        Self::new(surface, points.map(|(point, face)| PathPoint { face, ..*point }).collect())
    }

    /// Whether it ends where it begins, after having been elsewhere.
    pub fn is_closed(&self, surface: &Surface) -> bool {
        matches!(self.points[..], [first, .., last] if first.location.is_at(surface, last.location))
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

    /// The positions of the points, each other than the one before: where the path hops between components that touch, two
    /// places have one.
    pub fn positions(&self) -> Vec<DVec3> {
        let mut positions: Vec<DVec3> = self.points.iter().map(|point| point.position).collect();
        positions.dedup();
        positions
    }

    /// Length, in the file's unit.
    pub fn length(&self) -> f64 {
        let segments = self.points.windows(2).map(|ends| triangle::length(ends[1].position - ends[0].position));
        // The empty sum of floats is −0.
        segments.fold(0.0, |sum, segment| sum + segment)
    }
}

fn normal(surface: &Surface, point: &PathPoint, at_vertex: impl FnOnce(VertexId) -> DVec3) -> DVec3 {
    let normal = match point.location {
        Place::Vertex(vertex) => at_vertex(vertex),
        Place::Edge { .. } | Place::Face { .. } => {
            let faces = point.location.faces(surface);
            triangle::unit(faces.into_iter().map(|face| surface.face_normal(face)).sum())
        }
    };
    // Faces back to back cancel.
    if normal == DVec3::ZERO { surface.face_normal(point.face) } else { normal }
}
