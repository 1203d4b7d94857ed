//! Dense partial Cholesky factorisation of a frontal matrix, for several matrices side by side.
//!
//! All arrays hold the entries of `N` matrices interleaved: the lanes of one entry lie next to each other, so that fronts
//! of a few rows, which are most of them, still fill vector registers, and every index is computed once for all.

use crate::scalar::{Pair, Scalar};
use crate::simd::array;

/// Numbers of a packed block: rows of the front times lanes.
const BLOCK: usize = 8;
/// Columns of a register tile. Sixteen registers hold 4 of them with four numbers each, or 2 with two numbers each.
const TILE_COLUMNS: usize = if cfg!(target_arch = "wasm32") { 2 } else { 4 };
/// Columns eliminated one by one before the others of a panel are updated.
const STEP: usize = 8;
/// Columns eliminated before the rest of the front is updated; their packed rows stay in the nearest cache.
const PANEL: usize = 64;
/// Packed numbers that stay in the second cache while they meet all columns.
const CHUNK: usize = 1 << 14;

/// The pivot of a column and matrix that is not positive.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NotPositive {
    pub(crate) column: usize,
    pub(crate) lane: usize,
}

/// A frontal matrix: lower triangle, rows in the elimination order.
pub(crate) struct Front<'a, T, const N: usize> {
    /// Number of rows.
    pub(crate) rows: usize,
    /// Number of columns to eliminate.
    pub(crate) columns: usize,
    /// `rows × columns`, column-major. What is above the diagonal is not looked at.
    pub(crate) eliminated: &'a mut [T],
    /// The lower triangle of the other columns, one after another, each from its diagonal on.
    pub(crate) rest: &'a mut [T],
}

/// First number of a column of a packed lower triangle.
#[inline(always)]
pub(crate) fn packed_start(rows: usize, column: usize) -> usize {
    column * (2 * rows - column + 1) / 2
}

impl<T: Scalar, const N: usize> Front<'_, T, N> {
    /// A column from its diagonal on.
    #[inline(always)]
    pub(crate) fn column(&mut self, column: usize) -> &mut [T] {
        match column.checked_sub(self.columns) {
            None => &mut self.eliminated[(column * self.rows + column) * N..(column + 1) * self.rows * N],
            Some(column) => {
                let rows = self.rows - self.columns;
                let start = packed_start(rows, column);
                &mut self.rest[start * N..(start + rows - column) * N]
            }
        }
    }

    /// Replaces the columns to eliminate by those of the Cholesky factor and the others by their Schur complement.
    #[inline(always)]
    pub(crate) fn eliminate<const FUSED: bool>(&mut self, packed: &mut Vec<T>) -> Result<(), NotPositive> {
        let mut panel = 0;
        while panel < self.columns {
            let panel_end = (panel + PANEL).min(self.columns);
            let mut step = panel;
            while step < panel_end {
                let step_end = (step + STEP).min(panel_end);
                self.factor_columns::<FUSED>(step, step_end)?;
                if step_end < panel_end {
                    self.pack(step, step_end, packed);
                    self.update::<FUSED>(step_end - step, step_end, panel_end, packed);
                }
                step = step_end;
            }
            if panel_end < self.rows {
                self.pack(panel, panel_end, packed);
                self.update::<FUSED>(panel_end - panel, panel_end, self.rows, packed);
            }
            panel = panel_end;
        }
        Ok(())
    }

    /// Factors some columns of which all earlier ones have been taken out.
    #[inline(always)]
    fn factor_columns<const FUSED: bool>(&mut self, from: usize, to: usize) -> Result<(), NotPositive> {
        let rows = self.rows;
        for j in from..to {
            let (before, here) = self.eliminated.split_at_mut(j * rows * N);
            let column = &mut here[j * N..rows * N];
            for k in from..j {
                let other = &before[(k * rows + j) * N..(k + 1) * rows * N];
                let factors: [T; 2] = array(|lane| -other[lane % N].conj());
                let ((pairs, last), (other_pairs, other_last)) = (column.as_chunks_mut(), other.as_chunks());
                for (pair, other) in pairs.iter_mut().zip(other_pairs) {
                    let sum = T::Pair::new(*pair).plus_product::<FUSED>(T::Pair::new(*other), T::Pair::new(factors));
                    *pair = sum.numbers();
                }
                for (entry, other) in last.iter_mut().zip(other_last) {
                    *entry = T::multiply_add::<FUSED>(*other, factors[0], *entry);
                }
            }
            let mut inverses = [0.0; N];
            for lane in 0..N {
                let pivot = column[lane].real();
                if pivot.is_nan() || pivot <= 0.0 {
                    return Err(NotPositive { column: j, lane });
                }
                inverses[lane] = 1.0 / pivot.sqrt();
            }
            for entry in column.as_chunks_mut::<N>().0 {
                for lane in 0..N {
                    entry[lane] = entry[lane].scale(inverses[lane]);
                }
            }
        }
        Ok(())
    }

    /// Copies the rows from `to` on of columns `from..to`, in blocks of `BLOCK` numbers, each with all its columns.
    #[inline(always)]
    fn pack(&self, from: usize, to: usize, packed: &mut Vec<T>) {
        let depth = to - from;
        let numbers = (self.rows - to) * N;
        packed.clear();
        packed.resize(numbers.div_ceil(BLOCK) * BLOCK * depth, T::ZERO);
        for k in 0..depth {
            let start = ((from + k) * self.rows + to) * N;
            let (blocks, last) = self.eliminated[start..start + numbers].as_chunks::<BLOCK>();
            let mut targets = packed.as_chunks_mut::<BLOCK>().0.iter_mut().skip(k).step_by(depth);
            for (block, target) in blocks.iter().zip(&mut targets) {
                *target = *block;
            }
            if let Some(target) = targets.next() {
                target[..last.len()].copy_from_slice(last);
            }
        }
    }

    /// Takes `depth` packed columns, whose first row is `first`, out of columns `first..end`.
    #[inline(always)]
    fn update<const FUSED: bool>(&mut self, depth: usize, first: usize, end: usize, packed: &[T]) {
        let block_rows = BLOCK / N;
        let stride = BLOCK * depth;
        let blocks = packed.len() / stride;
        let chunk = (CHUNK / stride).max(1);
        for chunk_start in (0..blocks).step_by(chunk) {
            let chunk_end = (chunk_start + chunk).min(blocks);
            let columns = end.min(first + chunk_end * block_rows) - first;
            for tile in (0..columns).step_by(TILE_COLUMNS) {
                let (block, offset) = (tile / block_rows, tile % block_rows);
                let right = &packed[block * stride..(block + 1) * stride];
                let tile_columns = TILE_COLUMNS.min(columns - tile);
                for row_block in block.max(chunk_start)..chunk_end {
                    let left = &packed[row_block * stride..(row_block + 1) * stride];
                    let products = tile_products::<T, N, FUSED>(left, right, offset);
                    for (j, products) in products.iter().enumerate().take(tile_columns) {
                        subtract(self.column(first + tile + j), products, row_block * block_rows, tile + j, N);
                    }
                }
            }
        }
    }
}

/// Products of a block of rows with the conjugates of `TILE_COLUMNS` rows of another from row `offset` on, summed over their columns.
#[inline(always)]
fn tile_products<T: Scalar, const N: usize, const FUSED: bool>(
    left: &[T],
    right: &[T],
    offset: usize,
) -> [[T; BLOCK]; TILE_COLUMNS] {
    let mut sums = [[T::Pair::default(); BLOCK / 2]; TILE_COLUMNS];
    for (left, right) in left.as_chunks::<BLOCK>().0.iter().zip(right.as_chunks::<BLOCK>().0) {
        let right = &right[offset * N..(offset + TILE_COLUMNS) * N];
        let left: [T::Pair; BLOCK / 2] = array(|i| T::Pair::new([left[2 * i], left[2 * i + 1]]));
        for (j, sums) in sums.iter_mut().enumerate() {
            let right = T::Pair::new(array(|lane| right[j * N + lane % N].conj()));
            for (sum, left) in sums.iter_mut().zip(left) {
                *sum = sum.plus_product::<FUSED>(left, right);
            }
        }
    }
    array(|j| array(|i| sums[j][i / 2].numbers()[i % 2]))
}

/// Subtracts a block of rows from row `row` on from a column that begins at row `start`.
#[inline(always)]
fn subtract<T: Scalar>(column: &mut [T], block: &[T; BLOCK], row: usize, start: usize, lanes: usize) {
    if let Some(target) = row.checked_sub(start).and_then(|skip| column[skip * lanes..].first_chunk_mut::<BLOCK>()) {
        *target = array(|lane| target[lane] - block[lane]);
        return;
    }
    let (skip, above) = (row.saturating_sub(start) * lanes, start.saturating_sub(row) * lanes);
    for (target, value) in column[skip..].iter_mut().zip(&block[above.min(BLOCK)..]) {
        *target -= *value;
    }
}
