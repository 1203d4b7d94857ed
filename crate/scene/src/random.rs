//! Numbers that look random and are the same on every machine: SplitMix64 (Steele, Lea, Flood 2014).

/// The next number of the sequence.
pub(crate) fn random(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}

/// The next number as a share, 0 to below 1.
pub(crate) fn random_share(state: &mut u64) -> f64 {
    // As many bits as a share has: 53.
    (random(state) >> 11) as f64 / (1_u64 << 53) as f64
}
