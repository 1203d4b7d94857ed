//! The numbers of a matrix.

use std::fmt::Debug;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use crate::simd::array;

/// A number of a Hermitian matrix; [`f64`], whose matrices are symmetric, is one. A type of one's own is factored too:
/// it says `type Pair = [Self; 2]` and leaves vector instructions to the compiler. Its functions are to be
/// `#[inline(always)]`.
pub trait Scalar:
    Copy
    + Default
    + Debug
    + PartialEq
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + Sum
{
    /// Two numbers in a vector register.
    type Pair: Pair<Self>;

    /// What adding leaves unchanged.
    const ZERO: Self;

    /// The complex conjugate.
    fn conj(self) -> Self;

    /// The real part.
    fn real(self) -> f64;

    /// The square of the absolute value.
    fn abs2(self) -> f64;

    /// The product with a real number.
    fn scale(self, factor: f64) -> Self;

    /// The quotient by a real number.
    fn divide(self, divisor: f64) -> Self;

    /// `a · b + c`. `FUSED` tells whether the machine has one instruction for both; where it has not, calling for it would
    /// be many times slower.
    fn multiply_add<const FUSED: bool>(a: Self, b: Self, c: Self) -> Self;
}

/// Two numbers that are worked on side by side.
pub trait Pair<T>: Copy + Default {
    /// The pair of two numbers.
    fn new(numbers: [T; 2]) -> Self;

    /// The two numbers.
    fn numbers(self) -> [T; 2];

    /// The complex conjugates.
    fn conj(self) -> Self;

    /// `self + a · b`, number by number.
    fn plus_product<const FUSED: bool>(self, a: Self, b: Self) -> Self;
}

impl<T: Scalar> Pair<T> for [T; 2] {
    #[inline(always)]
    fn new(numbers: [T; 2]) -> Self {
        numbers
    }

    #[inline(always)]
    fn numbers(self) -> [T; 2] {
        self
    }

    #[inline(always)]
    fn conj(self) -> Self {
        array(|i| self[i].conj())
    }

    #[inline(always)]
    fn plus_product<const FUSED: bool>(self, a: Self, b: Self) -> Self {
        array(|i| T::multiply_add::<FUSED>(a[i], b[i], self[i]))
    }
}

impl Scalar for f64 {
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    type Pair = wasm::Register;
    #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
    type Pair = [f64; 2];

    const ZERO: Self = 0.0;

    #[inline(always)]
    fn conj(self) -> Self {
        self
    }

    #[inline(always)]
    fn real(self) -> f64 {
        self
    }

    #[inline(always)]
    fn abs2(self) -> f64 {
        self * self
    }

    #[inline(always)]
    fn scale(self, factor: f64) -> Self {
        self * factor
    }

    #[inline(always)]
    fn divide(self, divisor: f64) -> Self {
        self / divisor
    }

    #[inline(always)]
    fn multiply_add<const FUSED: bool>(a: Self, b: Self, c: Self) -> Self {
        if FUSED { a.mul_add(b, c) } else { a * b + c }
    }
}

/// On wasm32 the compiler does not find pairs by itself as it does elsewhere.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod wasm {
    use core::arch::wasm32::{f64x2_add, f64x2_mul, v128};

    use super::Pair;

    /// Two numbers in one vector register.
    #[derive(Debug, Clone, Copy)]
    pub struct Register(v128);

    impl Default for Register {
        #[inline(always)]
        fn default() -> Self {
            Self::new([0.0; 2])
        }
    }

    impl Pair<f64> for Register {
        #[inline(always)]
        fn new(numbers: [f64; 2]) -> Self {
            Self(bytemuck::cast(numbers))
        }

        #[inline(always)]
        fn numbers(self) -> [f64; 2] {
            bytemuck::cast(self.0)
        }

        #[inline(always)]
        fn conj(self) -> Self {
            self
        }

        #[inline(always)]
        fn plus_product<const FUSED: bool>(self, a: Self, b: Self) -> Self {
            Self(f64x2_add(self.0, f64x2_mul(a.0, b.0)))
        }
    }
}
