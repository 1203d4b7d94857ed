//! Cholesky factors of the heat and the Poisson matrix of a mesh: ours against faer's own, on the same matrices in the
//! same elimination order, on one thread. Prints medians in milliseconds, as JSON.
//!
//! `cargo run --release -p heatwalk --example factors -- MESH`

use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::PermRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side, Spec};
use heatwalk::operator::Operators;
use heatwalk::operator::laplacian::Laplacian;
use heatwalk::sparse::{Permutation, Symbolic, SymmetricMatrix};
use heatwalk::{Operator, Surface, go_on};
use heatwalk_model::io;
use serde_json::{Value, json};

/// Each time is the median of so many. Ours and faer's are taken in turn.
const ROUNDS: usize = 7;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("give a mesh")?;
    let soup = io::read(&path, &fs::read(&path)?, &|_| None)?.soup;
    let surface = Surface::build(&soup)?;
    let operators = Operators::new(&surface, Operator::Delaunay);
    let laplacian = operators.laplacian();
    let pattern = laplacian.stiffness.pattern();
    let permutation = Permutation::fill_reducing(pattern)?;
    let symbolic = Arc::new(Symbolic::analyse(pattern, permutation.clone())?);
    let matrices = [heat(laplacian), poisson(laplacian, &surface)];
    let supernodal = Faer::new(&matrices[0], &permutation, SupernodalThreshold::FORCE_SUPERNODAL)?;
    let simplicial = Faer::new(&matrices[0], &permutation, SupernodalThreshold::FORCE_SIMPLICIAL)?;
    let right: Vec<f64> = (0..laplacian.size()).map(|row| (row as f64 * 1.7).sin()).collect();

    let mut answer = serde_json::Map::new();
    for (name, matrix) in ["heat", "poisson"].into_iter().zip(&matrices) {
        let [factor] = symbolic.factor([matrix], &mut go_on)?;
        let mut values = [&supernodal, &simplicial].map(|faer| vec![0.0; faer.symbolic.len_val()]);
        let ours = factor.solve(&right);
        for (faer, values) in [&supernodal, &simplicial].into_iter().zip(&mut values) {
            let llt = faer.factor(matrix, values)?;
            let largest = ours.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            let theirs = faer.solve(llt, &right);
            let difference = ours.iter().zip(&theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(difference <= 1e-6 * largest, "solutions differ by {difference} of {largest}");
        }
        let mut times: [Vec<f64>; 6] = Default::default();
        for _ in 0..ROUNDS {
            times[0].push(time(|| black_box(symbolic.factor([matrix], &mut go_on)).is_ok()));
            times[1].push(time(|| supernodal.factor(matrix, &mut values[0]).is_ok()));
            times[2].push(time(|| simplicial.factor(matrix, &mut values[1]).is_ok()));
            times[3].push(warm_time(|| !black_box(factor.solve(&right)).is_empty()));
            for (index, faer) in [&supernodal, &simplicial].into_iter().enumerate() {
                let llt = LltRef::new(&faer.symbolic, &values[index]);
                times[4 + index].push(warm_time(|| !black_box(faer.solve(llt, &right)).is_empty()));
            }
        }
        let [factor, supernodal, simplicial, solve, supernodal_solve, simplicial_solve] = times.map(median);
        let entry = json!({
            "factor": factor, "faer_supernodal_factor": supernodal, "faer_simplicial_factor": simplicial,
            "solve": solve, "faer_supernodal_solve": supernodal_solve, "faer_simplicial_solve": simplicial_solve,
        });
        answer.insert(name.to_owned(), entry);
    }
    let both = || time(|| black_box(symbolic.factor(matrices.each_ref(), &mut go_on)).is_ok());
    answer.insert("factor_both".to_owned(), median((0..ROUNDS).map(|_| both()).collect()).into());
    answer.insert("rows".to_owned(), laplacian.size().into());
    answer.insert("factor_nonzeros".to_owned(), symbolic.factor_nonzeros().into());
    answer.insert("faer_supernodal_nonzeros".to_owned(), supernodal.symbolic.len_val().into());
    answer.insert("faer_simplicial_nonzeros".to_owned(), simplicial.symbolic.len_val().into());
    println!("{}", Value::from(answer));
    Ok(())
}

/// faer's Cholesky in our elimination order, with its own choice of supernodes.
struct Faer {
    symbolic: SymbolicCholesky<u32>,
    new_of_old: Vec<u32>,
}

impl Faer {
    fn new(
        matrix: &SymmetricMatrix,
        permutation: &Permutation,
        supernodal_flop_ratio_threshold: SupernodalThreshold,
    ) -> Result<Self, Box<dyn Error>> {
        let size = matrix.size();
        let order = PermRef::new_checked(permutation.old_of_new(), permutation.new_of_old(), size);
        let params = CholeskySymbolicParams { supernodal_flop_ratio_threshold, ..Default::default() };
        let ordering = SymmetricOrdering::Custom(order);
        let symbolic = factorize_symbolic_cholesky(view(matrix).symbolic(), Side::Lower, ordering, params)
            .map_err(|error| format!("faer's analysis: {error:?}"))?;
        Ok(Self { symbolic, new_of_old: permutation.new_of_old().to_vec() })
    }

    fn factor<'a>(
        &'a self,
        matrix: &SymmetricMatrix,
        values: &'a mut [f64],
    ) -> Result<LltRef<'a, u32, f64>, Box<dyn Error>> {
        let scratch = self.symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default());
        let mut memory = MemBuffer::new(scratch);
        let stack = MemStack::new(&mut memory);
        let (side, regularization) = (Side::Lower, Default::default());
        self.symbolic
            .factorize_numeric_llt(values, view(matrix), side, regularization, Par::Seq, stack, Spec::default())
            .map_err(|error| format!("faer's factorisation: {error:?}").into())
    }

    fn solve(&self, llt: LltRef<'_, u32, f64>, right: &[f64]) -> Vec<f64> {
        let mut solution = right.to_vec();
        let mut memory = MemBuffer::new(self.symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        let column = MatMut::from_column_major_slice_mut(&mut solution, self.new_of_old.len(), 1);
        llt.solve_in_place_with_conj(Conj::No, column, Par::Seq, MemStack::new(&mut memory));
        solution
    }
}

fn view(matrix: &SymmetricMatrix) -> SparseColMatRef<'_, u32, f64> {
    let (size, pattern) = (matrix.size(), matrix.pattern());
    let symbolic = SymbolicSparseColMatRef::new_checked(size, size, pattern.column_start(), None, pattern.rows());
    SparseColMatRef::new(symbolic, matrix.values())
}

/// `L + M / t` for a time of the mean area of a point.
fn heat(laplacian: &Laplacian) -> SymmetricMatrix {
    let mut values = laplacian.stiffness.values().to_vec();
    let scale = laplacian.size() as f64 / laplacian.mass.iter().sum::<f64>();
    for (point, mass) in laplacian.mass.iter().enumerate() {
        values[laplacian.column(point).start] += scale * mass;
    }
    SymmetricMatrix::new(Arc::clone(laplacian.stiffness.pattern()), values).expect("the values of the pattern")
}

/// `L` with one point of each component constrained, its entries stored as zeros.
fn poisson(laplacian: &Laplacian, surface: &Surface) -> SymmetricMatrix {
    let mut is_met = vec![false; laplacian.size()];
    let meets = |&component: &u32| !std::mem::replace(&mut is_met[component as usize], true);
    let is_constrained: Vec<bool> = surface.components().iter().map(meets).collect();
    let mut values = laplacian.stiffness.values().to_vec();
    for point in 0..laplacian.size() {
        for entry in laplacian.column(point) {
            let row = laplacian.rows()[entry] as usize;
            if is_constrained[point] || is_constrained[row] {
                values[entry] = f64::from(u8::from(row == point));
            }
        }
    }
    SymmetricMatrix::new(Arc::clone(laplacian.stiffness.pattern()), values).expect("the values of the pattern")
}

fn time(work: impl FnOnce() -> bool) -> f64 {
    let start = Instant::now();
    assert!(work(), "what was factored once is factored again");
    start.elapsed().as_secs_f64() * 1e3
}

/// The time of doing it again: else the factor that was made last would still be in the cache, the others not.
fn warm_time(mut work: impl FnMut() -> bool) -> f64 {
    work();
    time(work)
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
