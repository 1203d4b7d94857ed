//! Straight lines from a place, through the faces around it, to what they meet first.

use std::collections::HashMap;
use std::sync::Arc;

use heatwalk_surface::{FaceId, HalfedgeId, PathPoint, Place, Source, VertexData, VertexId};

use crate::exact::Crossing;
use crate::exact::geometry::{ExactGeometry, Frame, after, before};
use crate::exact::points::PointsInFaces;
use crate::exact::portals::Portals;
use crate::exact::window::{Beam, length};
use crate::extremum::{larger, smaller};

/// What is known of distances from sources.
#[derive(Debug)]
pub(super) struct Known<'a> {
    pub geometry: &'a Arc<ExactGeometry>,
    /// `#V`, those of vertices.
    pub values: &'a VertexData<f64>,
    pub sources: Vec<Source>,
    pub sources_in_faces: PointsInFaces,
}

impl Known<'_> {
    // Four copies would be a kilobyte of the page's module.
    #[inline(never)]
    pub fn point(&self, location: Place, face: u32) -> PathPoint {
        PathPoint { position: location.position(&self.geometry.surface), location, face: FaceId(face) }
    }
}

/// Where a straight line ends.
#[derive(Debug, Clone, Copy)]
pub(crate) enum End {
    Vertex(VertexId),
    Source(u32),
}

/// The end of the shortest path found.
#[derive(Debug)]
pub(super) struct Found {
    /// In this face.
    face: u32,
    /// By way of this step.
    step: u32,
    pub end: End,
}

/// A step on the way of lines.
#[derive(Debug, Clone, Copy)]
enum Step {
    /// They go out from a place.
    Start(Place),
    /// They cross an edge, from one half-edge to another, after a step.
    Cross { out: u32, into: u32, after: u32 },
    /// They go on from the other end of a portal, one end of which they have reached in a face, after a step.
    Emerge { end: u32, face: u32, after: u32 },
}

/// Straight lines from a place.
pub(super) struct Lines<'a> {
    known: &'a Known<'a>,
    /// The length of the shortest path found.
    pub least: f64,
    pub found: Option<Found>,
    /// Distances of ends of portals that have been reached.
    ends: HashMap<u32, f64>,
    /// Ends that have come nearer to the place, to be left by their portals, with the faces and the steps by which they are reached.
    reached_ends: Vec<(u32, u32, u32)>,
    /// Windows, each with the half-edges by which it leaves a face and enters the next. Their root is the step before.
    waiting: Vec<(u32, u32, Beam)>,
    steps: Vec<Step>,
}

impl<'a> Lines<'a> {
    /// Those from a place, to their ends; none where they take more windows than `most`. And how many they take.
    pub fn followed(known: &'a Known<'a>, place: Place, most: usize) -> (Option<Self>, usize) {
        let mut lines = Lines {
            known,
            least: f64::INFINITY,
            found: None,
            ends: HashMap::new(),
            reached_ends: Vec::new(),
            waiting: Vec::new(),
            steps: Vec::new(),
        };
        lines.start(place, 0.0, Step::Start(place));
        let windows = lines.follow(most);
        (windows.map(|_| lines), windows.unwrap_or(most))
    }

    /// Sends lines from a place at this distance from the one asked for.
    fn start(&mut self, place: Place, offset: f64, step: Step) {
        let geometry = self.known.geometry;
        let root = self.push(step);
        for (face, weights) in geometry.faces_at(&geometry.surface, place) {
            let frame = geometry.frame(face);
            for k in 0..3 {
                let [x, depth] = frame.place(k, weights);
                let vertex = VertexId(frame[k].vertex);
                // A vertex is not on the way from itself.
                if place != Place::Vertex(vertex) {
                    self.offer(End::Vertex(vertex), offset + length(x, depth), (face, root));
                }
            }
            let from = frame.place(0, weights);
            self.see(3 * face, root, |[x, y]| Some(offset + length(from[0] - x, from[1] - y)));
            for k in 0..3 {
                let [x, depth] = frame.place(k, weights);
                if depth > 0.0 {
                    let across = frame[k].length;
                    let all = Beam { begin: 0.0, end: across, x: across - x, depth, offset, root };
                    self.leave(face * 3 + k as u32, all);
                }
            }
        }
    }

    /// Follows all lines to their ends. Returns how many windows they take, unless that is more than `most`.
    fn follow(&mut self, most: usize) -> Option<usize> {
        let mut taken = 0;
        loop {
            let window = self.waiting.pop();
            let end = if window.is_none() { self.reached_ends.pop() } else { None };
            match (window, end) {
                (None, None) => return Some(taken),
                _ if taken == most => return None,
                (Some((out, halfedge, beam)), _) => self.cross(out, halfedge, beam),
                (None, Some(reached)) => self.emerge(reached),
            }
            taken += 1;
        }
    }

    /// Lets a window cross a face.
    fn cross(&mut self, out: u32, halfedge: u32, mut beam: Beam) {
        let geometry = self.known.geometry;
        let (frame, k) = geometry.frame_of(halfedge);
        if !self.can_be_nearer(frame, k, &beam) {
            return;
        }
        beam.root = self.push(Step::Cross { out, into: halfedge, after: beam.root });
        let here = (halfedge / 3, beam.root);
        self.see(halfedge, beam.root, |place| beam.sees(place, geometry.grain).map(|(_, length)| length));
        let (sides, opposite) = (frame.seen_from(k), frame.opposite(k));
        let crossing = Crossing::new(beam, opposite);
        if crossing.sees_corner(geometry.grain) {
            let at = smaller(larger(crossing.splits(), beam.begin), beam.end);
            let length = beam.at(at) + length(opposite[0] - at, opposite[1]);
            self.offer(End::Vertex(VertexId(sides[2].vertex)), length, here);
        }
        let first = halfedge - k as u32;
        for (out, beam) in [(before(k), crossing.to_left(sides)), (after(k), crossing.to_right(sides))] {
            if let Some(beam) = beam.filter(Beam::is_wide) {
                self.leave(first + out as u32, beam);
            }
        }
    }

    /// Lets a window out of a face by a half-edge, as those across see it.
    fn leave(&mut self, out: u32, beam: Beam) {
        let geometry = self.known.geometry;
        let (frame, k) = geometry.frame_of(out);
        self.waiting.extend(geometry.across(out).map(|(target, is_mirrored)| {
            (out, target, if is_mirrored { beam.mirrored(frame[k].length) } else { beam })
        }));
    }

    /// Whether a path through a window at a half-edge can be shorter than the shortest one found.
    fn can_be_nearer(&self, frame: &Frame, k: usize, beam: &Beam) -> bool {
        let across = frame[k].length;
        let [a, b] = [frame[k].vertex, frame[after(k)].vertex].map(|vertex| self.known.values[VertexId(vertex)]);
        // Seen from the place by way of the half-edge's begin, a source comes nearer along it, by way of its end it goes away:
        // the larger of both is least where they agree.
        let agree = 0.5 * (a - b + across);
        let at = smaller(larger(agree, beam.begin), beam.end);
        beam.at(at) + larger(a - at, b - (across - at)) < self.least
    }

    /// Offers an end at this distance from the place, by way of a face and a step.
    fn offer(&mut self, end: End, length: f64, (face, step): (u32, u32)) {
        let length = length
            + match end {
                End::Vertex(vertex) => self.known.values[vertex],
                End::Source(source) => self.known.sources[source as usize].initial_distance(),
            };
        if length < self.least {
            self.least = length;
            self.found = Some(Found { face, step, end });
        }
    }

    /// Offers the sources and the ends of portals in a half-edge's face the lines by which they are `seen` there after a step, as it is
    /// laid out by the half-edge.
    fn see(&mut self, halfedge: u32, step: u32, seen: impl Fn([f64; 2]) -> Option<f64>) {
        let (known, face) = (self.known, halfedge / 3);
        let (frame, k) = known.geometry.frame_of(halfedge);
        for source in known.sources_in_faces.in_face(face) {
            if let Some(length) = seen(frame.place(k, source.weights)) {
                self.offer(End::Source(source.point as u32), length, (face, step));
            }
        }
        for end in known.geometry.portals().in_faces().in_face(face) {
            let (number, before) = (end.point as u32, self.at_end(end.point as u32));
            if let Some(length) = seen(frame.place(k, end.weights)).filter(|&length| length < before) {
                self.ends.insert(number, length);
                self.reached_ends.push((number, face, step));
            }
        }
    }

    /// The distance of an end of a portal from the place.
    fn at_end(&self, end: u32) -> f64 {
        self.ends.get(&end).copied().unwrap_or(f64::INFINITY)
    }

    /// Goes on from the other end of a portal, unless that is nearer by itself.
    fn emerge(&mut self, (end, face, after): (u32, u32, u32)) {
        let (portals, other) = (self.known.geometry.portals(), Portals::across(end));
        let length = self.at_end(end) + portals.gap(end);
        if length < self.at_end(other) && length < self.least {
            self.ends.insert(other, length);
            self.start(portals.places()[other as usize], length, Step::Emerge { end, face, after });
        }
    }

    fn push(&mut self, step: Step) -> u32 {
        self.steps.push(step);
        self.steps.len() as u32 - 1
    }

    /// Appends what the shortest path crosses, from the place to its end.
    pub fn trace(&self, found: &Found, points: &mut Vec<PathPoint>) {
        let (known, begin) = (self.known, points.len());
        let end = match found.end {
            End::Vertex(vertex) => Place::Vertex(vertex),
            End::Source(source) => known.sources[source as usize].place(),
        };
        // From the end to the place; each point knows the face after it.
        points.push(known.point(end, found.face));
        let (mut face, mut step) = (found.face, found.step);
        loop {
            match self.steps[step as usize] {
                Step::Start(place) => {
                    points.push(known.point(place, face));
                    break;
                }
                Step::Cross { out, into, after } => {
                    let middle = Place::Edge { halfedge: HalfedgeId(into), fraction: 0.5 };
                    points.push(known.point(middle, into / 3));
                    (face, step) = (out / 3, after);
                }
                Step::Emerge { end, face: reached, after } => {
                    let places = known.geometry.portals().places();
                    points.push(known.point(places[Portals::across(end) as usize], face));
                    points.push(known.point(places[end as usize], reached));
                    (face, step) = (reached, after);
                }
            }
        }
        points[begin..].reverse();
        // The last line has ended where this one begins.
        if begin > 0 {
            points.remove(begin - 1);
        }
    }
}
