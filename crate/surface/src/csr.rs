//! Compressed rows: variable-length lists in two flat arrays.

/// In place of an index: there is none.
pub const NONE: u32 = u32::MAX;

/// `#rows` lists of indices, one after another.
#[derive(Debug, Clone, Default)]
pub struct Csr {
    /// `#rows + 1`, where each list begins.
    start: Vec<u32>,
    items: Vec<u32>,
}

impl Csr {
    /// Groups the indices `0..keys.len()` by their key, ascending inside a group. Items of key [`NONE`] are left out.
    pub fn group(rows: usize, keys: impl Iterator<Item = u32> + Clone) -> Self {
        // Counted two places ahead, so that one place ahead is where a list's next item goes, and in the end where the
        // list after it begins.
        let mut start = vec![0; rows + 2];
        for key in keys.clone().filter(|&key| key != NONE) {
            start[key as usize + 2] += 1;
        }
        for row in 2..rows + 2 {
            start[row] += start[row - 1];
        }
        let mut items = vec![0; start[rows + 1] as usize];
        for (index, key) in keys.enumerate().filter(|&(_, key)| key != NONE) {
            let slot = &mut start[key as usize + 1];
            items[*slot as usize] = index as u32;
            *slot += 1;
        }
        start.pop();
        Self { start, items }
    }

    /// The list of one row.
    pub fn row(&self, row: u32) -> &[u32] {
        let row = row as usize;
        &self.items[self.start[row] as usize..self.start[row + 1] as usize]
    }

    /// The lists in order.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.start.windows(2).map(|bounds| &self.items[bounds[0] as usize..bounds[1] as usize])
    }

    /// All items, list after list.
    pub fn items_mut(&mut self) -> &mut [u32] {
        &mut self.items
    }
}
