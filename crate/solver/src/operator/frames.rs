//! Tangent planes at the vertices of an intrinsic triangulation: signposts, which tell the direction of each side, and what
//! carries vectors along sides and into faces.
//!
//! Sharp, Soliman, Crane, "Navigating intrinsic triangulations" (2019), for signposts, which flips keep; "The vector heat
//! method" (2019) for transport. Angles around an inner vertex are scaled to sum to 2π. At the boundary, where geometry-central
//! scales them to sum to π, they stay as they are: so flat surfaces stay flat up to their corners.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use heatwalk_sparse::c64;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element, HalfedgeId, VertexId, triangle};

use crate::error::{Error, Result};
use crate::operator::intrinsic::{IntrinsicTriangulation, next, previous};

/// An intrinsic triangulation with a tangent plane at each vertex. A tangent vector at a vertex is a complex number: its
/// length, and its angle from the reference direction, counter-clockwise. Flips keep the planes and their references.
#[derive(Debug, Clone)]
pub struct Frames {
    triangulation: IntrinsicTriangulation,
    /// `3 #F`, angle of each side in the plane of the vertex that it leaves, radians.
    angles: Vec<f64>,
    /// `#V`, angle of all corners at each vertex, radians.
    sums: Vec<f64>,
    /// `#V`, what angles at each vertex are multiplied by.
    scales: Vec<f64>,
    /// `#V`, the side that had the reference direction when the planes were laid out.
    references: Vec<HalfedgeId>,
}

/// A tangent plane in space.
#[derive(Debug, Clone, Copy)]
pub struct TangentPlane {
    /// Of unit length; zero where the normals of the faces cancel.
    pub normal: DVec3,
    /// The direction of the number 1, of unit length, orthogonal to the normal.
    pub reference: DVec3,
}

impl Frames {
    /// Lays out the planes. The reference of a vertex on the boundary is its first side, counter-clockwise, that of another
    /// the lowest that leaves it.
    ///
    /// # Errors
    /// [`Error::NoTangentPlane`] where the triangles around a vertex are several fans, as welded vertices where a surface is
    /// no manifold may have, and of the tufted cover, where a vector in one sheet is mirrored in the other. The half-edge
    /// mesh has a vertex for each fan ([`IntrinsicTriangulation::of_surface`]).
    pub fn new(triangulation: IntrinsicTriangulation) -> Result<Self> {
        let sides = 3 * triangulation.face_count() as u32;
        let origin = |side: u32| triangulation.ends(HalfedgeId(side))[0].index();
        let count = (0..sides).map(origin).max().map_or(0, |last| last + 1);
        let (mut degrees, mut first) = (vec![0; count], vec![None; count]);
        for side in 0..sides {
            let vertex = origin(side);
            degrees[vertex] += 1;
            let is_open = triangulation.twin(HalfedgeId(side)).is_none();
            if is_open || first[vertex].is_none() {
                first[vertex] = Some(side);
            }
        }
        let mut frames = Self {
            angles: vec![0.0; sides as usize],
            sums: vec![0.0; count],
            scales: vec![1.0; count],
            references: Vec::with_capacity(count),
            triangulation,
        };
        for (vertex, first) in first.into_iter().enumerate() {
            let is_whole = first.is_some_and(|first| frames.lay_out(vertex, first) == degrees[vertex]);
            if !is_whole || frames.triangulation.sheets() > 1 {
                return Err(Error::NoTangentPlane { vertex });
            }
        }
        Ok(frames)
    }

    /// Sets the angles of the sides that leave a vertex, from the first on, and returns how many there are.
    fn lay_out(&mut self, vertex: usize, first: u32) -> usize {
        let mut fan = vec![first];
        let mut sum = 0.0;
        loop {
            let last = fan[fan.len() - 1];
            self.angles[last as usize] = sum;
            sum += self.triangulation.corner_angle(last);
            match self.triangulation.twin(HalfedgeId(previous(last))) {
                Some(side) if side.0 == first => {
                    self.scales[vertex] = TAU / sum;
                    break;
                }
                Some(side) => fan.push(side.0),
                None => break,
            }
        }
        for &side in &fan {
            self.angles[side as usize] *= self.scales[vertex];
        }
        self.sums[vertex] = sum;
        self.references.push(HalfedgeId(first));
        fan.len()
    }

    /// Flips edges until the triangulation is Delaunay. The new side of each of the two triangles follows the one before it,
    /// clockwise, by the corner between.
    pub fn flip_to_delaunay(&mut self) {
        let Self { triangulation, angles, scales, .. } = self;
        let sides = 0..3 * triangulation.face_count() as u32;
        triangulation.flip_to_delaunay(sides, |triangulation, slot| {
            let twin = triangulation.twin(HalfedgeId(slot)).map_or(slot, |twin| twin.0);
            let moved = [next(slot), previous(slot), next(twin), previous(twin)];
            // Where these four were before.
            let old = [previous(twin), next(slot), previous(slot), next(twin)].map(|side| angles[side as usize]);
            for (side, angle) in moved.into_iter().zip(old) {
                angles[side as usize] = angle;
            }
            for (side, before) in [(slot, next(twin)), (twin, next(slot))] {
                let scale = scales[triangulation.ends(HalfedgeId(side))[0].index()];
                angles[side as usize] = angles[before as usize] + scale * triangulation.corner_angle(before);
            }
        });
    }

    /// The triangles.
    pub fn triangulation(&self) -> &IntrinsicTriangulation {
        &self.triangulation
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.sums.len()
    }

    /// Angle of all corners at a vertex, radians: 2π less the curvature of an inner one.
    pub fn angle_sum(&self, vertex: VertexId) -> f64 {
        self.sums[vertex.index()]
    }

    /// The direction of a side in the plane of the vertex that it leaves: of absolute value 1.
    pub fn direction(&self, side: HalfedgeId) -> c64 {
        c64::cis(self.angles[side.index()])
    }

    /// What turns a vector at the vertex that a side leaves into the one at the vertex that it enters, along the side: of
    /// absolute value 1. Along the side's twin it is the conjugate.
    pub fn transport(&self, side: HalfedgeId) -> c64 {
        let after = next(side.0);
        let scale = self.scales[self.triangulation.ends(HalfedgeId(after))[0].index()];
        let back = self.angles[after as usize] + scale * self.triangulation.corner_angle(after);
        -c64::cis(back - self.angles[side.index()])
    }

    /// Means of the vectors (`#V`) at the corners of each face (`#F × 2`), in the face's own coordinates: x along the side from
    /// corner 0 to corner 1, y to its left.
    pub fn in_faces(&self, vectors: &[c64]) -> Vec<[f64; 2]> {
        let of_face = |face: u32| {
            let corners = [0, 1, 2].map(|k| self.triangulation.corner_angle(3 * face + k));
            let sides = [0.0, PI - corners[1], PI + corners[0]];
            let corner = |k: usize| {
                let side = HalfedgeId(3 * face + k as u32);
                let vertex = self.triangulation.ends(side)[0].index();
                // Scaled angles agree with those of the face in the middle of the corner.
                let middle = 0.5 * (1.0 - self.scales[vertex]) * corners[k];
                vectors[vertex] * c64::cis(sides[k] - self.angles[side.index()] + middle)
            };
            let mean = (corner(0) + corner(1) + corner(2)) / 3.0;
            [mean.re, mean.im]
        };
        (0..self.triangulation.face_count() as u32).map(of_face).collect()
    }

    /// `#V`, the planes in space, where the first triangles were the faces of this surface
    /// ([`IntrinsicTriangulation::of_surface`]).
    ///
    /// # Panics
    /// Where the surface has another number of vertices, copies counted.
    pub fn in_space(&self, surface: &Surface) -> Vec<TangentPlane> {
        assert_eq!(self.vertex_count(), surface.mesh().vertex_count(), "planes are those of the surface's vertices");
        let mut normals = vec![DVec3::ZERO; self.vertex_count()];
        for face in surface.mesh().faces() {
            let mut corners = surface.corners(face);
            for k in 0..3 {
                let vertex = surface.mesh().vertex(face.halfedge(k));
                normals[vertex.index()] += triangle::angle(corners) * surface.face_normal(face);
                corners.rotate_left(1);
            }
        }
        let plane = |(normal, &side): (DVec3, &HalfedgeId)| {
            let normal = triangle::unit(normal);
            let [start, end] = surface.ends(side);
            let along = triangle::unit(surface.position(end) - surface.position(start));
            TangentPlane { normal, reference: triangle::unit(along - normal * along.dot(normal)) }
        };
        normals.into_iter().zip(&self.references).map(plane).collect()
    }
}

impl TangentPlane {
    /// A tangent vector in space.
    pub fn vector(&self, number: c64) -> DVec3 {
        number.re * self.reference + number.im * self.normal.cross(self.reference)
    }

    /// What of a vector lies in the plane.
    pub fn number(&self, vector: DVec3) -> c64 {
        c64::new(vector.dot(self.reference), vector.dot(self.normal.cross(self.reference)))
    }
}
