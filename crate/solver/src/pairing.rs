//! Which half-edges of a triangle list face each other, and which triangles to turn so that they agree.

use crate::csr::{Csr, NONE};

/// Visits each edge with its lower point and its half-edges `3 f + k`, ascending, of either direction. `corners` lists
/// the corners `3 f + k` at each point.
pub(crate) fn for_each_edge(faces: &[[u32; 3]], corners: &Csr, mut visit: impl FnMut(u32, &[u32])) {
    // Half-edges between the point and higher ones, as (other point, half-edge) in one sortable word.
    let mut around: Vec<u64> = Vec::new();
    let mut sides: Vec<u32> = Vec::new();
    for (point, row) in corners.rows().enumerate() {
        around.clear();
        for &corner in row {
            let (face, k) = (corner as usize / 3, corner as usize % 3);
            let before = (k + 2) % 3;
            for (other, halfedge) in
                [(faces[face][(k + 1) % 3], corner as usize), (faces[face][before], face * 3 + before)]
            {
                if other as usize > point {
                    around.push(u64::from(other) << 32 | halfedge as u64);
                }
            }
        }
        around.sort_unstable();
        for edge in around.chunk_by(|a, b| a >> 32 == b >> 32) {
            sides.clear();
            sides.extend(edge.iter().map(|&side| side as u32));
            visit(point as u32, &sides);
        }
    }
}

/// The edges of a triangle list. Half-edge `3 f + k` runs from corner `k` of face `f` to the next corner.
pub(crate) struct Pairing {
    /// `3 #F`, the other half-edge of the same edge where exactly two faces meet, else [`NONE`].
    pub(crate) mate: Vec<u32>,
    /// `3 #F`, whether the edge has one face only.
    pub(crate) single: Vec<bool>,
    /// `#E`, one half-edge of each edge.
    pub(crate) edges: Vec<u32>,
    /// Edges of three faces or more.
    pub(crate) non_manifold_edges: usize,
}

impl Pairing {
    /// Pairs half-edges by their end points; `corners` as in [`for_each_edge`].
    pub(crate) fn new(faces: &[[u32; 3]], corners: &Csr) -> Self {
        let mut pairing = Self {
            mate: vec![NONE; faces.len() * 3],
            single: vec![false; faces.len() * 3],
            edges: Vec::with_capacity(faces.len() * 3 / 2),
            non_manifold_edges: 0,
        };
        for_each_edge(faces, corners, |_, sides| {
            pairing.edges.push(sides[0]);
            match *sides {
                [only] => pairing.single[only as usize] = true,
                [a, b] => {
                    pairing.mate[a as usize] = b;
                    pairing.mate[b as usize] = a;
                }
                _ => pairing.non_manifold_edges += 1,
            }
        });
        pairing
    }

    /// The faces to turn so that as many neighbours as possible agree, the fewer in each connected piece.
    pub(crate) fn faces_to_turn(&self, faces: &[[u32; 3]]) -> Vec<u32> {
        let mut turned: Vec<Option<bool>> = vec![None; faces.len()];
        let mut piece: Vec<u32> = Vec::new();
        let mut result = Vec::new();
        for start in 0..faces.len() {
            if turned[start].is_some() {
                continue;
            }
            piece.clear();
            piece.push(start as u32);
            turned[start] = Some(false);
            let mut done = 0;
            let mut turns = 0;
            while done < piece.len() {
                let face = piece[done];
                done += 1;
                let turn = turned[face as usize] == Some(true);
                turns += usize::from(turn);
                for halfedge in face * 3..face * 3 + 3 {
                    let mate = self.mate[halfedge as usize];
                    if mate != NONE && turned[mate as usize / 3].is_none() {
                        turned[mate as usize / 3] = Some(turn ^ same_direction(faces, halfedge, mate));
                        piece.push(mate / 3);
                    }
                }
            }
            let minority = turns * 2 <= piece.len();
            result.extend(piece.iter().copied().filter(|&face| turned[face as usize] == Some(minority)));
        }
        result
    }

    /// Twin of each half-edge: its mate where the two run in opposite directions, else [`NONE`].
    pub(crate) fn twins(&self, faces: &[[u32; 3]]) -> Vec<u32> {
        let agree = |(halfedge, &mate): (usize, &u32)| {
            if mate == NONE || same_direction(faces, halfedge as u32, mate) { NONE } else { mate }
        };
        self.mate.iter().enumerate().map(agree).collect()
    }
}

/// Whether two half-edges of one edge leave the same point.
fn same_direction(faces: &[[u32; 3]], a: u32, b: u32) -> bool {
    let origin = |halfedge: u32| faces[halfedge as usize / 3][halfedge as usize % 3];
    origin(a) == origin(b)
}
