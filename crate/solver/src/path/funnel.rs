//! The shortest path inside a strip of faces: the funnel of Lee and Preparata (1984) over the unfolded strip.

use std::collections::VecDeque;

use glam::{DVec2, DVec3};
use heatwalk_base::csr::NONE;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, Place, VertexId, triangle};

use super::strip::{Strip, StripEdge, unfold};

/// A line that passes a vertex within this share of the edge touches it: rounding of unfolding some ten faces.
const TOUCH: f64 = 1e-14;

/// The direction in which a path leaves or reaches a vertex.
#[derive(Debug, Clone, Copy)]
pub(super) struct Heading {
    /// The face that it lies in.
    pub face: FaceId,
    /// The vertices that the vertex is joined to in that face, with the angles to them, radians. Those of one index are on the
    /// same side of a segment at both of its ends.
    pub sides: [(VertexId, f64); 2],
}

/// A straight segment of a path, from one vertex or end to the next.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    /// The faces that it goes through.
    pub strip: Strip,
    /// Where it ends.
    pub to: Place,
    /// In mean edges.
    pub length: f64,
    /// At its start; `None` where that is no vertex.
    pub leaving: Option<Heading>,
    /// At its end, backwards; `None` where that is no vertex.
    pub arriving: Option<Heading>,
}

/// The shortest path in a strip: none where its ends are one.
pub(super) fn tighten(surface: &Surface, from: Place, mut strip: Strip, to: Place) -> Vec<Segment> {
    strip.trim(surface, from, to);
    if strip.steps.is_empty() {
        return Segment::in_face(surface, strip.first, from, to).into_iter().collect();
    }
    let (edges, end) = unfold(surface, &strip, from, to);
    let mut segments = Vec::new();
    let mut start = Stop { location: from, at: DVec2::ZERO, edges: [0, 0] };
    for stop in stops(&edges, Stop { location: to, at: end, edges: [edges.len(); 2] }) {
        let [first, last] = [start.edges[1].min(stop.edges[0]), stop.edges[0]];
        if first == last {
            segments.extend(Segment::in_face(surface, strip.face_before(first), start.location, stop.location));
        } else {
            segments.push(Segment::over(strip.part(first, last), &edges[first..last], &start, &stop));
        }
        start = stop;
    }
    segments
}

/// A vertex that the path bends around or touches, or its end.
#[derive(Debug, Clone, Copy)]
struct Stop {
    location: Place,
    at: DVec2,
    /// First of the edges that end there, and the one after the last.
    edges: [usize; 2],
}

impl Segment {
    fn in_face(surface: &Surface, face: FaceId, from: Place, to: Place) -> Option<Self> {
        let [start, end] = [from, to].map(|location| location.position(surface));
        let heading = |location: Place, toward: DVec3| {
            let Place::Vertex(vertex) = location else { return None };
            let corners = surface.faces()[face];
            let k = corners.iter().position(|&corner| corner == vertex).expect("a vertex of the face");
            let position = surface.position(vertex);
            let side = |other| (other, triangle::angle([position, toward, surface.position(other)]));
            let mut sides = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
            // A segment between two vertices is along an edge: the face is on its first side, and beyond it is the second.
            if [from, to].contains(&Place::Vertex(sides[0])) {
                sides.reverse();
            }
            Some(Heading { face, sides: sides.map(side) })
        };
        let length = triangle::length(end - start) / surface.mean_edge();
        (length > 0.0).then(|| Self {
            strip: Strip::new(face),
            to,
            length,
            leaving: heading(from, end),
            arriving: heading(to, start),
        })
    }

    /// Straight through edges.
    fn over(strip: Strip, edges: &[StripEdge], start: &Stop, end: &Stop) -> Self {
        let heading = |here: &Stop, there: &Stop, face: FaceId, edge: &StripEdge| {
            let direction = there.at - here.at;
            let side = |k: usize| {
                let side = edge.at[k] - here.at;
                (edge.ends[k], direction.perp_dot(side).abs().atan2(direction.dot(side)))
            };
            matches!(here.location, Place::Vertex(_)).then(|| Heading { face, sides: [side(0), side(1)] })
        };
        Self {
            to: end.location,
            length: start.at.distance(end.at),
            leaving: heading(start, end, strip.first, &edges[0]),
            arriving: heading(end, start, strip.last(), &edges[edges.len() - 1]),
            strip,
        }
    }
}

/// The vertices that the shortest path bends around and those that it touches, then its end.
fn stops(edges: &[StripEdge], end: Stop) -> Vec<Stop> {
    let mut stops = Vec::new();
    let (mut at, mut next) = (DVec2::ZERO, 0);
    for bend in bends(edges, end.at).into_iter().map(|corner| corner.stop(edges)).chain([end]) {
        let mut edge = next;
        while edge < bend.edges[0] {
            edge += 1;
            if let Some(touch) = touched(edges, [next, edge - 1], at, bend.at) {
                next = touch.edges[1];
                edge = next;
                stops.push(touch);
            }
        }
        stops.push(bend);
        (at, next) = (bend.at, bend.edges[1]);
    }
    stops
}

/// The end of an edge that a straight line passes within `TOUCH`, if any. Edges from `first` on may end there, too.
fn touched(edges: &[StripEdge], [first, edge]: [usize; 2], start: DVec2, end: DVec2) -> Option<Stop> {
    let share = share_of(&edges[edge], start, end);
    let side = match share {
        _ if share <= TOUCH => 0,
        _ if share >= 1.0 - TOUCH => 1,
        _ => return None,
    };
    let StripEdge { ends, at } = edges[edge];
    let ending = edges[first..edge].iter().rev().take_while(|before| before.ends.contains(&ends[side])).count();
    Some(Corner { vertex: ends[side], at: at[side], edge: edge - ending }.stop(edges))
}

/// Where a line crosses an edge, as a share of the way from its left end to its right one, 0 to 1.
pub(super) fn share_of(edge: &StripEdge, start: DVec2, end: DVec2) -> f64 {
    let [left, right] = edge.at.map(|at| (end - start).perp_dot(at - start));
    let share = left / (left - right);
    if share.is_nan() {
        // Along the edge: its nearer end comes first.
        let [left, right] = edge.at.map(|at| at.distance_squared(start));
        return if left < right { 0.0 } else { 1.0 };
    }
    share.clamp(0.0, 1.0)
}

#[derive(Debug, Clone, Copy)]
struct Corner {
    vertex: VertexId,
    at: DVec2,
    /// The first edge that ends there.
    edge: usize,
}

impl Corner {
    fn stop(self, edges: &[StripEdge]) -> Stop {
        let ending = edges[self.edge..].iter().take_while(|edge| edge.ends.contains(&self.vertex)).count();
        let edges = [self.edge, self.edge + ending];
        Stop { location: Place::Vertex(self.vertex), at: self.at, edges }
    }
}

/// The vertices that the shortest path through the edges from the origin bends around.
fn bends(edges: &[StripEdge], end: DVec2) -> Vec<Corner> {
    let mut apex = DVec2::ZERO;
    let mut bends = Vec::new();
    // From the apex outward, left and right; positive is to the inside of neither.
    let mut chains = [VecDeque::<Corner>::new(), VecDeque::new()];
    let outward = [1.0, -1.0];
    let mut add = |side: usize, corner: Corner, bends: &mut Vec<Corner>, chains: &mut [VecDeque<Corner>; 2]| {
        let turn = |a: DVec2, b: DVec2, c: DVec2| outward[side] * (b - a).perp_dot(c - a);
        while let Some(last) = chains[side].back() {
            let before = chains[side].len().checked_sub(2).map_or(apex, |before| chains[side][before].at);
            if turn(before, last.at, corner.at) > 0.0 {
                break;
            }
            chains[side].pop_back();
        }
        if chains[side].is_empty() {
            // Past the other side's chain: the path bends around it.
            while let Some(&first) = chains[1 - side].front().filter(|first| turn(apex, first.at, corner.at) < 0.0) {
                apex = first.at;
                bends.push(first);
                chains[1 - side].pop_front();
            }
        }
        chains[side].push_back(corner);
    };
    for (k, edge) in edges.iter().enumerate() {
        for side in 0..2 {
            if k == 0 || edges[k - 1].ends[side] != edge.ends[side] {
                let corner = Corner { vertex: edge.ends[side], at: edge.at[side], edge: k };
                add(side, corner, &mut bends, &mut chains);
            }
        }
    }
    add(0, Corner { vertex: VertexId(NONE), at: end, edge: edges.len() }, &mut bends, &mut chains);
    let [mut left, _] = chains;
    left.pop_back();
    bends.extend(left);
    bends
}
