//! Numbers of any size are brought near 1 by powers of two, which round nothing: of what is scaled so, answers are the same at any size,
//! bit by bit.

/// Stored bits of a float's mantissa, below those of its exponent.
const MANTISSA_BITS: u32 = f64::MANTISSA_DIGITS - 1;

/// The sum of the stored exponents of a power of two and its inverse.
const TWICE_BIAS: u64 = 2 * (f64::MAX_EXP as u64 - 1);

/// A power of two that takes numbers whose absolute values are at most `largest`, finite and not negative, to at most 2, and a normal
/// `largest` to at least 1. It takes no division, and what it multiplies is not rounded.
#[inline]
pub fn scale(largest: f64) -> f64 {
    let exponent = largest.to_bits() >> MANTISSA_BITS;
    f64::from_bits(TWICE_BIAS.saturating_sub(exponent) << MANTISSA_BITS)
}
