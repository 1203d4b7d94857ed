//! The sparse Cholesky factor of a mesh's heat matrix by this project and by faer, under the same elimination order:
//! factoring and one solve, in alternation. Prints medians in milliseconds, as JSON.
//!
//! `cargo run --release -p heatwalk --example factors -- MESH`

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};
use heatwalk::operator::laplacian::Laplacian;
use heatwalk::{Operator, Surface, io};
use heatwalk_sparse::{Permutation, Symbolic, SymmetricMatrix};
use serde_json::json;

const ROUNDS: usize = 9;
/// Rounding of two eliminations in another order of sums, as a share of the largest value.
const AGREEMENT: f64 = 1e-9;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("give a mesh")?;
    let surface = Surface::build(&io::read(&path, &fs::read(&path)?, &|_| None)?)?;
    let matrix = heat_matrix(&surface)?;
    let permutation = Permutation::fill_reducing(matrix.pattern())?;
    let [supernodal, simplicial] = [SupernodalThreshold::FORCE_SUPERNODAL, SupernodalThreshold::FORCE_SIMPLICIAL]
        .map(|threshold| Faer::analyse(&matrix, &permutation, threshold));
    let (mut supernodal, mut simplicial) = (supernodal?, simplicial?);
    let symbolic = Arc::new(Symbolic::analyse(matrix.pattern(), permutation)?);
    let right: Vec<f64> = (0..matrix.size()).map(|row| (row as f64).sin()).collect();

    let mut times = [const { Vec::new() }; 6];
    for _ in 0..ROUNDS {
        let (time, factor) = timed(|| symbolic.factor([&matrix], &mut |_| ControlFlow::Continue(())));
        let [factor] = factor?;
        times[0].push(time);
        let (time, own) = timed(|| factor.solve(&right));
        times[1].push(time);
        for (index, peer) in [&mut supernodal, &mut simplicial].into_iter().enumerate() {
            times[2 + 2 * index].push(timed(|| peer.factor(&matrix)).0);
            let (time, solution) = timed(|| peer.solve(&right));
            times[3 + 2 * index].push(time);
            let largest = own.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
            let agrees = own.iter().zip(&solution).all(|(a, b)| (a - b).abs() <= AGREEMENT * largest);
            assert!(agrees, "the solutions differ");
        }
    }
    let [factor, solve, supernodal_factor, supernodal_solve, simplicial_factor, simplicial_solve] = times.map(median);
    println!(
        "{}",
        json!({
            "factor": factor,
            "solve": solve,
            "faer_supernodal_factor": supernodal_factor,
            "faer_supernodal_solve": supernodal_solve,
            "faer_simplicial_factor": simplicial_factor,
            "faer_simplicial_solve": simplicial_solve,
        })
    );
    Ok(())
}

/// `M / t + L` for a time step of one mean edge squared.
fn heat_matrix(surface: &Surface) -> heatwalk_sparse::Result<SymmetricMatrix> {
    let laplacian = Laplacian::new(surface, Operator::default());
    let time = surface.mean_edge() * surface.mean_edge();
    let (pattern, mut values) = laplacian.stiffness.into_parts();
    for (column, mass) in laplacian.mass.iter().enumerate() {
        values[pattern.column(column).start] += mass / time;
    }
    SymmetricMatrix::new(pattern, values)
}

/// faer's Cholesky factorisation of one matrix, with all its memory.
struct Faer {
    symbolic: SymbolicCholesky<u32>,
    values: Vec<f64>,
    memory: MemBuffer,
}

impl Faer {
    fn analyse(
        matrix: &SymmetricMatrix,
        permutation: &Permutation,
        threshold: SupernodalThreshold,
    ) -> Result<Self, Box<dyn Error>> {
        let order = PermRef::new_checked(permutation.old_of_new(), permutation.new_of_old(), matrix.size());
        let parameters =
            CholeskySymbolicParams { supernodal_flop_ratio_threshold: threshold, ..CholeskySymbolicParams::default() };
        let symbolic = factorize_symbolic_cholesky(
            view(matrix).symbolic(),
            Side::Lower,
            SymmetricOrdering::Custom(order),
            parameters,
        )
        .map_err(|error| format!("{error:?}"))?;
        let factoring = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let memory = MemBuffer::new(factoring.or(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq)));
        Ok(Self { values: vec![0.0; symbolic.len_val()], symbolic, memory })
    }

    fn factor(&mut self, matrix: &SymmetricMatrix) {
        let factored = self.symbolic.factorize_numeric_llt(
            &mut self.values,
            view(matrix),
            Side::Lower,
            LltRegularization::default(),
            Par::Seq,
            MemStack::new(&mut self.memory),
            Default::default(),
        );
        assert!(factored.is_ok(), "a heat matrix is positive definite");
    }

    fn solve(&mut self, right: &[f64]) -> Vec<f64> {
        let mut solution = right.to_vec();
        let size = solution.len();
        let factor = LltRef::new(&self.symbolic, &self.values);
        let side = MatMut::from_column_major_slice_mut(&mut solution, size, 1);
        factor.solve_in_place_with_conj(Conj::No, side, Par::Seq, MemStack::new(&mut self.memory));
        solution
    }
}

fn view(matrix: &SymmetricMatrix) -> SparseColMatRef<'_, u32, f64> {
    let (size, pattern) = (matrix.size(), matrix.pattern());
    let symbolic = SymbolicSparseColMatRef::new_checked(size, size, pattern.column_start(), None, pattern.rows());
    SparseColMatRef::new(symbolic, matrix.values())
}

fn timed<A>(work: impl FnOnce() -> A) -> (f64, A) {
    let start = Instant::now();
    let answer = black_box(work());
    (start.elapsed().as_secs_f64() * 1e3, answer)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
