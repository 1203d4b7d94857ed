//! The polygon in which a plane, or a level of a linear function, crosses a tetrahedron (marching tetrahedra; Doi and Koide 1991).

use crate::mesh::{EDGES, FACES};

/// The other two corners for each of [`EDGES`], so that all four are an even permutation.
const OPPOSITE: [[usize; 2]; 6] = [[2, 3], [3, 1], [1, 2], [0, 3], [2, 0], [0, 1]];

/// The edges of a tetrahedron that are crossed, as corners before and beyond.
#[derive(Clone, Copy)]
pub(super) struct Crossed {
    edges: [[usize; 2]; 4],
    count: usize,
}

impl Crossed {
    /// In order around the polygon, counter-clockwise seen from beyond.
    #[inline]
    pub(super) fn edges(&self) -> &[[usize; 2]] {
        &self.edges[..self.count]
    }
}

/// By which corners are beyond, one bit each.
pub(super) const CROSSED: [Crossed; 16] = {
    let mut table = [Crossed { edges: [[0; 2]; 4], count: 0 }; 16];
    let mut corner = 0;
    while corner < 4 {
        let [a, b, c] = FACES[corner];
        // The face opposite is counter-clockwise seen from the side that its corner is not on.
        let before = [[corner, a], [corner, b], [corner, c], [0; 2]];
        let beyond = [[c, corner], [b, corner], [a, corner], [0; 2]];
        table[0b1111 ^ (1 << corner)] = Crossed { edges: before, count: 3 };
        table[1 << corner] = Crossed { edges: beyond, count: 3 };
        corner += 1;
    }
    let mut edge = 0;
    while edge < 6 {
        let ([a, b], [c, d]) = (EDGES[edge], OPPOSITE[edge]);
        table[(1 << c) | (1 << d)] = Crossed { edges: [[a, c], [a, d], [b, d], [b, c]], count: 4 };
        edge += 1;
    }
    table
};
