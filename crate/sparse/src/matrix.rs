//! Symmetric and Hermitian matrices.

use std::ops::Index;
use std::sync::Arc;

use crate::error::{Error, Result};
use crate::pattern::Pattern;
use crate::scalar::Scalar;

/// A symmetric matrix, Hermitian where numbers are complex: the values of its lower triangle, one for each entry of its
/// pattern.
#[derive(Debug, Clone, PartialEq)]
pub struct SymmetricMatrix<T = f64> {
    pattern: Arc<Pattern>,
    values: Vec<T>,
}

impl<T> SymmetricMatrix<T> {
    /// A matrix of these values, in the order of the pattern's entries.
    ///
    /// # Errors
    /// [`Error::ValueCount`].
    pub fn new(pattern: Arc<Pattern>, values: Vec<T>) -> Result<Self> {
        if values.len() != pattern.nonzeros() {
            return Err(Error::ValueCount { values: values.len(), nonzeros: pattern.nonzeros() });
        }
        Ok(Self { pattern, values })
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.pattern.size()
    }

    /// Where the values are.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.pattern
    }

    /// The values of the lower triangle, in the order of the pattern's entries.
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// Pattern and values.
    pub fn into_parts(self) -> (Arc<Pattern>, Vec<T>) {
        (self.pattern, self.values)
    }
}

/// The value of one stored entry.
impl<T> Index<usize> for SymmetricMatrix<T> {
    type Output = T;

    fn index(&self, entry: usize) -> &T {
        &self.values[entry]
    }
}

impl<T: Scalar> SymmetricMatrix<T> {
    /// The matrix of this diagonal (`#rows`) and these entries below it: those of each column in `entries` from
    /// `column_start[column]` on to the next column's, as `(row, value)` in any order, which is not kept. Entries of one
    /// place are added up.
    ///
    /// # Panics
    /// Where a row is not below the diagonal or not in the matrix, or `column_start` (`#rows + 1`) does not fit.
    pub fn from_entries(diagonal: &[T], column_start: &[u32], entries: &mut [(u32, T)]) -> Self {
        let size = diagonal.len();
        assert_eq!(column_start.len(), size + 1, "one start for each column, and the end");
        // Meshes have two entries for each edge, but at boundaries.
        let capacity = size + entries.len() / 2 + entries.len() / 8;
        let (mut starts, mut rows) = (Vec::with_capacity(size + 1), Vec::with_capacity(capacity));
        let mut values = Vec::with_capacity(capacity);
        starts.push(0);
        for column in 0..size {
            rows.push(column as u32);
            values.push(diagonal[column]);
            let below = &mut entries[column_start[column] as usize..column_start[column + 1] as usize];
            below.sort_unstable_by_key(|entry| entry.0);
            if let (Some(first), Some(last)) = (below.first(), below.last()) {
                assert!(first.0 as usize > column && (last.0 as usize) < size, "entries lie below the diagonal");
            }
            for entries in below.chunk_by(|a, b| a.0 == b.0) {
                rows.push(entries[0].0);
                values.push(entries.iter().map(|entry| entry.1).sum());
            }
            starts.push(rows.len() as u32);
        }
        Self { pattern: Arc::new(Pattern::from_sorted(starts, rows)), values }
    }

    /// `result += A vector`.
    ///
    /// # Panics
    /// Where `vector` or `result` has not [`SymmetricMatrix::size`] numbers.
    pub fn multiply_add(&self, vector: &[T], result: &mut [T]) {
        assert_eq!([vector.len(), result.len()], [self.size(); 2], "vectors have the size of the matrix");
        for column in 0..self.size() {
            let mut entries = self.pattern.column(column);
            let own = vector[column];
            let mut sum = entries.next().map_or(T::ZERO, |entry| self.values[entry] * own);
            for entry in entries {
                let row = self.pattern.rows()[entry] as usize;
                result[row] += self.values[entry] * own;
                sum += self.values[entry].conj() * vector[row];
            }
            result[column] += sum;
        }
    }
}
