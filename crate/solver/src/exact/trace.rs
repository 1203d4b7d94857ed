//! Shortest paths, traced back through the faces that their windows crossed.

use heatwalk_surface::{FaceId, HalfedgeId, Path, PathPoint, Place, VertexId};

use super::goal::Goal;
use super::origin::Origin;
use super::portals::Portals;
use super::ray::{Found, Ray};
use super::roots::Root;
use super::wavefront::Wavefront;
use crate::dijkstra;
use crate::error::{Error, Result};

/// A line back is longer than the distance says by no more than this share of it.
const STRAIGHT: f64 = 1e-9;

/// Where a path has come to.
#[derive(Debug, Clone, Copy)]
struct Stop {
    location: Place,
    value: f64,
    origin: Origin,
}

impl Wavefront {
    /// The shortest path from a vertex to its source; its value must be final.
    ///
    /// # Errors
    /// [`Error::Unreachable`] where the value is infinite; `NoSuchVertex` where there is no such vertex.
    pub fn path_from_vertex(&self, vertex: VertexId) -> Result<Path> {
        self.surface.point(vertex)?;
        self.path_from(self.at_vertex(vertex.0))
    }

    /// The shortest path from a target to its source; its value must be final.
    ///
    /// # Errors
    /// [`Error::Unreachable`] where the value is infinite.
    pub fn path_from_target(&self, index: usize) -> Result<Path> {
        let targets = &self.targets;
        let (location, value) = (targets.locations[index], targets.values[index]);
        let stop = Stop { location, value, origin: targets.origins[index] };
        // Rounding may have found the vertex itself sooner.
        let vertex = match location {
            Place::Vertex(vertex) => Some(self.at_vertex(vertex.0)),
            _ => None,
        };
        self.path_from(vertex.filter(|vertex| vertex.value < value).unwrap_or(stop))
    }

    fn at_vertex(&self, vertex: u32) -> Stop {
        let (value, origin) = (self.values[VertexId(vertex)], self.origins[vertex as usize]);
        Stop { location: Place::Vertex(VertexId(vertex)), value, origin }
    }

    fn path_from(&self, start: Stop) -> Result<Path> {
        let mut trace = Trace { front: self, points: Vec::new() };
        let face = self.geometry.faces_at(&self.surface, start.location).first().map_or(0, |&(face, _)| face);
        trace.go(start.location, face);
        let mut stop = start;
        // Values of vertices on the way fall strictly, so that each is passed once.
        loop {
            let (root, last) = match stop.origin {
                // No path goes on from one portal to the next without a way between.
                Origin::None | Origin::Portal => return Err(Error::Unreachable),
                Origin::Straight { face, root } => (root, Some((self.foot_of_root(root, face, stop.location), face))),
                Origin::Window { halfedge, root, at, x, depth } => {
                    let ray = Ray { halfedge, at, x, depth };
                    match trace.follow_straight(&stop, root, ray) {
                        Some(End::Root(place, face)) => (root, Some((place, face))),
                        Some(End::Vertex(vertex, face)) => {
                            trace.go(Place::Vertex(VertexId(vertex)), face);
                            stop = self.at_vertex(vertex);
                            continue;
                        }
                        None => match trace.step_aside(&stop) {
                            Some(vertex) => {
                                stop = self.at_vertex(vertex);
                                continue;
                            }
                            None => {
                                trace.take_edges(&stop, root);
                                (root, None)
                            }
                        },
                    }
                }
            };
            last.into_iter().for_each(|(place, face)| trace.go(place, face));
            stop = match self.root(root) {
                Root::Source(_) | Root::Side(_) => break,
                Root::Vertex(vertex) => self.at_vertex(vertex.0),
                Root::End(end) => {
                    let stop = self.at_end(Portals::across(end));
                    let faces = self.geometry.faces_at(&self.surface, stop.location);
                    trace.hop(stop.location, faces.first().map_or(0, |&(face, _)| face));
                    stop
                }
            };
        }
        Ok(Path::new(&self.surface, trace.points))
    }

    fn at_end(&self, end: u32) -> Stop {
        let (ends, end) = (&self.ends, end as usize);
        Stop { location: ends.locations[end], value: ends.values[end], origin: ends.origins[end] }
    }
}

/// How a straight line back ends, with the last face it goes through.
enum End {
    Root(Place, u32),
    Vertex(u32, u32),
}

struct Trace<'a> {
    front: &'a Wavefront,
    points: Vec<PathPoint>,
}

impl Trace<'_> {
    /// Appends a straight segment through `face`.
    fn go(&mut self, location: Place, face: u32) {
        let position = location.position(&self.front.surface);
        let face = FaceId(face);
        if let Some(last) = self.points.last_mut() {
            if last.location == location {
                return;
            }
            last.face = face;
        }
        self.points.push(PathPoint { position, location, face });
    }

    /// Appends a point of another component, which begins in `face`.
    fn hop(&mut self, location: Place, face: u32) {
        let position = location.position(&self.front.surface);
        self.points.push(PathPoint { position, location, face: FaceId(face) });
    }

    /// [Follows](Self::follow) a straight line back, if that is as long as the distance says: where triangles are flat, rounding may
    /// lead the line to and fro along their edges.
    fn follow_straight(&mut self, start: &Stop, root: u32, first: Ray) -> Option<End> {
        let (front, begin) = (self.front, self.points.len());
        let end = self.follow(start, root, first)?;
        let (last, value, face) = match end {
            End::Root(place, face) => (place, front.value_of_root(root), face),
            End::Vertex(vertex, face) => (Place::Vertex(VertexId(vertex)), front.values[VertexId(vertex)], face),
        };
        let places = self.points[begin - 1..].iter().map(|point| point.position).chain([last.position(&front.surface)]);
        let length: f64 = places.clone().zip(places.skip(1)).map(|(a, b)| a.distance(b)).sum();
        let [a, b, _] = front.surface.corners(FaceId(face));
        let cost = front.geometry.frame(face)[0].length / a.distance(b);
        let is_straight = cost * length <= (start.value - value) * (1.0 + STRAIGHT) + front.geometry.grain;
        if !is_straight {
            self.points.truncate(begin);
        }
        is_straight.then_some(end)
    }

    /// Follows the straight line from a place back to a root, or to a vertex on it; `None` where it is lost.
    ///
    /// Where several faces lie across an edge the line is in one of them; the others do not meet the root at its
    /// distance. They are tried in turn.
    fn follow(&mut self, start: &Stop, root: u32, first: Ray) -> Option<End> {
        let front = self.front;
        let mut steps_left = 8 * front.geometry.frames.len() + 64;
        // Faces still to try: the ray, the half-edge to enter by, whether mirrored, and the length of the path before.
        let mut open: Vec<(Ray, u32, bool, usize)> = Vec::new();
        let mut ray = first;
        let begin = self.points.len();
        let near = first.near(front.geometry.grain);
        let source = front.goal(root);
        loop {
            let inside = ray.halfedge / 3;
            if let Some(vertex) = front.passes(start.value, root, &ray) {
                return Some(End::Vertex(vertex, inside));
            }
            let (frame, k) = front.geometry.frame_of(ray.halfedge);
            let fraction = (ray.at / frame[k].length).clamp(0.0, 1.0);
            self.go(Place::Edge { halfedge: HalfedgeId(ray.halfedge), fraction }, inside);
            let length = self.points.len();
            open.extend(
                front.geometry.across(ray.halfedge).map(|(halfedge, is_mirrored)| (ray, halfedge, is_mirrored, length)),
            );
            loop {
                let next = open.pop().filter(|_| steps_left > 0);
                let Some((from, halfedge, is_mirrored, length)) = next else {
                    self.points.truncate(begin);
                    return None;
                };
                steps_left -= 1;
                self.points.truncate(length);
                match front.step(from, (halfedge, is_mirrored), (source, near)) {
                    Found::Arrived(weights) => {
                        let face = FaceId(halfedge / 3);
                        let place = match source {
                            Goal::Place(_) => front.place_of_root(root),
                            Goal::Side(_) => Place::Face { face, weights },
                        };
                        return Some(End::Root(place, face.0));
                    }
                    Found::Leaves(next, _) => {
                        ray = next;
                        break;
                    }
                    Found::Lost => {}
                }
            }
        }
    }

    /// Goes straight to the corner of a face here by which the source is nearest instead, if that is nearer than here: where rounding
    /// lost the line, it passes that corner by about as little. Returns the corner.
    fn step_aside(&mut self, start: &Stop) -> Option<u32> {
        let (face, corner) = self.front.nearer_corner(start.location, start.value)?;
        self.go(Place::Vertex(VertexId(corner)), face);
        Some(corner)
    }

    /// Goes along edges to a root's nearest corner instead: where rounding lost the line.
    fn take_edges(&mut self, start: &Stop, root: u32) {
        let front = self.front;
        let goal = front.place_of_root(root).nearest_vertex(&front.surface);
        let from = start.location.nearest_vertex(&front.surface);
        let path = dijkstra::nearest_goal(&front.surface, from, |vertex| vertex == goal).unwrap_or_default();
        for vertex in path {
            let next = Place::Vertex(vertex);
            let last = self.points[self.points.len() - 1].location;
            let face = self.shared_face(last, next);
            self.go(next, face);
        }
        let location = front.place_of_root(root);
        let face = self.shared_face(Place::Vertex(goal), location);
        self.go(location, face);
    }

    fn shared_face(&self, a: Place, b: Place) -> u32 {
        let surface = &self.front.surface;
        let shared = a.faces(surface).into_iter().find(|&face| b.lies_on(surface, face));
        shared.expect("neighbours along an edge, and a location and its nearest corner, share a face").0
    }
}
