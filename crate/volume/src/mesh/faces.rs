//! Which tetrahedra share a face.

use crate::error::{Error, Result};
use crate::lists::Lists;
use crate::mesh::{FACES, NONE};

/// The tetrahedron beyond the face opposite each corner, or [`NONE`].
///
/// # Errors
/// [`Error::NonManifoldFace`], in the numbers of `tetrahedra`.
pub(super) fn neighbors(vertices: usize, tetrahedra: &[[u32; 4]]) -> Result<Vec<[u32; 4]>> {
    // Faces are told apart among those with the same lowest vertex: some dozen each.
    let lowest = |side: usize| corners(tetrahedra, side)[0];
    let sides = 4 * tetrahedra.len();
    let of_vertex = Lists::group(vertices, || (0..sides).map(|side| (lowest(side), side as u32)));
    let mut neighbors = vec![[NONE; 4]; tetrahedra.len()];
    let mut faces: Vec<(u32, u32, u32)> = Vec::new();
    for vertex in 0..of_vertex.rows() as u32 {
        faces.clear();
        faces.extend(of_vertex.row(vertex).iter().map(|&side| {
            let [_, middle, highest] = corners(tetrahedra, side as usize);
            (middle, highest, side)
        }));
        faces.sort_unstable();
        for shared in faces.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            match *shared {
                [(.., one), (.., other)] => {
                    neighbors[one as usize / 4][one as usize % 4] = other / 4;
                    neighbors[other as usize / 4][other as usize % 4] = one / 4;
                }
                [(middle, highest, a), (.., b), (.., c), ..] => {
                    let tetrahedra = [a / 4, b / 4, c / 4];
                    return Err(Error::NonManifoldFace { tetrahedra, vertices: [vertex, middle, highest] });
                }
                _ => {}
            }
        }
    }
    Ok(neighbors)
}

/// Corners of the face opposite corner `side % 4` of tetrahedron `side / 4`, ascending.
fn corners(tetrahedra: &[[u32; 4]], side: usize) -> [u32; 3] {
    let mut corners = FACES[side % 4].map(|corner| tetrahedra[side / 4][corner]);
    corners.sort_unstable();
    corners
}
