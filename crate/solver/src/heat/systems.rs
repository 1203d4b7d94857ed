//! How systems of the operators' pattern are made ready, and whether there is room for it.

use std::sync::{Arc, Mutex, PoisonError};

use heatwalk_sparse::{
    ConjugateGradients, Factor, Functional, Permutation, Progress, Scalar, SchurCache, SchurColumn, Stage, Symbolic,
    SymmetricMatrix, System, go_on, report,
};

use crate::error::{Error, Result};
use crate::operator::{Discretization, Operators};
use crate::options::{LinearSolver, MemoryLimit};

/// Matrices that are factored at the same time, at most.
const SIDE_BY_SIDE: usize = 2;

/// Numbers a vertex that a solve has in use at once, beside the factors: heat, the field of the faces (three numbers each,
/// and twice as many faces as vertices), distance, their right sides and what is answered.
const SOLVE_NUMBERS: usize = 32;

/// Factors of fewer entries stay in a cache, where substitutions do not wait for memory.
const ROUNDED_ENTRIES: usize = 1 << 20;

const BYTES_PER_NUMBER: u64 = size_of::<f64>() as u64;

/// Share of the progress before ordering, and before analysing.
const SHARES: [f64; 2] = [0.1, 0.2];

/// Operators and how systems of their pattern are solved. Every matrix has the same pattern, so that one elimination order
/// and one symbolic analysis serve all of them.
#[derive(Debug)]
pub struct Systems<D = Operators> {
    operators: D,
    /// None for conjugate gradients.
    symbolic: Option<Arc<Symbolic>>,
}

impl<D: Discretization> Systems<D> {
    /// Chooses an elimination order and finds the pattern of the factors; with conjugate gradients there is nothing to do.
    ///
    /// # Errors
    /// [`Error::Cancelled`]; [`Error::OutOfMemory`].
    pub fn new(operators: D, solver: LinearSolver, progress: Progress<'_>) -> Result<Arc<Self>> {
        Self::numbered(operators, None, solver, progress)
    }

    /// The same for the operators of a surface whose vertices came in another order: see
    /// [`Permutation::fill_reducing_by`].
    pub(super) fn numbered(
        operators: D,
        numbering: Option<Vec<u32>>,
        solver: LinearSolver,
        progress: Progress<'_>,
    ) -> Result<Arc<Self>> {
        let symbolic = match solver {
            LinearSolver::Cholesky => {
                let pattern = operators.laplacian().pattern();
                let [ordering, analysing] = SHARES;
                report(progress, Stage::Ordering, ordering)?;
                let permutation = match numbering {
                    Some(numbering) => Permutation::fill_reducing_by(pattern, numbering)?,
                    None => Permutation::fill_reducing(pattern)?,
                };
                report(progress, Stage::Analysing, analysing)?;
                Some(Arc::new(Symbolic::analyse(pattern, permutation)?))
            }
            LinearSolver::ConjugateGradients => None,
        };
        Ok(Arc::new(Self { operators, symbolic }))
    }

    /// The operators.
    pub fn operators(&self) -> &D {
        &self.operators
    }

    /// Refuses to make so many matrices ready where their factors do not fit beside those kept, which have `kept` numbers.
    ///
    /// # Errors
    /// [`Error::TooLarge`].
    pub fn check_memory(&self, kept: usize, matrices: usize, limit: MemoryLimit) -> Result<()> {
        let Some(symbolic) = &self.symbolic else { return Ok(()) };
        if matrices == 0 {
            return Ok(());
        }
        let memory = symbolic.memory::<f64>(matrices.min(SIDE_BY_SIDE));
        let mut blocks = vec![memory.factor; matrices];
        // Work on the factors ends before the first solve begins.
        blocks.push(memory.factorization.max(BYTES_PER_NUMBER * (SOLVE_NUMBERS * symbolic.size()) as u64));
        let needed_bytes = BYTES_PER_NUMBER * kept as u64 + blocks.iter().sum::<u64>();
        let fits = match limit {
            MemoryLimit::Automatic => heatwalk_base::memory::has_room(&blocks),
            MemoryLimit::Bytes(most) => needed_bytes <= most,
        };
        if fits { Ok(()) } else { Err(Error::TooLarge { needed_bytes }) }
    }

    /// Makes matrices ready, side by side. Each has a name for errors.
    pub(super) fn systems<const N: usize>(
        &self,
        matrices: [(SymmetricMatrix, &'static str); N],
        progress: Progress<'_>,
    ) -> Result<[System; N]> {
        report(progress, Stage::Factoring, 0.0)?;
        Ok(match &self.symbolic {
            Some(symbolic) => {
                let names = matrices.each_ref().map(|&(_, name)| name);
                let factors = symbolic.factor(matrices.each_ref().map(|(matrix, _)| matrix), progress);
                factors.map_err(|error| Error::of_matrices(&error, &names))?.map(Self::kept)
            }
            None => matrices.map(|(matrix, _)| System::ConjugateGradients(ConjugateGradients::new(matrix))),
        })
    }

    /// Another matrix of the pattern, of real or complex numbers, made ready.
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`]; [`Error::OutOfMemory`]; [`Error::Cancelled`];
    /// [`Error::Algebra`] for a matrix of another pattern.
    pub fn system_of<T: Scalar>(&self, matrix: SymmetricMatrix<T>, progress: Progress<'_>) -> Result<System<T>> {
        let Some(symbolic) = &self.symbolic else {
            return Ok(System::ConjugateGradients(ConjugateGradients::new(matrix)));
        };
        let [factor] = symbolic.factor([&matrix], progress)?;
        Ok(System::cholesky(factor))
    }

    fn kept(factor: Factor) -> System {
        if D::ROUNDS && factor.nonzeros() >= ROUNDED_ENTRIES {
            factor.rounded().map_or_else(System::cholesky, System::cholesky)
        } else {
            System::cholesky(factor)
        }
    }

    pub(super) fn system(&self, matrix: SymmetricMatrix, name: &'static str) -> Result<System> {
        let [system] = self.systems([(matrix, name)], &mut go_on)?;
        Ok(system)
    }

    /// Whether so many constraints cost more than factoring the matrix with their vertices constrained.
    pub(super) fn is_cheaper_to_factor(&self, constraints: usize) -> bool {
        match &self.symbolic {
            Some(symbolic) => symbolic.constraint_work(constraints) > symbolic.factor_work(),
            // Each constraint is a solve of its own; constraining vertices takes new grids, which is a fraction of one. A
            // single value is reached by adding a constant or by scaling.
            None => constraints > 1,
        }
    }
}

/// A system with the Schur columns of its constraints of late.
#[derive(Debug)]
pub(super) struct CachedSystem {
    pub(super) system: System,
    columns: Mutex<SchurCache>,
}

impl CachedSystem {
    pub(super) fn new(system: System) -> Self {
        Self { system, columns: Mutex::default() }
    }

    /// The Schur columns of constraints. As many numbers are kept as the factor has.
    pub(super) fn columns(&self, functionals: &[Functional]) -> Result<Vec<Arc<SchurColumn>>> {
        let capacity = self.system.factor_nonzeros().max(self.system.size());
        // Columns are kept once they are whole, so those kept before a panic are right.
        let mut kept = self.columns.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(kept.columns(&self.system, functionals, capacity)?)
    }
}
