//! The order of vertices and triangles in memory: neighbours on the surface shall be neighbours there, since whatever
//! spreads over the surface waits for memory otherwise.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk_base::parallel::{self, Numbers};
use heatwalk_base::sort::Sorted;

use crate::element::{InputTriangle, VertexId};
use crate::index::along_curve;

/// Smaller surfaces stay in the processor's caches whatever their order.
const LEAST_VERTICES: usize = 1 << 14;

/// Vertices in rows are this far apart at most, in rows.
const ROWS_APART: f64 = 8.0;

/// Triangles that tell whether the order is scattered.
const SAMPLES: usize = 1 << 16;

/// Renumbers vertices along a Morton curve where the order given is so scattered that it costs time. `vertex_of_input` tells
/// the vertex of each input vertex, or a number out of range. Returns whether it did.
pub fn gather(
    triangles: &[[u32; 3]],
    positions: &mut Vec<DVec3>,
    vertex_of_input: &mut [u32],
    threads: NonZeroUsize,
) -> bool {
    if positions.len() < LEAST_VERTICES || !is_scattered(triangles, positions.len(), vertex_of_input) {
        return false;
    }
    let order = along_curve(positions.len(), |vertex| positions[vertex], threads);
    let renumbered = Numbers::identity(positions.len());
    *positions = parallel::collect(order.len(), threads, |new| {
        renumbered.set(order[new], new as u32);
        positions[order[new] as usize]
    });
    let vertices = positions.len();
    parallel::map_parts(parallel::ranges(vertex_of_input.len(), threads), vertex_of_input, |_, numbers| {
        for number in numbers.iter_mut().filter(|number| (**number as usize) < vertices) {
            *number = renumbered.get(*number);
        }
    });
    true
}

/// Sorts faces by their first vertices, those of one vertex in their own order. Returns the number that each one had.
pub fn sort_faces(faces: &mut Vec<[VertexId; 3]>, vertices: usize, threads: NonZeroUsize) -> Vec<InputTriangle> {
    let first = |face: usize| faces[face].iter().map(|vertex| vertex.0).min().unwrap_or_default();
    let keys = parallel::collect(faces.len(), threads, first);
    let order = Sorted::new(&keys, vertices.ilog2() + 1, threads);
    *faces = parallel::collect(order.count(), threads, |place| faces[order.number(place) as usize]);
    parallel::collect(order.count(), threads, |place| InputTriangle(order.number(place)))
}

/// Whether the numbers of a triangle's vertices are far apart in the mean, or those of successive triangles, as a sample tells.
fn is_scattered(triangles: &[[u32; 3]], vertices: usize, vertex_of_input: &[u32]) -> bool {
    let number = |corner: u32| i64::from(vertex_of_input[corner as usize]);
    let steps = |pair: &[[u32; 3]]| {
        let [[a, b, c], [d, ..]] = [pair[0], pair[1]].map(|triangle| triangle.map(number));
        (a.abs_diff(b).max(b.abs_diff(c)), a.abs_diff(d))
    };
    let sample = triangles.windows(2).step_by((triangles.len() / SAMPLES).max(1));
    let count = sample.len();
    let total: u64 = sample.map(steps).map(|(inside, between)| inside + between).sum();
    total as f64 > ROWS_APART * (vertices as f64).sqrt() * count as f64
}
