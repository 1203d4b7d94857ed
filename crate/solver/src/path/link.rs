//! Ways around a vertex. Its link is a graph: a node for each edge there, an arc for each face, as long as its angle.
//! On a manifold it is a circle, on a boundary an arc; where more than two faces meet in an edge it branches.
//!
//! A path through a vertex is locally shortest exactly where its two directions are at least π apart in the link.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::funnel::Heading;
use super::strip::Step;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::triangle;
use heatwalk_surface::{FaceId, VertexId};

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
/// `limit`.
pub(super) fn shortest_turn(
    surface: &Surface,
    vertex: VertexId,
    [from, to]: [&Heading; 2],
    sides: [Option<usize>; 2],
    limit: f64,
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

    // Each arc from both of its ends, in order of these; a node is the first place of its vertex.
    let mut arcs: Vec<(VertexId, Arc)> = Vec::new();
    for (face, k) in surface.corners_of_vertex(vertex) {
        let corners = surface.faces()[face];
        let [p, q] = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
        arcs.extend([(p, Arc { face, to: q }), (q, Arc { face, to: p })]);
    }
    arcs.sort_unstable_by_key(|arc| arc.0);
    let node_of = |other: VertexId| arcs.partition_point(|arc| arc.0 < other);

    // Dijkstra (1959) from both sides of the first direction.
    let mut nearest: Vec<(f64, Option<(usize, FaceId)>)> = vec![(f64::INFINITY, None); arcs.len()];
    let mut queue = BinaryHeap::new();
    for (_, (other, angle)) in from.sides.into_iter().enumerate().filter(|&(side, _)| is_open(0, side)) {
        nearest[node_of(other)].0 = angle;
        queue.push(Reverse((angle.to_bits(), node_of(other))));
    }
    let position = surface.position(vertex);
    let mut end = None;
    while let Some(Reverse((bits, here))) = queue.pop() {
        let angle = f64::from_bits(bits);
        if angle >= best.angle {
            break;
        }
        if angle > nearest[here].0 {
            continue;
        }
        let other = arcs[here].0;
        if let Some(side) = to.sides.iter().position(|side| side.0 == other)
            && is_open(1, side)
            && angle + to.sides[side].1 < best.angle
        {
            best.angle = angle + to.sides[side].1;
            best.sides[1] = side;
            end = Some(here);
        }
        for (_, arc) in arcs[here..].iter().take_while(|arc| arc.0 == other) {
            let there = node_of(arc.to);
            // Not back.
            if nearest[there].0 <= angle {
                continue;
            }
            let further = angle + triangle::angle([position, surface.position(other), surface.position(arc.to)]);
            if further < nearest[there].0 {
                nearest[there] = (further, Some((here, arc.face)));
                queue.push(Reverse((further.to_bits(), there)));
            }
        }
    }

    let Some(end) = end else { return is_found.then_some(best) };
    let (mut here, mut face) = (end, to.face);
    loop {
        best.steps.push(Step::new(vertex, arcs[here].0, face));
        let (_, Some((before, between))) = nearest[here] else { break };
        (here, face) = (before, between);
    }
    best.sides[0] = usize::from(from.sides[0].0 != arcs[here].0);
    best.steps.reverse();
    Some(best)
}

/// A face at a vertex, from one of its edges there.
#[derive(Debug, Clone, Copy)]
struct Arc {
    face: FaceId,
    /// The vertex at the other edge's end.
    to: VertexId,
}
