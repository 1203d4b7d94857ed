//! Shortest paths along edges (Dijkstra 1959): an upper bound for distance, and the way out of a dead end.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::ControlFlow;

use crate::csr::NONE;
use crate::surface::Surface;
use crate::triangle;

/// Visits points in order of their distance along edges from `start`, until `settled(point, distance)` breaks or all
/// that can be reached are done. Returns the predecessor of each point, [`NONE`] for the start and the unreached.
pub(crate) fn sweep(
    surface: &Surface,
    start: u32,
    mut settled: impl FnMut(u32, f64) -> ControlFlow<()>,
) -> Vec<u32> {
    let mut best = vec![f64::INFINITY; surface.point_count()];
    let mut parent = vec![NONE; surface.point_count()];
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
                parent[other as usize] = point;
                queue.push(Reverse((candidate.to_bits(), other)));
            }
        }
    }
    parent
}

/// The farthest point from `start` along edges, with its distance.
fn farthest(surface: &Surface, start: u32) -> (u32, f64) {
    let mut last = (start, 0.0);
    sweep(surface, start, |point, distance| {
        last = (point, distance);
        ControlFlow::Continue(())
    });
    last
}

/// The largest extent of a connected piece along edges, found by two sweeps over each; at least half the true one.
pub(crate) fn extent(surface: &Surface) -> f64 {
    let mut extent: f64 = 0.0;
    let mut next = 0;
    for point in 0..surface.point_count() as u32 {
        if surface.component_of_point[point as usize] == next {
            next += 1;
            let (end, _) = farthest(surface, point);
            extent = extent.max(farthest(surface, end).1);
        }
    }
    extent
}
