//! Supernodal sparse Cholesky: one symbolic analysis for all matrices of a pattern.
//!
//! Chen, Davis, Hager, Rajamanickam, "Algorithm 887: CHOLMOD" (2008) for supernodes and their relaxation; faer finds them.

use std::collections::BTreeSet;
use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::SymbolicSupernodalParams;
use faer::sparse::linalg::cholesky::{simplicial, supernodal};

use crate::error::{Error, Result};
use crate::front::packed_start;
use crate::ordering::Permutation;
use crate::pattern::{NONE, Pattern};
use crate::scalar::Scalar;

#[cfg(test)]
mod tests;

/// Two supernodes become one where they have at most so many columns together and at most this share of zeros.
const RELAXATION: &[(usize, f64)] = &[(4, 1.0), (16, 0.8), (48, 0.1), (usize::MAX, 0.05)];

/// Unknowns whose way to the root is looked at to tell what a constraint costs.
const CONSTRAINT_SAMPLES: usize = 16;

/// How much slower a multiplication is in a sparse forward solve, which waits for memory, than in a factorisation,
/// which works in dense blocks.
const SPARSE_PENALTY: f64 = 4.0;

/// Elimination order and the pattern of the factors, shared by every matrix of one pattern.
#[derive(Debug)]
pub struct Symbolic {
    pub(crate) pattern: Arc<Pattern>,
    pub(crate) permutation: Permutation,
    /// `#supernodes + 1`, first unknown of each, in the elimination order.
    start: Vec<u32>,
    /// `#supernodes + 1`, where the rows of each begin in `below`.
    below_start: Vec<u32>,
    below: Vec<u32>,
    /// `#supernodes + 1`, where the dense block of each begins among the factor's values.
    value_start: Vec<usize>,
    /// The supernode that each leaves its Schur complement to; [`NONE`] at a root.
    parent: Vec<u32>,
    /// `2 #supernodes + 1`, where the entries of each begin in `entries`: those that the elimination order leaves below the
    /// diagonal, then those that it moves above it, where the conjugate stands for them.
    entry_start: Vec<u32>,
    /// Stored entries of the matrix, each with its place in its supernode's block.
    entries: Vec<(u32, u32)>,
    /// Most numbers that wait on the stack of Schur complements.
    stack_length: usize,
    /// Supernode of each unknown, in the elimination order.
    supernode_of: Vec<u32>,
}

/// Bytes that factors take, by stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FactorMemory {
    /// Of one factor, for as long as it lives.
    pub factor: u64,
    /// Most that is in use beside the factors while they are made: Schur complements that wait, and the largest front.
    pub factorization: u64,
}

/// A supernode: consecutive unknowns whose columns of the factor have the same rows below.
pub(crate) struct Supernode<'a> {
    /// Its first unknown, in the elimination order.
    pub(crate) start: usize,
    /// Number of its unknowns.
    pub(crate) width: usize,
    /// The rows below, ascending.
    pub(crate) below: &'a [u32],
    /// Where its dense block lies among the factor's values.
    pub(crate) values: std::ops::Range<usize>,
}

impl Symbolic {
    /// Analyses a pattern under an elimination order of it.
    ///
    /// # Errors
    /// [`Error::PermutationMismatch`] where the order is that of another pattern; [`Error::OutOfMemory`].
    pub fn analyse(pattern: &Arc<Pattern>, permutation: Permutation) -> Result<Self> {
        let size = pattern.size();
        let mismatch = Error::PermutationMismatch { expected: size, found: permutation.size() };
        if permutation.size() != size {
            return Err(mismatch);
        }
        let analysis = supernodes(pattern, &permutation).ok_or(Error::OutOfMemory { stage: "analysing the matrix" })?;
        let count = analysis.n_supernodes();
        let mut symbolic = Self {
            pattern: Arc::clone(pattern),
            permutation,
            start: Vec::with_capacity(count + 1),
            below_start: Vec::with_capacity(count + 1),
            below: Vec::new(),
            value_start: Vec::with_capacity(count + 1),
            parent: Vec::with_capacity(count),
            entry_start: Vec::new(),
            entries: Vec::new(),
            stack_length: 0,
            supernode_of: vec![0; size],
        };
        symbolic.below_start.push(0);
        symbolic.value_start.push(0);
        symbolic.start.push(0);
        let mut values = 0;
        for index in 0..count {
            let supernode = analysis.supernode(index);
            let (start, end) = (supernode.start(), analysis.supernode_end()[index] as usize);
            symbolic.supernode_of[start..end].fill(index as u32);
            symbolic.start.push(end as u32);
            symbolic.below.extend_from_slice(supernode.pattern());
            symbolic.below_start.push(symbolic.below.len() as u32);
            values += (end - start) * (end - start + supernode.pattern().len());
            symbolic.value_start.push(values);
        }
        for index in 0..count {
            let first = symbolic.supernode(index).below.first();
            symbolic.parent.push(first.map_or(NONE, |&row| symbolic.supernode_of[row as usize]));
        }
        symbolic.place_entries(pattern);
        symbolic.stack_length = symbolic.measure_stack().ok_or(mismatch)?;
        Ok(symbolic)
    }

    /// Finds for every stored entry of the matrix its place in the factor.
    fn place_entries(&mut self, pattern: &Pattern) {
        let new_of_old = &self.permutation.new_of_old;
        let group = |column: u32, row: u32| {
            2 * self.supernode_of[column.min(row) as usize] as usize + usize::from(row < column)
        };
        let mut entry_start = vec![0; 2 * self.supernode_count() + 1];
        pattern.each_renumbered(new_of_old, |column, row| entry_start[group(column, row) + 1] += 1);
        for index in 0..2 * self.supernode_count() {
            entry_start[index + 1] += entry_start[index];
        }
        let mut free: Vec<u32> = entry_start.clone();
        // First as (column, row) with the entry; the places need the rows of the supernode, one at a time.
        let mut placed = vec![(0, 0); pattern.nonzeros()];
        let mut position = vec![(0, 0); pattern.nonzeros()];
        let mut entry = 0;
        pattern.each_renumbered(new_of_old, |column, row| {
            let slot = &mut free[group(column, row)];
            placed[*slot as usize] = (entry, 0);
            position[*slot as usize] = (column.min(row), column.max(row));
            *slot += 1;
            entry += 1;
        });
        let mut places = vec![0; self.size()];
        for index in 0..self.supernode_count() {
            let Supernode { start, width, below, .. } = self.supernode(index);
            for (place, row) in (start as u32..(start + width) as u32).chain(below.iter().copied()).enumerate() {
                places[row as usize] = place as u32;
            }
            let rows = (width + below.len()) as u32;
            let slots = entry_start[2 * index] as usize..entry_start[2 * index + 2] as usize;
            for (placed, &(low, high)) in placed[slots.clone()].iter_mut().zip(&position[slots]) {
                placed.1 = (low - start as u32) * rows + places[high as usize];
            }
        }
        self.entry_start = entry_start;
        self.entries = placed;
    }

    /// Goes through the supernodes as the factorisation does, and counts what is on its stack; none where they are not in
    /// a postorder.
    fn measure_stack(&self) -> Option<usize> {
        let left_over = |index: usize| {
            let rows = self.supernode(index).below.len();
            packed_start(rows, rows)
        };
        let mut waiting: Vec<u32> = Vec::new();
        let (mut length, mut most) = (0, 0);
        for index in 0..self.supernode_count() {
            most = most.max(length + left_over(index));
            while let Some(&child) = waiting.last().filter(|&&child| self.parent[child as usize] == index as u32) {
                waiting.pop();
                length -= left_over(child as usize);
            }
            if self.parent[index] != NONE {
                waiting.push(index as u32);
                length += left_over(index);
            }
        }
        waiting.is_empty().then_some(most)
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.supernode_of.len()
    }

    /// Number of supernodes.
    pub(crate) fn supernode_count(&self) -> usize {
        self.start.len() - 1
    }

    /// One supernode; they are numbered in the elimination order.
    #[inline(always)]
    pub(crate) fn supernode(&self, index: usize) -> Supernode<'_> {
        let start = self.start[index] as usize;
        Supernode {
            start,
            width: self.start[index + 1] as usize - start,
            below: &self.below[self.below_start[index] as usize..self.below_start[index + 1] as usize],
            values: self.value_start[index]..self.value_start[index + 1],
        }
    }

    /// The supernode that one leaves its Schur complement to; [`NONE`] at a root.
    pub(crate) fn parent(&self, index: usize) -> u32 {
        self.parent[index]
    }

    /// The stored entries of the matrix in a supernode's columns, each with its place in the dense block: those to be
    /// taken as they are, and those of which the conjugate is taken.
    pub(crate) fn entries(&self, index: usize) -> [&[(u32, u32)]; 2] {
        let ends = |group: usize| self.entry_start[group] as usize..self.entry_start[group + 1] as usize;
        [2 * index, 2 * index + 1].map(|group| &self.entries[ends(group)])
    }

    /// Nonzeros of a factor, zeros inside supernodes counted.
    pub fn factor_nonzeros(&self) -> usize {
        self.value_start[self.supernode_count()]
    }

    /// Most numbers of one matrix that wait on the stack of Schur complements while it is factored.
    pub(crate) fn stack_length(&self) -> usize {
        self.stack_length
    }

    /// What factors of the pattern take, when so many matrices of numbers `T` are factored side by side.
    pub fn memory<T: Scalar>(&self, matrices: usize) -> FactorMemory {
        let widest = self.value_start.windows(2).map(|ends| ends[1] - ends[0]).max().unwrap_or(0);
        let bytes = |numbers: usize| numbers as u64 * size_of::<T>() as u64;
        FactorMemory {
            factor: bytes(self.factor_nonzeros()),
            factorization: bytes(matrices * (self.stack_length + widest)),
        }
    }

    /// The supernodes that a forward solve touches when the right side is non-zero at `unknowns` (in the elimination
    /// order) only: theirs and all ancestors in the elimination tree, ascending.
    pub(crate) fn reach(&self, unknowns: impl Iterator<Item = usize>) -> Vec<u32> {
        let mut reached = BTreeSet::new();
        for unknown in unknowns {
            let mut next = self.supernode_of[unknown];
            while next != NONE && reached.insert(next) {
                next = self.parent[next as usize];
            }
        }
        reached.into_iter().collect()
    }

    /// Work of `count` constraints, in the unit of [`Symbolic::factor_work`].
    pub fn constraint_work(&self, count: usize) -> f64 {
        let samples = self.size().min(CONSTRAINT_SAMPLES);
        let (mut entries, mut rows) = (0, 0);
        for sample in 0..samples {
            for index in self.reach(std::iter::once(sample * self.size() / samples)) {
                let Supernode { width, values, .. } = self.supernode(index as usize);
                entries += values.len();
                rows += width;
            }
        }
        let [entries, rows] = [entries, rows].map(|sum| sum as f64 / samples as f64);
        let count = count as f64;
        count * (SPARSE_PENALTY * entries + 0.5 * count * rows + count * count / 6.0)
    }

    /// Multiplications and additions of one factorisation, roughly.
    pub fn factor_work(&self) -> f64 {
        (0..self.supernode_count()).map(|index| self.work(index)).sum()
    }

    /// The part of a supernode in [`Symbolic::factor_work`].
    pub(crate) fn work(&self, index: usize) -> f64 {
        let Supernode { width, below, .. } = self.supernode(index);
        width as f64 * ((width + below.len()) as f64).powi(2)
    }
}

/// The supernodes of a pattern in an elimination order, by faer; none where memory is short.
fn supernodes(pattern: &Pattern, permutation: &Permutation) -> Option<supernodal::SymbolicSupernodalCholesky<u32>> {
    let size = pattern.size();
    let (column_start, rows) = pattern.upper_renumbered(&permutation.new_of_old);
    let upper = SymbolicSparseColMatRef::new_unsorted_checked(size, size, &column_start, None, &rows);
    let scratch = simplicial::prefactorize_symbolic_cholesky_scratch::<u32>(size, rows.len())
        .or(supernodal::factorize_supernodal_symbolic_cholesky_scratch::<u32>(size));
    let mut memory = MemBuffer::try_new(scratch).ok()?;
    let (mut parents, mut counts) = (vec![0; size], vec![0; size]);
    let parents =
        simplicial::prefactorize_symbolic_cholesky(&mut parents, &mut counts, upper, MemStack::new(&mut memory));
    let relaxed = SymbolicSupernodalParams { relax: Some(RELAXATION) };
    supernodal::factorize_supernodal_symbolic_cholesky(upper, parents, &counts, MemStack::new(&mut memory), relaxed)
        .ok()
}
