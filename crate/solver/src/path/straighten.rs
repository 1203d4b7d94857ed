//! Straightening to a locally shortest path, after Sharp and Crane, "You Can Find Geodesic Paths in Triangle Meshes by
//! Just Flipping Edges" (2020).
//!
//! As there, the vertex where the path turns most sharply goes first: the path is led through the faces on the side
//! where it turns by less than π, and shortened there, until no vertex is left to do that at. There, that means to
//! flip edges of an intrinsic triangulation; here, it means to take the shortest path in the unfolded strip of faces
//! between the vertices before and after, which is the same path and needs neither a manifold nor an orientation.
//!
//! That goes in rounds, in each of which no segment changes twice: so segments that grow together double, where one that grew
//! vertex by vertex would be unfolded as often as it has faces.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

use glam::DVec2;

use super::funnel::{Segment, share_of, tighten};
use super::link::{Turn, shortest_turn};
use super::strip::{Step, Strip, unfold};
use crate::error::Result;
use heatwalk_surface::csr::NONE;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, Place};
use heatwalk_surface::{Path, PathPoint};

/// A turn by less than this short of π, in radians, is none: to cut it would shorten the path by 10⁻¹⁵ of it, which is
/// its rounding.
const STRAIGHT: f64 = 1e-7;

/// Faces unfolded per point of the path given and face of the surface, at most. Paths along edges need MEASURED; each vertex
/// that is led around shortens the path, so that this bounds time and makes no path longer than it was.
const LONGEST_WORK: usize = 1000;

/// Shortens a path of this surface to a locally shortest one with the same ends, never longer than it was.
///
/// Where it crosses portals, it still does. Every segment of the result is straight once the faces that it goes through are unfolded, and at every vertex between
/// its ends all turns around it within the surface are π at least.
///
/// # Errors
/// [`Error::Surface`](crate::Error::Surface) with `ForeignSurface` for a path on another surface.
pub fn straighten(surface: &Surface, path: &Path) -> Result<Path> {
    surface.require_own(path.surface(), "path")?;
    let pieces = path.points.chunk_by(|a, b| b.location.lies_on(surface, a.face));
    let straight = pieces.map(|piece| straightened(surface, &Path::new(surface, piece.to_vec())).points);
    Ok(Path::new(surface, straight.flatten().collect()))
}

/// The same for a path on one component.
fn straightened(surface: &Surface, path: &Path) -> Path {
    let Some(mut chain) = Chain::new(surface, path) else { return path.clone() };
    chain.shorten(LONGEST_WORK * (path.points.len() + surface.face_count()));
    let straight = Path::new(surface, chain.points());
    // Where it was straight already, rounding may make it longer.
    if straight.length() <= path.length() { straight } else { path.clone() }
}

/// A vertex that the path goes through, or one of its ends.
struct Node {
    location: Place,
    before: u32,
    after: u32,
    /// To the node after.
    segment: Option<Segment>,
    /// The way around the vertex that is shorter than through it.
    turn: Option<Turn>,
    /// Changes with the segments at the node; tells which entry of the queue is the latest.
    version: u32,
}

struct Chain<'a> {
    surface: &'a Surface,
    nodes: Vec<Node>,
    /// For the next round: bits of the angle, node, version. Bits of non-negative floats order as the floats do.
    queue: BinaryHeap<Reverse<(u64, u32, u32)>>,
    /// Faces unfolded so far.
    work: usize,
    last_face: FaceId,
}

impl<'a> Chain<'a> {
    /// The shortest path in the faces of `path` between each vertex on it and the next; `None` without points.
    fn new(surface: &'a Surface, path: &Path) -> Option<Self> {
        let (first, rest) = path.points.split_first()?;
        let mut chain = Self { surface, nodes: Vec::new(), queue: BinaryHeap::new(), work: 0, last_face: first.face };
        let mut last = chain.add(first.location.reduced(surface), NONE);
        let mut strip = Strip::new(first.face);
        for (k, point) in rest.iter().enumerate() {
            let location = point.location.reduced(surface);
            match location {
                Place::Edge { halfedge, .. } if k + 1 < rest.len() => {
                    let [a, b] = surface.ends(halfedge);
                    strip.push(Step::new(a, b, point.face));
                }
                Place::Face { .. } if k + 1 < rest.len() => {}
                _ => {
                    let start = chain.nodes[last as usize].location;
                    for segment in tighten(surface, start, strip, location) {
                        last = chain.append(last, segment);
                    }
                    strip = Strip::new(point.face);
                }
            }
        }
        let mut node = chain.nodes[0].after;
        while node != NONE {
            chain.look_around(node);
            node = chain.nodes[node as usize].after;
        }
        Some(chain)
    }

    fn add(&mut self, location: Place, before: u32) -> u32 {
        self.nodes.push(Node { location, before, after: NONE, segment: None, turn: None, version: 0 });
        self.nodes.len() as u32 - 1
    }

    /// Adds a segment and a new node at its end.
    fn append(&mut self, node: u32, segment: Segment) -> u32 {
        let next = self.add(segment.to, node);
        self.join(node, segment, next);
        next
    }

    fn join(&mut self, node: u32, segment: Segment, next: u32) {
        self.nodes[node as usize].after = next;
        self.nodes[node as usize].segment = Some(segment);
        self.nodes[next as usize].before = node;
    }

    /// Queues a node where there is a way around that turns by less than π.
    fn look_around(&mut self, index: u32) {
        let node = &self.nodes[index as usize];
        let turn = match (node.location, self.segment_before(index), &node.segment) {
            (Place::Vertex(vertex), Some(before), Some(after)) => {
                let [from, to] = [&before.arriving, &after.leaving].map(Option::as_ref);
                let [from, to] = [from, to].map(|heading| heading.expect("a segment has headings at its vertices"));
                shortest_turn(self.surface, vertex, from, to, PI - STRAIGHT)
            }
            _ => None,
        };
        let node = &mut self.nodes[index as usize];
        node.version += 1;
        if let Some(turn) = &turn {
            self.queue.push(Reverse((turn.angle.to_bits(), index, node.version)));
        }
        node.turn = turn;
    }

    fn segment_before(&self, index: u32) -> Option<&Segment> {
        self.nodes.get(self.nodes[index as usize].before as usize)?.segment.as_ref()
    }

    /// Leads the path around vertices until none is left or about `most` faces were unfolded, the sharpest turn of each round
    /// first. What changes in a round waits for the next one.
    fn shorten(&mut self, most: usize) {
        let mut round = BinaryHeap::new();
        while self.work < most {
            let Some(Reverse((_, index, version))) = round.pop() else {
                if self.queue.is_empty() {
                    break;
                }
                std::mem::swap(&mut round, &mut self.queue);
                continue;
            };
            if self.nodes[index as usize].version == version {
                self.lead_around(index);
            }
        }
    }

    fn lead_around(&mut self, index: u32) {
        let Some(turn) = self.nodes[index as usize].turn.take() else { return };
        let Node { before, after, .. } = self.nodes[index as usize];
        let [Some(first), Some(second)] = [self.segment_before(index), self.nodes[index as usize].segment.as_ref()]
        else {
            return;
        };
        let mut strip = first.strip.clone();
        strip.extend(turn.steps);
        strip.extend(second.strip.steps.iter().copied());
        let length = first.length + second.length;
        self.work += strip.steps.len();
        let [start, end] = [before, after].map(|node| self.nodes[node as usize].location);
        let segments = tighten(self.surface, start, strip, end);
        // Not so where the turn is among rounding errors.
        if segments.iter().map(|segment| segment.length).sum::<f64>() >= length {
            return;
        }
        // The strip is as long as the path may be.
        self.nodes[index as usize].segment = None;
        self.nodes[index as usize].version += 1;
        self.replace(before, segments, after);
    }

    /// Puts new segments between two nodes.
    fn replace(&mut self, before: u32, mut segments: Vec<Segment>, after: u32) {
        let Some(last) = segments.pop() else { return self.merge(before, after) };
        let mut node = before;
        for segment in segments {
            node = self.append(node, segment);
        }
        self.join(node, last, after);
        while node != before {
            self.look_around(node);
            node = self.nodes[node as usize].before;
        }
        self.look_around(before);
        self.look_around(after);
    }

    /// Makes two neighbours at one place into one node, keeping an end of the path if either is.
    fn merge(&mut self, before: u32, after: u32) {
        let [kept, dropped] = if self.nodes[after as usize].after == NONE { [after, before] } else { [before, after] };
        self.nodes[dropped as usize].version += 1;
        let Node { before: previous, .. } = self.nodes[before as usize];
        if kept == before {
            let segment = self.nodes[after as usize].segment.take().expect("a node that is not the last has a segment");
            let next = self.nodes[after as usize].after;
            self.join(before, segment, next);
        } else if previous != NONE {
            self.nodes[previous as usize].after = after;
            self.nodes[after as usize].before = previous;
        } else {
            // Start and end are one.
            self.nodes[before as usize].after = NONE;
            self.nodes[before as usize].segment = None;
            return;
        }
        self.look_around(kept);
    }

    /// The points of the path, with all crossings of edges.
    fn points(&self) -> Vec<PathPoint> {
        let surface = self.surface;
        let mut points: Vec<PathPoint> = Vec::new();
        let mut add = |location: Place, face| match points.last_mut() {
            // Two crossings next to one vertex.
            Some(last) if last.location == location => last.face = face,
            _ => points.push(PathPoint { position: location.position(surface), location, face }),
        };
        let mut last_face = self.last_face;
        let mut node = &self.nodes[0];
        while let Some(segment) = &node.segment {
            add(node.location, segment.strip.first);
            if !segment.strip.steps.is_empty() {
                let (portals, end) = unfold(surface, &segment.strip, node.location, segment.to);
                for (portal, step) in portals.iter().zip(&segment.strip.steps) {
                    let share = share_of(portal, DVec2::ZERO, end);
                    let location = Place::on_edge(surface, step.face, portal.ends, share);
                    add(location.reduced(surface), step.face);
                }
            }
            last_face = segment.strip.last();
            node = &self.nodes[node.after as usize];
        }
        add(node.location, last_face);
        points
    }
}
