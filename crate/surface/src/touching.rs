//! Sheets of one surface that touch in a point without an edge or a vertex of the file in common. Distance must not take
//! a short cut there, so they are parted; but where the touch is all that holds two pieces together, it is kept.

use glam::DVec3;

use crate::csr::{Csr, NONE};
use crate::edges::Edges;
use crate::union_find::UnionFind;

/// What tells the sheets at welded points apart.
pub struct Sheets<'a, I> {
    /// The corners `3 f + k` at each point.
    pub corners_of_point: &'a Csr,
    pub edges: &'a Edges,
    /// The vertex of the file at a corner.
    pub input: I,
}

/// Lists used at each point anew.
#[derive(Default)]
struct Scratch {
    /// What corners have in common, a vertex of the file or a point, each with the place of a corner that has it.
    keys: Vec<((bool, u32), usize)>,
    /// The first corner of each corner's group.
    sheet: Vec<usize>,
}

impl<I: Fn(u32) -> u32> Sheets<'_, I> {
    /// Gives each further sheet of a piece at a point a point of its own, at the same position, after the last point.
    /// `faces` are over welded points, `point_of_input` has [`NONE`] for vertices that no face uses. Returns whether
    /// any sheet got one.
    pub fn part_touching(
        &self,
        faces: &mut [[u32; 3]],
        positions: &mut Vec<DVec3>,
        point_of_input: &mut [u32],
    ) -> bool {
        let mut inputs = vec![0_u32; positions.len()];
        for &point in point_of_input.iter().filter(|&&point| point != NONE) {
            inputs[point as usize] += 1;
        }
        // The corners of each sheet at points where there are several.
        let mut touching: Vec<Vec<Vec<u32>>> = Vec::new();
        let mut scratch = Scratch::default();
        for (_, corners) in self.corners_of_point.rows().enumerate().filter(|&(point, _)| inputs[point] > 1) {
            touching.extend(self.at_point(corners, faces, &mut scratch));
        }
        if touching.is_empty() {
            return false;
        }
        let mut pieces = self.pieces(faces.len());
        let points = positions.len();
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
                    point_of_input[(self.input)(corner) as usize] = point;
                    faces[corner as usize / 3][corner as usize % 3] = point;
                }
            }
        }
        positions.len() > points
    }

    /// Groups the corners at a point by what they have in common: other ends of their edges, or vertices of the file.
    /// `None` where they are one group.
    fn at_point(&self, corners: &[u32], faces: &[[u32; 3]], scratch: &mut Scratch) -> Option<Vec<Vec<u32>>> {
        let Scratch { keys, sheet } = scratch;
        keys.clear();
        for (index, &corner) in corners.iter().enumerate() {
            let (face, k) = (faces[corner as usize / 3], corner as usize % 3);
            let common = [(true, (self.input)(corner)), (false, face[(k + 1) % 3]), (false, face[(k + 2) % 3])];
            keys.extend(common.map(|key| (key, index)));
        }
        keys.sort_unstable();
        sheet.clear();
        sheet.extend(0..corners.len());
        for pair in keys.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            let [a, b] = [pair[0].1, pair[1].1].map(|index| sheet[index]);
            if a != b {
                for number in sheet.iter_mut().filter(|number| **number == a.max(b)) {
                    *number = a.min(b);
                }
            }
        }
        if sheet.iter().all(|&number| number == 0) {
            return None;
        }
        let mut sheets: Vec<Vec<u32>> = Vec::new();
        for first in (0..corners.len()).filter(|&index| sheet[index] == index) {
            let of_sheet = corners.iter().zip(&*sheet).filter(|&(_, &number)| number == first);
            sheets.push(of_sheet.map(|(&corner, _)| corner).collect());
        }
        Some(sheets)
    }

    /// Faces that edges or vertices of the file hold together.
    fn pieces(&self, faces: usize) -> UnionFind {
        let mut pieces = UnionFind::new(faces);
        for last in self.edges.lasts() {
            for side in self.edges.around(last) {
                pieces.join(last / 3, side / 3);
            }
        }
        let mut of_inputs: Vec<(u32, u32)> = Vec::new();
        for corners in self.corners_of_point.rows() {
            of_inputs.clear();
            of_inputs.extend(corners.iter().map(|&corner| ((self.input)(corner), corner / 3)));
            of_inputs.sort_unstable();
            for pair in of_inputs.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
                pieces.join(pair[0].1, pair[1].1);
            }
        }
        pieces
    }
}
