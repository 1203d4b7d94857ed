//! Which rows become one on the next grid, and its matrix.
//!
//! Notay, "An aggregation-based algebraic multigrid method" (2010): double pairwise aggregation, with two differences.
//! Rows are visited as they are numbered; and one that finds no partner joins the aggregate of its strongest neighbour
//! instead of staying alone, so that each pairing leaves at most half of the rows, even around a hub.

use crate::matrix::SymmetricMatrix;
use crate::pattern::NONE;

/// A row whose diagonal is so many times the sum of its other entries is in no aggregate: smoothing alone solves it.
const DOMINANT: f64 = 5.0;

/// Another row is a partner if its coupling is at least this share of the strongest. Any share will do on good
/// triangles; of 0.25, which Notay takes, and this one, this takes fewer steps on obtuse ones.
const STRONG: f64 = 0.5;

/// Least diagonal entry of an aggregate as a share of those of its rows. Rounding of their sum may leave less than
/// nothing; a larger entry only makes the correction smaller.
const LEAST_DIAGONAL: f64 = 1e-12;

/// The matrix of the next grid.
pub(super) struct Coarse {
    /// Its row that each row of the finer grid is part of; [`NONE`] where it is in none.
    pub(super) aggregates: Vec<u32>,
    pub(super) matrix: SymmetricMatrix,
}

/// The next grid, of pairs of pairs. It is empty where no rows are coupled.
pub(super) fn coarsen(matrix: &SymmetricMatrix) -> Coarse {
    let pairs = coarsen_once(matrix);
    let Coarse { aggregates, matrix } = coarsen_once(&pairs.matrix);
    let of_pair = |&pair: &u32| if pair == NONE { NONE } else { aggregates[pair as usize] };
    Coarse { aggregates: pairs.aggregates.iter().map(of_pair).collect(), matrix }
}

fn coarsen_once(matrix: &SymmetricMatrix) -> Coarse {
    let (aggregates, count) = pair(matrix);
    let matrix = merge(matrix, &aggregates, count);
    Coarse { aggregates, matrix }
}

/// Pairs rows that are strongly coupled. Returns the aggregate of each row and the number of aggregates. Rows without a
/// negative coupling are in none: to pair them would not reduce what smoothing leaves.
fn pair(matrix: &SymmetricMatrix) -> (Vec<u32>, usize) {
    let strongest = strongest(matrix);
    let coupled = || (0..matrix.size()).filter(|&row| strongest[row].0 != NONE);
    let mut aggregates = vec![NONE; matrix.size()];
    let mut count = 0;
    for row in coupled() {
        if aggregates[row] != NONE {
            continue;
        }
        // Rows before this one are taken or have made their choice.
        let free = matrix.pattern().column(row).skip(1).filter(|&entry| {
            let other = matrix.pattern().rows()[entry] as usize;
            let is_strong = matrix[entry] <= STRONG * strongest[row].1;
            is_strong && strongest[other].0 != NONE && aggregates[other] == NONE
        });
        if let Some(entry) = free.min_by(|&a, &b| matrix[a].total_cmp(&matrix[b])) {
            aggregates[row] = count;
            aggregates[matrix.pattern().rows()[entry] as usize] = count;
            count += 1;
        }
    }
    for row in coupled() {
        // From strongest to strongest neighbour couplings grow. In a ring they would be equal, and its first row would
        // have found the next one free.
        let mut end = row;
        while aggregates[end] == NONE {
            end = strongest[end].0 as usize;
        }
        let aggregate = aggregates[end];
        let mut next = row;
        while aggregates[next] == NONE {
            aggregates[next] = aggregate;
            next = strongest[next].0 as usize;
        }
    }
    (aggregates, count as usize)
}

/// The stored entries below the diagonal, as `(column, row, value)`.
fn sides(matrix: &SymmetricMatrix) -> impl Iterator<Item = (usize, usize, f64)> {
    let of_column = |column| matrix.pattern().column(column).skip(1).map(move |entry| (column, entry));
    let entries = (0..matrix.size()).flat_map(of_column);
    entries.map(|(column, entry)| (column, matrix.pattern().rows()[entry] as usize, matrix[entry]))
}

/// Per row whether its diagonal entry dominates. Constrained rows are such, for the others are all 0 there.
fn dominant(matrix: &SymmetricMatrix) -> Vec<bool> {
    let mut sums = vec![0.0; matrix.size()];
    for (column, row, value) in sides(matrix) {
        sums[column] += value.abs();
        sums[row] += value.abs();
    }
    let diagonal = (0..matrix.size()).map(|row| matrix[matrix.pattern().column(row).start]);
    diagonal.zip(sums).map(|(diagonal, sum)| diagonal >= DOMINANT * sum).collect()
}

/// Per row the other row with the most negative entry, and that entry; [`NONE`] and 0 where no entry is negative. Rows
/// whose diagonal dominates have none and are none's.
fn strongest(matrix: &SymmetricMatrix) -> Vec<(u32, f64)> {
    let is_dominant = dominant(matrix);
    let mut strongest = vec![(NONE, 0.0); matrix.size()];
    for (column, row, value) in sides(matrix).filter(|&(a, b, _)| !is_dominant[a] && !is_dominant[b]) {
        for (row, other) in [(column, row), (row, column)] {
            if value < strongest[row].1 {
                strongest[row] = (other as u32, value);
            }
        }
    }
    strongest
}

/// The matrix of aggregates: sums of the entries of their rows, `Pᵀ A P` where `P` has a 1 at the aggregate of each row.
fn merge(matrix: &SymmetricMatrix, aggregates: &[u32], count: usize) -> SymmetricMatrix {
    let mut diagonal = vec![0.0; count];
    for (row, &aggregate) in aggregates.iter().enumerate().filter(|&(_, &aggregate)| aggregate != NONE) {
        diagonal[aggregate as usize] += matrix[matrix.pattern().column(row).start];
    }
    let least: Vec<f64> = diagonal.iter().map(|sum| LEAST_DIAGONAL * sum).collect();
    let merged = || {
        let sides = sides(matrix).map(|(a, b, value)| (aggregates[a], aggregates[b], value));
        sides.filter(|&(a, b, value)| a != NONE && b != NONE && value != 0.0)
    };
    let mut start = vec![0; count + 1];
    for (a, b, value) in merged() {
        if a == b {
            diagonal[a as usize] += 2.0 * value;
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
    let mut between = vec![(0, 0.0); start[count] as usize];
    for (a, b, value) in merged().filter(|(a, b, _)| a != b) {
        let slot = &mut free[a.min(b) as usize];
        between[*slot as usize] = (a.max(b), value);
        *slot += 1;
    }
    SymmetricMatrix::from_entries(&diagonal, &start, &mut between)
}
