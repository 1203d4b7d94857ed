//! Solves with a Cholesky factor: whole vectors, and right sides that are zero almost everywhere.

use std::sync::Arc;

use crate::linear::cholesky::{Supernode, Symbolic};
use crate::linear::columns::Column;

/// The Cholesky factor `C` of one matrix `A = C Cᵀ`.
#[derive(Debug)]
pub(crate) struct Factor {
    symbolic: Arc<Symbolic>,
    /// Supernodes one after another, each a dense column-major block of its own rows, then the rows below.
    values: Vec<f64>,
}

impl Factor {
    pub(crate) fn new(symbolic: Arc<Symbolic>, values: Vec<f64>) -> Self {
        Self { symbolic, values }
    }

    /// Number of stored entries, zeros inside supernodes counted.
    pub(crate) fn nonzeros(&self) -> usize {
        self.values.len()
    }

    /// `C⁻¹ right`, in the elimination order. Written for one vector: faer's own solve is made for many, and takes
    /// twice as long for one.
    pub(crate) fn forward(&self, right: &[f64]) -> Vec<f64> {
        let old_of_new = &self.symbolic.permutation.old_of_new;
        let mut x: Vec<f64> = old_of_new.iter().map(|&old| right[old as usize]).collect();
        let mut change = Vec::new();
        for index in 0..self.symbolic.supernode_count() {
            self.eliminate(&self.symbolic.supernode(index), &mut x, &mut change);
        }
        x
    }

    /// `C⁻ᵀ x` for a vector in the elimination order; the result is in the order of the matrix.
    pub(crate) fn backward(&self, mut x: Vec<f64>) -> Vec<f64> {
        let mut known = Vec::new();
        for index in (0..self.symbolic.supernode_count()).rev() {
            let Supernode { start, width, below, values } = self.symbolic.supernode(index);
            known.clear();
            known.extend(below.iter().map(|&row| x[row as usize]));
            let own = &mut x[start..start + width];
            for (j, column) in self.values[values].chunks_exact(width + below.len()).enumerate().rev() {
                let sum = dot(&column[j + 1..width], &own[j + 1..]) + dot(&column[width..], &known);
                own[j] = (own[j] - sum) / column[j];
            }
        }
        let mut result = vec![0.0; x.len()];
        for (&old, value) in self.symbolic.permutation.old_of_new.iter().zip(x) {
            result[old as usize] = value;
        }
        result
    }

    /// `C⁻¹ right` for right sides that are zero but at a few rows, given as `(row, value)`. Only the ancestors of
    /// these rows in the elimination tree are touched.
    pub(crate) fn sparse_forward<'a>(&self, rights: impl Iterator<Item = &'a [(u32, f64)]>) -> Vec<Column> {
        let mut x = vec![0.0; self.symbolic.size()];
        let mut change = Vec::new();
        let columns = rights.map(|right| {
            let unknown = |row: u32| self.symbolic.permutation.new_of_old[row as usize] as usize;
            let supernodes = self.symbolic.reach(right.iter().map(|&(row, _)| unknown(row)));
            for &(row, value) in right {
                x[unknown(row)] += value;
            }
            let mut column = Column::default();
            for &index in &supernodes {
                let supernode = self.symbolic.supernode(index as usize);
                self.eliminate(&supernode, &mut x, &mut change);
                let own = &mut x[supernode.start..supernode.start + supernode.width];
                column.push(supernode.start, own);
                own.fill(0.0);
            }
            column
        });
        columns.collect()
    }

    /// One step of the forward solve. `change` is scratch.
    fn eliminate(&self, supernode: &Supernode<'_>, x: &mut [f64], change: &mut Vec<f64>) {
        let &Supernode { start, width, below, ref values } = supernode;
        change.clear();
        change.resize(below.len(), 0.0);
        let own = &mut x[start..start + width];
        for (j, column) in self.values[values.clone()].chunks_exact(width + below.len()).enumerate() {
            let value = own[j] / column[j];
            own[j] = value;
            subtract_multiple(&mut own[j + 1..], &column[j + 1..width], value);
            subtract_multiple(change, &column[width..], value);
        }
        for (&row, change) in below.iter().zip(change) {
            x[row as usize] += *change;
        }
    }
}

fn subtract_multiple(target: &mut [f64], column: &[f64], factor: f64) {
    for (target, value) in target.iter_mut().zip(column) {
        *target -= value * factor;
    }
}

/// Dot product in four running sums, which the compiler may keep in vector registers.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
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
