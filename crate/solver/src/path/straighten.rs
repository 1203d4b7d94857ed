//! Straightening to a locally shortest path, after Sharp and Crane, "You Can Find Geodesic Paths in Triangle Meshes by
//! Just Flipping Edges" (2020).
//!
//! As there, the vertex where the path turns most sharply goes first: the path is led through the faces on the side
//! where it turns by less than π, and shortened there, until no vertex is left to do that at. There, that means to
//! flip edges of an intrinsic triangulation; here, it means to take the shortest path in the unfolded strip of faces
//! between the vertices before and after, which is the same path and needs neither a manifold nor an orientation.
//!
//! That goes in rounds, in each of which no segment changes twice: so segments that grow together double, where one that grew
//! vertex by vertex would be unfolded as often as it has faces. One that grows alone, along a line of vertices that the path
//! runs straight through, doubles by being led around more and more of these at once.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};
use std::f64::consts::PI;

use glam::DVec2;
use heatwalk_base::csr::NONE;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, Path, PathPoint, Place};

use super::funnel::{Segment, share_of, tighten};
use super::link::{Turn, shortest_turn};
use super::strip::{Step, Strip, unfold};
use crate::error::Result;

/// A turn by less than this short of π, in radians, is none: to cut it would shorten the path by 10⁻¹⁵ of it, which is
/// its rounding.
const STRAIGHT: f64 = 1e-7;

/// Faces unfolded per point of the path given and face of the surface, at most. Each vertex that is led around shortens the
/// path, so that this bounds time and makes no path longer than it was.
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
    /// How many vertices are led around at once, on either side from this one on, where the path runs straight through those.
    reach: usize,
}

struct Chain<'a> {
    surface: &'a Surface,
    nodes: Vec<Node>,
    /// Of this round: bits of the angle, node, version. Bits of non-negative floats order as the floats do.
    queue: BinaryHeap<Reverse<(u64, u32, u32)>>,
    /// For the next round: nodes to look around, with their versions.
    changed: Vec<(u32, u32)>,
    /// Faces unfolded so far.
    work: usize,
    last_face: FaceId,
}

impl<'a> Chain<'a> {
    /// The shortest path in the faces of `path` between each vertex on it and the next; `None` without points.
    fn new(surface: &'a Surface, path: &Path) -> Option<Self> {
        let (first, rest) = path.points.split_first()?;
        let mut chain = Self {
            surface,
            nodes: Vec::new(),
            queue: BinaryHeap::new(),
            changed: Vec::new(),
            work: 0,
            last_face: first.face,
        };
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
            chain.mark(node);
            node = chain.nodes[node as usize].after;
        }
        Some(chain)
    }

    fn add(&mut self, location: Place, before: u32) -> u32 {
        self.nodes.push(Node { location, before, after: NONE, segment: None, turn: None, version: 0, reach: 1 });
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

    /// Lets a node whose segments changed wait for the next round: a vertex of many faces may change with every other one.
    fn mark(&mut self, index: u32) {
        let node = &mut self.nodes[index as usize];
        node.version += 1;
        node.turn = None;
        self.changed.push((index, node.version));
    }

    /// Begins a round: queues the nodes that changed where there is a way around that turns by less than π.
    fn look_around(&mut self) {
        for (index, version) in std::mem::take(&mut self.changed) {
            if self.nodes[index as usize].version != version {
                continue;
            }
            let turn = self.turn_at(index, [None; 2], PI - STRAIGHT);
            self.queue.extend(turn.iter().map(|turn| Reverse((turn.angle.to_bits(), index, version))));
            self.nodes[index as usize].turn = turn;
        }
    }

    /// The shortest way around a node by these sides of the segments there, if it turns by less than `limit`.
    fn turn_at(&mut self, index: u32, sides: [Option<usize>; 2], limit: f64) -> Option<Turn> {
        let Node { location: Place::Vertex(vertex), ref segment, .. } = self.nodes[index as usize] else { return None };
        let headings = [self.segment_before(index)?.arriving.as_ref(), segment.as_ref()?.leaving.as_ref()];
        let headings = headings.map(|heading| heading.expect("a segment has headings at its vertices"));
        let mut work = 0;
        let turn = shortest_turn(self.surface, vertex, headings, sides, limit, &mut work);
        self.work += work;
        turn
    }

    fn segment_before(&self, index: u32) -> Option<&Segment> {
        self.nodes.get(self.nodes[index as usize].before as usize)?.segment.as_ref()
    }

    /// Leads the path around vertices until none is left or about `most` faces were unfolded, the sharpest turn of each round
    /// first. What changes in a round waits for the next one.
    fn shorten(&mut self, most: usize) {
        while self.work < most {
            match self.queue.pop() {
                Some(Reverse((_, index, version))) if self.nodes[index as usize].version == version => {
                    self.lead_around(index);
                }
                Some(_) => {}
                None if self.changed.is_empty() => break,
                None => self.look_around(),
            }
        }
    }

    fn lead_around(&mut self, index: u32) {
        let Some(turn) = self.nodes[index as usize].turn.take() else { return };
        let reach = std::mem::replace(&mut self.nodes[index as usize].reach, 1);
        let alone = VecDeque::from([(index, turn)]);
        if reach > 1 {
            let run = self.run(alone.clone(), reach);
            if self.replace_if_shorter(&run, reach) {
                return;
            }
        }
        self.replace_if_shorter(&alone, 1);
    }

    /// Extends the way around a node by those around the next ones on either side, while the path runs straight through these.
    fn run(&mut self, mut run: VecDeque<(u32, Turn)>, reach: usize) -> VecDeque<(u32, Turn)> {
        for _ in 1..reach {
            let Some((last, turn)) = run.back() else { break };
            let (next, side) = (self.nodes[*last as usize].after, turn.sides[1]);
            let Some(turn) = self.turn_at(next, [Some(side), None], PI + STRAIGHT) else { break };
            run.push_back((next, turn));
        }
        for _ in 1..reach {
            let Some((first, turn)) = run.front() else { break };
            let (next, side) = (self.nodes[*first as usize].before, turn.sides[0]);
            let Some(turn) = self.turn_at(next, [None, Some(side)], PI + STRAIGHT) else { break };
            run.push_front((next, turn));
        }
        run
    }

    /// Leads the path around nodes that follow each other, if that makes it shorter.
    fn replace_if_shorter(&mut self, run: &VecDeque<(u32, Turn)>, reach: usize) -> bool {
        let (Some(&(first, _)), Some(&(last, _))) = (run.front(), run.back()) else { return false };
        let (before, after) = (self.nodes[first as usize].before, self.nodes[last as usize].after);
        let Some(Segment { strip, length, .. }) = &self.nodes[before as usize].segment else { return false };
        let (mut strip, mut length) = (strip.clone(), *length);
        for (node, turn) in run {
            let Some(segment) = &self.nodes[*node as usize].segment else { return false };
            strip.extend(turn.steps.iter().chain(&segment.strip.steps).copied());
            length += segment.length;
        }
        self.work += strip.steps.len();
        let [start, end] = [before, after].map(|node| self.nodes[node as usize].location);
        let segments = tighten(self.surface, start, strip, end);
        // Not so where the turn is among rounding errors.
        if segments.iter().map(|segment| segment.length).sum::<f64>() >= length {
            return false;
        }
        for &(node, _) in run {
            let node = &mut self.nodes[node as usize];
            // Its strip may be as long as the path.
            (node.segment, node.turn) = (None, None);
            node.version += 1;
        }
        let reach = if segments.len() == 1 { 2 * reach } else { 1 };
        [before, after].iter().for_each(|&node| self.nodes[node as usize].reach = reach);
        self.replace(before, segments, after);
        true
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
            self.mark(node);
            node = self.nodes[node as usize].before;
        }
        self.mark(before);
        self.mark(after);
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
        self.mark(kept);
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
                let (edges, end) = unfold(surface, &segment.strip, node.location, segment.to);
                for (edge, step) in edges.iter().zip(&segment.strip.steps) {
                    let share = share_of(edge, DVec2::ZERO, end);
                    let location = Place::on_edge(surface, step.face, edge.ends, share);
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

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use glam::DVec3;
    use heatwalk_surface::{Soup, VertexId};

    use super::*;

    /// A surface, vertices of a path along its edges, and the length of the shortest one.
    type Case = (Soup, Vec<u32>, f64);

    /// A square cut across into slivers, and a zigzag over all of them.
    fn ladder(count: u32) -> Case {
        let at = |index: u32| DVec3::new(f64::from(index / 2) / f64::from(count / 2), f64::from(index % 2), 0.0);
        let triangles = (0..count).map(|index| [index, index + 1, index + 2]);
        (Soup::single("ladder", (0..count + 2).map(at).collect(), triangles.collect()), (0..count + 1).collect(), 1.0)
    }

    /// A triangle cut from one corner into needles, and a path around it.
    fn needles(count: u32) -> Case {
        let side = (0..=count).map(|index| DVec3::new(1.0, f64::from(index) / f64::from(count), 0.0));
        let triangles = (1..=count).map(|index| [0, index, index + 1]);
        let positions = [DVec3::ZERO].into_iter().chain(side).collect();
        (Soup::single("needles", positions, triangles.collect()), (0..count + 2).collect(), 2_f64.sqrt())
    }

    /// The same triangle, and a path from the end of each needle to the next by way of their common corner.
    fn spokes(count: u32) -> Case {
        let (soup, ..) = needles(count);
        let path = (1..count + 2).flat_map(|index| [index, 0]).take(2 * count as usize + 1);
        (soup, path.collect(), 1.0)
    }

    /// The same with needles of the other kind beyond their side, so that paths may go on either side of it.
    fn kite(count: u32) -> Case {
        let (mut soup, path, length) = needles(count);
        let last = soup.positions.len() as u32;
        soup.positions.push(DVec3::new(2.0, 1.0, 0.0));
        soup.triangles.extend((1..=count).map(|index| [last, index + 1, index]));
        (soup, path, length)
    }

    /// Triangles around a vertex, and a path along a third of their rim.
    fn hub(count: u32) -> Case {
        let rim =
            (0..count).map(|index| DVec3::from((DVec2::from_angle(TAU * f64::from(index) / f64::from(count)), 0.0)));
        let triangles = (0..count).map(|index| [0, 1 + index, 1 + (index + 1) % count]);
        let positions = [DVec3::ZERO].into_iter().chain(rim).collect();
        (Soup::single("hub", positions, triangles.collect()), (1..count / 3 + 2).collect(), 3_f64.sqrt())
    }

    #[test]
    fn on_slivers_the_faces_unfolded_grow_hardly_faster_than_their_number() {
        for make in [ladder, needles, spokes, kite, hub] {
            let work = [300, 1200, 4800].map(|count| {
                let (soup, through, length) = make(count);
                let name = soup.parts[0].name.clone();
                let surface = Surface::build(&soup).expect("a surface");
                let through: Vec<VertexId> = through.into_iter().map(VertexId).collect();
                let path = Path::along_edges(&surface, &through).expect("edges");
                let mut chain = Chain::new(&surface, &path).expect("a path with points");
                chain.shorten(usize::MAX);
                let straight = Path::new(&surface, chain.points()).length();
                // Rounding of a chain of thousands of unfoldings.
                assert!((straight - length).abs() < 1e-9, "{name}: {straight} for {length}");
                chain.work as f64
            });
            for pair in work.windows(2) {
                assert!(pair[1] < pair[0] * 4_f64.powf(1.3), "{work:?}");
            }
        }
    }
}
