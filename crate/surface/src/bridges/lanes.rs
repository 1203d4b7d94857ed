//! Two numbers that are computed with at once.
//!
//! Browsers branch where one of two numbers is taken on wasm32, and a branch that goes either way takes longer than the arithmetic
//! around it. Vectors have an instruction for it, which the compiler does not choose by itself there; elsewhere it does.

use std::ops::{Add, Mul, Sub};

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod vector {
    use std::arch::wasm32::f64x2_extract_lane;
    pub use std::arch::wasm32::{
        f64x2 as of, f64x2_add as sum, f64x2_mul as product, f64x2_pmax as larger, f64x2_sub as difference,
        v128 as Vector,
    };

    #[inline]
    pub fn numbers(vector: Vector) -> [f64; 2] {
        [f64x2_extract_lane::<0>(vector), f64x2_extract_lane::<1>(vector)]
    }
}

#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
mod vector {
    #[derive(Clone, Copy)]
    #[repr(align(16))]
    pub struct Vector([f64; 2]);

    #[inline]
    pub fn of(first: f64, second: f64) -> Vector {
        Vector([first, second])
    }

    #[inline]
    pub fn numbers(vector: Vector) -> [f64; 2] {
        vector.0
    }

    #[inline]
    pub fn sum(Vector(a): Vector, Vector(b): Vector) -> Vector {
        of(a[0] + b[0], a[1] + b[1])
    }

    #[inline]
    pub fn difference(Vector(a): Vector, Vector(b): Vector) -> Vector {
        of(a[0] - b[0], a[1] - b[1])
    }

    #[inline]
    pub fn product(Vector(a): Vector, Vector(b): Vector) -> Vector {
        of(a[0] * b[0], a[1] * b[1])
    }

    #[inline]
    pub fn larger(Vector(a): Vector, Vector(b): Vector) -> Vector {
        let larger = |a: f64, b: f64| if a < b { b } else { a };
        of(larger(a[0], b[0]), larger(a[1], b[1]))
    }
}

/// Two numbers.
#[derive(Clone, Copy)]
pub struct Lanes(vector::Vector);

impl Lanes {
    #[inline]
    pub fn new([first, second]: [f64; 2]) -> Self {
        Self(vector::of(first, second))
    }

    /// The same number twice.
    #[inline]
    pub fn both(number: f64) -> Self {
        Self::new([number; 2])
    }

    #[inline]
    pub fn to_array(self) -> [f64; 2] {
        vector::numbers(self.0)
    }

    /// The larger one of two each.
    #[inline]
    pub fn larger(self, other: Self) -> Self {
        Self(vector::larger(self.0, other.0))
    }
}

impl Add for Lanes {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self(vector::sum(self.0, other.0))
    }
}

impl Sub for Lanes {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self(vector::difference(self.0, other.0))
    }
}

impl Mul for Lanes {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self(vector::product(self.0, other.0))
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    #[test]
    fn each_lane_is_computed_by_itself() {
        let (a, b) = (Lanes::new([5.0, -2.0]), Lanes::new([3.0, 7.0]));
        assert_eq!((a + b).to_array(), [8.0, 5.0]);
        assert_eq!((a - b).to_array(), [2.0, -9.0]);
        assert_eq!((a * b).to_array(), [15.0, -14.0]);
        assert_eq!(a.larger(b).to_array(), [5.0, 7.0]);
    }
}
