//! Input vertices of equal position, by sorting their hashes.

use std::num::NonZeroUsize;

use glam::DVec3;
use heatwalk_base::csr::NONE;
use heatwalk_base::parallel::{self, Numbers};
use heatwalk_base::sort::Sorted;

/// Welded vertex of each used input vertex ([`NONE`] elsewhere) and position of each welded one, in order of the first input
/// vertex there.
pub fn merge(vertices: &[DVec3], is_used: &[bool], threads: NonZeroUsize) -> (Vec<u32>, Vec<DVec3>) {
    // Adding 0 turns −0 into +0: one position, one bit pattern.
    let position = |vertex: u32| vertices[vertex as usize] + 0.0;
    let hashes = parallel::collect(vertices.len(), threads, |vertex| hash(position(vertex as u32)));
    let first_there = Numbers::identity(vertices.len());
    Sorted::new(&hashes, u32::BITS, threads).for_each_key(threads, |same| {
        let mut same = same.filter(|&vertex| is_used[vertex as usize]);
        let Some(first) = same.next() else { return };
        // Few have the hash of another position.
        let mut others: Vec<u32> = Vec::new();
        for vertex in same {
            let is_there = |&other: &u32| position(other) == position(vertex);
            match Some(first).filter(is_there).or_else(|| others.iter().copied().find(is_there)) {
                Some(first) => first_there.set(vertex, first),
                None => others.push(vertex),
            }
        }
    });
    let mut vertex_of_input: Vec<u32> = Vec::with_capacity(vertices.len());
    let mut inputs: Vec<u32> = Vec::with_capacity(vertices.len());
    for (vertex, &is_used) in (0..).zip(is_used) {
        let first = first_there.get(vertex);
        vertex_of_input.push(match is_used {
            false => NONE,
            true if first == vertex => inputs.len() as u32,
            true => vertex_of_input[first as usize],
        });
        if is_used && first == vertex {
            inputs.push(vertex);
        }
    }
    let positions = parallel::collect(inputs.len(), threads, |vertex| position(inputs[vertex]));
    (vertex_of_input, positions)
}

/// 32 bits of a position's.
fn hash(position: DVec3) -> u32 {
    let hash = position.to_array().iter().fold(0_u64, |hash, coordinate| {
        // The odd constant of Fibonacci hashing, 2⁶⁴ / golden ratio, spreads low bits to the top.
        (hash.rotate_left(23) ^ coordinate.to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15)
    });
    (hash >> 32) as u32
}
