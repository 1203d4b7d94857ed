//! Two numbers that are computed with at once.
//!
//! Browsers branch where one of two numbers is taken on wasm32, and a branch that goes either way takes longer than the arithmetic
//! around it. Vectors have instructions for it, which the compiler does not choose by itself there; elsewhere it does.

use std::ops::{Add, BitAnd, Div, Mul, Sub};

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod vector {
    pub use std::arch::wasm32::{
        f64x2 as of, f64x2_abs as absolute, f64x2_add as sum, f64x2_div as quotient, f64x2_lt as less,
        f64x2_mul as product, f64x2_pmax as larger, f64x2_pmin as smaller, f64x2_splat as both, f64x2_sqrt as root,
        f64x2_sub as difference, v128 as Vector, v128 as Choice, v128_and as both_hold, v128_bitselect as choose,
    };
    use std::arch::wasm32::{f64x2_extract_lane, i64x2_bitmask, i64x2_splat};

    #[inline]
    pub fn numbers(vector: Vector) -> [f64; 2] {
        [f64x2_extract_lane::<0>(vector), f64x2_extract_lane::<1>(vector)]
    }

    #[inline]
    pub fn twice(holds: bool) -> Choice {
        i64x2_splat(-i64::from(holds))
    }

    #[inline]
    pub fn each(choice: Choice) -> [bool; 2] {
        let bits = i64x2_bitmask(choice);
        [bits & 1 != 0, bits & 2 != 0]
    }
}

#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
mod vector {
    use std::hint::select_unpredictable;

    #[derive(Debug, Clone, Copy)]
    #[repr(align(16))]
    pub struct Vector([f64; 2]);

    pub type Choice = [bool; 2];

    #[inline]
    pub fn of(first: f64, second: f64) -> Vector {
        Vector([first, second])
    }

    #[inline]
    pub fn both(number: f64) -> Vector {
        Vector([number; 2])
    }

    #[inline]
    pub fn numbers(vector: Vector) -> [f64; 2] {
        vector.0
    }

    #[inline]
    pub fn twice(holds: bool) -> Choice {
        [holds; 2]
    }

    #[inline]
    pub fn each(choice: Choice) -> [bool; 2] {
        choice
    }

    #[inline]
    fn with(Vector(a): Vector, Vector(b): Vector, what: impl Fn(f64, f64) -> f64) -> Vector {
        of(what(a[0], b[0]), what(a[1], b[1]))
    }

    #[inline]
    pub fn sum(a: Vector, b: Vector) -> Vector {
        with(a, b, |a, b| a + b)
    }

    #[inline]
    pub fn difference(a: Vector, b: Vector) -> Vector {
        with(a, b, |a, b| a - b)
    }

    #[inline]
    pub fn product(a: Vector, b: Vector) -> Vector {
        with(a, b, |a, b| a * b)
    }

    #[inline]
    pub fn quotient(a: Vector, b: Vector) -> Vector {
        with(a, b, |a, b| a / b)
    }

    #[inline]
    pub fn larger(a: Vector, b: Vector) -> Vector {
        with(a, b, |a, b| if a < b { b } else { a })
    }

    #[inline]
    pub fn smaller(a: Vector, b: Vector) -> Vector {
        with(a, b, |a, b| if b < a { b } else { a })
    }

    #[inline]
    pub fn absolute(Vector(a): Vector) -> Vector {
        Vector(a.map(f64::abs))
    }

    #[inline]
    pub fn root(Vector(a): Vector) -> Vector {
        Vector(a.map(f64::sqrt))
    }

    #[inline]
    pub fn less(Vector(a): Vector, Vector(b): Vector) -> Choice {
        [a[0] < b[0], a[1] < b[1]]
    }

    #[inline]
    pub fn both_hold(a: Choice, b: Choice) -> Choice {
        [a[0] & b[0], a[1] & b[1]]
    }

    #[inline]
    pub fn choose(Vector(a): Vector, Vector(b): Vector, choice: Choice) -> Vector {
        of(select_unpredictable(choice[0], a[0], b[0]), select_unpredictable(choice[1], a[1], b[1]))
    }
}

/// Two numbers.
#[derive(Debug, Clone, Copy)]
pub struct Lanes(vector::Vector);

impl Lanes {
    /// These two.
    #[inline]
    pub fn new([first, second]: [f64; 2]) -> Self {
        Self(vector::of(first, second))
    }

    /// The same number twice.
    #[inline]
    pub fn both(number: f64) -> Self {
        Self(vector::both(number))
    }

    /// The two.
    #[inline]
    pub fn to_array(self) -> [f64; 2] {
        vector::numbers(self.0)
    }

    /// The larger one of two each; of `self` where one is NaN.
    #[inline]
    pub fn larger(self, other: Self) -> Self {
        Self(vector::larger(self.0, other.0))
    }

    /// The smaller one of two each; of `self` where one is NaN.
    #[inline]
    pub fn smaller(self, other: Self) -> Self {
        Self(vector::smaller(self.0, other.0))
    }

    /// Without their signs.
    #[inline]
    pub fn abs(self) -> Self {
        Self(vector::absolute(self.0))
    }

    /// Their square roots.
    #[inline]
    pub fn sqrt(self) -> Self {
        Self(vector::root(self.0))
    }

    /// Which of them are less than the other ones.
    #[inline]
    pub fn is_below(self, other: Self) -> Choice {
        Choice(vector::less(self.0, other.0))
    }
}

/// An operator between the numbers of both, by a function of `vector`.
macro_rules! operator {
    ($operator:ident, $method:ident, $function:ident) => {
        impl $operator for Lanes {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                Self(vector::$function(self.0, other.0))
            }
        }
    };
}

operator!(Add, add, sum);
operator!(Sub, sub, difference);
operator!(Mul, mul, product);
operator!(Div, div, quotient);

/// Of two things each, which hold.
#[derive(Debug, Clone, Copy)]
pub struct Choice(vector::Choice);

impl Choice {
    /// The same for both.
    #[inline]
    pub fn both(holds: bool) -> Self {
        Self(vector::twice(holds))
    }

    /// Each number of `then` where it holds, else that of `otherwise`; without a branch.
    #[inline]
    pub fn choose(self, then: Lanes, otherwise: Lanes) -> Lanes {
        Lanes(vector::choose(then.0, otherwise.0, self.0))
    }

    /// The two.
    #[inline]
    pub fn to_array(self) -> [bool; 2] {
        vector::each(self.0)
    }
}

impl BitAnd for Choice {
    type Output = Self;

    #[inline]
    fn bitand(self, other: Self) -> Self {
        Self(vector::both_hold(self.0, other.0))
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    #[test]
    fn each_lane_is_computed_by_itself() {
        let (a, b) = (Lanes::new([5.0, -2.0]), Lanes::new([4.0, 8.0]));
        assert_eq!((a + b).to_array(), [9.0, 6.0]);
        assert_eq!((a - b).to_array(), [1.0, -10.0]);
        assert_eq!((a * b).to_array(), [20.0, -16.0]);
        assert_eq!((a / b).to_array(), [1.25, -0.25]);
        assert_eq!(a.larger(b).to_array(), [5.0, 8.0]);
        assert_eq!(a.smaller(b).to_array(), [4.0, -2.0]);
        assert_eq!(a.abs().to_array(), [5.0, 2.0]);
        assert_eq!((b + Lanes::new([0.0, 1.0])).sqrt().to_array(), [2.0, 3.0]);
    }

    #[test]
    fn each_lane_is_chosen_by_itself() {
        let (a, b) = (Lanes::new([5.0, -2.0]), Lanes::new([4.0, 8.0]));
        let is_below = a.is_below(b);
        assert_eq!(is_below.to_array(), [false, true]);
        assert_eq!(is_below.choose(a, b).to_array(), [4.0, -2.0]);
        assert_eq!(Choice::both(true).choose(a, b).to_array(), [5.0, -2.0]);
        assert_eq!((is_below & b.is_below(Lanes::both(6.0))).to_array(), [false, false]);
    }

    #[test]
    fn what_is_not_a_number_is_passed_over() {
        let (a, b) = (Lanes::both(1.0), Lanes::both(f64::NAN));
        assert_eq!(a.larger(b).to_array(), [1.0; 2]);
        assert_eq!(a.smaller(b).to_array(), [1.0; 2]);
        assert_eq!(a.is_below(b).to_array(), [false; 2]);
    }
}
