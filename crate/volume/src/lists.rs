//! Variable-length lists in two flat arrays.

/// For each row a list of numbers, one list after another.
#[derive(Debug, Clone, Default)]
pub(crate) struct Lists {
    /// `#rows + 1`, where each list begins.
    start: Vec<u32>,
    items: Vec<u32>,
}

impl Lists {
    /// Items as `(row, item)`, those of one row in the order given. `pairs` is walked through twice.
    pub(crate) fn group<I: Iterator<Item = (u32, u32)>>(rows: usize, pairs: impl Fn() -> I) -> Self {
        let mut start = vec![0; rows + 1];
        for (row, _) in pairs() {
            start[row as usize + 1] += 1;
        }
        for row in 0..rows {
            start[row + 1] += start[row];
        }
        let mut next: Vec<u32> = start[..rows].to_vec();
        let mut items = vec![0; start[rows] as usize];
        for (row, item) in pairs() {
            let place = &mut next[row as usize];
            items[*place as usize] = item;
            *place += 1;
        }
        Self { start, items }
    }

    /// The list of one row.
    #[inline]
    pub(crate) fn row(&self, row: u32) -> &[u32] {
        &self.items[self.start[row as usize] as usize..self.start[row as usize + 1] as usize]
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> usize {
        self.start.len() - 1
    }
}
