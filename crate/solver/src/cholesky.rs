//! Supernodal sparse Cholesky: one symbolic analysis for all matrices of a pattern, and solves of single vectors.
//!
//! Chen, Davis, Hager, Rajamanickam, "Algorithm 887: CHOLMOD" (2008) for the scheme; faer does the factoring.

use std::sync::Arc;

use faer::Par;
use faer::Side;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
// Named here only so that its wasm-simd128-enable feature reaches faer's dense kernels.
use gemm as _;

use crate::error::{Error, Result};
use crate::ordering::{Ordering, Permutation};

/// Elimination order and the pattern of the factors, shared by every matrix of one pattern.
#[derive(Debug)]
pub(crate) struct Symbolic {
    analysis: SymbolicCholesky<u32>,
    permutation: Permutation,
    column_start: Vec<u32>,
    rows: Vec<u32>,
}

impl Symbolic {
    /// Finds an elimination order for a pattern: `column_start` and `rows` of its lower triangle.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(crate) fn order(ordering: Ordering, column_start: &[u32], rows: &[u32]) -> Result<Permutation> {
        ordering.order(pattern(column_start, rows))
    }

    /// Analyses a pattern under an elimination order.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(crate) fn analyse(permutation: Permutation, column_start: Vec<u32>, rows: Vec<u32>) -> Result<Self> {
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        let size = column_start.len() - 1;
        let order = PermRef::new_checked(&permutation.old_of_new, &permutation.new_of_old, size);
        let custom = SymmetricOrdering::Custom(order);
        let analysis = factorize_symbolic_cholesky(pattern(&column_start, &rows), Side::Lower, custom, params)
            .map_err(|_| Error::OutOfMemory { stage: "analysing the matrix" })?;
        Ok(Self { analysis, permutation, column_start, rows })
    }

    /// Factors the matrix with these values of the lower triangle. `name` tells which it is in errors.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] with the vertex of the failing pivot; [`Error::OutOfMemory`].
    pub(crate) fn factor(self: &Arc<Self>, values: &[f64], name: &'static str) -> Result<Factor> {
        let out_of_memory = || Error::OutOfMemory { stage: "factoring" };
        let length = self.analysis.len_val();
        let mut factor = Vec::new();
        factor.try_reserve_exact(length).map_err(|_| out_of_memory())?;
        factor.resize(length, 0.0);
        let scratch = self.analysis.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let mut memory = MemBuffer::try_new(scratch).map_err(|_| out_of_memory())?;
        let matrix = SparseColMatRef::new(pattern(&self.column_start, &self.rows), values);
        let result = self.analysis.factorize_numeric_llt(
            &mut factor,
            matrix,
            Side::Lower,
            Default::default(),
            Par::Seq,
            MemStack::new(&mut memory),
            Default::default(),
        );
        match result {
            Ok(_) => Ok(Factor { symbolic: Arc::clone(self), values: factor }),
            Err(LltError::NonPositivePivot { index }) => Err(Error::NotPositiveDefinite {
                matrix: name,
                vertex: self.permutation.old_of_new.get(index).map_or(index, |&old| old as usize),
            }),
        }
    }
}

fn pattern<'a>(column_start: &'a [u32], rows: &'a [u32]) -> SymbolicSparseColMatRef<'a, u32> {
    let size = column_start.len() - 1;
    SymbolicSparseColMatRef::new_checked(size, size, column_start, None, rows)
}

/// The Cholesky factor of one matrix.
#[derive(Debug)]
pub(crate) struct Factor {
    symbolic: Arc<Symbolic>,
    /// Supernodes one after another, each a dense column-major block of its own rows, then the rows below.
    values: Vec<f64>,
}

impl Factor {
    /// Number of stored entries, zeros inside supernodes counted.
    pub(crate) fn nonzeros(&self) -> usize {
        self.values.len()
    }

    /// Replaces a right side by the solution. Written for one vector: faer's own solve is made for many, and takes
    /// twice as long for one.
    pub(crate) fn solve_in_place(&self, vector: &mut [f64]) {
        let SymbolicCholeskyRaw::Supernodal(supernodal) = self.symbolic.analysis.raw() else {
            unreachable!("the analysis is always supernodal, its threshold being 0");
        };
        let old_of_new = &self.symbolic.permutation.old_of_new;
        let mut x: Vec<f64> = old_of_new.iter().map(|&old| vector[old as usize]).collect();
        let mut below = Vec::new();
        let blocks = |s: usize| {
            let supernode = supernodal.supernode(s);
            let start = supernode.start();
            let width = supernodal.supernode_end()[s] as usize - start;
            let values = supernodal.col_ptr_for_val();
            (start, width, supernode.pattern(), &self.values[values[s] as usize..values[s + 1] as usize])
        };
        for s in 0..supernodal.n_supernodes() {
            let (start, width, pattern, block) = blocks(s);
            below.clear();
            below.resize(pattern.len(), 0.0);
            let own = &mut x[start..start + width];
            for (j, column) in block.chunks_exact(width + pattern.len()).enumerate() {
                let value = own[j] / column[j];
                own[j] = value;
                subtract_multiple(&mut own[j + 1..], &column[j + 1..width], value);
                subtract_multiple(&mut below, &column[width..], value);
            }
            for (&row, change) in pattern.iter().zip(&below) {
                x[row as usize] += change;
            }
        }
        for s in (0..supernodal.n_supernodes()).rev() {
            let (start, width, pattern, block) = blocks(s);
            below.clear();
            below.extend(pattern.iter().map(|&row| x[row as usize]));
            let own = &mut x[start..start + width];
            for (j, column) in block.chunks_exact(width + pattern.len()).enumerate().rev() {
                let known = dot(&column[j + 1..width], &own[j + 1..]) + dot(&column[width..], &below);
                own[j] = (own[j] - known) / column[j];
            }
        }
        for (&old, value) in old_of_new.iter().zip(x) {
            vector[old as usize] = value;
        }
    }
}

fn subtract_multiple(target: &mut [f64], column: &[f64], factor: f64) {
    for (target, value) in target.iter_mut().zip(column) {
        *target -= value * factor;
    }
}

/// Dot product in four running sums, which the compiler may keep in vector registers.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a_blocks, b_blocks) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a_blocks.remainder().iter().zip(b_blocks.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; 4];
    for (a, b) in a_blocks.zip(b_blocks) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}
