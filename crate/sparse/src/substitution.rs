//! One supernode's part in solving with a Cholesky factor. Its block is dense and column-major: its own rows, then those
//! below.

use crate::scalar::{Entry, Pair, Scalar};
use crate::simd::array;
use crate::symbolic::Supernode;

/// Columns that are gone through side by side. Most supernodes have no more.
const GROUP: usize = 4;

/// Rows that are gone through side by side.
const ROWS: usize = 4;

/// `x ← C⁻¹ x` as far as the supernode goes. `scratch` may hold anything.
#[inline(always)]
pub(crate) fn forward<T: Scalar, E: Entry<T>, const FUSED: bool>(
    supernode: &Supernode<'_>,
    block: &[E],
    x: &mut [T],
    scratch: &mut Vec<T>,
) {
    let &Supernode { start, width, below, .. } = supernode;
    let offset = start + width;
    let (own, beyond) = x.split_at_mut(offset);
    let own = &mut own[start..];
    let height = width + below.len();
    scratch.clear();
    scratch.extend_from_slice(own);
    scratch.resize(height, T::ZERO);
    let groups = width / GROUP * GROUP;
    for first in (0..groups).step_by(GROUP) {
        forward_group::<T, E, GROUP, FUSED>(&block[first * height..], first, scratch);
    }
    let rest = &block[groups * height..];
    match width - groups {
        1 => forward_group::<T, E, 1, FUSED>(rest, groups, scratch),
        2 => forward_group::<T, E, 2, FUSED>(rest, groups, scratch),
        3 => forward_group::<T, E, 3, FUSED>(rest, groups, scratch),
        _ => {}
    }
    let (values, changes) = scratch.split_at(width);
    own.copy_from_slice(values);
    for (&row, change) in below.iter().zip(changes) {
        beyond[row as usize - offset] += *change;
    }
}

/// [`forward`] for columns `first..first + W`, which `block` begins with, of a supernode whose rows are `x`.
#[inline(always)]
fn forward_group<T: Scalar, E: Entry<T>, const W: usize, const FUSED: bool>(block: &[E], first: usize, x: &mut [T]) {
    let height = x.len();
    let columns: [&[E]; W] = array(|j| &block[j * height + first..(j + 1) * height]);
    let (own, beyond) = x[first..].split_at_mut(W);
    for j in 0..W {
        own[j] = own[j].divide(columns[j][j].number().real());
        for k in j + 1..W {
            own[k] = T::multiply_add::<FUSED>(-columns[j][k].number(), own[j], own[k]);
        }
    }
    let values: [T; W] = array(|j| -own[j]);
    let columns: [(&[[E; ROWS]], &[E]); W] = array(|j| columns[j][W..].as_chunks());
    let (blocks, last) = beyond.as_chunks_mut::<ROWS>();
    let all: [&[[E; ROWS]]; W] = array(|j| &columns[j].0[..blocks.len()]);
    for (i, target) in blocks.iter_mut().enumerate() {
        let mut pairs = pairs_of(target);
        for j in 0..W {
            let (entries, value) = (entry_pairs(&all[j][i]), T::Pair::new([values[j]; 2]));
            for (pair, entries) in pairs.iter_mut().zip(entries) {
                *pair = pair.plus_product::<FUSED>(entries, value);
            }
        }
        *target = array(|row| pairs[row / 2].numbers()[row % 2]);
    }
    for (i, target) in last.iter_mut().enumerate() {
        for j in 0..W {
            *target = T::multiply_add::<FUSED>(columns[j].1[i].number(), values[j], *target);
        }
    }
}

/// `x ← C⁻ᴴ x` as far as the supernode goes. `scratch` may hold anything.
#[inline(always)]
pub(crate) fn backward<T: Scalar, E: Entry<T>, const FUSED: bool>(
    supernode: &Supernode<'_>,
    block: &[E],
    x: &mut [T],
    scratch: &mut Vec<T>,
) {
    let &Supernode { start, width, below, .. } = supernode;
    let offset = start + width;
    let (own, beyond) = x.split_at_mut(offset);
    let own = &mut own[start..];
    let height = width + below.len();
    scratch.clear();
    scratch.extend_from_slice(own);
    scratch.extend(below.iter().map(|&row| beyond[row as usize - offset]));
    let groups = width / GROUP * GROUP;
    let rest = &block[groups * height..];
    match width - groups {
        1 => backward_group::<T, E, 1, FUSED>(rest, groups, scratch),
        2 => backward_group::<T, E, 2, FUSED>(rest, groups, scratch),
        3 => backward_group::<T, E, 3, FUSED>(rest, groups, scratch),
        _ => {}
    }
    for first in (0..groups).step_by(GROUP).rev() {
        backward_group::<T, E, GROUP, FUSED>(&block[first * height..], first, scratch);
    }
    own.copy_from_slice(&scratch[..width]);
}

/// [`backward`] for columns `first..first + W`, which `block` begins with, of a supernode whose rows are `x`.
#[inline(always)]
fn backward_group<T: Scalar, E: Entry<T>, const W: usize, const FUSED: bool>(block: &[E], first: usize, x: &mut [T]) {
    let height = x.len();
    let columns: [&[E]; W] = array(|j| &block[j * height + first..(j + 1) * height]);
    let (own, beyond) = x[first..].split_at_mut(W);
    let below: [(&[[E; ROWS]], &[E]); W] = array(|j| columns[j][W..].as_chunks());
    let (blocks, last) = beyond.as_chunks::<ROWS>();
    let all: [&[[E; ROWS]]; W] = array(|j| &below[j].0[..blocks.len()]);
    let mut sums = [[T::Pair::default(); ROWS / 2]; W];
    for (i, known) in blocks.iter().enumerate() {
        let known = pairs_of(known);
        for j in 0..W {
            let entries = entry_pairs(&all[j][i]);
            for row in 0..ROWS / 2 {
                sums[j][row] = sums[j][row].plus_product::<FUSED>(entries[row].conj(), known[row]);
            }
        }
    }
    let mut products: [T; W] = array(|j| sums[j].iter().flat_map(|sum| sum.numbers()).sum());
    for (i, known) in last.iter().enumerate() {
        for j in 0..W {
            products[j] = T::multiply_add::<FUSED>(below[j].1[i].number().conj(), *known, products[j]);
        }
    }
    for j in (0..W).rev() {
        own[j] = (own[j] - products[j]).divide(columns[j][j].number().real());
        for k in 0..j {
            products[k] = T::multiply_add::<FUSED>(columns[k][j].number().conj(), own[j], products[k]);
        }
    }
}

#[inline(always)]
fn pairs_of<T: Scalar>(numbers: &[T; ROWS]) -> [T::Pair; ROWS / 2] {
    array(|pair| T::Pair::new([numbers[2 * pair], numbers[2 * pair + 1]]))
}

#[inline(always)]
fn entry_pairs<T: Scalar, E: Entry<T>>(entries: &[E; ROWS]) -> [T::Pair; ROWS / 2] {
    array(|pair| E::pair([entries[2 * pair], entries[2 * pair + 1]]))
}

/// [`forward`] for `L` vectors at a time. `change` is scratch.
#[inline(always)]
pub(crate) fn forward_lanes<T: Scalar, E: Entry<T>, const L: usize, const FUSED: bool>(
    supernode: &Supernode<'_>,
    block: &[E],
    x: &mut [[T; L]],
    change: &mut Vec<[T; L]>,
) {
    let &Supernode { start, width, below, .. } = supernode;
    change.clear();
    change.resize(below.len(), [T::ZERO; L]);
    for (j, column) in block.chunks_exact(width + below.len()).enumerate() {
        let (values, others) = x[start + j..start + width].split_first_mut().expect("a column has its diagonal");
        for value in values.iter_mut() {
            *value = value.divide(column[j].number().real());
        }
        let targets = others.iter_mut().chain(change.iter_mut());
        for (target, entry) in targets.zip(&column[j + 1..]) {
            for lane in 0..L {
                target[lane] = T::multiply_add::<FUSED>(-entry.number(), values[lane], target[lane]);
            }
        }
    }
    for (&row, change) in below.iter().zip(change) {
        for (target, change) in x[row as usize].iter_mut().zip(change) {
            *target += *change;
        }
    }
}
