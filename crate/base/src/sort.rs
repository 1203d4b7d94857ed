//! Sorting by keys, where there are more of them than the processor's caches hold.

use std::num::NonZeroUsize;
use std::ops::Range;

use crate::csr::distribute;
use crate::parallel;

/// Keys of a bucket, which stay in the fastest cache.
const BUCKET: usize = 1 << 10;

/// Buckets that can be filled at the same time without waiting for memory, as a power of two.
const MOST_BUCKETS: u32 = 12;

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
