//! Complex numbers as scalars.

use faer::c64;

use crate::scalar::{Scalar, Turn};

impl Scalar for c64 {
    type Pair = [Self; 2];
    type Bits = [u64; 2];
    type Turn = Self;

    const ZERO: Self = Self::new(0.0, 0.0);

    #[inline(always)]
    fn conj(self) -> Self {
        Self::new(self.re, -self.im)
    }

    #[inline(always)]
    fn real(self) -> f64 {
        self.re
    }

    #[inline(always)]
    fn from_real(number: f64) -> Self {
        Self::new(number, 0.0)
    }

    #[inline(always)]
    fn bits(self) -> [u64; 2] {
        [self.re.to_bits(), self.im.to_bits()]
    }

    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.re.hypot(self.im)
    }

    #[inline(always)]
    fn abs2(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    #[inline(always)]
    fn scale(self, factor: f64) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }

    #[inline(always)]
    fn divide(self, divisor: f64) -> Self {
        Self::new(self.re / divisor, self.im / divisor)
    }

    #[inline(always)]
    fn multiply_add<const FUSED: bool>(a: Self, b: Self, c: Self) -> Self {
        let sum = |a, b, c| f64::multiply_add::<FUSED>(a, b, c);
        Self::new(sum(-a.im, b.im, sum(a.re, b.re, c.re)), sum(a.im, b.re, sum(a.re, b.im, c.im)))
    }

    #[inline(always)]
    fn coupling(self) -> f64 {
        self.magnitude()
    }

    #[inline(always)]
    fn turn(self) -> Self {
        -self.divide(self.magnitude())
    }
}

impl Turn<Self> for c64 {
    const NONE: Self = Self::new(1.0, 0.0);

    #[inline(always)]
    fn and(self, other: Self) -> Self {
        self * other
    }

    #[inline(always)]
    fn apply(self, number: Self) -> Self {
        self * number
    }

    #[inline(always)]
    fn revert(self, number: Self) -> Self {
        self.conj() * number
    }
}
