//! Compressed rows: variable-length lists in two flat arrays.

/// In place of an index: there is none.
pub(crate) const NONE: u32 = u32::MAX;

/// `#rows` lists of indices, one after another.
#[derive(Debug, Clone, Default)]
pub(crate) struct Csr {
    /// `#rows + 1`, where each list begins.
    start: Vec<u32>,
    items: Vec<u32>,
}

impl Csr {
    /// Groups the indices `0..keys.len()` by their key, ascending inside a group. Items of key [`NONE`] are left out.
    pub(crate) fn group(rows: usize, keys: impl Iterator<Item = u32> + Clone) -> Self {
        let mut start = vec![0; rows + 1];
        for key in keys.clone().filter(|&key| key != NONE) {
            start[key as usize + 1] += 1;
        }
        for row in 0..rows {
            start[row + 1] += start[row];
        }
        let mut free = start.clone();
        let mut items = vec![0; start[rows] as usize];
        for (index, key) in keys.enumerate().filter(|&(_, key)| key != NONE) {
            let slot = &mut free[key as usize];
            items[*slot as usize] = index as u32;
            *slot += 1;
        }
        Self { start, items }
    }

    /// The list of one row.
    pub(crate) fn row(&self, row: u32) -> &[u32] {
        let row = row as usize;
        &self.items[self.start[row] as usize..self.start[row + 1] as usize]
    }

    /// The lists in order.
    pub(crate) fn rows(&self) -> impl Iterator<Item = &[u32]> {
        self.start.windows(2).map(|bounds| &self.items[bounds[0] as usize..bounds[1] as usize])
    }
}
