//! Compressed rows: variable-length lists in two flat arrays.

use std::marker::PhantomData;
use std::num::NonZeroUsize;
use std::ops::Range;

use bytemuck::Zeroable;

use crate::element::Element;
use crate::parallel;

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
    pub fn group<K: Copy + Into<Option<R>> + Sync>(rows: usize, keys: &[K], threads: NonZeroUsize) -> Self {
        let row = |index: usize| keys[index].into().map(R::index);
        let (start, items) = distribute(rows, keys.len(), threads, row, I::from_index);
        Self { start, items, row: PhantomData }
    }

    /// Ranges of rows with about equally many items, one a thread.
    pub fn ranges(&self, threads: NonZeroUsize) -> Vec<Range<usize>> {
        parallel::ranges_of_rows(&self.start, threads)
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

    /// The same lists, and others after them.
    pub fn with(&self, others: &[Vec<I>]) -> Self {
        let mut lists = Self { start: self.start.clone(), items: self.items.clone(), row: PhantomData };
        for other in others {
            lists.items.extend_from_slice(other);
            lists.start.push(lists.items.len() as u32);
        }
        lists
    }

    /// All items, list after list.
    pub fn items_mut(&mut self) -> &mut [I] {
        &mut self.items
    }
}

/// Items `0..count` in order of their rows, those of one row in their own order, and before them where each row begins, and the
/// last one ends. Items without a row are left out.
pub fn distribute<T: Zeroable + Send>(
    rows: usize,
    count: usize,
    threads: NonZeroUsize,
    row: impl Fn(usize) -> Option<usize> + Sync,
    item: impl Fn(usize) -> T + Sync,
) -> (Vec<u32>, Vec<T>) {
    // Each thread looks at all items, but counts and places those of its own rows. Counted two places ahead, so that one place
    // ahead is where a row's next item goes, and in the end where the row after it begins.
    let mut start: Vec<u32> = vec![0; rows + 2];
    let own_rows = parallel::shares(rows, count, threads);
    parallel::map_parts(own_rows, &mut start[2..], |own, lengths| {
        for row in (0..count).filter_map(&row) {
            if let Some(length) = lengths.get_mut(row.wrapping_sub(own.start)) {
                *length += 1;
            }
        }
    });
    for row in 2..rows + 2 {
        start[row] += start[row - 1];
    }
    let mut items = parallel::zeroed(start[rows + 1] as usize, threads);
    let own_rows = parallel::ranges_of_rows(&start[1..], threads);
    let own_items: Vec<_> = own_rows.iter().map(|own| (start[own.end + 1] - start[own.start + 1]) as usize).collect();
    let items_of = parallel::split(&mut items, own_items);
    let next_of =
        parallel::split(&mut start[1..=rows], own_rows.iter().map(ExactSizeIterator::len).collect::<Vec<_>>());
    let place = |((own, items), next): ((Range<usize>, &mut [T]), &mut [u32])| {
        let first = next.first().copied().unwrap_or_default();
        for index in 0..count {
            if let Some(next) = row(index).and_then(|row| next.get_mut(row.wrapping_sub(own.start))) {
                items[(*next - first) as usize] = item(index);
                *next += 1;
            }
        }
    };
    parallel::map(own_rows.into_iter().zip(items_of).zip(next_of), place);
    start.pop();
    (start, items)
}
