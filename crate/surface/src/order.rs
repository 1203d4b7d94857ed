//! The order of vertices and triangles in memory: neighbours on the surface shall be neighbours there, since whatever
//! spreads over the surface waits for memory otherwise.
//!
//! The curve is that of Morton, "A computer oriented geodetic data base", 1966: cells by the interleaved bits of their coordinates.

use glam::DVec3;

use crate::csr::Csr;
use crate::element::{InputTriangle, VertexId};

/// Smaller surfaces stay in the processor's caches whatever their order.
const LEAST_VERTICES: usize = 1 << 14;

/// Vertices in rows are this far apart at most, in rows.
const ROWS_APART: f64 = 8.0;

/// Cells of the curve along each axis, as a power of two.
const BITS: u32 = 10;

/// Renumbers vertices along a Morton curve, and sorts triangles by their vertices, where the order given is so scattered that
/// it costs time. `vertex_of_input` tells the vertex of each input vertex, or a number out of range. Returns the order of the
/// triangles; none where everything stays.
pub fn gather(
    triangles: &[[u32; 3]],
    positions: &mut [DVec3],
    vertex_of_input: &mut [u32],
) -> Option<Vec<InputTriangle>> {
    if positions.len() < LEAST_VERTICES || !is_scattered(triangles, positions.len(), vertex_of_input) {
        return None;
    }
    let order = along_curve(positions.iter().copied());
    let mut renumbered = vec![0; positions.len()];
    for (new, &old) in order.iter().enumerate() {
        renumbered[old as usize] = new as u32;
    }
    let gathered: Vec<DVec3> = order.iter().map(|&old| positions[old as usize]).collect();
    positions.copy_from_slice(&gathered);
    for vertex in vertex_of_input.iter_mut() {
        *vertex = renumbered.get(*vertex as usize).copied().unwrap_or(*vertex);
    }
    let first = |corners: &[u32; 3]| corners.iter().map(|&corner| VertexId(vertex_of_input[corner as usize])).min();
    Some(Csr::group(positions.len(), triangles.iter().map(first)).into_items())
}

/// Whether the numbers of a triangle's vertices are far apart in the mean, or those of successive triangles.
fn is_scattered(triangles: &[[u32; 3]], vertices: usize, vertex_of_input: &[u32]) -> bool {
    let number = |corner: u32| i64::from(vertex_of_input[corner as usize]);
    let steps = |[a, b, c]: [u32; 3]| number(a).abs_diff(number(b)).max(number(b).abs_diff(number(c)));
    let inside: u64 = triangles.iter().map(|&corners| steps(corners)).sum();
    let between: u64 = triangles.windows(2).map(|pair| number(pair[0][0]).abs_diff(number(pair[1][0]))).sum();
    (inside + between) as f64 > ROWS_APART * (vertices as f64).sqrt() * triangles.len() as f64
}

/// The numbers of points in order of a Morton curve through their bounding box.
pub fn along_curve(points: impl Iterator<Item = DVec3> + Clone) -> Vec<u32> {
    let bounds = |(low, high): (DVec3, DVec3), point| (low.min(point), high.max(point));
    let (low, high) = points.clone().fold((DVec3::MAX, DVec3::MIN), bounds);
    // Halved, so that the size of the largest box is a number.
    let size = (0.5 * high - 0.5 * low).max_element();
    let cells = f64::from((1_u32 << BITS) - 1);
    let mut keyed: Vec<u64> = points
        .zip(0_u64..)
        .map(|(point, number)| {
            let cell = (0.5 * point - 0.5 * low) / size * cells;
            let code = spread(cell.x as u32) | spread(cell.y as u32) << 1 | spread(cell.z as u32) << 2;
            u64::from(code) << 32 | number
        })
        .collect();
    keyed.sort_unstable();
    keyed.into_iter().map(|key| key as u32).collect()
}

/// The lowest [`BITS`] bits, two zeros before each.
fn spread(bits: u32) -> u32 {
    let bits = (bits | bits << 16) & 0x0300_00FF;
    let bits = (bits | bits << 8) & 0x0300_F00F;
    let bits = (bits | bits << 4) & 0x030C_30C3;
    (bits | bits << 2) & 0x0924_9249
}
