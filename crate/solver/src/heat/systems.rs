//! How the heat and Poisson systems of one surface are made ready, and whether there is room for it.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::error::{Error, Result};
use crate::options::MemoryLimit;
use heatwalk_sparse::{ConjugateGradients, Symbolic, SymmetricMatrix, System};
use heatwalk_surface::memory;

/// Matrices that are factored at the same time, at most.
const SIDE_BY_SIDE: usize = 2;

/// Numbers a point that a solve has in use at once, beside the factors: heat, the field of the faces (three numbers each,
/// and twice as many faces as points), distance, their right sides and what is answered.
const SOLVE_NUMBERS: usize = 32;

const BYTES_PER_NUMBER: u64 = size_of::<f64>() as u64;

/// How systems of the surface's pattern are made ready.
#[derive(Debug, Clone)]
pub(super) enum Solve {
    Factored(Arc<Symbolic>),
    Iterated,
}

impl Solve {
    /// Refuses to make so many matrices ready where their factors do not fit beside those kept, which have `kept` numbers.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    pub(super) fn check_memory(&self, kept: usize, matrices: usize, limit: MemoryLimit) -> Result<()> {
        let Self::Factored(symbolic) = self else { return Ok(()) };
        if matrices == 0 {
            return Ok(());
        }
        let memory = symbolic.memory::<f64>(matrices.min(SIDE_BY_SIDE));
        let mut blocks = vec![memory.factor; matrices];
        // Work on the factors ends before the first solve begins.
        blocks.push(memory.factorization.max(BYTES_PER_NUMBER * (SOLVE_NUMBERS * symbolic.size()) as u64));
        let needed_bytes = BYTES_PER_NUMBER * kept as u64 + blocks.iter().sum::<u64>();
        let fits = match limit {
            MemoryLimit::Automatic => memory::has_room(&blocks),
            MemoryLimit::Bytes(most) => needed_bytes <= most,
        };
        if fits { Ok(()) } else { Err(Error::TooLarge { needed_bytes }) }
    }

    /// Makes matrices ready, side by side. Each has a name for errors. `progress` is told the share of the work done.
    pub(super) fn systems<const N: usize>(
        &self,
        matrices: [(SymmetricMatrix, &'static str); N],
        progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<[System; N]> {
        if progress(0.0).is_break() {
            return Err(Error::Cancelled);
        }
        Ok(match self {
            Self::Factored(symbolic) => {
                let names = matrices.each_ref().map(|&(_, name)| name);
                let factors = symbolic.factor(matrices.each_ref().map(|(matrix, _)| matrix), progress);
                factors.map_err(|error| Error::of_matrices(&error, &names))?.map(System::Cholesky)
            }
            Self::Iterated => matrices.map(|(matrix, _)| System::ConjugateGradients(ConjugateGradients::new(matrix))),
        })
    }

    pub(super) fn system(&self, matrix: SymmetricMatrix, name: &'static str) -> Result<System> {
        let [system] = self.systems([(matrix, name)], &mut |_| ControlFlow::Continue(()))?;
        Ok(system)
    }
}
