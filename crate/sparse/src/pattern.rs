//! Where the stored entries of a symmetric matrix are.

use std::ops::Range;

use crate::error::{Error, Result};

/// In place of an index: there is none.
pub(crate) const NONE: u32 = u32::MAX;

/// Where the entries of a symmetric matrix are: its lower triangle in compressed columns, of each column the diagonal
/// first, then the rows below in ascending order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Pattern {
    column_start: Vec<u32>,
    rows: Vec<u32>,
}

impl Pattern {
    /// A pattern of `column_start` (`#rows + 1`, where each column begins in `rows`) and `rows` (of each stored entry).
    ///
    /// # Errors
    /// [`Error::InvalidColumnStart`], [`Error::MissingDiagonal`], [`Error::InvalidRow`] at the first place that is not in
    /// the form above.
    pub fn new(column_start: Vec<u32>, rows: Vec<u32>) -> Result<Self> {
        let nonzeros = rows.len();
        if column_start.first() != Some(&0) {
            return Err(Error::InvalidColumnStart { column: 0, nonzeros });
        }
        let size = column_start.len() - 1;
        for (column, ends) in column_start.windows(2).enumerate() {
            if ends[0] > ends[1] || ends[1] as usize > nonzeros {
                return Err(Error::InvalidColumnStart { column: column + 1, nonzeros });
            }
            let rows = &rows[ends[0] as usize..ends[1] as usize];
            if rows.first().map(|&row| row as usize) != Some(column) {
                return Err(Error::MissingDiagonal { column });
            }
            let ascends = |rows: &[u32]| rows[0] < rows[1] && (rows[1] as usize) < size;
            if let Some(rows) = rows.windows(2).find(|rows| !ascends(rows)) {
                return Err(Error::InvalidRow { column, row: rows[1] as usize, size });
            }
        }
        if column_start[size] as usize != nonzeros {
            return Err(Error::InvalidColumnStart { column: size, nonzeros });
        }
        Ok(Self { column_start, rows })
    }

    /// A pattern known to have the form that [`Pattern::new`] checks.
    pub(crate) fn from_sorted(column_start: Vec<u32>, rows: Vec<u32>) -> Self {
        Self { column_start, rows }
    }

    /// The same pattern with another number for each row.
    pub(crate) fn renumbered(&self, number: &[u32]) -> Self {
        let (column_start, rows) = self.compressed(number, |a, b| (a.min(b), a.max(b)));
        let mut renumbered = Self::from_sorted(column_start, rows);
        for column in 0..renumbered.size() {
            let range = renumbered.column(column);
            renumbered.rows[range].sort_unstable();
        }
        renumbered
    }

    /// The upper triangle in compressed columns, with another number for each row; rows of a column in no order.
    pub(crate) fn upper_renumbered(&self, number: &[u32]) -> (Vec<u32>, Vec<u32>) {
        self.compressed(number, |a, b| (a.max(b), a.min(b)))
    }

    /// The entries in compressed columns, with another number for each row: `place` makes a column and a row of both.
    fn compressed(&self, number: &[u32], place: impl Fn(u32, u32) -> (u32, u32)) -> (Vec<u32>, Vec<u32>) {
        let mut column_start = vec![0; self.size() + 1];
        self.each_renumbered(number, |a, b| column_start[place(a, b).0 as usize + 1] += 1);
        for column in 0..self.size() {
            column_start[column + 1] += column_start[column];
        }
        let mut rows = vec![0; self.rows.len()];
        let mut next = column_start.clone();
        self.each_renumbered(number, |a, b| {
            let (column, row) = place(a, b);
            let free = &mut next[column as usize];
            rows[*free as usize] = row;
            *free += 1;
        });
        (column_start, rows)
    }

    /// Column and row of each stored entry in turn, by other numbers.
    pub(crate) fn each_renumbered(&self, number: &[u32], mut act: impl FnMut(u32, u32)) {
        for column in 0..self.size() {
            let renumbered = number[column];
            for &row in &self.rows[self.column(column)] {
                act(renumbered, number[row as usize]);
            }
        }
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.column_start.len() - 1
    }

    /// Number of stored entries.
    pub fn nonzeros(&self) -> usize {
        self.rows.len()
    }

    /// `#rows + 1`, where each column begins among the entries.
    pub fn column_start(&self) -> &[u32] {
        &self.column_start
    }

    /// Row of each stored entry.
    pub fn rows(&self) -> &[u32] {
        &self.rows
    }

    /// Stored entries of one column, its diagonal first.
    #[inline]
    pub fn column(&self, column: usize) -> Range<usize> {
        self.column_start[column] as usize..self.column_start[column + 1] as usize
    }
}
