//! Tangent planes at places, and the directions of half-edges in them.

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use heatwalk_sparse::c64;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{CutVertex, HalfedgeId, Place, VertexId, triangle};

use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, Heading};
use crate::operator::TangentPlane;

/// A vector whose part along the surface is a smaller share of it is square to the surface: rounding.
const SQUARE: f64 = 1e-12;

/// Where the normal is nearer to the x axis than 45°, directions are measured from the y axis unless another direction is given.
const STEEP: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// The plane at a place.
#[derive(Debug)]
pub(crate) struct Plane {
    /// In space.
    tangent: TangentPlane,
    /// Half-edges that [`Heading`]s may be measured from, with their angles: at a vertex those that leave it, at other places the first of each face.
    sides: Vec<(u32, f64)>,
    /// What angles from those half-edges are multiplied by.
    scale: f64,
}

impl Plane {
    /// At a place of the geometry's surface.
    ///
    /// # Errors
    /// [`Error::BadParameter`] where there is none, as on an edge of three faces or more.
    pub fn at(geometry: &ExactGeometry, place: Place) -> Result<Self> {
        let surface = geometry.surface();
        let (plane, place) = match geometry.settled(place) {
            Place::Vertex(vertex) => (Self::at_vertex(geometry, vertex), format!("at vertex {}", vertex.0)),
            Place::Edge { halfedge, .. } => {
                let [a, b] = surface.ends(halfedge);
                (Self::on_edge(geometry, halfedge), format!("on the edge of vertices {} and {}", a.0, b.0))
            }
            Place::Face { face, .. } => {
                let [a, b, _] = surface.corners(face);
                let (normal, reference) = (surface.face_normal(face), triangle::unit(b - a));
                let tangent = TangentPlane { normal, reference };
                (Some(Self { tangent, sides: vec![(3 * face.0, 0.0)], scale: 1.0 }), format!("in face {}", face.0))
            }
        };
        let range = "where the triangles around it are one ring or fan of one orientation";
        plane.ok_or(Error::BadParameter { name: "the source", value: place, range })
    }

    /// At a vertex; none where the triangles around it are not one fan.
    pub fn at_vertex(geometry: &ExactGeometry, vertex: VertexId) -> Option<Self> {
        let plane = Self::of_fan(geometry, CutVertex(vertex.0));
        (plane.sides.len() == geometry.surface().corners_of_vertex(vertex).count()).then_some(plane)
    }

    /// At a vertex of the half-edge mesh, by the triangles of its fan alone. The reference is that of [`Frames`](crate::operator::Frames).
    pub fn of_fan(geometry: &ExactGeometry, copy: CutVertex) -> Self {
        let surface = geometry.surface();
        let mesh = surface.mesh();
        let mut fan: Vec<u32> =
            mesh.outgoing(copy).filter(|&side| !mesh.is_boundary(mesh.face(side))).map(|side| side.0).collect();
        fan.reverse();
        if !mesh.is_boundary_vertex(copy) {
            let lowest = (0..fan.len()).min_by_key(|&place| fan[place]).unwrap_or(0);
            fan.rotate_left(lowest);
        }
        let mut sum = 0.0;
        let with_angle = |side: u32| {
            let (frame, k) = geometry.frame_of(side);
            let angle = sum;
            sum += frame[k].sin.atan2(frame[k].cos);
            (side, angle)
        };
        let mut sides: Vec<(u32, f64)> = fan.into_iter().map(with_angle).collect();
        let scale = if mesh.is_boundary_vertex(copy) { 1.0 } else { TAU / sum };
        sides.iter_mut().for_each(|(_, angle)| *angle *= scale);
        let normal = surface.vertex_normal(surface.vertex_of_cut(copy));
        let tangent = tangent(surface, HalfedgeId(sides[0].0), normal);
        Self { tangent, sides, scale }
    }

    /// On an edge; none where it has three faces or more, or two of different orientations.
    fn on_edge(geometry: &ExactGeometry, halfedge: HalfedgeId) -> Option<Self> {
        let surface = geometry.surface();
        let mesh = surface.mesh();
        let along = if mesh.is_boundary(mesh.face(halfedge)) { mesh.twin(halfedge) } else { halfedge };
        let across: Vec<(u32, bool)> = geometry.across(along.0).collect();
        let against = match across[..] {
            [] => None,
            [(side, false)] => Some(side),
            _ => return None,
        };
        // The first side of the face, seen from this one.
        let first = |side: u32| {
            let frame = geometry.frame_of(side).0;
            let angle = |corner: usize| frame[corner].sin.atan2(frame[corner].cos);
            (side - side % 3, [0.0, angle(1) - PI, -PI - angle(0)][side as usize % 3])
        };
        let turned = |(side, angle): (u32, f64)| (side, angle + PI);
        let sides: Vec<_> = [first(along.0)].into_iter().chain(against.map(|side| turned(first(side)))).collect();
        let normal = sides.iter().map(|&(side, _)| surface.face_normal(HalfedgeId(side).triangle())).sum();
        Some(Self { tangent: tangent(surface, along, triangle::unit(normal)), sides, scale: 1.0 })
    }

    /// The tangent vector to a vector in space.
    ///
    /// # Errors
    /// [`Error::BadParameter`] of this name for one that is not finite, or has no part along the plane.
    pub fn number(&self, name: &'static str, vector: DVec3) -> Result<c64> {
        let bad = || Error::BadParameter {
            name,
            value: vector.to_string(),
            range: "a finite vector that is not square to the surface",
        };
        let number = self.tangent.number(vector);
        // Of a vector that is not finite, or zero, the comparison does not hold.
        if vector.is_finite() && number.norm() > SQUARE * triangle::length(vector) { Ok(number) } else { Err(bad()) }
    }

    /// The unit vector that a log map has for u: along this direction, or without one along the x axis, or the y axis where that is steep.
    ///
    /// # Errors
    /// Those of [`Self::number`].
    pub fn first_axis(&self, direction: Option<DVec3>) -> Result<c64> {
        let direction = direction.unwrap_or(if self.tangent.normal.x.abs() > STEEP { DVec3::Y } else { DVec3::X });
        let u = self.number("the direction", direction)?;
        Ok(u / u.norm())
    }

    /// The unit vectors in space along u and v, which is to the left of u. No coordinate is −0.
    pub fn axes(&self, u: c64) -> [DVec3; 2] {
        [u, u * c64::new(0.0, 1.0)].map(|axis| self.tangent.vector(axis) + DVec3::ZERO)
    }

    /// The half-edge that directions may be measured from: at places that are no vertex the first one of a triangle that they are in.
    pub fn first_side(&self) -> HalfedgeId {
        HalfedgeId(self.sides[0].0)
    }

    /// The vector in space.
    pub fn vector(&self, number: c64) -> DVec3 {
        self.tangent.vector(number)
    }

    /// The angle of a direction, radians.
    pub fn angle(&self, heading: &Heading) -> f64 {
        let side = self.sides.iter().find(|(side, _)| *side == heading.side);
        side.expect("headings are measured from the sides of their plane").1 + self.scale * heading.direction.arg()
    }
}

/// The plane of this normal, where the direction of a half-edge is 1.
fn tangent(surface: &Surface, along: HalfedgeId, normal: DVec3) -> TangentPlane {
    let [start, end] = surface.ends(along).map(|vertex| surface.position(vertex));
    let along = triangle::unit(end - start);
    TangentPlane { normal, reference: triangle::unit(along - normal * along.dot(normal)) }
}
