//! Multifrontal Cholesky factorisation of matrices of one pattern, several at a time.
//!
//! Duff and Reid, "The multifrontal solution of indefinite sparse symmetric linear equations" (1983); Liu, "The
//! multifrontal method for sparse matrix solution: theory and practice" (1992). Every supernode adds up what its
//! children in the elimination tree left over for it, eliminates its own unknowns in a dense front, and leaves the
//! Schur complement on a stack.

use crate::front::{Front, NotPositive, packed_start};
use crate::progress::{Progress, Stage};
use crate::scalar::Scalar;
use crate::simd::{Work, array};
use crate::symbolic::{Supernode, Symbolic};

/// Share of the work after which progress is told.
const TELLING: f64 = 1.0 / 64.0;

/// Why there are no factors.
pub(crate) enum Failure {
    NotPositive {
        unknown: usize,
        lane: usize,
    },
    OutOfMemory,
    /// Progress was told to.
    Stopped,
}

/// Factors the `N` matrices with these values of the lower triangle.
pub(crate) struct Factorisation<'a, T, const N: usize> {
    pub(crate) symbolic: &'a Symbolic,
    pub(crate) matrices: [&'a [T]; N],
    pub(crate) progress: Progress<'a>,
}

impl<T: Scalar, const N: usize> Work for Factorisation<'_, T, N> {
    /// Values of the factors: supernodes one after another, each a dense column-major block.
    type Output = Result<[Vec<T>; N], Failure>;

    #[inline(always)]
    fn run<const FUSED: bool>(self) -> Self::Output {
        let Self { symbolic, matrices, progress } = self;
        let mut factors: [Vec<T>; N] = std::array::from_fn(|_| Vec::new());
        for factor in &mut factors {
            factor.try_reserve_exact(symbolic.factor_nonzeros()).map_err(|_| Failure::OutOfMemory)?;
        }
        let mut stack: Vec<T> = Vec::new();
        stack.try_reserve_exact(symbolic.stack_length() * N).map_err(|_| Failure::OutOfMemory)?;
        let mut waiting: Vec<u32> = Vec::new();
        let mut eliminated = Vec::new();
        let mut packed = Vec::new();
        let mut places = vec![0; symbolic.size()];
        let mut relative = Vec::new();
        let whole = symbolic.factor_work();
        let (mut done, mut told) = (0.0, 0.0);
        for index in 0..symbolic.supernode_count() {
            if done > told + TELLING * whole {
                told = done;
                if progress(Stage::Factoring, done / whole).is_break() {
                    return Err(Failure::Stopped);
                }
            }
            done += symbolic.work(index);
            let Supernode { start, width, below, .. } = symbolic.supernode(index);
            let rows = width + below.len();
            eliminated.clear();
            eliminated.resize(rows * width * N, T::ZERO);
            let [kept, transposed] = symbolic.entries(index);
            let targets = eliminated.as_chunks_mut::<N>().0;
            for &(source, place) in kept {
                targets[place as usize] = array(|lane| matrices[lane][source as usize]);
            }
            for &(source, place) in transposed {
                targets[place as usize] = array(|lane| matrices[lane][source as usize].conj());
            }
            for (place, &row) in below.iter().enumerate() {
                places[row as usize] = (width + place) as u32;
            }
            let top = stack.len();
            stack.resize(top + packed_start(below.len(), below.len()) * N, T::ZERO);
            let (children, rest) = stack.split_at_mut(top);
            let mut front = Front::<T, N> { rows, columns: width, eliminated: &mut eliminated, rest };
            let mut bottom = top;
            while let Some(&child) = waiting.last().filter(|&&child| symbolic.parent(child as usize) == index as u32) {
                waiting.pop();
                let child = symbolic.supernode(child as usize).below;
                relative.clear();
                relative.extend(child.iter().map(|&row| match row as usize {
                    row if row < start + width => (row - start) as u32,
                    row => places[row],
                }));
                let end = bottom;
                bottom -= packed_start(child.len(), child.len()) * N;
                add(&mut front, &children[bottom..end], &relative);
            }
            front
                .eliminate::<FUSED>(&mut packed)
                .map_err(|NotPositive { column, lane }| Failure::NotPositive { unknown: start + column, lane })?;
            for (lane, factor) in factors.iter_mut().enumerate() {
                factor.extend(eliminated.as_chunks::<N>().0.iter().map(|entry| entry[lane]));
            }
            stack.copy_within(top.., bottom);
            stack.truncate(bottom + packed_start(below.len(), below.len()) * N);
            if !below.is_empty() {
                waiting.push(index as u32);
            }
        }
        Ok(factors)
    }
}

/// Adds the packed lower triangle that a child left over; `relative` are its rows in the front, ascending.
#[inline(always)]
fn add<T: Scalar, const N: usize>(front: &mut Front<'_, T, N>, child: &[T], relative: &[u32]) {
    let mut child = child;
    for (j, &column) in relative.iter().enumerate() {
        let (entries, others) = child.split_at((relative.len() - j) * N);
        child = others;
        let target = front.column(column as usize).as_chunks_mut::<N>().0;
        for (&row, entry) in relative[j..].iter().zip(entries.as_chunks::<N>().0) {
            let target = &mut target[(row - column) as usize];
            *target = array(|lane| target[lane] + entry[lane]);
        }
    }
}
