//! Linear systems of one pattern: ordering, Cholesky factors, conjugate gradients, and solutions under constraints.

pub(crate) mod cholesky;
pub(crate) mod columns;
pub(crate) mod conjugate_gradients;
pub(crate) mod constraints;
mod dissection;
pub(crate) mod factor;
mod front;
mod multifrontal;
pub(crate) mod ordering;
pub(crate) mod responses;
mod substitution;
mod vector;

/// Where the entries of a symmetric matrix are: its lower triangle in compressed columns, of each column the diagonal
/// first, then the rows below in ascending order.
#[derive(Debug, Clone)]
pub(crate) struct Pattern {
    /// `#rows + 1`, where each column begins.
    pub(crate) column_start: Vec<u32>,
    /// Row of each stored entry.
    pub(crate) rows: Vec<u32>,
}

impl Pattern {
    /// Number of rows.
    pub(crate) fn size(&self) -> usize {
        self.column_start.len() - 1
    }

    /// Stored entries of one column.
    pub(crate) fn column(&self, column: usize) -> std::ops::Range<usize> {
        self.column_start[column] as usize..self.column_start[column + 1] as usize
    }

    /// `result += A vector` for the symmetric matrix with these values of the lower triangle.
    pub(crate) fn multiply_add(&self, values: &[f64], vector: &[f64], result: &mut [f64]) {
        for column in 0..self.size() {
            let mut entries = self.column(column);
            let own = vector[column];
            let mut sum = entries.next().map_or(0.0, |entry| values[entry] * own);
            for entry in entries {
                let row = self.rows[entry] as usize;
                result[row] += values[entry] * own;
                sum += values[entry] * vector[row];
            }
            result[column] += sum;
        }
    }
}

/// Dot product in four running sums, which the compiler may keep in vector registers.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a_blocks, b_blocks) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a_blocks.remainder().iter().zip(b_blocks.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; 4];
    for (a, b) in a_blocks.zip(b_blocks) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}
