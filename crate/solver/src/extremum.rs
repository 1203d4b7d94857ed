//! Larger and smaller of two numbers, and one of two, in loops that must be fast. On wasm32 those of the standard library are
//! calls for their care of NaN, and a choice between two numbers is a branch unless they are [`Lanes`].

use std::hint::select_unpredictable;

use heatwalk_base::lanes::{Choice, Lanes};

const HAS_LANES: bool = cfg!(all(target_arch = "wasm32", target_feature = "simd128"));

/// The larger number; `b` where one is NaN.
#[inline(always)]
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if HAS_LANES {
        Lanes::both(b).larger(Lanes::both(a)).to_array()[0]
    } else if a > b {
        a
    } else {
        b
    }
}

/// The smaller number; `b` where one is NaN.
#[inline(always)]
pub(crate) fn smaller(a: f64, b: f64) -> f64 {
    if HAS_LANES {
        Lanes::both(b).smaller(Lanes::both(a)).to_array()[0]
    } else if a < b {
        a
    } else {
        b
    }
}

/// The first number where it `is_first`, else the second; which of them is as good as random.
#[inline(always)]
pub(crate) fn either(is_first: bool, first: f64, second: f64) -> f64 {
    if HAS_LANES {
        Choice::both(is_first).choose(Lanes::both(first), Lanes::both(second)).to_array()[0]
    } else {
        select_unpredictable(is_first, first, second)
    }
}
