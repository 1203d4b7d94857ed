//! One piece of work on several threads.
//!
//! Work is cut into unbroken ranges, one a thread. Each fills an unbroken part of the result, or numbers that no other one
//! writes, so that the result does not depend on how many threads there are. The first is the caller's own, and where there
//! is no other nothing is started.

use std::mem::MaybeUninit;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;

use bytemuck::Zeroable;
use bytemuck::allocation::zeroed_vec;

use crate::element::Element;

/// The caller's thread alone.
pub const ONE: NonZeroUsize = NonZeroUsize::MIN;

/// For fewer items a thread is not worth its start.
const LEAST_ITEMS: usize = 1 << 12;

/// Bytes of memory that the system hands out at once, at least.
const PAGE: usize = 1 << 12;

/// Memory of this alignment can be had as zeros without writing them.
const LARGEST_ALIGNMENT: usize = 16;

/// How many threads have enough to do with so many items.
fn busy(items: usize, threads: NonZeroUsize) -> usize {
    threads.get().min(items / LEAST_ITEMS).max(1)
}

/// `0..count` in ranges of about equal length, one a thread.
pub fn ranges(count: usize, threads: NonZeroUsize) -> Vec<Range<usize>> {
    shares(count, count, threads)
}

/// `0..count` in ranges of about equal length, one for each thread that has enough to do with so many items.
pub fn shares(count: usize, items: usize, threads: NonZeroUsize) -> Vec<Range<usize>> {
    let busy = busy(items, threads);
    (0..busy).map(|part| count * part / busy..count * (part + 1) / busy).collect()
}

/// Ranges of rows with about equally many items, one a thread. `start`: `#rows + 1`, the first item of each row, and the end.
pub fn ranges_of_rows(start: &[u32], threads: NonZeroUsize) -> Vec<Range<usize>> {
    let (rows, items) = (start.len() - 1, start[start.len() - 1] as usize);
    let busy = busy(items, threads);
    let begin = |part| start[..rows].partition_point(|&first| (first as usize) < items * part / busy);
    let bounds: Vec<usize> = (0..busy).map(begin).chain([rows]).collect();
    bounds.windows(2).map(|pair| pair[0]..pair[1]).collect()
}

/// The values in successive parts of these lengths.
pub fn split<T>(mut values: &mut [T], lengths: impl IntoIterator<Item = usize>) -> impl Iterator<Item = &mut [T]> {
    lengths.into_iter().map(move |length| values.split_off_mut(..length).expect("parts of the values"))
}

/// What `work` makes of each task, in their order, each on a thread of its own.
pub fn map<T: Send, R: Send>(tasks: impl IntoIterator<Item = T>, work: impl Fn(T) -> R + Sync) -> Vec<R> {
    let (work, mut tasks) = (&work, tasks.into_iter());
    // No thread can be started there, and what starts one is compiled for each kind of work.
    if cfg!(target_arch = "wasm32") {
        return tasks.map(work).collect();
    }
    thread::scope(|scope| {
        let first = tasks.next();
        let others: Vec<_> = tasks.map(|task| scope.spawn(move || work(task))).collect();
        let mut results: Vec<R> = first.into_iter().map(work).collect();
        results.extend(others.into_iter().map(|other| other.join().unwrap_or_else(|panic| resume_unwind(panic))));
        results
    })
}

/// What `work` makes of each range and its part of the values.
pub fn map_parts<T: Send, R: Send>(
    ranges: Vec<Range<usize>>,
    values: &mut [T],
    work: impl Fn(Range<usize>, &mut [T]) -> R + Sync,
) -> Vec<R> {
    let parts: Vec<_> = split(values, ranges.iter().map(ExactSizeIterator::len)).collect();
    map(ranges.into_iter().zip(parts), |(range, part)| work(range, part))
}

/// `value` of each of `0..count`.
pub fn collect<T: Zeroable + Send>(count: usize, threads: NonZeroUsize, value: impl Fn(usize) -> T + Sync) -> Vec<T> {
    if busy(count, threads) == 1 {
        return (0..count).map(value).collect();
    }
    let mut values = zeroed(count, threads);
    fill(&mut values, threads, value);
    values
}

/// Zeros in memory that each thread is the first to touch its part of.
pub fn zeroed<T: Zeroable + Send>(count: usize, threads: NonZeroUsize) -> Vec<T> {
    if align_of::<T>() <= LARGEST_ALIGNMENT {
        return zeroed_vec(count);
    }
    let mut values = Vec::with_capacity(count);
    touch(&mut values, threads);
    values.resize_with(count, T::zeroed);
    values
}

/// Touches every page of a vector's spare memory. The system hands pages out one by one, when they are first written to, which
/// takes ten times as long as writing; several threads are as many times as fast. With one thread nothing is done.
pub fn touch<T: Send>(values: &mut Vec<T>, threads: NonZeroUsize) {
    let spare = values.spare_capacity_mut();
    if busy(spare.len(), threads) == 1 {
        return;
    }
    map_parts(ranges(spare.len(), threads), spare, |_, part| {
        for value in part.iter_mut().step_by((PAGE / size_of::<T>().max(1)).max(1)) {
            *value = MaybeUninit::zeroed();
        }
    });
}

/// Replaces each value by that of its number.
pub fn fill<T: Send>(values: &mut [T], threads: NonZeroUsize, value: impl Fn(usize) -> T + Sync) {
    map_parts(ranges(values.len(), threads), values, |range, part| {
        for (index, place) in range.zip(part) {
            *place = value(index);
        }
    });
}

/// Numbers that every thread may write, each place only one of them, or all the same.
#[derive(Debug)]
pub struct Numbers(Vec<AtomicU32>);

impl Numbers {
    /// `0..count`.
    pub fn identity(count: usize) -> Self {
        Self((0..count as u32).map(AtomicU32::new).collect())
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// The number in a place.
    pub fn get(&self, place: u32) -> u32 {
        self.0[place as usize].load(Ordering::Relaxed)
    }

    /// Writes the number of a place.
    pub fn set(&self, place: u32, number: u32) {
        self.0[place as usize].store(number, Ordering::Relaxed);
    }

    /// Replaces one number by another, unless a thread has replaced it before. Returns whether it did.
    pub fn replace(&self, place: u32, old: u32, new: u32) -> bool {
        self.0[place as usize].compare_exchange(old, new, Ordering::Relaxed, Ordering::Relaxed).is_ok()
    }

    /// As elements of these numbers.
    pub fn into_elements<E: Element>(self) -> Vec<E> {
        self.0.into_iter().map(|number| E::from_index(number.into_inner() as usize)).collect()
    }
}
