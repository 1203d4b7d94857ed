//! Real numbers as scalars.

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use core::arch::wasm32::{f64x2_add, f64x2_mul, f64x2_promote_low_f32x4, v128};

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
use crate::scalar::Pair;
use crate::scalar::{Entry, Scalar};

impl Scalar for f64 {
    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    type Pair = Register;
    #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
    type Pair = [f64; 2];
    type Bits = u64;
    type Turn = ();

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
    fn from_real(number: f64) -> Self {
        number
    }

    #[inline(always)]
    fn bits(self) -> u64 {
        self.to_bits()
    }

    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.abs()
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

    #[inline(always)]
    fn coupling(self) -> f64 {
        -self
    }

    #[inline(always)]
    fn turn(self) {}
}

/// Rounded to single precision.
impl Entry<f64> for f32 {
    #[inline(always)]
    fn number(self) -> f64 {
        f64::from(self)
    }

    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    #[inline(always)]
    fn pair([first, second]: [Self; 2]) -> Register {
        Register(f64x2_promote_low_f32x4(bytemuck::cast([first, second, 0.0, 0.0])))
    }

    #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
    #[inline(always)]
    fn pair(entries: [Self; 2]) -> [f64; 2] {
        entries.map(f64::from)
    }
}

/// Two numbers in one vector register. On wasm32 the compiler does not find pairs by itself as it does elsewhere.
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
#[derive(Debug, Clone, Copy)]
pub struct Register(v128);

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
impl Default for Register {
    #[inline(always)]
    fn default() -> Self {
        Self::new([0.0; 2])
    }
}

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
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
