//! Paths and closed curves as chains of straight segments between vertices, which shorten around these.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};
use std::f64::consts::PI;

use glam::DVec2;
use heatwalk_base::csr::NONE;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, Path, PathPoint, Place};

use super::funnel::{Segment, share_of, tighten};
use super::link::{Turn, shortest_turn};
use super::ring::{STRAIGHT, tighten_ring, total};
use super::strip::{Step, Strip, unfold};

/// A vertex that the path goes through, or one of its ends; of a closed curve that goes through no vertex, any place of it.
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

/// Of a closed one, the last node is before the first.
pub(super) struct Chain<'a> {
    surface: &'a Surface,
    nodes: Vec<Node>,
    /// Where it begins.
    start: u32,
    /// Of this round: bits of the angle, node, version. Bits of non-negative floats order as the floats do.
    queue: BinaryHeap<Reverse<(u64, u32, u32)>>,
    /// For the next round: nodes to look around, with their versions.
    changed: Vec<(u32, u32)>,
    /// Faces unfolded so far.
    pub work: usize,
    last_face: FaceId,
}

impl<'a> Chain<'a> {
    /// The shortest path in the faces of `path` between each vertex on it and the next; `None` without points.
    pub fn open(surface: &'a Surface, path: &Path) -> Option<Self> {
        let mut chain = Self::laid(surface, &path.points)?;
        chain.mark_all();
        Some(chain)
    }

    /// The same of a path that ends where it begins, as a closed curve; `None` without segments.
    pub fn closed(surface: &'a Surface, path: &Path) -> Option<Self> {
        let around = path.points.split_last().map(|(_, around)| around).filter(|around| !around.is_empty())?;
        let location = |point: &PathPoint| point.location.reduced(surface);
        let corner = around.iter().position(|point| matches!(location(point), Place::Vertex(_)));
        if let Some(corner) = corner {
            let mut chain = Self::laid(surface, &begun_at(around, corner))?;
            chain.close();
            chain.mark_all();
            return Some(chain);
        }
        let mut ring = Strip::new(around[0].face);
        for point in around[1..].iter().chain([&around[0]]) {
            if let Place::Edge { halfedge, .. } = location(point) {
                let [a, b] = surface.ends(halfedge);
                ring.push(Step::new(a, b, point.face));
            }
        }
        let mut chain = Self::empty(surface, around[0].face);
        let (start, segments) = tighten_ring(surface, ring, around[0].location);
        chain.surround(start, segments);
        Some(chain)
    }

    fn empty(surface: &'a Surface, last_face: FaceId) -> Self {
        Self { surface, nodes: Vec::new(), start: 0, queue: BinaryHeap::new(), changed: Vec::new(), work: 0, last_face }
    }

    fn laid(surface: &'a Surface, points: &[PathPoint]) -> Option<Self> {
        let (first, rest) = points.split_first()?;
        let mut chain = Self::empty(surface, first.face);
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
        Some(chain)
    }

    /// Makes the last node, which is where the first is, the first.
    fn close(&mut self) {
        if self.nodes.len() > 1 {
            let before = self.nodes.pop().map_or(NONE, |last| last.before);
            self.nodes[before as usize].after = 0;
            self.nodes[0].before = before;
        }
    }

    /// Becomes the closed curve of these segments.
    fn surround(&mut self, start: Place, segments: Vec<Segment>) {
        self.nodes.clear();
        self.queue.clear();
        self.changed.clear();
        self.start = 0;
        let mut last = self.add(start, NONE);
        for segment in segments {
            last = self.append(last, segment);
        }
        self.close();
        self.mark_all();
    }

    fn mark_all(&mut self) {
        (0..self.nodes.len() as u32).for_each(|node| self.mark(node));
    }

    /// Whether nothing is left of it but a place.
    pub fn is_point(&self) -> bool {
        self.nodes[self.start as usize].segment.is_none()
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
    pub fn shorten(&mut self, most: usize) {
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
        if self.nodes[index as usize].before == index {
            return self.lead_off(index, &turn);
        }
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

    /// Leads a closed curve through one vertex around it.
    fn lead_off(&mut self, index: u32, turn: &Turn) {
        let Node { location, segment: Some(Segment { strip, length, .. }), .. } = &self.nodes[index as usize] else {
            return;
        };
        let (mut ring, location, length) = (strip.clone(), *location, *length);
        ring.extend(turn.steps.iter().copied());
        self.work += ring.steps.len();
        let (start, segments) = tighten_ring(self.surface, ring, location);
        if total(&segments) < length {
            self.surround(start, segments);
        }
    }

    /// Extends the way around a node by those around the next ones on either side, while the path runs straight through these.
    fn run(&mut self, mut run: VecDeque<(u32, Turn)>, reach: usize) -> VecDeque<(u32, Turn)> {
        for _ in 1..reach {
            let Some((last, turn)) = run.back() else { break };
            let (next, side) = (self.nodes[*last as usize].after, turn.sides[1]);
            // A closed curve keeps a node to hang on.
            if run.front().is_some_and(|first| self.nodes[first.0 as usize].before == next) {
                break;
            }
            let Some(turn) = self.turn_at(next, [Some(side), None], PI + STRAIGHT) else { break };
            run.push_back((next, turn));
        }
        for _ in 1..reach {
            let Some((first, turn)) = run.front() else { break };
            let (next, side) = (self.nodes[*first as usize].before, turn.sides[0]);
            if run.back().is_some_and(|last| self.nodes[last.0 as usize].after == next) {
                break;
            }
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
        if total(&segments) >= length {
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
        if self.nodes[self.start as usize].before != NONE {
            // The node where a closed curve began may be gone.
            self.start = before;
        }
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
        if before == after {
            self.nodes[before as usize].segment = None;
            return;
        }
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
    pub fn points(&self) -> Vec<PathPoint> {
        let surface = self.surface;
        let mut points: Vec<PathPoint> = Vec::new();
        let mut add = |location: Place, face| match points.last_mut() {
            // Two crossings next to one vertex.
            Some(last) if last.location == location => last.face = face,
            _ => points.push(PathPoint { position: location.position(surface), location, face }),
        };
        let mut last_face = self.last_face;
        let mut node = &self.nodes[self.start as usize];
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
            let after = node.after;
            node = &self.nodes[after as usize];
            if after == self.start {
                break;
            }
        }
        add(node.location, last_face);
        points
    }
}

/// The closed curve of these points, each other than the one after, that begins at one of them and ends there.
pub(super) fn begun_at(around: &[PathPoint], start: usize) -> Vec<PathPoint> {
    let before = (start + around.len() - 1) % around.len();
    let end = PathPoint { face: around[before].face, ..around[start] };
    around[start..].iter().chain(&around[..start]).copied().chain([end]).collect()
}
