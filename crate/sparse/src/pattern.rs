//! Where the stored entries of a symmetric matrix are.

/// In place of an index: there is none.
pub(crate) const NONE: u32 = u32::MAX;

/// Where the entries of a symmetric matrix are: its lower triangle in compressed columns, of each column the diagonal
/// first, then the rows below in ascending order.
#[derive(Debug, Clone)]
pub struct Pattern {
    /// `#rows + 1`, where each column begins.
    pub column_start: Vec<u32>,
    /// Row of each stored entry.
    pub rows: Vec<u32>,
}

impl Pattern {
    /// A matrix of this diagonal and these entries below it, in `sides` from `start[column]` on to the next column's, as
    /// `(row, value)` in any order. Entries of one place are added up.
    pub fn of_sides(diagonal: &[f64], start: &[u32], sides: &mut [(u32, f64)]) -> (Self, Vec<f64>) {
        let size = diagonal.len();
        // Meshes have two entries for each edge, but at boundaries.
        let capacity = size + sides.len() / 2 + sides.len() / 8;
        let mut pattern = Self { column_start: Vec::with_capacity(size + 1), rows: Vec::with_capacity(capacity) };
        let mut values = Vec::with_capacity(capacity);
        pattern.column_start.push(0);
        for column in 0..size {
            pattern.rows.push(column as u32);
            values.push(diagonal[column]);
            let below = &mut sides[start[column] as usize..start[column + 1] as usize];
            below.sort_unstable_by_key(|entry| entry.0);
            for entries in below.chunk_by(|a, b| a.0 == b.0) {
                pattern.rows.push(entries[0].0);
                values.push(entries.iter().map(|entry| entry.1).sum());
            }
            pattern.column_start.push(pattern.rows.len() as u32);
        }
        (pattern, values)
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.column_start.len() - 1
    }

    /// Stored entries of one column.
    pub fn column(&self, column: usize) -> std::ops::Range<usize> {
        self.column_start[column] as usize..self.column_start[column + 1] as usize
    }

    /// `result += A vector` for the symmetric matrix with these values of the lower triangle.
    pub fn multiply_add(&self, values: &[f64], vector: &[f64], result: &mut [f64]) {
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
