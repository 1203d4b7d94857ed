//! Larger and smaller of two numbers in loops that must be fast on wasm32, where those of the standard library are
//! calls for their care of NaN.

/// The larger number; `b` where one is NaN.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// The smaller number; `b` where one is NaN.
#[inline(always)]
pub(crate) fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
