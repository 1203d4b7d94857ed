//! Attributes by corner, as formats have them that index positions and attributes apart, as rows of vertices.

use std::cmp::Ordering;

use crate::appearance::Seams;
use crate::csr::distribute;
use crate::parallel;

/// The seams of triangles whose corners have attributes of their own, told apart by `order`, and what each row is made of; none
/// for vertices that no triangle uses. Each corner names a vertex below `vertices`.
pub fn seams<A: Copy>(
    vertices: usize,
    triangles: &[[u32; 3]],
    attributes: &[[A; 3]],
    order: impl Fn(&A, &A) -> Ordering,
) -> (Seams, Vec<Option<A>>) {
    let (vertex_of_corner, attribute) = (triangles.as_flattened(), attributes.as_flattened());
    let vertex = |corner: usize| Some(vertex_of_corner[corner] as usize);
    let (start, mut corners) =
        distribute(vertices, vertex_of_corner.len(), parallel::ONE, vertex, |corner| corner as u32);
    let mut rows: Vec<Option<A>> = vec![None; vertices];
    let mut seams = Seams { vertices: (0..vertices as u32).collect(), corners: triangles.to_vec() };
    let row_of_corner = seams.corners.as_flattened_mut();
    for vertex in 0..vertices {
        let corners = &mut corners[start[vertex] as usize..start[vertex + 1] as usize];
        let compare = |a: &u32, b: &u32| order(&attribute[*a as usize], &attribute[*b as usize]);
        corners.sort_unstable_by(compare);
        for equal in corners.chunk_by(|a, b| compare(a, b).is_eq()) {
            let value = Some(attribute[equal[0] as usize]);
            if rows[vertex].is_none() {
                rows[vertex] = value;
                continue;
            }
            equal.iter().for_each(|&corner| row_of_corner[corner as usize] = rows.len() as u32);
            seams.vertices.push(vertex as u32);
            rows.push(value);
        }
    }
    if rows.len() == vertices { (Seams::default(), rows) } else { (seams, rows) }
}
