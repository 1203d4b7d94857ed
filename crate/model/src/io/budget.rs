//! How much memory a file may take, asked before it is taken.

use std::cell::{Cell, RefCell};
use std::collections::HashSet;
use std::collections::hash_map::DefaultHasher;
use std::hash::Hasher;
use std::ops::Range;

use heatwalk_surface::Part;

use crate::error::{Error, Result};

/// Bytes that any file may take: a few kilobytes of a scene may show one mesh many times.
const LEAST_BYTES: u64 = 64 << 20;
/// Bytes for each byte of a file. Meshes are packed by 20 at most, and what is unpacked takes up to 20 bytes a byte once read.
const PER_BYTE: u64 = 512;
/// Bytes that the two above come to at most.
const MOST_BYTES: u64 = 2 << 30;
/// Bytes for each byte of a file that is so large that this is more.
const PER_BYTE_OF_LARGE: u64 = 64;

/// The bytes that may be allocated for a file. Readers take from it before they allocate, so that a file which claims much, or packs
/// or repeats it, is refused and does not fill the memory.
///
/// 64 MiB and 512 bytes for each byte of the file, up to 2 GiB; a file of more than 32 MiB may take 64 bytes for each of its bytes. Of
/// files that it refers to, each brings its own bytes along, once.
///
/// What is no longer than a line, or no more than the text that it came from, is not counted.
#[derive(Debug)]
pub struct Budget {
    /// Bytes of the file, and of those that it refers to.
    size: Cell<u64>,
    /// Bytes that may be taken.
    most: Cell<u64>,
    /// Bytes that stay taken.
    kept: Cell<u64>,
    /// Bytes that a [`Loan`] gives back.
    lent: Cell<u64>,
    is_exceeded: Cell<bool>,
    /// Contents of the files that the file refers to, which may do so by many names.
    companions: RefCell<HashSet<u64>>,
}

impl Budget {
    /// That of a file of so many bytes.
    pub fn of_file(size: usize) -> Self {
        Self::limited(size, bytes_for(size as u64))
    }

    /// So many bytes, whatever a file of `size` bytes may take by itself; files that it refers to add theirs.
    pub fn limited(size: usize, bytes: u64) -> Self {
        Self {
            size: Cell::new(size as u64),
            most: Cell::new(bytes),
            kept: Cell::new(0),
            lent: Cell::new(0),
            is_exceeded: Cell::new(false),
            companions: RefCell::default(),
        }
    }

    /// Bytes that are left.
    pub fn left(&self) -> u64 {
        if self.is_exceeded.get() { 0 } else { self.most.get() - self.kept.get() - self.lent.get() }
    }

    /// Takes bytes.
    ///
    /// # Errors
    /// [`Error::OverBudget`] where fewer are left, and ever after: what goes on without the part that failed is still refused.
    pub fn take(&self, bytes: u64) -> Result<()> {
        self.check(bytes)?;
        self.kept.set(self.kept.get() + bytes);
        Ok(())
    }

    /// Takes bytes until the [`Loan`] ends in which that happens; outside of any, for good.
    ///
    /// # Errors
    /// As [`Self::take`].
    pub fn lend(&self, bytes: u64) -> Result<()> {
        self.check(bytes)?;
        self.lent.set(self.lent.get() + bytes);
        Ok(())
    }

    /// Begins a time after which all that is lent in it is free.
    pub fn loan(&self) -> Loan<'_> {
        Loan { budget: self, before: self.lent.get() }
    }

    /// Takes room for so many items of a type.
    ///
    /// # Errors
    /// As [`Self::take`].
    pub fn take_items<T>(&self, count: usize) -> Result<()> {
        self.take(bytes_of::<T>(count))
    }

    /// Takes room for a part of this name and one range of triangles.
    ///
    /// # Errors
    /// As [`Self::take`].
    pub(crate) fn take_part(&self, name: &str) -> Result<()> {
        self.take((size_of::<Part>() + FEWEST * size_of::<Range<usize>>() + name.len()) as u64)
    }

    /// An empty list with room for so many items.
    ///
    /// # Errors
    /// As [`Self::take`]; [`OutOfMemory`](heatwalk_surface::Error::OutOfMemory) where the machine has not so much.
    pub fn list<T>(&self, count: usize) -> Result<Vec<T>> {
        let mut list = Vec::new();
        self.reserve(&mut list, count)?;
        Ok(list)
    }

    /// Makes room in a list for so many more items.
    ///
    /// # Errors
    /// As [`Self::list`].
    pub fn reserve<T>(&self, list: &mut Vec<T>, count: usize) -> Result<()> {
        let (length, capacity) = (list.len(), list.capacity());
        if count <= capacity - length {
            return Ok(());
        }
        // At least twice as long, so that a list which grows item by item is not copied each time.
        let more = count.max(capacity);
        self.take_items::<T>(more.saturating_sub(capacity - length))?;
        list.try_reserve_exact(more)
            .map_err(|_| heatwalk_surface::Error::OutOfMemory { stage: "reading the file" }.into())
    }

    /// Makes a list so long, with items like this one where it is longer.
    ///
    /// # Errors
    /// As [`Self::list`].
    pub fn resize<T: Clone>(&self, list: &mut Vec<T>, length: usize, item: T) -> Result<()> {
        self.reserve(list, length.saturating_sub(list.len()))?;
        list.resize(length, item);
        Ok(())
    }

    /// Appends an item to a list.
    ///
    /// # Errors
    /// As [`Self::list`].
    pub fn push<T>(&self, list: &mut Vec<T>, item: T) -> Result<()> {
        self.reserve(list, if list.is_empty() { FEWEST } else { 1 })?;
        list.push(item);
        Ok(())
    }

    /// Counts a file that the file refers to.
    ///
    /// # Errors
    /// As [`Self::take`].
    pub fn admit(&self, bytes: Vec<u8>) -> Result<Vec<u8>> {
        let mut hasher = DefaultHasher::new();
        hasher.write(&bytes);
        if self.companions.borrow_mut().insert(hasher.finish()) {
            let (before, size) = (self.size.get(), self.size.get() + bytes.len() as u64);
            self.size.set(size);
            self.most.set(self.most.get() + (bytes_for(size) - bytes_for(before)));
        }
        self.take(bytes.len() as u64).map(|()| bytes)
    }

    /// Refuses the file where more was asked for than there is, by whatever part of it.
    ///
    /// # Errors
    /// [`Error::OverBudget`].
    pub fn finish(&self) -> Result<()> {
        if self.is_exceeded.get() { Err(self.exceeded()) } else { Ok(()) }
    }

    fn check(&self, bytes: u64) -> Result<()> {
        if bytes <= self.left() && !self.is_exceeded.get() {
            return Ok(());
        }
        self.is_exceeded.set(true);
        Err(self.exceeded())
    }

    fn exceeded(&self) -> Error {
        Error::OverBudget { size: self.size.get(), budget: self.most.get() }
    }
}

/// Items that a list has room for with its first one.
const FEWEST: usize = 4;

fn bytes_for(size: u64) -> u64 {
    let small = size.saturating_mul(PER_BYTE).saturating_add(LEAST_BYTES).min(MOST_BYTES);
    small.max(size.saturating_mul(PER_BYTE_OF_LARGE))
}

fn bytes_of<T>(count: usize) -> u64 {
    (count as u64).saturating_mul(size_of::<T>() as u64)
}

/// Gives back at its end what was lent since it began.
#[must_use]
#[derive(Debug)]
pub struct Loan<'a> {
    budget: &'a Budget,
    before: u64,
}

impl Drop for Loan<'_> {
    fn drop(&mut self) {
        self.budget.lent.set(self.before);
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    #[test]
    fn a_larger_file_may_take_more() {
        let sizes = [0, 1, 1 << 10, 1 << 20, 8 << 20, 32 << 20, 33 << 20, 1 << 30, u64::MAX / 2];
        let bytes = sizes.map(bytes_for);
        assert!(bytes.is_sorted(), "{bytes:?}");
        assert_eq!(bytes[..2], [LEAST_BYTES, LEAST_BYTES + PER_BYTE]);
        assert_eq!(bytes_for(32 << 20), MOST_BYTES);
    }

    #[test]
    fn what_is_lent_comes_back_and_what_is_taken_does_not() {
        let budget = Budget::limited(1, 100);
        {
            let _loan = budget.loan();
            budget.lend(60).unwrap();
            budget.take(30).unwrap();
            assert_eq!(budget.left(), 10);
        }
        assert_eq!(budget.left(), 70);
    }

    #[test]
    fn a_budget_that_was_exceeded_stays_so() {
        let budget = Budget::limited(1, 100);
        assert_eq!(budget.take(101), Err(Error::OverBudget { size: 1, budget: 100 }));
        assert!(budget.take(0).is_err() && budget.finish().is_err() && budget.left() == 0);
    }

    #[test]
    fn lists_take_what_they_can_hold() {
        let budget = Budget::limited(1, 1000);
        let mut list: Vec<u64> = Vec::new();
        let refused = (0..).find(|&item| budget.push(&mut list, item).is_err());
        assert_eq!(refused, Some(64), "at 64 items of 8 bytes twice the room would be 1024 bytes");
        assert!(Budget::limited(1, 1000).list::<u64>(usize::MAX).is_err());
    }

    #[test]
    fn a_file_named_twice_brings_its_room_once() {
        let budget = Budget::of_file(0);
        for _ in 0..3 {
            budget.admit(vec![7; 1000]).unwrap();
        }
        assert_eq!(budget.left(), LEAST_BYTES + 1000 * PER_BYTE - 3 * 1000);
        budget.admit(vec![8; 1000]).unwrap();
        assert_eq!(budget.left(), LEAST_BYTES + 2000 * PER_BYTE - 4 * 1000);
    }
}
