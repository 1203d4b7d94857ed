//! One supernode's part in solving with a Cholesky factor. Its block is dense and column-major: its own rows, then those
//! below.

use crate::linear::cholesky::Supernode;
use crate::linear::vector::{Pair, multiply_add};

/// Columns that are gone through side by side. Most supernodes have no more.
const GROUP: usize = 4;

/// `x ← C⁻¹ x` as far as the supernode goes. `change` is scratch.
#[inline(always)]
pub(crate) fn forward<const FUSED: bool>(
    supernode: &Supernode<'_>,
    block: &[f64],
    x: &mut [f64],
    change: &mut Vec<f64>,
) {
    let &Supernode { start, width, below, .. } = supernode;
    let offset = start + width;
    let (own, beyond) = x.split_at_mut(offset);
    let own = &mut own[start..];
    match width {
        1 => return forward_narrow::<1, FUSED>(block, own, below, beyond, offset),
        2 => return forward_narrow::<2, FUSED>(block, own, below, beyond, offset),
        3 => return forward_narrow::<3, FUSED>(block, own, below, beyond, offset),
        4 => return forward_narrow::<4, FUSED>(block, own, below, beyond, offset),
        _ => {}
    }
    let height = width + below.len();
    for (j, column) in block.chunks_exact(height).enumerate() {
        let value = own[j] / column[j];
        own[j] = value;
        subtract::<FUSED, 1>([&column[j + 1..width]], &[value], &mut own[j + 1..]);
    }
    change.clear();
    change.resize(below.len(), 0.0);
    let groups = block.chunks_exact(GROUP * height);
    let (values, rest) = own.as_chunks::<GROUP>();
    for (column, value) in groups.remainder().chunks_exact(height).zip(rest) {
        subtract::<FUSED, 1>([&column[width..]], &[*value], change);
    }
    for (group, values) in groups.zip(values) {
        let columns = std::array::from_fn(|j| &group[j * height + width..(j + 1) * height]);
        subtract::<FUSED, GROUP>(columns, values, change);
    }
    for (&row, change) in below.iter().zip(change) {
        beyond[row as usize - offset] += *change;
    }
}

/// [`forward`] for a supernode of `W` columns.
#[inline(always)]
fn forward_narrow<const W: usize, const FUSED: bool>(
    block: &[f64],
    own: &mut [f64],
    below: &[u32],
    beyond: &mut [f64],
    offset: usize,
) {
    let height = W + below.len();
    let columns: [&[f64]; W] = std::array::from_fn(|j| &block[j * height..(j + 1) * height]);
    let mut values = [0.0; W];
    for j in 0..W {
        let known: f64 = (0..j).map(|k| columns[k][j] * values[k]).sum();
        values[j] = (own[j] - known) / columns[j][j];
    }
    own.copy_from_slice(&values);
    let columns = columns.map(|column| &column[W..]);
    for (i, &row) in below.iter().enumerate() {
        let mut sum = columns[0][i] * values[0];
        for j in 1..W {
            sum = multiply_add::<FUSED>(columns[j][i], values[j], sum);
        }
        beyond[row as usize - offset] -= sum;
    }
}

/// `x ← C⁻ᵀ x` as far as the supernode goes. `known` is scratch.
#[inline(always)]
pub(crate) fn backward<const FUSED: bool>(
    supernode: &Supernode<'_>,
    block: &[f64],
    x: &mut [f64],
    known: &mut Vec<f64>,
) {
    let &Supernode { start, width, below, .. } = supernode;
    let offset = start + width;
    let (own, beyond) = x.split_at_mut(offset);
    let own = &mut own[start..];
    match width {
        1 => return backward_narrow::<1, FUSED>(block, own, below, beyond, offset),
        2 => return backward_narrow::<2, FUSED>(block, own, below, beyond, offset),
        3 => return backward_narrow::<3, FUSED>(block, own, below, beyond, offset),
        4 => return backward_narrow::<4, FUSED>(block, own, below, beyond, offset),
        _ => {}
    }
    known.clear();
    known.extend(below.iter().map(|&row| beyond[row as usize - offset]));
    for (j, column) in block.chunks_exact(width + below.len()).enumerate().rev() {
        let (within, beneath) = column.split_at(width);
        let sum = product::<FUSED>(&within[j + 1..], &own[j + 1..]) + product::<FUSED>(beneath, known);
        own[j] = (own[j] - sum) / within[j];
    }
}

/// [`backward`] for a supernode of `W` columns.
#[inline(always)]
fn backward_narrow<const W: usize, const FUSED: bool>(
    block: &[f64],
    own: &mut [f64],
    below: &[u32],
    beyond: &[f64],
    offset: usize,
) {
    let height = W + below.len();
    let columns: [&[f64]; W] = std::array::from_fn(|j| &block[j * height..(j + 1) * height]);
    let beneath = columns.map(|column| &column[W..]);
    let mut sums = [0.0; W];
    for (i, &row) in below.iter().enumerate() {
        let known = beyond[row as usize - offset];
        for j in 0..W {
            sums[j] = multiply_add::<FUSED>(beneath[j][i], known, sums[j]);
        }
    }
    for j in (0..W).rev() {
        let within: f64 = (j + 1..W).map(|k| columns[j][k] * own[k]).sum();
        own[j] = (own[j] - sums[j] - within) / columns[j][j];
    }
}

/// [`forward`] for `L` vectors at a time. `change` is scratch.
#[inline(always)]
pub(crate) fn forward_lanes<const L: usize, const FUSED: bool>(
    supernode: &Supernode<'_>,
    block: &[f64],
    x: &mut [[f64; L]],
    change: &mut Vec<[f64; L]>,
) {
    let &Supernode { start, width, below, .. } = supernode;
    change.clear();
    change.resize(below.len(), [0.0; L]);
    for (j, column) in block.chunks_exact(width + below.len()).enumerate() {
        let (values, others) = x[start + j..start + width].split_first_mut().expect("a column has its diagonal");
        for value in values.iter_mut() {
            *value /= column[j];
        }
        let targets = others.iter_mut().chain(change.iter_mut());
        for (target, entry) in targets.zip(&column[j + 1..]) {
            for lane in 0..L {
                target[lane] = multiply_add::<FUSED>(-entry, values[lane], target[lane]);
            }
        }
    }
    for (&row, change) in below.iter().zip(change) {
        for (target, change) in x[row as usize].iter_mut().zip(change) {
            *target += *change;
        }
    }
}

/// Takes multiples of `W` columns out of a vector.
#[inline(always)]
fn subtract<const FUSED: bool, const W: usize>(columns: [&[f64]; W], values: &[f64; W], target: &mut [f64]) {
    for (i, target) in target.iter_mut().enumerate() {
        for j in 0..W {
            *target = multiply_add::<FUSED>(-columns[j][i], values[j], *target);
        }
    }
}

/// Inner product in eight running sums, which lie in vector registers.
#[inline(always)]
fn product<const FUSED: bool>(a: &[f64], b: &[f64]) -> f64 {
    let ((a_blocks, a_rest), (b_blocks, b_rest)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
    let mut sums = [Pair::new([0.0; 2]); 4];
    for (a, b) in a_blocks.iter().zip(b_blocks) {
        for (i, sum) in sums.iter_mut().enumerate() {
            let [a, b] = [a, b].map(|block| Pair::new([block[2 * i], block[2 * i + 1]]));
            *sum = sum.plus_product::<FUSED>(a, b);
        }
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    sums.iter().flat_map(|sum| sum.numbers()).sum::<f64>() + rest
}
