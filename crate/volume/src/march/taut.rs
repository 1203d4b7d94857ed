//! Paths pulled taut: corners are left out where straight lines see past them, slide along the edges that they bend around, and are cut
//! where they do not bend around any. Lines stay in tetrahedra of one cost, so corners where a path refracts stay where they are.

use glam::DVec3;

use super::medium::Medium;
use crate::corner::Corner;
use crate::mesh::{Crossing, Start, TetMesh};

/// Rounds of cutting corners, at most. Each about halves what a corner is too far out.
const ROUNDS: usize = 24;

/// Ends when a round has shortened the path by less than this share.
const GAIN: f64 = 1e-7;

/// How often the share at which a corner is cut is halved before it is left.
const HALVINGS: u32 = 8;

/// Shortens a path while its ends stay where they are.
pub(crate) fn pull(mesh: &TetMesh, medium: &Medium, corners: &mut Vec<Corner>) {
    skip(mesh, medium, corners);
    shorten(mesh, medium, corners, |mesh, medium, corners| slide(mesh, medium, corners));
    shorten(mesh, medium, corners, cut);
}

/// Goes on by steps of one kind while they shorten the path.
fn shorten(mesh: &TetMesh, medium: &Medium, corners: &mut Vec<Corner>, step: fn(&TetMesh, &Medium, &mut Vec<Corner>)) {
    let mut length = length_of(corners);
    for _ in 0..ROUNDS {
        if corners.len() <= 2 {
            return;
        }
        step(mesh, medium, corners);
        skip(mesh, medium, corners);
        let shorter = length_of(corners);
        if shorter >= length * (1.0 - GAIN) {
            return;
        }
        length = shorter;
    }
}

/// The length of a path.
pub(crate) fn length_of(corners: &[Corner]) -> f64 {
    corners.windows(2).map(|ends| ends[0].place.distance(ends[1].place)).sum()
}

/// Leaves out corners that lie between two that see each other.
fn skip(mesh: &TetMesh, medium: &Medium, corners: &mut Vec<Corner>) {
    let mut kept = vec![corners[0]];
    let mut current = 0;
    while current + 1 < corners.len() {
        // The farthest that is seen, in strides that double while they succeed and halve while they do not.
        let (mut next, mut stride) = (current + 1, 1);
        while stride > 0 {
            let target = next + stride;
            let is_seen = target < corners.len() && medium.sees(mesh, [corners[current], corners[target]]);
            if is_seen {
                next = target;
                stride *= 2;
            } else {
                stride /= 2;
            }
        }
        kept.push(corners[next]);
        current = next;
    }
    *corners = kept;
}

/// Slides every corner along the edge that it is on, or one that it is the end of, to where the path is shortest, if that is seen from its
/// neighbors.
fn slide(mesh: &TetMesh, medium: &Medium, corners: &mut [Corner]) {
    for index in 1..corners.len() - 1 {
        let [before, corner, after] = [corners[index - 1], corners[index], corners[index + 1]];
        if before.cost != corner.cost {
            continue;
        }
        let edges: Vec<[u32; 2]> = match corner.start {
            Start::Edge(ends) => vec![ends],
            Start::Vertex(vertex) => mesh.adjacent().row(vertex).iter().map(|&other| [vertex, other]).collect(),
            Start::Inside(_) => continue,
        };
        let length = |place: DVec3| before.place.distance(place) + place.distance(after.place);
        let mut shortest = length(corner.place) * (1.0 - GAIN);
        for ends in edges {
            let (place, start) = best_on(mesh, ends, [before.place, after.place]);
            let moved = Corner { place, start, ..corner };
            let is_better =
                length(place) < shortest && medium.sees(mesh, [before, moved]) && medium.sees(mesh, [moved, after]);
            if is_better {
                shortest = length(place);
                corners[index] = moved;
            }
        }
    }
}

/// Where a shortest path between two places crosses an edge: straight once both sides are unfolded around it.
fn best_on(mesh: &TetMesh, ends: [u32; 2], places: [DVec3; 2]) -> (DVec3, Start) {
    let [base, end] = ends.map(|vertex| mesh.positions()[vertex as usize]);
    let length = base.distance(end);
    let direction = (end - base) / length;
    let [(one, one_away), (other, other_away)] = places.map(|place| {
        let along = (place - base).dot(direction);
        (along, (place - base - along * direction).length())
    });
    let along = (one * other_away + other * one_away) / (one_away + other_away);
    // Written so that not a number, where both places are on the line of the edge, stays at an end.
    if along > 0.0 && along < length {
        (base + along * direction, Start::Edge(ends))
    } else if along >= length {
        (end, Start::Vertex(ends[1]))
    } else {
        (base, Start::Vertex(ends[0]))
    }
}

/// Cuts every corner as deep as the line across stays inside.
fn cut(mesh: &TetMesh, medium: &Medium, corners: &mut Vec<Corner>) {
    let mut pulled = vec![corners[0]];
    for index in 1..corners.len() - 1 {
        let (before, corner, after) = (*pulled.last().expect("the first is there"), corners[index], corners[index + 1]);
        let at = |end: &Corner, share: f64| -> Option<Corner> {
            let place = corner.place.lerp(end.place, share);
            let may_enter = |tetrahedron: u32| medium.cost(tetrahedron) == corner.cost;
            let inside = medium.sight(mesh).walk(corner.start, [corner.place, place], may_enter, |_| Crossing::On)?;
            Some(Corner { place, start: Start::Inside(inside), cost: corner.cost })
        };
        if before.cost != corner.cost {
            pulled.push(corner);
            continue;
        }
        let across = (1..=HALVINGS).find_map(|halving| {
            let share = 0.5_f64.powi(halving as i32);
            let (near, far) = (at(&before, share)?, at(&after, share)?);
            // A line along a crack may have been followed on the other side of it.
            let is_clear = [[near, far], [before, near], [far, after]].into_iter().all(|ends| medium.sees(mesh, ends));
            is_clear.then_some([near, far])
        });
        match across {
            Some(two) => pulled.extend(two),
            None => pulled.push(corner),
        }
    }
    pulled.push(corners[corners.len() - 1]);
    *corners = pulled;
}
