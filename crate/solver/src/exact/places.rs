//! Exact distance at places in faces, and exact paths from them, from exact distances of all vertices.
//!
//! Straight lines go out from the place through unfolded faces until they meet a vertex, a source or an end of a portal, whose
//! distance is known: the shortest path goes straight to the first that it meets. No distance changes faster than place does, so
//! that the ends of each edge tell how near it can be to a source: what cannot be on a shortest path is not followed, and few faces
//! around that path are crossed.

use std::sync::Arc;

use heatwalk_sparse::go_on;
use heatwalk_surface::{FaceId, HalfedgeId, PathPoint, Place, Source, ToPoint, ToSource, VertexData, VertexId};

use super::geometry::{ExactGeometry, Frame, after, before};
use super::points::PointsInFaces;
use super::portals::Portals;
use super::targets::Targets;
use super::window::{Beam, length};
use super::{Crossing, checked_sources, search};
use crate::error::{Error, Result};
use crate::extremum::{larger, smaller};

/// A place may take as many windows as the surface has faces, or so many: usual ones take some hundreds to some ten thousand. Where
/// many faces of an edge lie on each other there is no end of lines of one length, which a search from the sources tells apart.
const MOST_WINDOWS: usize = 1 << 16;

/// A straight line on a path is longer than the distances of its ends say by no more than this share: their rounding.
const STRAIGHT: f64 = 1e-9;

/// Exact distances from sources, of places.
#[derive(Debug)]
pub struct PlaceDistances<'a> {
    geometry: &'a Arc<ExactGeometry>,
    /// `#V`.
    values: &'a VertexData<f64>,
    sources: Vec<Source>,
    sources_in_faces: Arc<PointsInFaces>,
}

impl<'a> PlaceDistances<'a> {
    /// `values`: the exact distance of each vertex from the sources, `#V`, as a [`Wavefront`](super::Wavefront) on this geometry
    /// gives it.
    ///
    /// # Errors
    /// [`Error::NoSource`]; [`Error::NotExact`] where faces have different costs; those of [`ToSource::to_source`].
    ///
    /// # Panics
    /// Where there is not one value a vertex.
    pub fn new<S: ToSource>(
        geometry: &'a Arc<ExactGeometry>,
        values: &'a VertexData<f64>,
        sources: &[S],
    ) -> Result<Self> {
        assert_eq!(values.len(), geometry.surface.vertex_count(), "one value a vertex");
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        if geometry.costs().is_some() {
            return Err(Error::NotExact);
        }
        let sources = checked_sources(&geometry.surface, sources)?;
        let places: Vec<Place> = sources.iter().map(Source::place).collect();
        let in_faces = PointsInFaces::new(&places, |place| geometry.faces_at(&geometry.surface, place));
        Ok(Self { geometry, values, sources, sources_in_faces: Arc::new(in_faces) })
    }

    /// The distance at a place, in the file's unit, times the cost where all faces have one; infinite where no source reaches it.
    ///
    /// # Errors
    /// Those of [`ToPoint::to_point`]; [`Error::OutOfMemory`].
    pub fn at(&self, place: impl ToPoint) -> Result<f64> {
        let place = place.to_point(&self.geometry.surface)?.place();
        if let Place::Vertex(vertex) = place {
            return Ok(self.values[vertex]);
        }
        match Lines::followed(self, place) {
            Some(lines) => Ok(lines.least),
            None => Ok(search(self.geometry, &self.sources, place, &mut go_on)?.target_values()[0]),
        }
    }

    /// What a straight line from a place leads to on its shortest path; none where no source reaches it.
    pub(crate) fn end(&self, place: impl ToPoint) -> Result<Option<End>> {
        let place = place.to_point(&self.geometry.surface)?.place();
        if let Place::Vertex(vertex) = place {
            return Ok(Some(End::Vertex(vertex)));
        }
        match Lines::followed(self, place) {
            Some(lines) => Ok(lines.found.map(|found| found.end)),
            None => Ok(search(self.geometry, &self.sources, place, &mut go_on)?.source_of_target(0).map(End::Source)),
        }
    }

    /// The surface in the faces of which distances are known, and the sources.
    pub(crate) fn asked(&self) -> (&'a Arc<ExactGeometry>, &[Source]) {
        (self.geometry, &self.sources)
    }

    /// Points on the edges that the shortest path crosses, wherever it crosses them, and at the vertices that it turns at, and how long
    /// it may be up to rounding; none where there is no path, and where rounding hides which way it goes.
    pub(crate) fn crossed(&self, from: Place) -> Option<(Vec<PathPoint>, f64)> {
        let mut points = Vec::new();
        let (mut place, mut value, mut whole) = (from, f64::INFINITY, f64::INFINITY);
        let source = loop {
            if let Place::Vertex(vertex) = place {
                // Values fall strictly, so that each vertex is passed once.
                if self.values[vertex] >= value {
                    return None;
                }
                value = self.values[vertex];
                let is_here = |source: &&Source| source.place() == place && source.initial_distance() <= value;
                if let Some(source) = self.sources.iter().find(is_here) {
                    if points.is_empty() {
                        let face = self.geometry.faces_at(&self.geometry.surface, place).first()?.0;
                        points.push(self.point(place, face));
                    }
                    break source;
                }
            }
            let lines = Lines::followed(self, place)?;
            let found = lines.found.as_ref()?;
            if points.is_empty() {
                whole = lines.least;
            }
            if lines.least > value * (1.0 + STRAIGHT) + self.geometry.grain {
                return None;
            }
            lines.trace(found, &mut points);
            match found.end {
                End::Source(source) => break &self.sources[source as usize],
                End::Vertex(vertex) => place = Place::Vertex(vertex),
            }
        };
        // From the source itself.
        points.dedup_by(|next, last| next.location == last.location);
        let face = points.first()?.face;
        let [a, b, _] = self.geometry.surface.corners(face);
        let cost = self.geometry.frame(face.0)[0].length / a.distance(b);
        let length = whole * (1.0 + STRAIGHT) + self.geometry.grain - source.initial_distance();
        Some((points, length / cost))
    }

    // Four copies would be a kilobyte of the page's module.
    #[inline(never)]
    fn point(&self, location: Place, face: u32) -> PathPoint {
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
struct Found {
    /// In this face.
    face: u32,
    /// By way of this step.
    step: u32,
    end: End,
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
struct Lines<'a> {
    known: &'a PlaceDistances<'a>,
    /// The length of the shortest path found.
    least: f64,
    found: Option<Found>,
    sources: Targets,
    /// Of the portals.
    ends: Targets,
    /// Ends that have come nearer to the place, to be left by their portals, with the faces and the steps by which they are reached.
    reached_ends: Vec<(u32, u32, u32)>,
    /// Windows, each with the half-edges by which it leaves a face and enters the next. Their root is the step before.
    waiting: Vec<(u32, u32, Beam)>,
    steps: Vec<Step>,
}

impl<'a> Lines<'a> {
    /// Those from a place, to their ends; none where they are too many.
    fn followed(known: &'a PlaceDistances<'a>, place: Place) -> Option<Self> {
        let places: Vec<Place> = known.sources.iter().map(Source::place).collect();
        let portals = known.geometry.portals();
        let mut lines = Lines {
            known,
            least: f64::INFINITY,
            found: None,
            sources: Targets::new(&places, Arc::clone(&known.sources_in_faces)),
            ends: Targets::new(portals.places(), Arc::clone(portals.in_faces())),
            reached_ends: Vec::new(),
            waiting: Vec::new(),
            steps: Vec::new(),
        };
        lines.start(place, 0.0, Step::Start(place));
        let most = MOST_WINDOWS.max(known.geometry.frames.len());
        lines.follow(most).then_some(lines)
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
            self.see((face, root), |targets, nearer| {
                targets.see_straight(frame, (face, weights), (offset, root), nearer);
            });
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

    /// Follows all lines to their ends. Returns whether these are no more than `most`.
    fn follow(&mut self, most: usize) -> bool {
        for _ in 0..most {
            if let Some((out, halfedge, beam)) = self.waiting.pop() {
                self.cross(out, halfedge, beam);
            } else if let Some(reached) = self.reached_ends.pop() {
                self.emerge(reached);
            } else {
                return true;
            }
        }
        false
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
        self.see(here, |targets, nearer| targets.see(frame, halfedge, (&beam, geometry.grain), nearer));
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

    /// Offers the sources and the ends of portals in a face what `offer` sees there.
    fn see(&mut self, here: (u32, u32), offer: impl Fn(&mut Targets, &mut dyn FnMut(u32, f64))) {
        let mut seen = Vec::new();
        offer(&mut self.sources, &mut |source, length| seen.push((source, length)));
        for (source, length) in seen {
            self.offer(End::Source(source), length, here);
        }
        let (face, step) = here;
        let reached_ends = &mut self.reached_ends;
        offer(&mut self.ends, &mut |end, _| reached_ends.push((end, face, step)));
    }

    /// Goes on from the other end of a portal, unless that is nearer by itself.
    fn emerge(&mut self, (end, face, after): (u32, u32, u32)) {
        let (portals, other) = (self.known.geometry.portals(), Portals::across(end));
        let length = self.ends.values[end as usize] + portals.gap(end);
        if length < self.ends.values[other as usize] && length < self.least {
            self.ends.values[other as usize] = length;
            self.start(portals.places()[other as usize], length, Step::Emerge { end, face, after });
        }
    }

    fn push(&mut self, step: Step) -> u32 {
        self.steps.push(step);
        self.steps.len() as u32 - 1
    }

    /// Appends what the shortest path crosses, from the place to its end.
    fn trace(&self, found: &Found, points: &mut Vec<PathPoint>) {
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
