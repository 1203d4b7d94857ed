//! Which rows become one on the next grid, and its matrix.
//!
//! Notay, "An aggregation-based algebraic multigrid method" (2010): double pairwise aggregation, with two differences.
//! Rows are visited as they are numbered; and one that finds no partner joins the aggregate of its strongest neighbour
//! instead of staying alone, so that each pairing leaves at most half of the rows, even around a hub.

use crate::matrix::SymmetricMatrix;
use crate::pattern::NONE;
use crate::scalar::{Scalar, Turn};

/// A row whose diagonal is so many times the sum of its other entries is in no aggregate: smoothing alone solves it.
const DOMINANT: f64 = 5.0;

/// Another row is a partner if its coupling is at least this share of the strongest. Any share will do on good
/// triangles; of 0.25, which Notay takes, and this one, this takes fewer steps on obtuse ones.
const STRONG: f64 = 0.5;

/// Least diagonal entry of an aggregate as a share of those of its rows. Rounding of their sum may leave less than
/// nothing; a larger entry only makes the correction smaller.
const LEAST_DIAGONAL: f64 = 1e-12;

/// The matrix of the next grid.
pub(super) struct Coarse<T: Scalar> {
    /// Its row that each row of the finer grid is part of; [`NONE`] where it is in none.
    pub(super) aggregates: Vec<u32>,
    /// From the value of that row to the value of each.
    pub(super) turns: Vec<T::Turn>,
    pub(super) matrix: SymmetricMatrix<T>,
}

/// The next grid, of pairs of pairs. It is empty where no rows are coupled.
pub(super) fn coarsen<T: Scalar>(matrix: &SymmetricMatrix<T>) -> Coarse<T> {
    let mut fine = coarsen_once(matrix);
    let coarse = coarsen_once(&fine.matrix);
    for (aggregate, turn) in fine.aggregates.iter_mut().zip(&mut fine.turns).filter(|(pair, _)| **pair != NONE) {
        *turn = turn.and(coarse.turns[*aggregate as usize]);
        *aggregate = coarse.aggregates[*aggregate as usize];
    }
    Coarse { matrix: coarse.matrix, ..fine }
}

fn coarsen_once<T: Scalar>(matrix: &SymmetricMatrix<T>) -> Coarse<T> {
    let (aggregates, turns, count) = pair(matrix);
    let matrix = merge(matrix, &aggregates, &turns, count);
    Coarse { aggregates, turns, matrix }
}

/// Pairs rows that are strongly coupled. Returns the aggregate of each row, what its value is turned by, and the number of
/// aggregates. Rows without a coupling are in none: to pair them would not reduce what smoothing leaves.
fn pair<T: Scalar>(matrix: &SymmetricMatrix<T>) -> (Vec<u32>, Vec<T::Turn>, usize) {
    let strongest = strongest(matrix);
    let coupled = || (0..matrix.size()).filter(|&row| strongest[row].row != NONE);
    let mut aggregates = vec![NONE; matrix.size()];
    let mut turns = vec![T::Turn::NONE; matrix.size()];
    let mut count = 0;
    for row in coupled() {
        if aggregates[row] != NONE {
            continue;
        }
        // Rows before this one are taken or have made their choice.
        let free = matrix.pattern().column(row).skip(1).filter(|&entry| {
            let other = matrix.pattern().rows()[entry] as usize;
            let is_strong = matrix[entry].coupling() >= STRONG * strongest[row].coupling;
            is_strong && strongest[other].row != NONE && aggregates[other] == NONE
        });
        if let Some(entry) = free.min_by(|&a, &b| matrix[b].coupling().total_cmp(&matrix[a].coupling())) {
            let other = matrix.pattern().rows()[entry] as usize;
            (aggregates[row], aggregates[other]) = (count, count);
            turns[other] = matrix[entry].turn();
            count += 1;
        }
    }
    let mut path = Vec::new();
    for row in coupled() {
        // From strongest to strongest neighbour couplings grow. In a ring they would be equal, and its first row would
        // have found the next one free.
        let mut end = row;
        while aggregates[end] == NONE {
            path.push(end);
            end = strongest[end].row as usize;
        }
        while let Some(row) = path.pop() {
            let next = &strongest[row];
            aggregates[row] = aggregates[end];
            turns[row] = next.turn.and(turns[next.row as usize]);
        }
    }
    (aggregates, turns, count as usize)
}

/// The stored entries below the diagonal, as `(column, row, value)`.
fn sides<T: Scalar>(matrix: &SymmetricMatrix<T>) -> impl Iterator<Item = (usize, usize, T)> {
    let of_column = |column| matrix.pattern().column(column).skip(1).map(move |entry| (column, entry));
    let entries = (0..matrix.size()).flat_map(of_column);
    entries.map(|(column, entry)| (column, matrix.pattern().rows()[entry] as usize, matrix[entry]))
}

/// Per row whether its diagonal entry dominates. Constrained rows are such, for the others are all 0 there.
fn dominant<T: Scalar>(matrix: &SymmetricMatrix<T>) -> Vec<bool> {
    let mut sums = vec![0.0; matrix.size()];
    for (column, row, value) in sides(matrix) {
        sums[column] += value.magnitude();
        sums[row] += value.magnitude();
    }
    let diagonal = (0..matrix.size()).map(|row| matrix[matrix.pattern().column(row).start].real());
    diagonal.zip(sums).map(|(diagonal, sum)| diagonal >= DOMINANT * sum).collect()
}

/// Of a row, the other one that it is coupled to most.
#[derive(Debug, Clone, Copy)]
struct Strongest<U> {
    /// [`NONE`] where it is coupled to none.
    row: u32,
    coupling: f64,
    /// From the value of the other row to the value of this one.
    turn: U,
}

/// Per row. Rows whose diagonal dominates have none and are none's.
fn strongest<T: Scalar>(matrix: &SymmetricMatrix<T>) -> Vec<Strongest<T::Turn>> {
    let is_dominant = dominant(matrix);
    let mut strongest = vec![Strongest { row: NONE, coupling: 0.0, turn: T::Turn::NONE }; matrix.size()];
    for (column, row, value) in sides(matrix).filter(|&(a, b, _)| !is_dominant[a] && !is_dominant[b]) {
        for (row, other, value) in [(column, row, value.conj()), (row, column, value)] {
            let coupling = value.coupling();
            if coupling > strongest[row].coupling {
                strongest[row] = Strongest { row: other as u32, coupling, turn: value.turn() };
            }
        }
    }
    strongest
}

/// The matrix of aggregates: sums of the entries of their rows, `Pᴴ A P` where `P` has the turn of each row at its aggregate.
fn merge<T: Scalar>(
    matrix: &SymmetricMatrix<T>,
    aggregates: &[u32],
    turns: &[T::Turn],
    count: usize,
) -> SymmetricMatrix<T> {
    let mut diagonal = vec![0.0; count];
    for (row, &aggregate) in aggregates.iter().enumerate().filter(|&(_, &aggregate)| aggregate != NONE) {
        diagonal[aggregate as usize] += matrix[matrix.pattern().column(row).start].real();
    }
    let least: Vec<f64> = diagonal.iter().map(|sum| LEAST_DIAGONAL * sum).collect();
    let merged = || {
        let turned = |a, b, value| T::Turn::revert(turns[b], T::Turn::apply(turns[a], value));
        let sides = sides(matrix).map(move |(a, b, value)| (aggregates[a], aggregates[b], turned(a, b, value)));
        sides.filter(|&(a, b, value)| a != NONE && b != NONE && value != T::ZERO)
    };
    let mut start = vec![0; count + 1];
    for (a, b, value) in merged() {
        if a == b {
            diagonal[a as usize] += 2.0 * value.real();
        } else {
            start[a.min(b) as usize + 1] += 1;
        }
    }
    for (diagonal, least) in diagonal.iter_mut().zip(least) {
        *diagonal = diagonal.max(least);
    }
    for aggregate in 0..count {
        start[aggregate + 1] += start[aggregate];
    }
    let mut free: Vec<u32> = start.clone();
    let mut between = vec![(0, T::ZERO); start[count] as usize];
    for (a, b, value) in merged().filter(|(a, b, _)| a != b) {
        let slot = &mut free[a.min(b) as usize];
        between[*slot as usize] = (a.max(b), if a < b { value } else { value.conj() });
        *slot += 1;
    }
    let diagonal: Vec<T> = diagonal.into_iter().map(T::from_real).collect();
    SymmetricMatrix::from_entries(&diagonal, &start, &mut between)
}
