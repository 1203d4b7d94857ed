//! What is inside of a lattice tetrahedron, in tetrahedra: the stencils of Labelle & Shewchuk (2007), figure 3.
//!
//! A face of which two corners are inside and the third is outside is cut to a quadrilateral. Both tetrahedra at the face have to
//! split it by the same diagonal, and dihedral angles depend on which one.

use super::lattice::{Directions, is_long};

/// Where a lattice point is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    Inside,
    Surface,
    Outside,
}

/// A corner of a part of a lattice tetrahedron.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corner {
    /// Of the lattice tetrahedron.
    Lattice(usize),
    /// Where the edge from one inside to one outside is cut.
    Cut(usize, usize),
}

/// Calls `emit` with each tetrahedron of what is inside, oriented as the lattice tetrahedron of these points.
pub fn split(signs: [Sign; 4], points: [usize; 4], directions: &Directions, mut emit: impl FnMut([Corner; 4])) {
    let mut inside = [0; 4];
    let mut outside = [0; 4];
    let (mut insides, mut outsides) = (0, 0);
    for corner in 0..4 {
        match signs[corner] {
            Sign::Inside => {
                inside[insides] = corner;
                insides += 1;
            }
            Sign::Outside => {
                outside[outsides] = corner;
                outsides += 1;
            }
            Sign::Surface => {}
        }
    }
    let diagonal = |first: usize, second: usize, out: usize| {
        let [first_is_long, second_is_long] = [first, second].map(|corner| is_long(directions[corner][out]));
        if first_is_long == second_is_long { points[first] < points[second] } else { second_is_long }
    };
    let mut parts = Parts { emit: &mut emit };
    match (&inside[..insides], &outside[..outsides]) {
        ([], _) => {}
        (_, []) => parts.add([0, 1, 2, 3].map(Corner::Lattice), true),
        (&[within], _) => {
            let is_outside = |corner: usize| signs[corner] == Sign::Outside;
            let corner =
                |corner| if is_outside(corner) { Corner::Cut(within, corner) } else { Corner::Lattice(corner) };
            parts.add([0, 1, 2, 3].map(corner), true);
        }
        (&[a, b], &[out]) => {
            let apex = 6 - a - b - out;
            let quad = [Corner::Lattice(a), Corner::Lattice(b), Corner::Cut(b, out), Corner::Cut(a, out)];
            let halves = if diagonal(a, b, out) { [[0, 1, 2], [0, 2, 3]] } else { [[1, 2, 3], [1, 3, 0]] };
            for half in halves {
                let [i, j, k] = half.map(|corner| quad[corner]);
                parts.add([i, j, k, Corner::Lattice(apex)], is_even([a, b, out, apex]));
            }
        }
        (&[a, b, c], &[out]) => {
            let ends = [[a, b, c].map(Corner::Lattice), [a, b, c].map(|corner| Corner::Cut(corner, out))];
            let diagonals = [diagonal(a, b, out), diagonal(b, c, out), diagonal(c, a, out)];
            parts.prism(ends, diagonals, is_even([a, b, c, out]));
        }
        (&[a, b], &[c, d]) => {
            let end = |corner| [Corner::Lattice(corner), Corner::Cut(corner, c), Corner::Cut(corner, d)];
            let (first, last) = (diagonal(a, b, c), !diagonal(a, b, d));
            // That of the quadrilateral on the surface is free, but the three must not run around the prism.
            parts.prism([end(a), end(b)], [first, !last, last], is_even([a, c, d, b]));
        }
        _ => {}
    }
}

/// Whether a permutation of the corners keeps the orientation.
fn is_even(corners: [usize; 4]) -> bool {
    let inversions = (0..4).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| corners[i] > corners[j]);
    inversions.count() % 2 == 0
}

/// Tetrahedra that are found.
struct Parts<'a, F> {
    emit: &'a mut F,
}

impl<F: FnMut([Corner; 4])> Parts<'_, F> {
    fn add(&mut self, [a, b, c, d]: [Corner; 4], is_even: bool) {
        (self.emit)(if is_even { [a, b, c, d] } else { [b, a, c, d] });
    }

    /// The prism between two triangles. Diagonal `i` leaves corner `i` of the first one, else corner `i + 1`. Of the three, two meet
    /// in a corner; the tetrahedra are those from there to the triangles of the faces without this corner.
    fn prism(&mut self, ends: [[Corner; 3]; 2], diagonals: [bool; 3], is_even: bool) {
        // Corners 0 to 2 of the first triangle, 3 to 5 of the other one; the diagonals that meet in each.
        let meets = |corner: usize| {
            let (after, before) = (corner % 3, (corner + 2) % 3);
            diagonals[after] == (corner < 3) && diagonals[before] == (corner >= 3)
        };
        let apex = (0..6).find(|&corner| meets(corner)).expect("diagonals do not run around");
        let mut triangles = [[0, 2, 1], [3, 4, 5], [0; 3], [0; 3], [0; 3], [0; 3], [0; 3], [0; 3]];
        for side in 0..3 {
            let [a, b] = [side, (side + 1) % 3];
            let halves =
                if diagonals[side] { [[a, b, b + 3], [a, b + 3, a + 3]] } else { [[a, b, a + 3], [b, b + 3, a + 3]] };
            triangles[2 + 2 * side..4 + 2 * side].copy_from_slice(&halves);
        }
        let corner = |corner: usize| ends[corner / 3][corner % 3];
        for [a, b, c] in triangles.into_iter().filter(|triangle| !triangle.contains(&apex)) {
            self.add([corner(a), corner(c), corner(b), corner(apex)], is_even);
        }
    }
}
