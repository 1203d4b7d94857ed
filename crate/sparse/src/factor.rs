//! Solves with a Cholesky factor: whole vectors, and right sides that are zero almost everywhere.
//!
//! Davis, "Direct Methods for Sparse Linear Systems" (2006), chapter 3.

use std::marker::PhantomData;
use std::sync::Arc;

use crate::error::{Error, Result};
use crate::matrix::SymmetricMatrix;
use crate::multifrontal::{Factorisation, Failure};
use crate::progress::Progress;
use crate::scalar::{Entry, Scalar};
use crate::simd::{Work, dispatch};
use crate::sparse_vector::SparseVector;
use crate::substitution;
use crate::symbolic::{Supernode, Symbolic};

#[cfg(test)]
mod tests;

/// Sparse right sides that are gone through side by side.
const LANES: usize = 8;

/// Entries that are looked at and rounded while they are in a cache.
const ROUNDED_AT_ONCE: usize = 1024;

/// The Cholesky factor `C` of one matrix `A = C Cᴴ` of numbers `T`, whose entries are kept as `E`.
#[derive(Debug)]
pub struct Factor<T = f64, E = T> {
    symbolic: Arc<Symbolic>,
    /// Supernodes one after another, each a dense column-major block of its own rows, then the rows below.
    values: Vec<E>,
    numbers: PhantomData<T>,
}

impl Symbolic {
    /// Factors matrices of the pattern, one or two side by side, which takes less time than one after another.
    ///
    /// # Errors
    /// [`Error::PatternMismatch`]; [`Error::NotPositiveDefinite`] with the row of the failing pivot;
    /// [`Error::OutOfMemory`]; [`Error::Cancelled`].
    pub fn factor<T: Scalar, const N: usize>(
        self: &Arc<Self>,
        matrices: [&SymmetricMatrix<T>; N],
        progress: Progress<'_>,
    ) -> Result<[Factor<T>; N]> {
        const { assert!(N == 1 || N == 2, "one matrix or two are factored at a time") };
        let has_pattern = |matrix: &SymmetricMatrix<T>| {
            Arc::ptr_eq(matrix.pattern(), &self.pattern) || *matrix.pattern() == self.pattern
        };
        if let Some(matrix) = matrices.iter().position(|matrix| !has_pattern(matrix)) {
            return Err(Error::PatternMismatch { matrix });
        }
        let matrices = matrices.map(SymmetricMatrix::values);
        match dispatch(Factorisation { symbolic: self, matrices, progress }) {
            Ok(factors) => {
                Ok(factors.map(|values| Factor { symbolic: Arc::clone(self), values, numbers: PhantomData }))
            }
            Err(Failure::Stopped) => Err(Error::Cancelled),
            Err(Failure::OutOfMemory) => Err(Error::OutOfMemory { stage: "factoring" }),
            Err(Failure::NotPositive { unknown, lane }) => {
                Err(Error::NotPositiveDefinite { matrix: lane, row: self.permutation.old_of_new[unknown] as usize })
            }
        }
    }
}

impl<T: Scalar, E: Entry<T>> Factor<T, E> {
    /// Number of rows.
    pub fn size(&self) -> usize {
        self.symbolic.size()
    }

    /// Number of nonzeros, zeros inside supernodes counted.
    pub fn nonzeros(&self) -> usize {
        self.values.len()
    }

    /// The solution (`#rows`) for one right side (`#rows`).
    ///
    /// # Panics
    /// Where the right side has another length.
    pub fn solve(&self, right: &[T]) -> Vec<T> {
        self.backward(self.forward(right))
    }

    /// The solution for a right side that is zero but at a few rows, given as `(row, value)`.
    ///
    /// # Panics
    /// Where a row is not in the matrix.
    pub fn solve_sparse(&self, right: &[(u32, T)]) -> Vec<T> {
        self.backward(self.forward_sparse(right))
    }

    /// A supernode and its dense block.
    #[inline(always)]
    fn block(&self, index: usize) -> (Supernode<'_>, &[E]) {
        let supernode = self.symbolic.supernode(index);
        let block = &self.values[supernode.values.clone()];
        (supernode, block)
    }

    /// `C⁻¹ right`, in the elimination order.
    pub(crate) fn forward(&self, right: &[T]) -> Vec<T> {
        assert_eq!(right.len(), self.size(), "a right side has the size of the matrix");
        let old_of_new = &self.symbolic.permutation.old_of_new;
        let mut x: Vec<T> = old_of_new.iter().map(|&old| right[old as usize]).collect();
        dispatch(Forward { factor: self, supernodes: 0..self.symbolic.supernode_count(), x: &mut x });
        x
    }

    /// The same for a right side that is zero but at a few rows, given as `(row, value)`: only the ancestors of these
    /// rows in the elimination tree are touched.
    fn forward_sparse(&self, right: &[(u32, T)]) -> Vec<T> {
        let mut x = vec![T::ZERO; self.symbolic.size()];
        for &(row, value) in right {
            x[self.unknown(row)] += value;
        }
        let supernodes = self.reach(right);
        dispatch(Forward { factor: self, supernodes: supernodes.iter().map(|&index| index as usize), x: &mut x });
        x
    }

    /// `C⁻ᴴ x` for a vector in the elimination order; the result is in the order of the matrix.
    pub(crate) fn backward(&self, mut x: Vec<T>) -> Vec<T> {
        dispatch(Backward { factor: self, x: &mut x });
        let new_of_old = &self.symbolic.permutation.new_of_old;
        new_of_old.iter().map(|&new| x[new as usize]).collect()
    }

    fn reach(&self, right: &[(u32, T)]) -> Vec<u32> {
        self.symbolic.reach(right.iter().map(|&(row, _)| self.unknown(row)))
    }

    fn unknown(&self, row: u32) -> usize {
        self.symbolic.permutation.new_of_old[row as usize] as usize
    }
}

impl Factor {
    /// The same with its entries in single precision, which takes half the memory and, where it is large, little more than half the
    /// time. Every substitution is that of a matrix whose entries differ by 10⁻⁷ or so. The factor itself where some entries
    /// are too large or too small for that.
    pub fn rounded(self) -> std::result::Result<Factor<f64, f32>, Self> {
        let [least, most] = [f32::MIN_POSITIVE, f32::MAX].map(f64::from);
        let mut values = Vec::with_capacity(self.values.len());
        for block in self.values.chunks(ROUNDED_AT_ONCE) {
            let is_beyond =
                |&value: &f64| ((value != 0.0) & (value.abs() < least)) | (value.abs() > most) | value.is_nan();
            if block.iter().fold(false, |any, value| any | is_beyond(value)) {
                return Err(self);
            }
            values.extend(block.iter().map(|&value| value as f32));
        }
        Ok(Factor { symbolic: self.symbolic, values, numbers: PhantomData })
    }
}

impl<T: Scalar, E: Entry<T>> Factor<T, E> {
    /// `C⁻¹ right` for several such right sides, each kept where it is not zero.
    pub(crate) fn forward_sparse_all(&self, rights: &[&[(u32, T)]]) -> Vec<SparseVector<T>> {
        rights.chunks(LANES).flat_map(|rights| dispatch(ForwardSparse { factor: self, rights })).collect()
    }
}

/// `x ← C⁻¹ x`, by the supernodes that matter.
struct Forward<'a, T, E, I> {
    factor: &'a Factor<T, E>,
    supernodes: I,
    x: &'a mut [T],
}

impl<T: Scalar, E: Entry<T>, I: Iterator<Item = usize>> Work for Forward<'_, T, E, I> {
    type Output = ();

    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let mut change = Vec::new();
        for index in self.supernodes {
            let (supernode, block) = self.factor.block(index);
            substitution::forward::<T, E, FUSED>(&supernode, block, self.x, &mut change);
        }
    }
}

/// `x ← C⁻ᴴ x`.
struct Backward<'a, T, E> {
    factor: &'a Factor<T, E>,
    x: &'a mut [T],
}

impl<T: Scalar, E: Entry<T>> Work for Backward<'_, T, E> {
    type Output = ();

    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let mut known = Vec::new();
        for index in (0..self.factor.symbolic.supernode_count()).rev() {
            let (supernode, block) = self.factor.block(index);
            substitution::backward::<T, E, FUSED>(&supernode, block, self.x, &mut known);
        }
    }
}

/// `C⁻¹ right` for up to [`LANES`] sparse right sides: each block of the factor is read once for all.
struct ForwardSparse<'a, T, E> {
    factor: &'a Factor<T, E>,
    rights: &'a [&'a [(u32, T)]],
}

impl<T: Scalar, E: Entry<T>> Work for ForwardSparse<'_, T, E> {
    type Output = Vec<SparseVector<T>>;

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> Vec<SparseVector<T>> {
        let Self { factor, rights } = self;
        let mut x = vec![[T::ZERO; LANES]; factor.symbolic.size()];
        // Every supernode that is touched, above the right sides that touch it: whole numbers are sorted soonest.
        let mut touched: Vec<u64> = Vec::new();
        for (lane, right) in rights.iter().enumerate() {
            for &(row, value) in *right {
                x[factor.unknown(row)][lane] += value;
            }
            touched.extend(factor.reach(right).into_iter().map(|index| u64::from(index) << 32 | lane as u64));
        }
        touched.sort_unstable();
        let mut vectors = vec![SparseVector::default(); rights.len()];
        let mut change = Vec::new();
        for lanes in touched.chunk_by(|a, b| a >> 32 == b >> 32) {
            let (supernode, block) = factor.block((lanes[0] >> 32) as usize);
            substitution::forward_lanes::<T, E, LANES, FUSED>(&supernode, block, &mut x, &mut change);
            let own = &x[supernode.start..supernode.start + supernode.width];
            for lane in lanes.iter().map(|&pair| pair as u32 as usize) {
                vectors[lane].push(supernode.start, own.iter().map(|values| values[lane]));
            }
        }
        vectors
    }
}
