//! Exact distance at places in faces, from exact distances of all vertices.
//!
//! Straight lines go out from the place through unfolded faces until they meet a vertex, a source or an end of a portal, whose
//! distance is known: the shortest path goes straight to the first that it meets. No distance changes faster than place does, so
//! that the ends of each edge tell how near it can be to a source: what cannot be on a shortest path is not followed, and few faces
//! around that path are crossed.

use std::sync::Arc;

use heatwalk_surface::{Place, Source, ToPoint, ToSource, VertexData, VertexId};

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
        let places: Vec<Place> = self.sources.iter().map(Source::place).collect();
        let portals = self.geometry.portals();
        let mut lines = Lines {
            known: self,
            least: f64::INFINITY,
            sources: Targets::new(&places, Arc::clone(&self.sources_in_faces)),
            ends: Targets::new(portals.places(), Arc::clone(portals.in_faces())),
            reached_ends: Vec::new(),
            waiting: Vec::new(),
        };
        lines.start(place, 0.0);
        let most = MOST_WINDOWS.max(self.geometry.frames.len());
        if lines.follow(most) {
            Ok(lines.least)
        } else {
            Ok(search(self.geometry, &self.sources, place)?.target_values()[0])
        }
    }
}

/// Straight lines from a place.
struct Lines<'a> {
    known: &'a PlaceDistances<'a>,
    /// The length of the shortest path found.
    least: f64,
    sources: Targets,
    /// Of the portals.
    ends: Targets,
    /// Ends that have come nearer to the place, to be left by their portals.
    reached_ends: Vec<u32>,
    /// Windows, each with the half-edge by which it enters a face.
    waiting: Vec<(u32, Beam)>,
}

impl Lines<'_> {
    /// Sends lines from a place at this distance from the one asked for.
    fn start(&mut self, place: Place, offset: f64) {
        let geometry = self.known.geometry;
        for (face, weights) in geometry.faces_at(&geometry.surface, place) {
            let frame = geometry.frame(face);
            for k in 0..3 {
                let [x, depth] = frame.place(k, weights);
                self.offer_vertex(frame[k].vertex, offset + length(x, depth));
            }
            self.see(|targets, nearer| targets.see_straight(frame, (face, weights), (offset, 0), nearer));
            for k in 0..3 {
                let [x, depth] = frame.place(k, weights);
                if depth > 0.0 {
                    let across = frame[k].length;
                    let all = Beam { begin: 0.0, end: across, x: across - x, depth, offset, root: 0 };
                    self.leave(face * 3 + k as u32, all);
                }
            }
        }
    }

    /// Follows all lines to their ends. Returns whether these are no more than `most`.
    fn follow(&mut self, most: usize) -> bool {
        for _ in 0..most {
            if let Some((halfedge, beam)) = self.waiting.pop() {
                self.cross(halfedge, beam);
            } else if let Some(end) = self.reached_ends.pop() {
                self.emerge(end);
            } else {
                return true;
            }
        }
        false
    }

    /// Lets a window cross a face.
    fn cross(&mut self, halfedge: u32, beam: Beam) {
        let geometry = self.known.geometry;
        let (frame, k) = geometry.frame_of(halfedge);
        if !self.can_be_nearer(frame, k, &beam) {
            return;
        }
        self.see(|targets, nearer| targets.see(frame, halfedge, (&beam, geometry.grain), nearer));
        let (sides, opposite) = (frame.seen_from(k), frame.opposite(k));
        let crossing = Crossing::new(beam, opposite);
        if crossing.sees_corner(geometry.grain) {
            let at = smaller(larger(crossing.splits(), beam.begin), beam.end);
            self.offer_vertex(sides[2].vertex, beam.at(at) + length(opposite[0] - at, opposite[1]));
        }
        let first = halfedge - k as u32;
        for (out, beam) in [(before(k), crossing.to_left(sides)), (after(k), crossing.to_right(sides))] {
            if let Some(beam) = beam.filter(Beam::is_wide) {
                self.leave(first + out as u32, beam);
            }
        }
    }

    /// Lets a window out of a face by a half-edge, as those across see it.
    fn leave(&mut self, halfedge: u32, beam: Beam) {
        let geometry = self.known.geometry;
        let (frame, k) = geometry.frame_of(halfedge);
        self.waiting.extend(
            geometry
                .across(halfedge)
                .map(|(target, is_mirrored)| (target, if is_mirrored { beam.mirrored(frame[k].length) } else { beam })),
        );
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

    fn offer_vertex(&mut self, vertex: u32, length: f64) {
        self.least = smaller(self.least, length + self.known.values[VertexId(vertex)]);
    }

    /// Offers the sources and the ends of portals in a face what `offer` sees there.
    fn see(&mut self, offer: impl Fn(&mut Targets, &mut dyn FnMut(u32, f64))) {
        let Self { known, least, sources, ends, reached_ends, .. } = self;
        offer(sources, &mut |source, length| {
            *least = smaller(*least, length + known.sources[source as usize].initial_distance());
        });
        offer(ends, &mut |end, _| reached_ends.push(end));
    }

    /// Goes on from the other end of a portal, unless that is nearer by itself.
    fn emerge(&mut self, end: u32) {
        let (portals, other) = (self.known.geometry.portals(), Portals::across(end));
        let length = self.ends.values[end as usize] + portals.gap(end);
        if length < self.ends.values[other as usize] && length < self.least {
            self.ends.values[other as usize] = length;
            self.start(portals.places()[other as usize], length);
        }
    }
}
