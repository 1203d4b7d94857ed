//! Sorting by keys, where there are more of them than the processor's caches hold; and sorting of what is sorted seldom, by one sort for
//! all types: that of the standard library is compiled for each type and order, 5 kB of a wasm module each time.

use std::cmp::Ordering;
use std::num::NonZeroUsize;
use std::ops::Range;

use crate::csr::distribute;
use crate::parallel;

/// Keys of a bucket, which stay in the fastest cache.
const BUCKET: usize = 1 << 10;

/// Buckets that can be filled at the same time without waiting for memory, as a power of two.
const MOST_BUCKETS: u32 = 12;

/// At most so many are sorted without an order of their own.
const FEW: usize = 16;

/// Sorts like `slice::sort_by`, in about twice the time.
pub fn sort_by<T>(items: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    if items.len() <= FEW {
        for end in 1..items.len() {
            let mut at = end;
            while at > 0 && compare(&items[at - 1], &items[at]).is_gt() {
                items.swap(at - 1, at);
                at -= 1;
            }
        }
        return;
    }
    let mut order = order_of(items.len(), &|a, b| compare(&items[a as usize], &items[b as usize]));
    // Along each cycle of the order, what belongs to a place comes from the next of the cycle.
    for first in 0..order.len() {
        let mut place = first;
        while order[place] as usize != first {
            let from = std::mem::replace(&mut order[place], place as u32) as usize;
            items.swap(place, from);
            place = from;
        }
        order[place] = place as u32;
    }
}

/// Sorts like `slice::sort_by_key`.
pub fn sort_by_key<T, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    sort_by(items, |a, b| key(a).cmp(&key(b)));
}

/// Sorts like `slice::sort`.
pub fn sort<T: Ord>(items: &mut [T]) {
    sort_by(items, T::cmp);
}

/// The numbers below `count` in order. Not generic, so that it is compiled once.
#[inline(never)]
fn order_of(count: usize, compare: &dyn Fn(u32, u32) -> Ordering) -> Vec<u32> {
    let mut order: Vec<u32> = (0..count as u32).collect();
    order.sort_by(|&a, &b| compare(a, b));
    order
}

/// Numbers in order of their keys.
pub struct Sorted {
    /// The first pair of each bucket, and the end.
    start: Vec<u32>,
    pairs: Vec<u64>,
}

impl Sorted {
    /// Sorts `0..keys.len()` by keys of so many bits at most, those of one key in their own order.
    pub fn new(keys: &[u32], bits: u32, threads: NonZeroUsize) -> Self {
        let buckets = (keys.len() / BUCKET).max(1).ilog2().min(MOST_BUCKETS).min(bits);
        let bucket = |number: usize| Some((u64::from(keys[number]) >> (bits - buckets)) as usize);
        let pair = |number: usize| u64::from(keys[number]) << 32 | number as u64;
        let (start, pairs) = distribute(1 << buckets, keys.len(), threads, bucket, pair);
        let mut sorted = Self { start, pairs };
        let own = parallel::ranges_of_rows(&sorted.start, threads);
        let lengths: Vec<usize> = own.iter().map(|own| sorted.pairs_of(own).len()).collect();
        let start = &sorted.start;
        let parts = own.into_iter().zip(parallel::split(&mut sorted.pairs, lengths));
        parallel::map(parts, |(own, pairs)| {
            let lengths = start[own.start..=own.end].windows(2).map(|bounds| (bounds[1] - bounds[0]) as usize);
            parallel::split(pairs, lengths).for_each(<[u64]>::sort_unstable);
        });
        sorted
    }

    fn pairs_of(&self, buckets: &Range<usize>) -> Range<usize> {
        self.start[buckets.start] as usize..self.start[buckets.end] as usize
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.pairs.len()
    }

    /// The number in a place of the order.
    pub fn number(&self, place: usize) -> u32 {
        self.pairs[place] as u32
    }

    /// Calls `work` with the numbers of each key, on several threads.
    pub fn for_each_key(&self, threads: NonZeroUsize, work: impl Fn(&mut dyn Iterator<Item = u32>) + Sync) {
        parallel::map(parallel::ranges_of_rows(&self.start, threads), |own| {
            for pairs in self.pairs[self.pairs_of(&own)].chunk_by(|a, b| a >> 32 == b >> 32) {
                work(&mut pairs.iter().map(|&pair| pair as u32));
            }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_sorted_by_one_sort_for_all_is_as_the_standard_library_sorts_it() {
        for count in [0, 1, 2, FEW - 1, FEW, FEW + 1, 100, 1000] {
            let numbers = (0..count as u64).map(|number| number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            // Several of each key, and what is not copied.
            let items: Vec<(u64, String)> = numbers.map(|number| (number >> 58, format!("{number}"))).collect();
            let (mut sorted, mut expected) = (items.clone(), items.clone());
            sort_by_key(&mut sorted, |item| item.0);
            expected.sort_by_key(|item| item.0);
            assert_eq!(sorted, expected);
            sort_by(&mut sorted, |a, b| b.1.cmp(&a.1));
            expected.sort_by(|a, b| b.1.cmp(&a.1));
            assert_eq!(sorted, expected);
            sort(&mut sorted);
            expected.sort();
            assert_eq!(sorted, expected);
        }
    }
}
