//! Attributes by corner, as formats have them that index positions and attributes apart, as rows of vertices.

use std::cmp::Ordering;

use heatwalk_base::csr::distribute;
use heatwalk_base::parallel;
use heatwalk_base::sort;

use crate::appearance::Seams;

/// The seams of triangles whose corners have attributes of their own, and for each row a corner that has it; none for a vertex
/// that no triangle uses. Corner `3 t + k` is the k-th of triangle t; `order` compares the attributes of two of them. Each
/// triangle has vertices below `vertices`.
pub fn seams(
    vertices: usize,
    triangles: &[[u32; 3]],
    order: &dyn Fn(usize, usize) -> Ordering,
) -> (Seams, Vec<Option<usize>>) {
    let vertex_of_corner = triangles.as_flattened();
    let vertex = |corner: usize| Some(vertex_of_corner[corner] as usize);
    let (start, mut corners) =
        distribute(vertices, vertex_of_corner.len(), parallel::ONE, vertex, |corner| corner as u32);
    let mut rows: Vec<Option<usize>> = vec![None; vertices];
    let mut seams = Seams { vertices: (0..vertices as u32).collect(), corners: triangles.to_vec() };
    let row_of_corner = seams.corners.as_flattened_mut();
    let compare = |a: &u32, b: &u32| order(*a as usize, *b as usize);
    for vertex in 0..vertices {
        let corners = &mut corners[start[vertex] as usize..start[vertex + 1] as usize];
        sort::sort_by(corners, compare);
        for equal in corners.chunk_by(|a, b| compare(a, b).is_eq()) {
            let corner = Some(equal[0] as usize);
            if rows[vertex].is_none() {
                rows[vertex] = corner;
                continue;
            }
            equal.iter().for_each(|&corner| row_of_corner[corner as usize] = rows.len() as u32);
            seams.vertices.push(vertex as u32);
            rows.push(corner);
        }
    }
    if rows.len() == vertices { (Seams::default(), rows) } else { (seams, rows) }
}
