//! Fill-reducing orderings.
//!
//! Amestoy, Davis, Duff, "An approximate minimum degree ordering algorithm" (1996).

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use crate::error::{Error, Result};

/// How to order the unknowns before factoring.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ordering {
    /// Approximate minimum degree: quick, good to about 10⁵ unknowns.
    #[default]
    MinimumDegree,
}

/// A renumbering of the unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Permutation {
    /// Old number of each new one.
    pub(crate) old_of_new: Vec<u32>,
    /// New number of each old one.
    pub(crate) new_of_old: Vec<u32>,
}

impl Ordering {
    /// Orders the unknowns of a symmetric pattern, given by its lower triangle.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub(crate) fn order(self, pattern: SymbolicSparseColMatRef<'_, u32>) -> Result<Permutation> {
        let out_of_memory = || Error::OutOfMemory { stage: "ordering the unknowns" };
        let size = pattern.nrows();
        let mut permutation = Permutation { old_of_new: vec![0; size], new_of_old: vec![0; size] };
        match self {
            Self::MinimumDegree => {
                let scratch = amd::order_maybe_unsorted_scratch::<u32>(size, pattern.compute_nnz());
                let mut memory = MemBuffer::try_new(scratch).map_err(|_| out_of_memory())?;
                amd::order_maybe_unsorted(
                    &mut permutation.old_of_new,
                    &mut permutation.new_of_old,
                    pattern,
                    amd::Control::default(),
                    MemStack::new(&mut memory),
                )
                .map_err(|_| out_of_memory())?;
            }
        }
        Ok(permutation)
    }
}
