//! Supernodal sparse Cholesky: one symbolic analysis for all matrices of a pattern.
//!
//! Chen, Davis, Hager, Rajamanickam, "Algorithm 887: CHOLMOD" (2008) for the scheme; faer does the factoring.

use std::collections::BTreeSet;
use std::sync::Arc;

use faer::Par;
use faer::Side;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
    supernodal::SymbolicSupernodalCholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
// Named here only so that its wasm-simd128-enable feature reaches faer's dense kernels.
use gemm as _;

use crate::error::{Error, Result};
use crate::linear::Pattern;
use crate::linear::factor::Factor;
use crate::linear::ordering::{Ordering, Permutation};

/// Unknowns whose way to the root is looked at to tell what a constraint costs.
const CONSTRAINT_SAMPLES: usize = 16;

/// How much slower a multiplication is in a sparse forward solve, which waits for memory, than in a factorisation,
/// which works in dense blocks.
const SPARSE_PENALTY: f64 = 4.0;

/// Elimination order and the pattern of the factors, shared by every matrix of one pattern.
#[derive(Debug)]
pub(crate) struct Symbolic {
    analysis: SymbolicCholesky<u32>,
    pub(crate) permutation: Permutation,
    pattern: Arc<Pattern>,
    /// Supernode of each unknown, in the elimination order.
    supernode_of: Vec<u32>,
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
    /// Finds an elimination order for a pattern.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(crate) fn order(ordering: Ordering, pattern: &Pattern) -> Result<Permutation> {
        ordering.order(view(pattern))
    }

    /// Analyses a pattern under an elimination order.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(crate) fn analyse(permutation: Permutation, pattern: Arc<Pattern>) -> Result<Self> {
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        let order = PermRef::new_checked(&permutation.old_of_new, &permutation.new_of_old, pattern.size());
        let custom = SymmetricOrdering::Custom(order);
        let analysis = factorize_symbolic_cholesky(view(&pattern), Side::Lower, custom, params)
            .map_err(|_| Error::OutOfMemory { stage: "analysing the matrix" })?;
        let mut symbolic = Self { analysis, permutation, pattern, supernode_of: Vec::new() };
        let mut supernode_of = vec![0; symbolic.size()];
        for index in 0..symbolic.supernode_count() {
            let Supernode { start, width, .. } = symbolic.supernode(index);
            supernode_of[start..start + width].fill(index as u32);
        }
        symbolic.supernode_of = supernode_of;
        Ok(symbolic)
    }

    /// Number of unknowns.
    pub(crate) fn size(&self) -> usize {
        self.pattern.size()
    }

    fn supernodal(&self) -> &SymbolicSupernodalCholesky<u32> {
        match self.analysis.raw() {
            SymbolicCholeskyRaw::Supernodal(supernodal) => supernodal,
            SymbolicCholeskyRaw::Simplicial(_) => {
                unreachable!("the analysis is always supernodal, its threshold being 0")
            }
        }
    }

    /// Number of supernodes.
    pub(crate) fn supernode_count(&self) -> usize {
        self.supernodal().n_supernodes()
    }

    /// One supernode; they are numbered in the elimination order.
    pub(crate) fn supernode(&self, index: usize) -> Supernode<'_> {
        let supernodal = self.supernodal();
        let supernode = supernodal.supernode(index);
        let start = supernode.start();
        let values = supernodal.col_ptr_for_val();
        Supernode {
            start,
            width: supernodal.supernode_end()[index] as usize - start,
            below: supernode.pattern(),
            values: values[index] as usize..values[index + 1] as usize,
        }
    }

    /// The supernodes that a forward solve touches when the right side is non-zero at `unknowns` (in the elimination
    /// order) only: theirs and all ancestors in the elimination tree, ascending.
    pub(crate) fn reach(&self, unknowns: impl Iterator<Item = usize>) -> Vec<u32> {
        let mut reached = BTreeSet::new();
        for unknown in unknowns {
            let mut next = Some(self.supernode_of[unknown]);
            while let Some(index) = next.filter(|&index| reached.insert(index)) {
                next = self.supernode(index as usize).below.first().map(|&row| self.supernode_of[row as usize]);
            }
        }
        reached.into_iter().collect()
    }

    /// Work of `count` constraints, in the unit of [`Symbolic::factor_work`].
    pub(crate) fn constraint_work(&self, count: usize) -> f64 {
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
    pub(crate) fn factor_work(&self) -> f64 {
        let work = |index| {
            let Supernode { width, below, .. } = self.supernode(index);
            width as f64 * ((width + below.len()) as f64).powi(2)
        };
        (0..self.supernode_count()).map(work).sum()
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
        let matrix = SparseColMatRef::new(view(&self.pattern), values);
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
            Ok(_) => Ok(Factor::new(Arc::clone(self), factor)),
            Err(LltError::NonPositivePivot { index }) => Err(Error::NotPositiveDefinite {
                matrix: name,
                vertex: self.permutation.old_of_new.get(index).map_or(index, |&old| old as usize),
            }),
        }
    }
}

fn view(pattern: &Pattern) -> SymbolicSparseColMatRef<'_, u32> {
    SymbolicSparseColMatRef::new_checked(pattern.size(), pattern.size(), &pattern.column_start, None, &pattern.rows)
}
