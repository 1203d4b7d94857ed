//! Compressed rows: variable-length lists in two flat arrays.

use std::marker::PhantomData;

use crate::element::Element;

/// In place of a number: there is none.
pub const NONE: u32 = u32::MAX;

/// For each row element a list of items, one list after another.
#[derive(Debug, Clone)]
pub struct Csr<R, I> {
    /// `#rows + 1`, where each list begins.
    start: Vec<u32>,
    items: Vec<I>,
    row: PhantomData<R>,
}

impl<R: Element, I: Element> Csr<R, I> {
    /// Groups the items `0..keys.len()` by their row, ascending inside a row. Items without a row are left out.
    pub fn group(rows: usize, keys: impl Iterator<Item = Option<R>> + Clone) -> Self {
        // Counted two places ahead, so that one place ahead is where a list's next item goes, and in the end where the
        // list after it begins.
        let mut start: Vec<u32> = vec![0; rows + 2];
        for key in keys.clone().flatten() {
            start[key.index() + 2] += 1;
        }
        for row in 2..rows + 2 {
            start[row] += start[row - 1];
        }
        let mut items = vec![I::from_index(0); start[rows + 1] as usize];
        for (index, key) in keys.enumerate() {
            let Some(key) = key else { continue };
            let place = &mut start[key.index() + 1];
            items[*place as usize] = I::from_index(index);
            *place += 1;
        }
        start.pop();
        Self { start, items, row: PhantomData }
    }

    /// The list of one row.
    pub fn row(&self, row: R) -> &[I] {
        &self.items[self.start[row.index()] as usize..self.start[row.index() + 1] as usize]
    }

    /// The lists in order, each with its row.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = (R, &[I])> {
        let lists = self.start.windows(2).map(|bounds| &self.items[bounds[0] as usize..bounds[1] as usize]);
        lists.enumerate().map(|(row, list)| (R::from_index(row), list))
    }

    /// All items, list after list.
    pub fn into_items(self) -> Vec<I> {
        self.items
    }

    /// All items, list after list.
    pub fn items_mut(&mut self) -> &mut [I] {
        &mut self.items
    }
}
