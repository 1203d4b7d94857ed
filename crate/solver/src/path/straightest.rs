//! Straightest geodesics (Polthier and Schmies 1998): as straight as the surface lets a curve be, from a point in a
//! direction. Over an edge the line goes on in the unfolded plane, through a vertex with the same angle on both sides.

use std::f64::consts::PI;

use glam::DVec3;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Element, FaceId, HalfedgeId, Path, PathPoint, Place, SNAP, ToPoint, VertexId, triangle};

use crate::error::{Error, Result};

/// Faces that a walk may enter, or turn past at vertices: far more than any use, and few enough to fit into memory.
const MOST_FACES: usize = 1 << 20;

/// A walk straight on.
#[derive(Debug, Clone, PartialEq)]
pub struct Straightest {
    /// From the start, in order.
    pub path: Path,
    /// Unit vector of the direction at the end, in the plane of the last point's face.
    pub direction: DVec3,
    /// Whether the walk ended where the surface ends, before its length was used up. So it also does at a vertex where
    /// no direction is straight on: one whose faces are not one closed ring.
    pub is_at_boundary: bool,
}

/// Walks straight on from a point of the surface for a length, in the file's unit.
///
/// The direction is a vector in space; only its projection counts. Where `face` is given, it is projected to the plane
/// of that face, which the point must lie on, and turned into the faces beside it where it points out of it. Otherwise
/// the walk begins in the face around the point that the direction agrees with best.
///
/// Over an edge of three faces or more, the walk goes on into the one that is straightest in space.
///
/// # Errors
/// [`Error::Surface`] as [`Surface::point`], and for a face that the point does not
/// lie on; [`Error::BadParameter`] for a direction that is zero, not finite or square to the surface, and for a length
/// that is negative, not finite, or more than a million faces long.
pub fn straightest(
    surface: &Surface,
    from: impl ToPoint,
    face: Option<FaceId>,
    direction: DVec3,
    length: f64,
) -> Result<Straightest> {
    let location = surface.point(from)?.place().snapped(surface);
    if !(length >= 0.0 && length.is_finite()) {
        return Err(Error::BadParameter { name: "length", value: length.to_string(), range: "0 or more, and finite" });
    }
    let bad_direction = || Error::BadParameter {
        name: "direction",
        value: direction.to_string(),
        range: "a finite vector that is not square to the surface",
    };
    if !direction.is_finite() {
        return Err(bad_direction());
    }
    let faces = location.faces(surface);
    let direction = triangle::unit(direction);
    let (face, direction) = match face {
        Some(face) if faces.contains(&face) => (face, in_plane(surface, face, direction)),
        Some(face) => {
            return Err(heatwalk_surface::Error::NotOnFace { face: face.index() }.into());
        }
        None => best_face(surface, location, &faces, direction),
    };
    if direction == DVec3::ZERO {
        return Err(bad_direction());
    }
    let position = location.position(surface);
    let start = PathPoint { position, location, face };
    let mut walk = Walk { surface, points: vec![start], face, direction, left: length, passed: 0 };
    let is_at_boundary = walk.turn_into_surface().is_none() || !walk.run()?;
    if let Some(last) = walk.points.last_mut() {
        last.face = walk.face;
    }
    Ok(Straightest { path: Path::new(surface, walk.points), direction: walk.direction, is_at_boundary })
}

/// Unit vector along the projection to the plane of a face; zero for none.
fn in_plane(surface: &Surface, face: FaceId, direction: DVec3) -> DVec3 {
    // One part in 10¹² is rounding of a vector square to the plane.
    const SQUARE: f64 = 1e-12;
    let projected = direction.reject_from_normalized(surface.face_normal(face));
    if projected.length() > SQUARE { triangle::unit(projected) } else { DVec3::ZERO }
}

/// The face that a direction points into, or that comes nearest to it, with the direction in its plane.
fn best_face(surface: &Surface, location: Place, faces: &[FaceId], direction: DVec3) -> (FaceId, DVec3) {
    let position = location.position(surface);
    let agreement = |face: FaceId| {
        let corners = surface.corners(face);
        let projected = in_plane(surface, face, direction);
        if points_inside(surface, location, face, projected) {
            return (projected.dot(direction), projected);
        }
        // Outside: the best is along one of the sides. Below all that point inside.
        let along = corners.map(|corner| triangle::unit(corner - position)).map(|side| (side.dot(direction), side));
        let best = along.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.0, projected));
        (best.0 - 2.0, projected)
    };
    let best = faces.iter().map(|&face| (face, agreement(face))).max_by(|a, b| a.1.0.total_cmp(&b.1.0));
    best.map_or((FaceId(0), DVec3::ZERO), |(face, (_, projected))| (face, projected))
}

/// Whether a unit vector in the plane of a face leads from a point of it into it, or along its side but for rounding.
fn points_inside(surface: &Surface, location: Place, face: FaceId, direction: DVec3) -> bool {
    let weights = location.weights_in(surface, face);
    let rates = rates(surface, face, direction);
    let edges = triangle::edges(surface.corners(face));
    (0..3).all(|k| weights[k] > 0.0 || rates[k] >= -SNAP * triangle::length(edges[k]))
}

/// How fast the barycentric weights change along a direction, times twice the area.
fn rates(surface: &Surface, face: FaceId, direction: DVec3) -> [f64; 3] {
    let corners = surface.corners(face);
    let normal = triangle::unit(triangle::area_vector(corners));
    triangle::edges(corners).map(|edge| normal.cross(edge).dot(direction))
}

struct Walk<'a> {
    surface: &'a Surface,
    points: Vec<PathPoint>,
    /// The face that is gone through next.
    face: FaceId,
    /// Unit vector in its plane.
    direction: DVec3,
    /// Length still to go.
    left: f64,
    /// Faces that were entered, and those around the vertices that it went through.
    passed: usize,
}

impl Walk<'_> {
    fn here(&self) -> Place {
        self.points[self.points.len() - 1].location
    }

    /// Goes on until the length is used up (true) or the surface ends (false).
    fn run(&mut self) -> Result<bool> {
        while self.passed < MOST_FACES {
            if self.left <= 0.0 {
                return Ok(true);
            }
            self.passed += 1;
            self.cross_face();
            if self.left > 0.0 && self.go_beyond().is_none() {
                return Ok(false);
            }
        }
        let walked = Path::new(self.surface, std::mem::take(&mut self.points)).length();
        let value = (walked + self.left).to_string();
        Err(Error::BadParameter { name: "length", value, range: "at most a million faces long" })
    }

    /// To where the line leaves the face, or to its end.
    fn cross_face(&mut self) {
        let (surface, face, here) = (self.surface, self.face, self.here());
        let weights = here.weights_in(surface, face);
        let rates = rates(surface, face, self.direction);
        let corners = surface.faces()[face];
        let twice_area = triangle::length(triangle::area_vector(surface.corners(face)));
        // Not over an edge that the line is on: its direction may point out by rounding.
        let exit = (0..3)
            .filter(|&k| rates[k] < 0.0 && weights[k] > 0.0)
            .map(|k| (k, weights[k] / -rates[k] * twice_area))
            .min_by(|a, b| a.1.total_cmp(&b.1));
        let location = match exit {
            Some((_, length)) if length > self.left => {
                let rate = self.left / twice_area;
                let inside: [f64; 3] = std::array::from_fn(|k| (weights[k] + rate * rates[k]).max(0.0));
                let sum: f64 = inside.iter().sum();
                self.left = 0.0;
                Place::Face { face, weights: inside.map(|weight| weight / sum) }.snapped(surface)
            }
            Some((exit, length)) => {
                let [i, j] = [(exit + 1) % 3, (exit + 2) % 3];
                let [a, b] = [i, j].map(|k| (weights[k] + length / twice_area * rates[k]).max(0.0));
                Place::on_edge(surface, face, [corners[i], corners[j]], b / (a + b)).snapped(surface)
            }
            // Among the rounding errors of a sliver: along it.
            None => {
                let ahead = (0..3).max_by(|&i, &j| rates[i].total_cmp(&rates[j])).unwrap_or(0);
                Place::Vertex(corners[ahead])
            }
        };
        if self.left > 0.0 {
            self.left -= triangle::length(location.position(surface) - here.position(surface));
        }
        if let Some(last) = self.points.last_mut() {
            last.face = face;
        }
        if here != location {
            self.points.push(PathPoint { position: location.position(surface), location, face });
        }
    }

    /// Into the face after a crossing; `None` where there is none.
    fn go_beyond(&mut self) -> Option<()> {
        // At a vertex: the way back, turned by half of all.
        self.enter(|ring, walk| ring.angle_of(walk.surface, -walk.direction) + 0.5 * ring.total)
    }

    /// From an edge over it, from a vertex at the angle given; `None` where the surface ends.
    fn enter(&mut self, angle: impl Fn(&Ring, &Self) -> f64) -> Option<()> {
        match self.here() {
            Place::Face { .. } => Some(()),
            Place::Edge { halfedge, .. } => self.cross_edge(halfedge),
            Place::Vertex(vertex) => {
                let ring = Ring::around(self.surface, vertex, self.face)?;
                self.passed += ring.faces.len();
                (self.face, self.direction) = ring.direction_at(self.surface, angle(&ring, self));
                Some(())
            }
        }
    }

    /// Unfolds the direction over an edge of the face.
    fn cross_edge(&mut self, halfedge: HalfedgeId) -> Option<()> {
        let [a, b] = self.surface.ends(halfedge);
        let along = triangle::unit(self.surface.position(b) - self.surface.position(a));
        let forward = self.direction.dot(along);
        let sideways = (1.0 - forward * forward).max(0.0).sqrt();
        let beyond = self.surface.faces_of_edge(halfedge).filter(|&face| face != self.face);
        let turned = beyond.map(|face| {
            let direction = along * forward + inward(self.surface, face, [a, b]) * sideways;
            (face, triangle::unit(direction))
        });
        let straight = turned.max_by(|p, q| p.1.dot(self.direction).total_cmp(&q.1.dot(self.direction)));
        (self.face, self.direction) = straight?;
        Some(())
    }

    /// At the start, turns a direction that points out of its face into the face where it belongs; `None` where that
    /// is outside the surface.
    fn turn_into_surface(&mut self) -> Option<()> {
        if points_inside(self.surface, self.here(), self.face, self.direction) {
            return Some(());
        }
        self.enter(|ring, walk| ring.angle_of(walk.surface, walk.direction))
    }
}

/// Unit vector in a face, square to one of its edges, to the inside.
fn inward(surface: &Surface, face: FaceId, [a, b]: [VertexId; 2]) -> DVec3 {
    let apex = surface.faces()[face].into_iter().find(|corner| ![a, b].contains(corner)).expect("three corners");
    let along = triangle::unit(surface.position(b) - surface.position(a));
    triangle::unit((surface.position(apex) - surface.position(a)).reject_from_normalized(along))
}

/// The faces around a vertex in order, where they form one closed ring.
struct Ring {
    vertex: VertexId,
    /// Each with its first and second neighbour of the vertex, and the angle up to its first, radians. The first face
    /// is the one asked for.
    faces: Vec<(FaceId, [VertexId; 2], f64)>,
    /// Sum of the angles.
    total: f64,
}

impl Ring {
    fn around(surface: &Surface, vertex: VertexId, first: FaceId) -> Option<Self> {
        let mut ring = Self { vertex, faces: Vec::new(), total: 0.0 };
        let mut sides = surface.faces()[first].into_iter().filter(|&corner| corner != vertex);
        let mut near = sides.next()?;
        let start = near;
        let mut face = first;
        loop {
            let far = surface.faces()[face].into_iter().find(|&corner| corner != vertex && corner != near)?;
            ring.faces.push((face, [near, far], ring.total));
            ring.total += triangle::angle([vertex, near, far].map(|corner| surface.position(corner)));
            let edge = surface.halfedge_between(vertex, far)?;
            let mut beyond = surface.faces_of_edge(edge).filter(|&other| other != face);
            let (next, None) = (beyond.next()?, beyond.next()) else { return None };
            if far == start || next == first {
                // A second ring may touch this one in the vertex.
                let is_all = ring.faces.len() == surface.corners_of_vertex(vertex).count();
                return is_all.then_some(ring);
            }
            (near, face) = (far, next);
        }
    }

    /// The angle of a direction in the plane of the first face, turning on where it lies outside.
    fn angle_of(&self, surface: &Surface, direction: DVec3) -> f64 {
        let (face, [near, far], _) = self.faces[0];
        let [along, square] = self.frame(surface, face, [near, far]);
        direction.dot(square).atan2(direction.dot(along))
    }

    /// The face and the unit vector in it at an angle.
    fn direction_at(&self, surface: &Surface, angle: f64) -> (FaceId, DVec3) {
        let angle = angle.rem_euclid(self.total);
        let index = self.faces.partition_point(|face| face.2 <= angle).max(1) - 1;
        let (face, sides, before) = self.faces[index];
        let [along, square] = self.frame(surface, face, sides);
        let (sin, cos) = (angle - before).min(PI).sin_cos();
        (face, triangle::unit(along * cos + square * sin))
    }

    /// Unit vectors along a face's first side and square to it, to the inside.
    fn frame(&self, surface: &Surface, face: FaceId, [near, _]: [VertexId; 2]) -> [DVec3; 2] {
        let along = triangle::unit(surface.position(near) - surface.position(self.vertex));
        [along, inward(surface, face, [self.vertex, near])]
    }
}
