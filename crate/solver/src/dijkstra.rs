//! Shortest paths along edges (Dijkstra 1959): an upper bound for distance, and the way out of a dead end.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::ControlFlow;

use crate::csr::NONE;
use crate::surface::Surface;
use crate::triangle;

/// Visits points in order of their distance along edges from `start`, until `settled(point, distance)` breaks or all
/// that can be reached are done. `best` holds infinity at every point of the piece before, the distances after;
/// `improved(point, from)` tells each new predecessor.
fn sweep(
    surface: &Surface,
    start: u32,
    best: &mut [f64],
    mut settled: impl FnMut(u32, f64) -> ControlFlow<()>,
    mut improved: impl FnMut(u32, u32),
) {
    // Bits of non-negative floats order as the floats do.
    let mut queue = BinaryHeap::from([Reverse((0.0_f64.to_bits(), start))]);
    best[start as usize] = 0.0;
    while let Some(Reverse((bits, point))) = queue.pop() {
        let distance = f64::from_bits(bits);
        if distance > best[point as usize] {
            continue;
        }
        if settled(point, distance).is_break() {
            break;
        }
        let position = surface.position(point);
        for other in surface.neighbours(point) {
            let candidate = distance + triangle::length(surface.position(other) - position);
            if candidate < best[other as usize] {
                best[other as usize] = candidate;
                improved(other, point);
                queue.push(Reverse((candidate.to_bits(), other)));
            }
        }
    }
}

/// The shortest way along edges from `start` to the nearest point that is a `goal`, both ends included; `None` where
/// none can be reached.
pub(crate) fn way_to(surface: &Surface, start: u32, goal: impl Fn(u32) -> bool) -> Option<Vec<u32>> {
    let mut best = vec![f64::INFINITY; surface.point_count()];
    let mut from = vec![NONE; surface.point_count()];
    let mut end = None;
    let settled = |point, _| {
        if goal(point) {
            end = Some(point);
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    sweep(surface, start, &mut best, settled, |point, before| from[point as usize] = before);
    let step_back = |&point: &u32| Some(from[point as usize]).filter(|&before| before != NONE);
    let mut way: Vec<u32> = std::iter::successors(Some(end?), step_back).collect();
    way.reverse();
    Some(way)
}

/// The largest extent of a connected piece along edges, found by two sweeps over each; at least half the true one.
pub(crate) fn extent(surface: &Surface) -> f64 {
    let mut first = vec![f64::INFINITY; surface.point_count()];
    let mut second = first.clone();
    let mut extent: f64 = 0.0;
    let mut pieces = 0;
    for point in 0..surface.point_count() as u32 {
        if surface.component_of_point[point as usize] == pieces {
            pieces += 1;
            let (end, _) = farthest(surface, point, &mut first);
            extent = extent.max(farthest(surface, end, &mut second).1);
        }
    }
    extent
}

/// The farthest point of the piece from `start` along edges, with its distance.
fn farthest(surface: &Surface, start: u32, best: &mut [f64]) -> (u32, f64) {
    let mut last = (start, 0.0);
    let settled = |point, distance| {
        last = (point, distance);
        ControlFlow::Continue(())
    };
    sweep(surface, start, best, settled, |_, _| {});
    last
}
