//! Rings: strips whose last face is the first one, which a closed curve goes through.

use heatwalk_surface::surface::Surface;
use heatwalk_surface::{Place, VertexId};

use super::funnel::{Segment, tighten};
use super::strip::{Strip, third, unfold};

/// A turn by less than this short of π, in radians, is none: to cut it would shorten the path by 10⁻¹⁵ of it, which is
/// its rounding.
pub(super) const STRAIGHT: f64 = 1e-7;

/// The golden section (Kiefer, "Sequential minimax search for a maximum", 1953), and how often an edge is cut by it: to less than 10⁻⁸ of it,
/// by which the vertices are found that the shortest curve bends around.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
const SEARCHES: usize = 40;

/// The shortest closed curve in a ring: where it begins, at a vertex if it goes through one, and its segments from there on. Without
/// segments where it shrinks to a point, of which `within` is one that is in the ring.
pub(super) fn tighten_ring(surface: &Surface, ring: Strip, within: Place) -> (Place, Vec<Segment>) {
    let ring = without_returns(ring);
    let Some(&crossing) = ring.steps.first() else { return (within, Vec::new()) };
    let (start, mut segments) = least_loop(surface, &ring);
    if matches!(start, Place::Vertex(_)) || segments.len() < 2 {
        return (start, segments);
    }
    // It bends around vertices: straight between the last and the first of them.
    let first = segments.remove(0);
    let mut around = segments.pop().map_or(Strip::new(ring.first), |last| last.strip);
    let from = segments.last().map_or(first.to, |before| before.to);
    around.extend(std::iter::once(crossing).chain(first.strip.steps));
    segments.extend(tighten(surface, from, around, first.to));
    (first.to, segments)
}

/// The same ring where it does not go back at its ends over the edge that it came from.
fn without_returns(mut ring: Strip) -> Strip {
    let mut inner = 0..ring.steps.len();
    while inner.len() > 1 && ring.steps[inner.start].edge == ring.steps[inner.end - 1].edge {
        let crossing = ring.steps[inner.start];
        inner = inner.start + 1..inner.end - 1;
        // Over an edge of more than two faces, to cross once.
        if ring.face_before(inner.end) != crossing.face {
            ring.steps[inner.end] = crossing;
            inner.end += 1;
            break;
        }
    }
    ring.part(inner.start, inner.end)
}

/// The shortest closed curve in a ring that is straight or bends around vertices but where it crosses the first edge: its length is
/// a convex function of where that is.
fn least_loop(surface: &Surface, ring: &Strip) -> (Place, Vec<Segment>) {
    let crossing = ring.steps[0];
    let rest = Strip { first: crossing.face, steps: ring.steps[1..].to_vec() };
    let (ends, straight) = straight_crossing(surface, ring);
    let at = |share: f64| {
        let start = Place::on_edge(surface, crossing.face, ends, share).snapped(surface);
        let segments = tighten(surface, start, rest.clone(), start);
        (total(&segments), start, segments)
    };
    let mut best = at(straight);
    let mut keep = |found: (f64, Place, Vec<Segment>)| {
        let length = found.0;
        if length < best.0 {
            best = found;
        }
        length
    };
    let mut between = [0.0, 1.0];
    between.into_iter().for_each(|end| {
        keep(at(end));
    });
    for _ in 0..SEARCHES {
        let [low, high] = between;
        let [a, b] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        between = if keep(at(a)) <= keep(at(b)) { [low, b] } else { [a, high] };
    }
    (best.1, best.2)
}

/// The ends of the first edge of a ring, and the share of the way between them at which a closed curve that is straight but there is
/// shortest. Its ends are where the edge lies in the unfolded ring and where it comes again, so its squared length is quadratic.
fn straight_crossing(surface: &Surface, ring: &Strip) -> ([VertexId; 2], f64) {
    let crossing = ring.steps[0];
    let beside = |face| Place::Vertex(third(surface.faces()[face], crossing.edge));
    let mut again = ring.clone();
    again.steps.push(crossing);
    let (edges, _) = unfold(surface, &again, beside(ring.first), beside(crossing.face));
    let [begin, mut end] = [edges[0], edges[edges.len() - 1]];
    if begin.ends != end.ends {
        end.at.reverse();
    }
    let edge = begin.at[1] - begin.at[0];
    let (gap, change) = (end.at[0] - begin.at[0], end.at[1] - end.at[0] - edge);
    if change.length() <= STRAIGHT * edge.length() {
        // All of these are as long.
        return (begin.ends, 0.5);
    }
    (begin.ends, (-gap.dot(change) / change.length_squared()).clamp(0.0, 1.0))
}

/// In mean edges.
pub(super) fn total(segments: &[Segment]) -> f64 {
    segments.iter().map(|segment| segment.length).sum()
}
