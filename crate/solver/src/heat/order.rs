//! The order in which distance along a field goes from vertex to vertex.

use std::vec::IntoIter;

use crate::extremum::{larger, smaller};

/// Vertices by falling heat.
#[derive(Debug)]
pub struct WarmestFirst(IntoIter<u64>);

impl WarmestFirst {
    /// Of some vertices; `heat` (`#V`) or its logarithm is that of all.
    pub fn new(heat: &[f64], vertices: impl Iterator<Item = u32>) -> Self {
        let mut order = Vec::with_capacity(heat.len());
        order.extend(vertices.map(key(heat)));
        sort_by_upper_half(&mut order);
        Self(order.into_iter())
    }
}

impl Iterator for WarmestFirst {
    type Item = u32;

    #[inline]
    fn next(&mut self) -> Option<u32> {
        self.0.next().map(|key| key as u32)
    }
}

/// What orders vertices by falling heat (`#V`), to so many levels as 32 bits tell, and has the vertex in its lower half.
fn key(heat: &[f64]) -> impl Fn(u32) -> u64 {
    let warmest = heat.iter().copied().fold(f64::NEG_INFINITY, larger);
    let coldest = heat.iter().copied().fold(f64::INFINITY, smaller);
    let levels = f64::from(u32::MAX) / larger(warmest - coldest, f64::MIN_POSITIVE);
    move |vertex| {
        let level = (levels * (warmest - heat[vertex as usize])) as u32;
        u64::from(level) << 32 | u64::from(vertex)
    }
}

const DIGIT_BITS: usize = 11;

/// Sorts by the upper half alone, least digits first, so that what is equal there stays as it was.
fn sort_by_upper_half(keys: &mut Vec<u64>) {
    let mut sorted = vec![0; keys.len()];
    for shift in (u32::BITS..u64::BITS).step_by(DIGIT_BITS) {
        let digit = |key: u64| (key >> shift) as usize & ((1 << DIGIT_BITS) - 1);
        let mut places = [0_u32; 1 << DIGIT_BITS];
        keys.iter().for_each(|&key| places[digit(key)] += 1);
        let mut before = 0;
        for place in &mut places {
            before += std::mem::replace(place, before);
        }
        for &key in &*keys {
            let place = &mut places[digit(key)];
            sorted[*place as usize] = key;
            *place += 1;
        }
        std::mem::swap(keys, &mut sorted);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_sorted_by_their_upper_half_and_keep_their_order_where_it_is_equal() {
        let scattered = |index: u64| index.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mut keys: Vec<u64> = (0..1000).map(|index| scattered(index % 700) >> 32 << 32 | (1000 - index)).collect();
        let mut expected = keys.clone();
        expected.sort_by_key(|key| key >> 32);
        sort_by_upper_half(&mut keys);
        assert_eq!(keys, expected);
    }
}
