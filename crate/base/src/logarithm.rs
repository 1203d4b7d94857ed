//! The natural logarithm of many numbers: without branches or calls, so that compilers compute it of several numbers at once, and of
//! sums and products alone, so that it has the same bits on every machine.

use std::f64::consts::{FRAC_1_SQRT_2, LN_2};

const MANTISSA_BITS: u32 = f64::MANTISSA_DIGITS - 1;
const MANTISSA: u64 = (1 << MANTISSA_BITS) - 1;

/// Whole numbers below 2⁵² added to its bits are added to the number.
const UNIT_IN_LAST_PLACE: f64 = (1_u64 << MANTISSA_BITS) as f64;

/// 1/3, 1/5, ... of the series of the inverse hyperbolic tangent, with as many terms as leave less than a unit in the last place of
/// 1 where its argument is (√2 − 1) / (√2 + 1) at most.
const SERIES: [f64; 9] =
    [1.0 / 3.0, 1.0 / 5.0, 1.0 / 7.0, 1.0 / 9.0, 1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0, 1.0 / 17.0, 1.0 / 19.0];

/// Of a positive number from [`f64::MIN_POSITIVE`] to [`f64::MAX`], with an error of 3 units in the last place of 1 or of the result,
/// whichever is larger. What other numbers give means nothing.
#[inline(always)]
pub fn ln(number: f64) -> f64 {
    // A power of two times a mantissa between √½ and √2.
    let least = FRAC_1_SQRT_2.to_bits();
    let above = number.to_bits().wrapping_sub(least).wrapping_add(1.0_f64.to_bits());
    let mantissa = f64::from_bits((above & MANTISSA) + least);
    let exponent = f64::from_bits((above >> MANTISSA_BITS) + UNIT_IN_LAST_PLACE.to_bits());
    let exponent = exponent - (UNIT_IN_LAST_PLACE + f64::from(f64::MAX_EXP - 1));
    // ln m = 2 artanh((m − 1) / (m + 1)).
    let ratio = (mantissa - 1.0) / (mantissa + 1.0);
    let square = ratio * ratio;
    let rest = SERIES.iter().rev().fold(0.0, |sum, term| (sum + term) * square);
    exponent * LN_2 + 2.0 * (ratio + ratio * rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_are_right_from_the_least_to_the_largest_number() {
        let mut number = f64::MIN_POSITIVE;
        while number < f64::MAX / 1.001 {
            let (found, expected) = (ln(number), number.ln());
            let bound = 3.0 * f64::EPSILON * expected.abs().max(1.0);
            assert!((found - expected).abs() <= bound, "{found} for {expected}, that of {number}");
            number *= 1.0003;
        }
        assert_eq!([1.0, 2.0, f64::MAX].map(ln), [0.0, LN_2, f64::MAX.ln()]);
    }
}
