//! Ways around a vertex. Its link is a graph: a node for each edge there, an arc for each face, as long as its angle.
//! On a manifold it is a circle, on a boundary an arc; where more than two faces meet in an edge it branches.
//!
//! A path through a vertex is locally shortest exactly where its two directions are at least π apart in the link.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceId, HalfedgeId, VertexId, triangle};

use super::funnel::Heading;
use super::strip::Step;

/// A way around a vertex from one direction to another.
#[derive(Debug, Clone)]
pub(super) struct Turn {
    /// Radians.
    pub angle: f64,
    /// The edges of the vertex that it crosses.
    pub steps: Vec<Step>,
    /// By which of its [sides](Heading::sides) it leaves the first direction, and by which it comes to the second.
    pub sides: [usize; 2],
}

/// The shortest way around `vertex` between two directions, by these `sides` of them where any are given, if it is shorter than
/// `limit`. Looks at no more faces than are within that angle, and adds their number to `work`.
pub(super) fn shortest_turn(
    surface: &Surface,
    vertex: VertexId,
    [from, to]: [&Heading; 2],
    sides: [Option<usize>; 2],
    limit: f64,
    work: &mut usize,
) -> Option<Turn> {
    let is_open = |end: usize, side: usize| sides[end].is_none_or(|only| only == side);
    let mut best = Turn { angle: limit, steps: Vec::new(), sides: [0; 2] };
    let mut is_found = false;
    if from.face == to.face {
        let (other, angle) = from.sides[0];
        let same = usize::from(to.sides[0].0 != other);
        let between = angle - to.sides[same].1;
        // What is between two directions is beside both.
        let inner = if between < 0.0 { [1, same] } else { [0, 1 - same] };
        if between.abs() < best.angle && is_open(0, inner[0]) && is_open(1, inner[1]) {
            best.angle = between.abs();
            best.sides = inner;
            is_found = true;
        }
    }

    // Dijkstra (1959) from both sides of the first direction. A node has the number of the vertex at its edge's other end.
    let mut nearest: HashMap<VertexId, Node> = HashMap::new();
    let mut queue = BinaryHeap::new();
    for (_, (other, angle)) in from.sides.into_iter().enumerate().filter(|&(side, _)| is_open(0, side)) {
        nearest.insert(other, Node { angle, before: None });
        queue.push(Reverse((angle.to_bits(), halfedge_in(surface, from.face, [vertex, other]))));
    }
    let position = surface.position(vertex);
    let mut end = None;
    while let Some(Reverse((bits, halfedge))) = queue.pop() {
        let angle = f64::from_bits(bits);
        if angle >= best.angle {
            break;
        }
        let here = far_end(surface, halfedge, vertex);
        if nearest.get(&here).is_some_and(|node| node.angle < angle) {
            continue;
        }
        if let Some(side) = to.sides.iter().position(|side| side.0 == here)
            && is_open(1, side)
            && angle + to.sides[side].1 < best.angle
        {
            best.angle = angle + to.sides[side].1;
            best.sides[1] = side;
            end = Some(here);
        }
        for arc in surface.edges().around(halfedge) {
            *work += 1;
            let leaves = surface.ends(arc)[0] == vertex;
            let next = if leaves { arc.previous_in_triangle() } else { arc.next_in_triangle() };
            let there = far_end(surface, next, vertex);
            let known = nearest.get(&there).map_or(f64::INFINITY, |node| node.angle);
            // Not back.
            if known <= angle {
                continue;
            }
            let further = angle + triangle::angle([position, surface.position(here), surface.position(there)]);
            if further < known {
                nearest.insert(there, Node { angle: further, before: Some((here, arc.triangle())) });
                queue.push(Reverse((further.to_bits(), next)));
            }
        }
    }

    let Some(end) = end else { return is_found.then_some(best) };
    let (mut here, mut face) = (end, to.face);
    loop {
        best.steps.push(Step::new(vertex, here, face));
        let Some((before, between)) = nearest[&here].before else { break };
        (here, face) = (before, between);
    }
    best.sides[0] = usize::from(from.sides[0].0 != here);
    best.steps.reverse();
    Some(best)
}

/// An edge of a vertex, as far as its link was walked.
struct Node {
    angle: f64,
    /// The edge before and the face between; `None` beside the first direction.
    before: Option<(VertexId, FaceId)>,
}

/// The end of an edge of a vertex that is another one.
fn far_end(surface: &Surface, halfedge: HalfedgeId, vertex: VertexId) -> VertexId {
    let [start, end] = surface.ends(halfedge);
    if start == vertex { end } else { start }
}

/// The half-edge of a face between two of its corners, in either direction.
fn halfedge_in(surface: &Surface, face: FaceId, corners: [VertexId; 2]) -> HalfedgeId {
    let mut halfedges = [0, 1, 2].map(|k| face.halfedge(k)).into_iter();
    let is_between = |&halfedge: &HalfedgeId| surface.ends(halfedge).iter().all(|end| corners.contains(end));
    halfedges.find(is_between).expect("two corners of a face have an edge")
}
