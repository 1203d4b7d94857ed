//! Sheets of one surface that touch in a point without an edge or a vertex of the file in common. Distance must not take
//! a short cut there, so they are parted; but where the touch is all that holds two pieces together, it is kept.

use glam::DVec3;

use crate::csr::{Csr, NONE};
use crate::pairing::for_each_edge;
use crate::soup::Soup;
use crate::union_find::UnionFind;

/// Gives each further sheet of a piece at a point a point of its own, at the same position, after the last point.
/// `faces` are over welded points, `point_of_input` has [`NONE`] for vertices that no face uses.
pub(crate) fn part_touching(
    soup: &Soup,
    triangle_of_face: &[u32],
    faces: &mut [[u32; 3]],
    positions: &mut Vec<DVec3>,
    point_of_input: &mut [u32],
) {
    let input = |corner: u32| soup.triangles[triangle_of_face[corner as usize / 3] as usize][corner as usize % 3];
    let mut inputs = vec![0_u32; positions.len()];
    for &point in point_of_input.iter().filter(|&&point| point != NONE) {
        inputs[point as usize] += 1;
    }
    let corners_of_point = Csr::group(positions.len(), faces.iter().flatten().copied());
    // The corners of each sheet at points where there are several.
    let mut touching: Vec<Vec<Vec<u32>>> = Vec::new();
    for (_, corners) in corners_of_point.rows().enumerate().filter(|&(point, _)| inputs[point] > 1) {
        let sheets = sheets(corners, faces, input);
        if sheets.len() > 1 {
            touching.push(sheets);
        }
    }
    if touching.is_empty() {
        return;
    }
    let mut pieces = pieces(faces, &corners_of_point, input);
    for sheets in touching {
        let mut here = Vec::new();
        for sheet in sheets {
            let piece = pieces.least(sheet[0] / 3);
            if !here.contains(&piece) {
                here.push(piece);
                continue;
            }
            let corner = sheet[0] as usize;
            positions.push(positions[faces[corner / 3][corner % 3] as usize]);
            let point = positions.len() as u32 - 1;
            for corner in sheet {
                point_of_input[input(corner) as usize] = point;
                faces[corner as usize / 3][corner as usize % 3] = point;
            }
        }
    }
}

/// Groups the corners at a point by what they have in common: other ends of their edges, or vertices of the file.
fn sheets(corners: &[u32], faces: &[[u32; 3]], input: impl Fn(u32) -> u32) -> Vec<Vec<u32>> {
    let mut keys: Vec<((bool, u32), usize)> = Vec::with_capacity(3 * corners.len());
    for (index, &corner) in corners.iter().enumerate() {
        let (face, k) = (faces[corner as usize / 3], corner as usize % 3);
        let common = [(true, input(corner)), (false, face[(k + 1) % 3]), (false, face[(k + 2) % 3])];
        keys.extend(common.map(|key| (key, index)));
    }
    keys.sort_unstable();
    let mut sheet: Vec<usize> = (0..corners.len()).collect();
    for pair in keys.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
        let [a, b] = [pair[0].1, pair[1].1].map(|index| sheet[index]);
        for number in sheet.iter_mut().filter(|number| **number == a.max(b)) {
            *number = a.min(b);
        }
    }
    let mut sheets: Vec<Vec<u32>> = Vec::new();
    for first in (0..corners.len()).filter(|&index| sheet[index] == index) {
        sheets
            .push((first..corners.len()).filter(|&index| sheet[index] == first).map(|index| corners[index]).collect());
    }
    sheets
}

/// Faces that edges or vertices of the file hold together.
fn pieces(faces: &[[u32; 3]], corners_of_point: &Csr, input: impl Fn(u32) -> u32) -> UnionFind {
    let mut pieces = UnionFind::new(faces.len());
    for_each_edge(faces, corners_of_point, |_, sides| {
        for pair in sides.windows(2) {
            pieces.join(pair[0] / 3, pair[1] / 3);
        }
    });
    let mut of_inputs: Vec<(u32, u32)> = Vec::new();
    for corners in corners_of_point.rows() {
        of_inputs.clear();
        of_inputs.extend(corners.iter().map(|&corner| (input(corner), corner / 3)));
        of_inputs.sort_unstable();
        for pair in of_inputs.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            pieces.join(pair[0].1, pair[1].1);
        }
    }
    pieces
}
